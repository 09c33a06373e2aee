#!/usr/bin/env python3
"""Do the intervals of `coulter run --confidence` hold the truth, and are bad set-ups caught?

    python3 scripts/reliability/confidence.py target/release/coulter [--short] [--only NAME,...] [-o DIR] [--resume]

Rows with exact answers are in validation/confidence/rows.toml, set-ups with one fault each in bad.toml there; both lists
were written before any of them was run. Each is run with --confidence on one thread and the default budget. A row is inside
if its interval holds the exact value. A fault is caught if the run is refused or broken, or its verdict is doubtful, because of
one of the checks that the list names, or if one of the sources that it names dominates an interval that holds the exact value. A fault that changes the value by less than 5 %, in an interval that holds the exact
one, has no effect, and there is nothing to catch.

Rows whose exact value was found not to be that of the set-up (`flawed`) are shown and counted apart.

Fails (exit code 1) unless five sixths of the others are inside, the median half-width is at most 15 %, and every fault is caught.
--short runs a row of each kind and one fault, in less than a minute.
"""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

CASES = Path(__file__).resolve().parents[2] / "validation" / "confidence"
INSIDE = 5 / 6
MEDIAN = 0.15
HARMLESS = 0.05


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter", type=Path)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--only", default="", help="names of rows and faults, separated by commas")
    parser.add_argument("--resume", action="store_true", help="use what is in the folder already")
    parser.add_argument("-o", "--output", type=Path)
    return parser.parse_args()


def run(options, name, row, folder):
    """Runs a case with its variations; exit code, standard error, summary (None without one)."""
    out = folder / name
    command = [options.coulter.resolve(), "run", CASES / row["case"], "-o", out, "--threads", "1", "--confidence"]
    command += ["--auto-resume" if options.resume else "--force"]
    for assignment in row.get("set", []):
        command += ["--set", assignment]
    for source in row.get("without", []):
        command += ["--without", source]
    done = subprocess.run(command, capture_output=True, text=True)
    summary = out / "summary.json"
    return done.returncode, done.stderr, json.loads(summary.read_text()) if summary.is_file() else None


def figure(row, summary):
    """The interval of the figure of a row, and its exact value; None without an interval."""
    bodies = (summary.get("confidence") or {}).get("bodies", {})
    body = next(iter(bodies), None)
    interval = bodies[body]["figures"].get(row["figure"]) if body else None
    expected = row["expected"]
    if row.get("per_sinkage"):
        expected *= summary["bodies"][body]["steady"]["sinkage_m"]
    return interval, expected


def holds(interval, expected):
    low, high = interval["interval"]
    return low <= expected <= high


def parts(interval):
    texts = []
    for part in interval["contributions"]:
        relative = part["relative"]
        if part["status"] == "examined":
            texts.append(f"{part['source']} {100 * relative:.1f}" if relative is not None else part["source"])
        else:
            texts.append(f"{part['source']} {part['status'].replace('-', ' ')}")
    return ", ".join(texts)


def judge_row(options, name, row, folder):
    code, error, summary = run(options, name, row, folder)
    if summary is None or summary.get("confidence") is None:
        return {"name": name, "inside": False, "width": None, "text": f"no intervals (code {code}): {error[-300:]}"}
    interval, expected = figure(row, summary)
    if interval is None:
        why = [body["no_interval_because"] for body in summary["confidence"]["bodies"].values()]
        broken = [check["name"] for check in summary["trust"]["checks"] if check["verdict"] == "broken"]
        text = f"| {name} | {expected:.5g} | – | – | **no** | – | – | no interval: {'; '.join(filter(None, why))} {', '.join(broken)} | {summary['trust']['verdict']} | – |"
        return {"name": name, "inside": False, "width": None, "text": text}
    low, high = (end / expected for end in interval["interval"])
    inside, width = holds(interval, expected), interval["half_width"] / abs(expected)
    seconds = summary["wall_s"] + summary["confidence"]["spent_s"]
    cells = [
        name,
        f"{expected:.5g}",
        f"{interval['value'] / expected:.3f}",
        f"{low:.3f} to {high:.3f}",
        "yes" if inside else "**no**",
        f"{100 * width:.1f} %",
        interval["dominated_by"] or "–",
        parts(interval),
        summary["trust"]["verdict"],
        f"{seconds:.0f} s",
    ]
    return {"name": name, "inside": inside, "width": width, "text": "| " + " | ".join(cells) + " |"}


def judge_fault(options, name, row, folder):
    code, error, summary = run(options, name, row, folder)
    if summary is None:
        first = next((line for line in error.splitlines() if line.strip()), "")
        return {"name": name, "caught": code == 2, "text": f"| {name} | refused | {first} | – | – |"}
    trust = summary["trust"]
    concerns = [check for check in trust["checks"] if check["verdict"] != "good"]
    named = [check for check in concerns if check["name"] in row["checks"]]
    interval, expected = figure(row, summary)
    widened = interval is not None and interval["dominated_by"] in row["sources"] and holds(interval, expected)
    why = "; ".join(f"{check['name']} {check['value']:.3g} {check['unit']}".strip() if check["value"] is not None else check["name"] for check in named)
    shown = "–"
    if interval is not None:
        low, high = (end / expected for end in interval["interval"])
        shown = f"{interval['value'] / expected:.3f}, {low:.3f} to {high:.3f}, {interval['dominated_by']}"
    caught = bool(named or widened)
    harmless = interval is not None and holds(interval, expected) and abs(interval["value"] / expected - 1) <= HARMLESS
    word = "yes" if caught else "no effect" if harmless else "**no**"
    cells = [name, trust["verdict"], why or "–", shown, word]
    return {"name": name, "caught": caught, "harmless": harmless, "text": "| " + " | ".join(cells) + " |"}


def count(what, results):
    """Prints and returns how many are inside, of how many, and the median half-width."""
    inside = sum(result["inside"] for result in results)
    widths = [result["width"] for result in results if result["width"] is not None]
    median = statistics.median(widths) if widths else float("inf")
    print(f"{what}: {inside} of {len(results)} inside, median half-width {100 * median:.1f} %")
    return inside, len(results), median


def chosen(options, table):
    names = [name for name in options.only.split(",") if name]
    return {n: row for n, row in table.items() if (not names or n in names) and (not options.short or row.get("short"))}


def main():
    options = arguments()
    folder = options.output or Path(tempfile.mkdtemp(prefix="confidence-"))
    rows = chosen(options, tomllib.loads((CASES / "rows.toml").read_text()))
    faults = chosen(options, tomllib.loads((CASES / "bad.toml").read_text()))
    failed = False
    if rows:
        print("| row | exact | value/exact | interval/exact | inside | half-width | dominated by | contributions [%] | verdict | time |")
        print("|---|--:|--:|--:|---|--:|---|---|---|--:|", flush=True)
        results = []
        for name, row in rows.items():
            results.append({**judge_row(options, name, row, folder), **row})
            print(results[-1]["text"], flush=True)
        print()
        count("as listed", [result for result in results if not result.get("added")])
        inside, number, median = count(
            "without rows whose exact value is not that of the set-up, with those added",
            [result for result in results if not result.get("flawed")],
        )
        print(flush=True)
        failed |= inside < INSIDE * number or median > MEDIAN
    if faults:
        print("| fault | verdict | because of | value, interval over exact, dominated by | caught |")
        print("|---|---|---|---|---|", flush=True)
        results = []
        for name, row in faults.items():
            results.append(judge_fault(options, name, row, folder))
            print(results[-1]["text"], flush=True)
        caught = sum(result["caught"] for result in results)
        harmless = sum(result.get("harmless", False) and not result["caught"] for result in results)
        print(f"\n{caught} of {len(results)} caught, {harmless} without effect")
        failed |= caught + harmless < len(results)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
