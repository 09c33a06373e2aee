#!/usr/bin/env python3
"""Does a run in several processes give the same results to the byte, and survive the loss of one?

    processes.py COULTER [--short] [--keep DIR]

COULTER is built with `--features mpi`; `mpirun` is that of the same library. Every case is run in one process and in 2, 3 and 4
(--short: three of the cases, each in one of these numbers): tables, summary, surface, bodies and pictures must be the same files, and the portions of the soil
must join to the file of one process, bit for bit. Then one process of three is killed (SIGKILL), once right after a checkpoint and
once later: what is left is resumed by two processes and, after a SIGTERM, by one, and must end as if nothing had happened.

Exits with 1 if anything differs. Python 3, standard library only.
"""

import argparse
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASES = {
    "towed disc": ("cases/light_disc.toml", ["run.tow_distance=\"0.02 m\"", "grid.cell=\"25 mm\""]),
    "towed disc, single": (
        "cases/light_disc.toml",
        ["run.tow_distance=\"0.02 m\"", "grid.cell=\"25 mm\"", "numerics.precision=\"single\""],
    ),
    "furrows, grid that travels": ("cases/furrowed_field.toml", ["run.tow_distance=\"0.02 m\""]),
    "assembly": ("cases/rockhopper.toml", ["run.tow_distance=\"0.01 m\"", "grid.cell=\"18 mm\""]),
    "pore water": ("validation/W2_wall_under_water/case.toml", ["run.tow_distance=\"0.005 m\""]),
}
SHORT = {"towed disc, single": (2,), "assembly": (4,), "pore water": (3,)}
# Files that say when, how long and with how many processes.
TIMES = re.compile(r"run\.json|run\.log|report\.html|.*checkpoints.*|soil\.pvd|.*\.p?vtr")
problems = []


def complain(what):
    problems.append(what)
    print(f"  FAULT: {what}", flush=True)


def command(arguments, ranks, case, folder, more=()):
    path, changes = CASES[case]
    sets = [word for change in changes for word in ("--set", change)]
    run = [arguments.coulter, "run", str(ROOT / path), *sets, "--threads", "1", "-o", str(folder), *more]
    return run if ranks == 1 else ["mpirun", "--oversubscribe", "-n", str(ranks), *run]


def environment():
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return {**os.environ, **(allowed if os.geteuid() == 0 else {})}


def run(arguments, ranks, case, folder, more=()):
    done = subprocess.run(command(arguments, ranks, case, folder, more), env=environment(), capture_output=True, text=True)
    # 1: a result that the run itself does not trust, which must be the same all the same.
    if done.returncode not in (0, 1):
        complain(f"{case}, {ranks} processes: exit code {done.returncode}\n{done.stderr[-2000:]}")
    return done.returncode


def arrays(path):
    """Extent of a .vtr file, and its arrays by section and name: components, bytes."""
    data = path.read_bytes()
    head, _, rest = data.partition(b'<AppendedData encoding="raw">\n_')
    text = head.decode()
    extent = [int(n) for n in re.search(r'<Piece Extent="([^"]+)"', text)[1].split()]
    found = {}
    for section in re.findall(r"<(PointData|CellData|Coordinates)>(.*?)</\1>", text, re.S):
        tags = re.findall(r'Name="([^"]+)" NumberOfComponents="(\d+)"[^>]*offset="(\d+)"', section[1])
        for name, components, offset in tags:
            found[section[0], name] = int(components), unpacked(rest, int(offset))
    return extent, found


def unpacked(data, at):
    count, _, _ = struct.unpack_from("<QQQ", data, at)
    sizes = struct.unpack_from(f"<{count}Q", data, at + 24)
    place, parts = at + 24 + 8 * count, []
    for size in sizes:
        parts.append(zlib.decompress(data[place : place + size]))
        place += size
    return b"".join(parts)


def joined(path):
    """The same of all portions of a .pvtr file."""
    text = path.read_text()
    whole = [int(n) for n in re.search(r'WholeExtent="([^"]+)"', text)[1].split()]
    found = {}
    for extent, source in re.findall(r'<Piece Extent="([^"]+)" Source="([^"]+)"', text):
        its, own = arrays(path.parent / source)
        assert its == [int(n) for n in extent.split()], source
        for (section, name), (components, values) in own.items():
            if section == "Coordinates":
                axis = "xyz".index(name)
                length = whole[2 * axis + 1] - whole[2 * axis] + 1
                target = found.setdefault((section, name), (components, bytearray(8 * length)))[1]
                start = 8 * (its[2 * axis] - whole[2 * axis])
                target[start : start + len(values)] = values
                continue
            beyond = int(section == "PointData")
            sizes = [whole[2 * n + 1] - whole[2 * n] + beyond for n in range(3)]
            count = [its[2 * n + 1] - its[2 * n] + beyond for n in range(3)]
            width = 4 * components
            row = width * count[0]
            target = found.setdefault((section, name), (components, bytearray(width * sizes[0] * sizes[1] * sizes[2])))[1]
            for k in range(count[2]):
                for j in range(count[1]):
                    there = ((k + its[4] - whole[4]) * sizes[1] + j + its[2] - whole[2]) * sizes[0] + its[0] - whole[0]
                    here = (k * count[1] + j) * row
                    target[width * there : width * there + row] = values[here : here + row]
    return whole, found


def compare(name, one, several):
    files = sorted(p.relative_to(one) for p in one.rglob("*") if p.is_file())
    count = 0
    for file in (f for f in files if not TIMES.fullmatch(str(f))):
        other = several / file
        if not other.is_file():
            complain(f"{name}: no {file}")
        elif file.name == "summary.json":
            a, b = (without_times(json.loads((folder / file).read_text())) for folder in (one, several))
            if a != b:
                complain(f"{name}: {file} differs")
        elif (one / file).read_bytes() != other.read_bytes():
            complain(f"{name}: {file} differs")
        count += 1
    for file in (f for f in files if f.suffix == ".vtr"):
        extent, expected = arrays(one / file)
        other = (several / file).with_suffix(".pvtr")
        whole, found = joined(other) if other.is_file() else arrays(several / file)
        if whole != extent or found.keys() != expected.keys():
            complain(f"{name}: {file} holds other arrays")
        for key in expected:
            if bytes(found[key][1]) != expected[key][1]:
                complain(f"{name}: {file}: {key[1]} differs")
        count += 1
    return count


def without_times(summary):
    return {key: value for key, value in summary.items() if key not in ("wall_s", "threads")}


def survive(arguments, folder, wait):
    """Kills one process of three; resumes with two, which get a SIGTERM, and then with one."""
    case, target = "towed disc", folder / f"killed {wait}"
    often = ["--set", "output.checkpoint_interval=\"0.2 s\""]
    process = subprocess.Popen(
        command(arguments, 3, case, target, often), env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    last = target / "checkpoints" / "last.checkpoint"
    first = None
    while process.poll() is None and (first is None or last.stat().st_mtime_ns == first):
        if first is None and last.is_file():
            first = last.stat().st_mtime_ns
        time.sleep(0.01)
    time.sleep(wait)
    children = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True).stdout.split()
    if children:
        os.kill(int(children[-1]), signal.SIGKILL)
    process.communicate(timeout=60)
    if not children:
        complain(f"kill after {wait} s: the run had ended")
    elif process.returncode == 0:
        complain(f"kill after {wait} s: mpirun ended with 0")
    stopped = subprocess.Popen(
        command(arguments, 2, case, target, [*often, "--resume"]), env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    time.sleep(1.5)
    stopped.send_signal(signal.SIGTERM)
    stopped.communicate(timeout=60)
    run(arguments, 1, case, target, [*often, "--resume"])
    return target


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    arguments.coulter = str(Path(arguments.coulter).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for case, counts in (SHORT if arguments.short else {case: (2, 3, 4) for case in CASES}).items():
            one = folder / f"{case} 1"
            run(arguments, 1, case, one)
            for ranks in counts:
                several = folder / f"{case} {ranks}"
                run(arguments, ranks, case, several)
                print(f"{case}, {ranks} processes: {compare(f'{case}, {ranks}', one, several)} files compared", flush=True)
        case = "towed disc"
        often = ["--set", "output.checkpoint_interval=\"0.2 s\""]
        run(arguments, 1, case, folder / "whole", often)
        for wait in (0.0, 0.5):
            target = survive(arguments, folder, wait)
            print(f"killed and resumed: {compare(f'killed after {wait} s', folder / 'whole', target)} files compared", flush=True)
    print(f"{len(problems)} faults")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
