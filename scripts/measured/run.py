#!/usr/bin/env python3
"""Runs the rows of validation/measured, prints what was computed beside what was measured, and registers the predictions of blind rows.

    run.py [ROW ...] [--coulter PROGRAM] [-o OUT] [--jobs N] [--limit MINUTES] [--round N] [--list] [--closed] [--dry]
           [--set KEY=VALUE ...]

ROW is a name of validation/measured/rows.toml or a pattern such as 'M2*'; without one all rows are run. Rows that others need (of which
ratios are formed, and the given rows of the same set, which widen the intervals) are run with them. Every row is run by the solver on one
thread and, where one applies, evaluated by the closed form. Runs that are finished in OUT are read, not repeated, and those that were
stopped go on; use another OUT, or another --round, after the program has changed. Predictions are written to validation/blind/predictions.toml,
what was computed of given rows to validation/measured/computed.toml; page.py draws docs/reference/measured.md from both.

Python 3.11 or newer, standard library only.
"""
import argparse
import csv
import fnmatch
import hashlib
import json
import math
import re
import shlex
import signal
import statistics
import subprocess
import sys
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "validation" / "measured"
REGISTER = ROOT / "validation" / "blind" / "predictions.toml"
COMPUTED = FOLDER / "computed.toml"
RATE = 10e6  # filled cell-steps per second and core (6 to 13 million in short runs beside two others), until runs in OUT say otherwise
NORMAL = 1.645  # half-width of a 90 % interval in standard deviations
WIDER = {"good": 1.0, "doubtful": 1.25, "broken": 2.0, "unfinished": 2.0}  # the intervals of runs of this grade
COLUMNS = {
    "drag": "drag F_H [N]", "vertical": "vertical F_V [N]", "sinkage": "sinkage z [m]", "torque": "axle torque [N m]",
    "travel": "displacement u [m]", "rotation": "rotation [rad]", "turn": "turn ratio [-]",
}
FIELDS = ["row", "quantity", "value", "low", "high", "model", "grade", "command", "round"]
GIVEN_FIELDS = ["row", "quantity", "unit", "measured", "scale", "value", "model", "grade", "round"]
MATHS = {name: getattr(math, name) for name in ("sqrt", "log", "exp", "pi", "tan", "radians")} | {"max": max, "min": min}


class Fault(Exception):
    """Something that the user can mend, or that leaves a quantity without a value."""


def formula(text, names, where):
    """The value of a formula, or of a number."""
    if isinstance(text, (int, float)):
        return float(text)
    try:
        return float(eval(text, {"__builtins__": {}}, MATHS | names))  # of rows.toml, which is part of the project
    except (NameError, SyntaxError, TypeError, AttributeError) as error:
        raise Fault(f"{where}: cannot evaluate '{text}': {error}") from None
    except (ArithmeticError, ValueError) as error:
        raise Fault(f"'{text}' has no value: {error}") from None


def filled(text, names, where):
    """The text with each <formula> replaced by its value."""
    return re.sub(r"<([^<>]+)>", lambda part: f"{formula(part[1], names, where):.6g}", text)


class Row:
    """A row with everything that it has from its set."""

    def __init__(self, table, sets, trials):
        self.name = table["name"]
        if table.get("set") not in sets:
            raise Fault(f"{self.name}: there is no set '{table.get('set')}'")
        self.set = table["set"]
        shared = inherited(self.set, sets)
        self.blind, self.helper = table.get("blind", False), table.get("helper", False)
        self.measured, self.of = table.get("measured", {}), table.get("of", {})
        self.rows_of = shared.get("rows_of", [self.set])
        self.quantity = shared["quantity"]
        plain = [name for name, spec in self.quantity.items() if self.helper or not spec.get("hidden")]
        self.shown = table.get("quantities", shared.get("quantities", plain))
        for name in [*self.shown, *self.measured]:
            if name not in self.quantity:
                raise Fault(f"{self.name}: its set has no quantity '{name}'")
            if self.blind and "sd" not in self.quantity[name]:
                raise Fault(f"{self.name}: '{name}' is to be predicted, and has no sd")
        self.number = resolved(shared.get("number", {}) | table.get("number", {}), self.name)
        fill = lambda words: [filled(word, self.number, self.name) for word in words]
        self.case = (FOLDER / shared["case"]).resolve() if "case" in shared else None
        self.override = fill(shared.get("override", []) + table.get("override", [])) + (trials if self.case else [])
        self.closed = shared.get("closed", True) and self.case is not None
        self.closed_override = shared.get("closed_override", [])
        if self.case and not self.case.is_file():
            raise Fault(f"{self.name}: no case file {shared['case']} in validation/measured")

    def words(self, override):
        return [word for one in override for word in ("--set", one)]

    def command(self, what, override):
        """The command as it is registered: from the root of the checkout."""
        return shlex.join(["coulter", what, str(self.case.relative_to(ROOT)), *self.words(override)])

    def key(self):
        text = self.case.read_text() + "\n".join(self.override)
        return f"{self.name}-{hashlib.sha1(text.encode()).hexdigest()[:8]}"


def inherited(name, sets):
    """A set, with what it takes from the one that it is `like`."""
    own = sets[name]
    if "like" not in own:
        return own
    base = inherited(own["like"], sets)
    quantity = {key: dict(value) for key, value in base["quantity"].items()}
    for key, value in own.get("quantity", {}).items():
        quantity[key] = quantity.get(key, {}) | value
    merged = base | own | {"quantity": quantity, "number": base.get("number", {}) | own.get("number", {})}
    if "rows_of" not in own:
        merged.pop("rows_of", None)
    if "quantities" not in own:
        merged.pop("quantities", None)
    return merged


def resolved(numbers, where):
    """Numbers, with the formulas among them evaluated in whatever order they need."""
    values, left = {}, dict(numbers)
    while left:
        for name in list(left):
            try:
                values[name] = formula(left[name], values, where)
            except Fault:
                continue
            del left[name]
            break
        else:
            formula(next(iter(left.values())), values, where)  # says what is missing
            raise Fault(f"{where}: {', '.join(left)} cannot be evaluated")
    return values


# --- what is read of a run ---


def history(folder):
    """Columns of forces.csv by short name."""
    lines = list(csv.DictReader(open(folder / "forces.csv")))
    number = lambda text: float(text) if text else math.nan
    return {short: [number(line[name]) for line in lines] for short, name in COLUMNS.items()}


def mean(values):
    values = [value for value in values if not math.isnan(value)]
    if not values:
        raise Fault("no line of the history is in its window")
    return sum(values) / len(values)


def steady_window(data, spec, row):
    """The lines of the last 40 % of the tow; with lugs so many of them as pass a whole number of lugs."""
    travel = data["travel"]
    last = [n for n, u in enumerate(travel) if u > 0.6 * travel[-1]]
    if not last or travel[-1] <= 0:
        raise Fault("it was not towed")
    if "pitch" in spec:
        pitch = formula(spec["pitch"], row.number, row.name)
        turn = data["rotation"]
        whole = math.floor((turn[-1] - turn[last[0]]) / pitch) * pitch
        if whole > 0:
            last = [n for n in last if turn[n] >= turn[-1] - whole]
    return last


def smoothed(depth, force, width):
    """Mean of the force over `width` of depth round every line."""
    result, low, high = [], 0, 0
    for z in depth:
        while low < len(depth) and depth[low] < z - width / 2:
            low += 1
        while high < len(depth) and depth[high] <= z + width / 2:
            high += 1
        result.append(mean(force[low:high]) if high > low else math.nan)
    return result


def read(row, spec, data):
    """One quantity from the history."""
    value = lambda key: formula(spec[key], row.number, row.name)
    kind = spec["read"]
    factor = value("factor") if "factor" in spec else 1.0
    if kind in ("skid", "slip"):
        turn = mean([data["turn"][n] for n in steady_window(data, spec, row)])
        if kind == "slip" and turn <= 0:
            raise Fault("it does not turn")
        return 1 - turn if kind == "skid" else 1 / turn - 1
    column, depth = data[spec["column"]], data["sinkage"]
    if kind == "steady":
        return factor * mean([column[n] for n in steady_window(data, spec, row)])
    if kind == "largest":
        return factor * max(column)
    if kind == "between":
        return factor * mean([f for f, u in zip(column, data["travel"]) if value("from") <= u <= value("to")])
    if kind == "at":
        at, within = value("at"), value("within") if "within" in spec else 0.1 * value("at")
        if max(depth) < at:
            raise Fault(f"it does not reach {1e3 * at:g} mm")
        if "per_depth" in spec:
            column = [f / (z - value("per_depth")) if z > value("per_depth") else math.nan for f, z in zip(column, depth)]
        chosen = [f for f, z in zip(column, depth) if abs(z - at) <= within]
        return factor * mean(chosen or [min(zip(column, depth), key=lambda pair: abs(pair[1] - at))[0]])
    if kind in ("peak", "where_peak"):
        smooth = smoothed(depth, column, value("smooth"))
        start = depth[0]
        peak = max((n for n, z in enumerate(depth) if z <= value("to") and not math.isnan(smooth[n])), key=smooth.__getitem__)
        return factor * (smooth[peak] if kind == "peak" else depth[peak] - start)
    raise Fault(f"{row.name}: no way to read '{kind}'")


class Others:
    """Quantities of another row, by name, for formulas."""

    def __init__(self, values):
        self.__dict__.update(values)


# --- running ---


class Harness:
    def __init__(self, given, rows):
        self.given, self.rows = given, {row.name: row for row in rows}
        self.out = given.out
        self.out.mkdir(parents=True, exist_ok=True)
        self.costs = self.load("costs.json")
        self.closed = self.load("closed.json")
        self.values, self.grades, self.notes = {}, {}, {}

    def load(self, name):
        path = self.out / name
        return json.loads(path.read_text()) if path.is_file() else {}

    def save(self, name, what):
        (self.out / name).write_text(json.dumps(what, indent=1) + "\n")

    def coulter(self, *words):
        try:
            return subprocess.run([str(self.given.coulter), *map(str, words)], capture_output=True, text=True)
        except OSError as error:
            raise SystemExit(f"run.py: cannot start {self.given.coulter}: {error.strerror}; build it, or give --coulter") from None

    def cost(self, row):
        """Cell-steps of the row, as `coulter check` predicts them."""
        key = row.key()
        if key not in self.costs:
            done = self.coulter("check", row.case, "--json", *row.words(row.override))
            if done.returncode != 0:
                raise Fault(f"{row.name}: coulter check refuses it:\n{done.stderr.strip()}")
            cost = json.loads(done.stdout)["cost"]
            self.costs[key] = cost["filled_cells"] * cost["steps"]
            self.save("costs.json", self.costs)
        return self.costs[key]

    def rate(self, row):
        """Cell-steps per second: the median of finished runs of the same case, else of all, else a usual one."""
        found = {}
        for one in self.rows.values():
            summary = self.out / one.key() / "summary.json" if one.case else None
            if summary and summary.is_file():
                told = json.loads(summary.read_text())
                if told["wall_s"] > 5:
                    found.setdefault(one.case, []).append(told["filled_cells"] * told["steps"] / told["wall_s"])
        if row.case in found:
            return statistics.median(found[row.case])
        return statistics.median([rate for rates in found.values() for rate in rates]) if found else RATE

    def finished(self, row):
        return (self.out / row.key() / "summary.json").is_file()

    def minutes(self, row):
        return self.cost(row) / self.rate(row) / 60

    def solve(self, row):
        """Runs a row; its grade. A run that has no result says why."""
        folder = self.out / row.key()
        command = [str(self.given.coulter), "run", str(row.case), "-o", str(folder), "--auto-resume", "--threads", "1", *row.words(row.override)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            try:
                text, errors = process.communicate(timeout=180 * self.given.limit)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGINT)  # it writes a checkpoint: the next call goes on from there
                process.communicate()
                return f"unfinished: stopped after {3 * self.given.limit:g} min, three times the limit"
        (self.out / f"{row.key()}.txt").write_text(row.command("run", row.override) + "\n" + text + errors)
        if not (folder / "summary.json").is_file():
            told = [line for line in (errors or text).splitlines() if line.strip()]
            return "broken: " + (told[0].strip() if told else f"exit code {process.returncode}")
        trust = json.loads((folder / "summary.json").read_text())["trust"]
        worst = [check for check in trust["checks"] if check["verdict"] == trust["verdict"] != "good"]
        reasons = ", ".join(f"{check['name']} {check['value']:.3g} {check['unit']}".strip() for check in worst)
        return trust["verdict"] + (f": {reasons}" if reasons else "")

    def evaluate(self, row):
        """Quantities of a row: from its run, then formulas."""
        values = {}
        folder = self.out / row.key() if row.name in self.grades else None
        data = None
        if folder and (folder / "forces.csv").is_file():
            data = history(folder)
            if not data["sinkage"]:
                data = None
        names = dict(row.number)
        for short, other in row.of.items():
            names[short] = Others(self.values.get(other, {}))
        for name, spec in sorted(row.quantity.items(), key=lambda pair: pair[1]["read"] == "formula"):
            try:
                if spec["read"] == "formula":
                    values[name] = formula(spec["formula"], names | values, row.name)
                elif data:
                    values[name] = read(row, spec, data)
            except Fault as fault:
                done = all(other in self.grades for other in [row.name, *row.of.values()] if self.rows[other].case)
                if name in row.shown and done:
                    self.notes.setdefault(row.name, []).append(f"{name}: {fault}")
        return {name: value for name, value in values.items() if math.isfinite(value)}

    def grade(self, row):
        """The worst of the grades of the runs that a row needs."""
        own = [self.grades[name] for name in [row.name, *row.of.values()] if name in self.grades]
        order = list(WIDER)
        return max(own, key=lambda grade: order.index(grade.split(":")[0]), default="not run")

    def forecast(self, row, name):
        """The closed form of a quantity: value, low, high, model and command, or None where none applies."""
        spec = row.quantity[name]
        if not row.closed or "closed" not in spec:
            return None
        depth = spec.get("closed_at", spec.get("at"))
        names = row.number | ({"at": formula(depth, row.number, row.name)} if depth is not None else {})
        override = row.override + [filled(one, names, row.name) for one in row.closed_override]
        key = row.key() + " " + " ".join(override)
        if key not in self.closed:
            done = self.coulter("forecast", row.case, "--json", *row.words(override))
            found = None
            if done.returncode == 0:
                document = json.loads(done.stdout)
                best = [m for m in document["models"] if m["name"] == document["recommended"] and m["applicable"]]
                found = {k: best[0][k] for k in ("name", "drag_N", "vertical_N", "sinkage_m", "slip", "interval")} if best else None
            self.closed[key] = found
            self.save("closed.json", self.closed)
        found = self.closed[key]
        if not found or found.get(spec["closed"]) is None:
            return None
        factor = formula(spec.get("closed_factor", spec.get("factor", 1)), row.number, row.name)
        value, span = factor * found[spec["closed"]], found["interval"].get(spec["closed"])
        ends = sorted([factor * span["low"], factor * span["high"]]) if span else None
        return {"value": value, "ends": ends, "model": found["name"], "command": row.command("forecast", override)}

    def needed(self, names):
        """The named rows, those that their formulas use, and the given rows of their sets."""
        wanted = set()

        def add(name):
            if name in wanted:
                return
            if name not in self.rows:
                raise Fault(f"there is no row '{name}'")
            wanted.add(name)
            row = self.rows[name]
            for other in row.of.values():
                add(other)
            if row.blind:
                for other in self.rows.values():
                    if other.set in row.rows_of and other.measured:
                        add(other.name)

        for name in names:
            add(name)
        return [row for row in self.rows.values() if row.name in wanted]

    # --- intervals ---

    def bias(self, row, name, computed):
        """Mean and spread of measured over computed, in the measure of the quantity, over the given rows of its class."""
        kind = row.quantity[name].get("class", name)
        found = []
        for other in self.rows.values():
            if other.set not in row.rows_of or not other.measured:
                continue
            for quantity, measured in other.measured.items():
                spec, value = other.quantity[quantity], computed(other, quantity)
                if spec.get("class", quantity) != kind or value is None:
                    continue
                if "scale" in spec:
                    found.append((measured - value) / formula(spec["scale"], other.number, other.name))
                elif value > 0 and measured > 0:
                    found.append(math.log(measured / value))
        if not found:
            return 0.0, 0.0
        return statistics.mean(found), statistics.stdev(found) if len(found) > 1 else 0.0

    def interval(self, row, name, value, computed, ends=None, wider=1.0, also=()):
        """The 90 % interval: validation/measured/README.md states the rule."""
        spec = row.quantity[name]
        mean_bias, spread = self.bias(row, name, computed)
        lean = spec.get("lean", 0.0)
        half = NORMAL * wider * max(spec["sd"], spread)
        down, up = min(0.0, mean_bias) + min(0.0, lean) - half, max(0.0, mean_bias) + max(0.0, lean) + half
        scale = formula(spec["scale"], row.number, row.name) if "scale" in spec else None
        if scale is None and value <= 0:
            raise Fault(f"{name} is {value:.3g}, which has no logarithm")
        move = (lambda at, by: at + by * scale) if scale is not None else (lambda at, by: at * math.exp(by))
        low, high = move(value, down), move(value, up)
        if ends:  # the closed form has an interval of its own: only the given rows widen it
            low, high = move(ends[0], min(0.0, mean_bias) + min(0.0, lean)), move(ends[1], max(0.0, mean_bias) + max(0.0, lean))
        low, high = min([low, *also]), max([high, *also])
        low, high = max(low, spec.get("floor", -math.inf)), min(high, spec.get("ceiling", math.inf))
        return min(low, value), max(high, value)


# --- the register ---


def digits(value):
    """Four significant digits, as TOML writes a float."""
    text = f"{value:.4g}"
    return text if re.search(r"[.e]", text) else text + ".0"


def register(path, key, what, new, order):
    """Writes tables [[key]] of predictions or of given rows, in place of those of the same row, quantity, model and round. All others stay."""
    old = tomllib.loads(path.read_text()).get(key, []) if path.is_file() else []
    same = lambda entry: tuple(entry[key] for key in ("row", "quantity", "model", "round"))
    merged = list(({same(entry): entry for entry in old} | {same(entry): entry for entry in new}).values())
    # Rounds and models one below the other; rows that are no longer listed come last.
    position = lambda entry: (order.get((entry["row"], entry["quantity"]), len(order)), entry["model"] != "solver", entry["round"])
    merged.sort(key=position)
    lines = [f"# {what}", ""]
    for entry in merged:
        lines.append(f"[[{key}]]")
        for field, value in entry.items():
            lines.append(f"{field} = {digits(value) if isinstance(value, float) else json.dumps(value, ensure_ascii=False)}")
        lines.append("")
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_suffix(".part")
    partial.write_text("\n".join(lines))
    partial.replace(path)
    print(f"{len(new)} of round {new[0]['round']} written to {path.relative_to(ROOT)}")


def number(value):
    return "–" if value is None else f"{value:.4g}"


def report(harness, rows, given):
    """Prints the table, and returns the predictions and what was computed of given rows."""
    predictions, computed, results = [], [], []
    solver = lambda row, name: harness.values.get(row.name, {}).get(name)

    def closed(row, name):
        found = harness.forecast(row, name)
        return found and found["value"]

    print(f"{'row':<16} {'quantity':<15} {'unit':<6} {'measured':>9} {'solver':>9} {'ratio':>6} {'closed':>9} {'ratio':>6}  interval (90 %) and grade")
    for row in rows:
        grade = harness.grade(row)
        for name in row.shown:
            spec, measured = row.quantity[name], row.measured.get(name)
            entry = {"row": row.name, "quantity": name, "unit": spec.get("unit", ""), "measured": measured, "grade": grade}
            told = []
            for model, value, wider in (("solver", solver(row, name), WIDER.get(grade.split(":")[0], 2.0)), ("closed form", None, 1.0)):
                found = None
                if model == "closed form":
                    found = harness.forecast(row, name)
                    value = found and found["value"]
                entry[model] = value
                if value is not None and measured is not None:
                    scale = formula(spec["scale"], row.number, row.name) if "scale" in spec else 0.0
                    told_by = found["model"] if found else grade
                    computed.append(dict(zip(GIVEN_FIELDS, [
                        row.name, name, spec.get("unit", ""), float(measured), scale, value, model, told_by, given.round])))
                if value is None or not row.blind:
                    continue
                values = harness.values.get(row.name, {}) if model == "solver" else {}
                also = [values[other] for other in spec.get("also", []) if other in values]
                try:
                    low, high = harness.interval(row, name, value, solver if model == "solver" else closed, found and found["ends"], wider, also)
                except Fault as fault:
                    harness.notes.setdefault(row.name, []).append(f"{model}: no interval: {fault}")
                    continue
                runs = [other for other in (row, *(harness.rows[o] for o in row.of.values())) if other.case]
                command = found["command"] if found else "; ".join(other.command("run", other.override) for other in runs)
                predictions.append(dict(zip(FIELDS, [
                    row.name, name, value, low, high, model, found["model"] if found else grade, command, given.round])))
                told.append(f"{low:.4g} to {high:.4g}")
            ratio = lambda value: f"{value / measured:.2f}" if value is not None and measured else "–"
            scatter = f" (measured {spec['scatter']})" if measured is not None and "scatter" in spec else ""
            print(f"{row.name:<16} {name:<15} {entry['unit']:<6} {number(measured):>9} {number(entry['solver']):>9} {ratio(entry['solver']):>6} "
                  f"{number(entry['closed form']):>9} {ratio(entry['closed form']):>6}  {'; closed '.join(told)}{scatter} {grade}", flush=True)
            results.append(entry)
        for note in harness.notes.get(row.name, []):
            print(f"    {note}")
    harness.save("rows.json", results)
    return predictions, computed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("row", nargs="*", help="rows to run, by name or pattern; all without one")
    parser.add_argument("--coulter", type=Path, default=ROOT / "target" / "release" / "coulter", metavar="PROGRAM", help="default: target/release/coulter")
    parser.add_argument("-o", "--out", type=Path, help="where runs are kept; default: results/measured/round-N")
    parser.add_argument("--jobs", type=int, default=2, metavar="N", help="runs at once, each on one thread; default: 2")
    parser.add_argument("--limit", type=float, default=10, metavar="MINUTES", help="rows that need longer are left out; default: 10")
    parser.add_argument("--round", type=int, default=1, metavar="N", help="round of the predictions: 1 before anything was changed; default: 1")
    parser.add_argument("--list", action="store_true", help="list the rows with their estimated minutes; run nothing")
    parser.add_argument("--closed", action="store_true", help="start no run: closed forms, and the runs that are finished in OUT")
    parser.add_argument("--dry", action="store_true", help="write no predictions")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="a trial: sets a key of all cases; writes no predictions")
    given = parser.parse_args()
    given.out = given.out or ROOT / "results" / "measured" / f"round-{given.round}"
    if given.jobs < 1 or given.limit <= 0 or given.round < 1:
        parser.error("--jobs, --limit and --round must be positive")
    try:
        table = tomllib.loads((FOLDER / "rows.toml").read_text())
        rows = [Row(one, table["set"], given.set) for one in table["row"]]
        names = []
        for pattern in given.row or ["*"]:
            found = [row.name for row in rows if fnmatch.fnmatchcase(row.name, pattern)]
            if not found:
                raise Fault(f"no row is called '{pattern}'; --list shows them")
            names += found
        harness = Harness(given, rows)
        chosen = harness.needed(names)
        work(harness, chosen, given)
    except Fault as fault:
        raise SystemExit(f"run.py: {fault}") from None
    except tomllib.TOMLDecodeError as error:
        raise SystemExit(f"run.py: rows.toml or predictions.toml cannot be read: {error}") from None


def work(harness, chosen, given):
    runs, total = [], 0.0
    for row in chosen:
        if not row.case:
            if given.list:
                print(f"{row.name:<16}     –      from {', '.join(row.of.values())}")
            continue
        minutes = harness.minutes(row)
        total += minutes
        kept = harness.finished(row)
        if given.list:
            kind = "blind" if row.blind else "helper" if row.helper else "given"
            state = "finished" if kept else "" if minutes <= given.limit else f"left out: over {given.limit:g} min"
            print(f"{row.name:<16} {minutes:6.1f} min {kind:<7} {row.case.name:<18} {state}", flush=True)
        elif kept or not given.closed and minutes <= given.limit:
            runs.append(row)
        elif not given.closed:
            print(f"left out: {row.name}, {minutes:.1f} min (limit {given.limit:g})", file=sys.stderr)
    if given.list:
        print(f"{len(chosen)} rows, {total:.0f} min on one core")
        return

    def one(row):
        kept = harness.finished(row)
        harness.grades[row.name] = harness.solve(row)
        if not kept:
            print(f"{row.name}: {harness.grades[row.name]}", file=sys.stderr, flush=True)

    with ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(one, runs))
    # Rows whose quantities others use come first.
    for row in sorted(chosen, key=lambda row: len(row.of)):
        harness.values[row.name] = harness.evaluate(row)
    predictions, computed = report(harness, chosen, given)
    if given.set or given.dry:
        return
    order = {(row.name, name): n for n, (row, name) in enumerate((row, name) for row in harness.rows.values() for name in row.shown)}
    if predictions:
        register(REGISTER, "prediction", "Predictions of the blind rows of validation/measured, written by scripts/measured/run.py: value and 90 % interval.", predictions, order)
    if computed:
        register(COMPUTED, "given", "What was computed of given rows, written by scripts/measured/run.py. An error is relative to the measured figure, or to a tenth of `scale` where that is larger.", computed, order)


try:
    main()
except BrokenPipeError:  # `run.py | head`
    sys.stderr.close()
