#!/usr/bin/env python3
"""Threads beside processes, in turns: time of a step of the towed disc at d/h = 40.

    ranks_and_threads.py COULTER [ROUNDS] [PLAIN]

COULTER is built with `--features mpi`, PLAIN without. Each round runs one thread, two threads, two processes of one thread, one process
under `mpirun` and two runs of one thread at once that have nothing to do with each other, then one thread of PLAIN if there is one, and
takes the seconds in steps over their number from `summary.json`. Last come the medians, and the medians of the ratios within a round. Two
runs at once show what the machine has to give: on many a virtual one the second core is not a whole one. Python 3, standard library only.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parents[2] / "cases" / "light_disc.toml"
KEYS = [
    'grid.cell="5 mm"',
    'run.tow_distance="2 mm"',
    "body.disc.sinkage=20 mm",
    "body.disc.forward.start=0 s",
    "body.disc.forward.ramp=10 ms",
    "body.disc.heave.ramp=10 ms",
]
UNBOUND = ["mpirun", "--bind-to", "none", "-n"]
WAYS = {"1 thread": ([], 1), "2 threads": ([], 2), "2 processes": ([*UNBOUND, "2"], 1), "1 process": ([*UNBOUND, "1"], 1)}
# Half of the time that two runs take at once: that of a step, if threads had nothing to share.
BOTH = "2 runs, halved"
PLAIN = "1 thread, plain"
RATIOS = [
    ("1 thread", "2 threads"),
    ("1 thread", BOTH),
    (BOTH, "2 threads"),
    ("2 processes", "2 threads"),
    ("2 processes", BOTH),
    ("1 process", "1 thread"),
    ("1 process", PLAIN),
]


def milliseconds(coulter: str, launcher: list[str], threads: int, runs: int = 1) -> float:
    """Mean time of a step [ms] of so many runs at once."""
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"} if os.geteuid() == 0 else {}
    with tempfile.TemporaryDirectory() as scratch:
        folders = [Path(scratch) / f"run{n}" for n in range(runs)]
        sets = [word for key in KEYS for word in ("--set", key)]
        words = [*launcher, coulter, "run", str(CASE), *sets, "--threads", str(threads), "-o"]
        started = [
            subprocess.Popen([*words, str(folder)], env={**os.environ, **allowed}, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            for folder in folders
        ]
        for one in started:
            complaint = one.communicate()[1]
            # 1: a result that the run does not trust takes as long.
            if one.returncode not in (0, 1):
                sys.exit(complaint)
        summaries = [json.loads((folder / "summary.json").read_text()) for folder in folders]
    return statistics.mean(1e3 * summary["wall_s"] / summary["steps"] for summary in summaries)


def main() -> None:
    coulter, rounds = str(Path(sys.argv[1]).resolve()), int(sys.argv[2]) if len(sys.argv) > 2 else 5
    plain = str(Path(sys.argv[3]).resolve()) if len(sys.argv) > 3 else None
    taken: dict[str, list[float]] = {way: [] for way in [*WAYS, BOTH, *([PLAIN] if plain else [])]}
    for _ in range(rounds):
        for way, (launcher, threads) in WAYS.items():
            taken[way].append(milliseconds(coulter, launcher, threads))
        taken[BOTH].append(milliseconds(coulter, [], 1, runs=2) / 2)
        if plain:
            taken[PLAIN].append(milliseconds(plain, [], 1))
        print("  ".join(f"{way}: {times[-1]:.2f} ms" for way, times in taken.items()), flush=True)
    print("medians:", "  ".join(f"{way}: {statistics.median(times):.2f} ms" for way, times in taken.items()))
    for one, other in (ratio for ratio in RATIOS if ratio[1] in taken):
        each = [a / b for a, b in zip(taken[one], taken[other])]
        print(f"{one} over {other}: {statistics.median(each):.2f} ({min(each):.2f} to {max(each):.2f})")


if __name__ == "__main__":
    main()
