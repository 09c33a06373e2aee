"""Whether what came agrees with what a page promises: lines with numbers, and single values of files."""

import csv
import difflib
import html
import json
import math
import re

# A sign belongs to a number unless something stands right before it, as in 0-3.
NUMBER = re.compile(r"(?:(?<![\w.])[-−])?\d+(?:\.\d+)?(?:[eE][-−+]?\d+)?")


def number(text):
    """A number as it is printed, with either kind of minus sign."""
    return float(text.replace("−", "-"))


def close(expected, came, tolerance):
    """Whether two printed numbers agree within the tolerance, or within one unit of the last digit of the expected one."""
    mantissa, _, exponent = re.sub("E", "e", expected).partition("e")
    decimals = len(mantissa.partition(".")[2])
    unit = 10.0 ** (-decimals + (number(exponent) if exponent else 0))
    return abs(number(expected) - number(came)) <= max(tolerance * abs(number(expected)), unit * 1.001 if decimals or exponent else 0.0)


def line_agrees(expected, came, tolerance):
    """Whether a line agrees with the expected one, in which … stands for any text."""
    pattern, numbers = as_pattern(expected)
    found = re.fullmatch(pattern, came)
    return bool(found) and all(close(e, c, tolerance) for e, c in zip(numbers, found.groups()))


def is_quoted(words, file, tolerance):
    """Whether words stand in a page of HTML or in a text."""
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".html":
        text = html.unescape(re.sub(r"<[^>]+>", "", re.sub(r"(?s)<(script|style|svg)\b.*?</\1>", "", text)))
    pattern, numbers = as_pattern(words)
    found = re.search(pattern, text)
    return bool(found) and all(close(e, c, tolerance) for e, c in zip(numbers, found.groups()))


def as_pattern(expected):
    """A pattern for a text, with a group for each number, and these numbers."""
    words, numbers, at = [], [], 0
    for token in re.finditer(rf"{NUMBER.pattern}|…|\s+", expected):
        words.append(re.escape(expected[at : token.start()]))
        at = token.end()
        if token.group() == "…":
            words.append(".*?")
        elif token.group().isspace():
            words.append(r"\s+")
        else:
            words.append(f"(?<!\\d)(?<!\\d\\.)({NUMBER.pattern})")
            numbers.append(token.group())
    words.append(re.escape(expected[at:]))
    return "".join(words), numbers


def missing_line(expected, output, tolerance):
    """The first expected line that does not come, as (its place, itself, the line that is most like it), or None."""
    lines = [line.strip() for line in output.split("\n")]
    at = 0
    for place, line in enumerate(expected.split("\n")):
        line = line.strip()
        if line in ("", "…"):
            continue
        hit = next((k for k in range(at, len(lines)) if line_agrees(line, lines[k], tolerance)), None)
        if hit is None:
            like = difflib.get_close_matches(line, [one for one in lines[at:] if one], 1, 0.3)
            return place, line, like[0] if like else "nothing like it"
        at = hit + 1
    return None


def value_of(file, path):
    """A value of a JSON file by its path, `trust.checks.drag noise.value`, or the last number of a column of a CSV file."""
    if file.suffix == ".csv":
        with file.open(encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
        return float([row[path] for row in rows if row[path]][-1])
    value = json.loads(file.read_text(encoding="utf-8"))
    left = path
    while left:
        if isinstance(value, list):
            key, _, left = left.partition(".")
            # An item has a number, or a name of its own: what is listed before it may change.
            named = {str(n): item for n, item in enumerate(value)}
            named |= {item["name"]: item for item in value if isinstance(item, dict) and "name" in item}
            if key not in named:
                raise KeyError(f"no {key} in {', '.join(named)}")
            value = named[key]
            continue
        # A key may hold dots itself, such as soil.friction_angle.
        key = next((key for key in sorted(value, key=len, reverse=True) if left == key or left.startswith(key + ".")), None)
        if key is None:
            raise KeyError(f"no {left} in {', '.join(value)}")
        value, left = value[key], left[len(key) + 1 :]
    return value


def value_agrees(expected, came, tolerance):
    """Whether a value of a file is as a table or a comment says: a number with or without a tolerance, a range, or a word."""
    expected = expected.strip().strip("`")
    if isinstance(came, (bool, str)) or came is None:
        return expected == (came if isinstance(came, str) else json.dumps(came))
    several = re.match(rf"^({NUMBER.pattern})(?:\s*(±|…)\s*({NUMBER.pattern})\s*(%?))?", expected)
    if not several or not math.isfinite(came):
        return False
    first, sign, second, percent = several.groups()
    if sign == "…":
        return number(first) <= came <= number(second)
    if sign == "±":
        width = number(second) * (abs(number(first)) / 100 if percent else 1)
        return abs(came - number(first)) <= width
    return close(first, repr(float(came)), tolerance)
