"""What a page holds, in its order: what is to be done and what is promised."""

import re
from dataclasses import dataclass, field
from pathlib import Path


class Wrong(Exception):
    """What is wrong, and in which line of the page."""

    def __init__(self, line, why):
        super().__init__(why)
        self.line = line


@dataclass
class Item:
    """A block, a comment or a table. `comments` are those that stand before a block and belong to it."""

    kind: str
    line: int
    text: str
    comments: dict = field(default_factory=dict)


# Comments that belong to the next block, and those that stand for themselves.
OF_BLOCK = {"file", "expect", "skip", "needs"}
ALONE = {"tolerance", "values", "check", "exists", "continues"}


def read(path):
    """The items of a page."""
    lines = Path(path).read_text(encoding="utf-8").split("\n")
    items, waiting, at = [], {}, 0
    while at < len(lines):
        line = lines[at]
        fence = re.match(r"^(```+)(\w*)\s*$", line)
        comment = re.match(r"^<!--\s*([\w]+):\s*(.*?)\s*-->\s*$", line)
        if fence:
            end = closing(lines, at, fence.group(1))
            items.append(Item(fence.group(2) or "plain", at + 1, "\n".join(lines[at + 1 : end]), waiting))
            waiting, at = {}, end
        elif comment and comment.group(1) in OF_BLOCK:
            waiting[comment.group(1)] = comment.group(2)
        elif comment and comment.group(1) == "values":
            table = next_table(lines, at)
            items.append(Item("values", at + 1, comment.group(2), {"rows": table}))
        elif comment and comment.group(1) == "quote":
            items.append(Item("quote", at + 1, comment.group(2), {"words": next_quotation(lines, at)}))
        elif comment and comment.group(1) in ALONE:
            items.append(Item(comment.group(1), at + 1, comment.group(2)))
        elif line.startswith("<!--"):
            raise Wrong(at + 1, f"unknown comment: {line}")
        at += 1
    if waiting:
        raise Wrong(len(lines), f"no block follows the comment {', '.join(waiting)}")
    return items


def closing(lines, at, fence):
    """The line that closes the block which begins in line `at`."""
    for end in range(at + 1, len(lines)):
        if lines[end].rstrip() == fence:
            return end
    raise Wrong(at + 1, "the block is not closed")


def next_quotation(lines, at):
    """The words of the quotation, lines with > in front, that begins within two lines."""
    start = next((k for k in range(at + 1, min(at + 3, len(lines))) if lines[k].startswith(">")), None)
    if start is None:
        raise Wrong(at + 1, "no quotation follows")
    end = next((k for k in range(start, len(lines)) if not lines[k].startswith(">")), len(lines))
    return " ".join(line[1:].strip() for line in lines[start:end])


def next_table(lines, at):
    """Rows of the next table, with their lines: what stands in the first two columns."""
    start = next((k for k in range(at + 1, len(lines)) if lines[k].startswith("|")), None)
    if start is None:
        raise Wrong(at + 1, "no table follows")
    rows = []
    for k in range(start + 2, len(lines)):
        if not lines[k].startswith("|"):
            break
        cells = [cell.strip() for cell in lines[k].strip().strip("|").split("|")]
        rows.append((k + 1, cells[0].strip("`"), cells[1]))
    return rows


def links(path):
    """Broken relative links of a page, with their lines."""
    text, broken = Path(path).read_text(encoding="utf-8"), []
    for number, line in enumerate(text.split("\n"), 1):
        for target in re.findall(r"\]\(([^)\s]+)\)", line):
            if re.match(r"^[a-z]+:", target):
                continue
            name, _, heading = target.partition("#")
            file = (Path(path).parent / name).resolve() if name else Path(path)
            if not file.exists():
                broken.append((number, f"the link leads nowhere: {target}"))
            elif heading and file.suffix == ".md" and heading not in headings(file):
                broken.append((number, f"the page has no such heading: {target}"))
    return broken


def headings(file):
    """Names that links give to the headings of a page."""
    found = re.findall(r"^#+ (.+)$", file.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-") for text in found}
