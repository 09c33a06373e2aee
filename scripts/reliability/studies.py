#!/usr/bin/env python3
"""Kills a study again and again, lets another engine finish it, and compares every byte with one that was left alone.

usage: studies.py COULTER [--short] [--engine parallel|slurm|hyperqueue]

The study has 1000 closed-form cases and 12 runs of the solver on a coarse grid (--short: 100 and 2). One copy runs without interruption.
The other is killed 20 times (--short: 4), at random moments, while the pool of this machine runs it up to its middle; the engine runs
what is left. Tables, page and outcomes must be the same to the byte. Without --engine GNU parallel is taken, where it is not installed one
process after the other. Unless --short, it also prints the overhead: processor time of `coulter sweep run` over that of `coulter run`, for
cases of about a second; on a machine that does nothing else.
"""
import json
import random
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COULTER = str(Path(sys.argv[1]).resolve())
SHORT = "--short" in sys.argv
ENGINE = sys.argv[sys.argv.index("--engine") + 1] if "--engine" in sys.argv else None
POINTS, RUNS, KILLS = (100, 2, 4) if SHORT else (1000, 12, 20)
COARSE = """
"grid.cell" = "25 mm"
"body.disc.sinkage" = "10 mm"
"body.disc.forward" = { speed = "0.2 m/s", ramp = "0.02 s" }
"body.disc.heave" = { load = "0 N", ramp = "0.02 s" }
"run.tow_distance" = "%s"
"output.checkpoint_interval" = "0.2 s"
"output.field_interval" = "1 s"
"""
STUDY = f"""format = 2
case = "disc.toml"

[factor.phi]
key = "soil.friction_angle"
range = ["30 deg", "40 deg"]

[factor.weight]
key = "body.disc.weight"
range = ["20 N", "80 N"]

[part.closed]
design = "sobol"
points = {POINTS}

[part.runs]
models = "solver"
design = "latin-hypercube"
points = {RUNS}
[part.runs.set]
{COARSE % "0.05 m"}
"""


def coulter(folder, *arguments):
    """Runs a command and expects it to succeed."""
    done = subprocess.run([COULTER, *map(str, arguments)], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"coulter {' '.join(map(str, arguments))}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def results(folder):
    """Every collected file of a study, and its outcomes."""
    named = ["table.csv", "table.parquet", "without_results.csv", "report.html", "cases.jsonl"]
    found = [folder / name for name in named]
    for inner in ["tables", "charts", "outcomes"]:
        # A process that was killed while it wrote leaves a part, which nobody reads.
        found += sorted(path for path in (folder / inner).iterdir() if path.suffix != ".part")
    return {str(path.relative_to(folder)): path.read_bytes() for path in found}


def outcomes(folder):
    return len(list((folder / "outcomes").glob("*.json"))) if (folder / "outcomes").is_dir() else 0


def kill_again_and_again(folder, name, longest):
    """Starts the pool and kills it, until half of the cases have an outcome or it has been killed often enough; it runs for `longest`
    seconds at most."""
    random.seed(1)
    total, kills = POINTS + RUNS, 0
    while kills < KILLS:
        child = subprocess.Popen([COULTER, "sweep", "run", name], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + random.uniform(0.02, longest)
        # However fast the machine is, the other half is left for the other engine.
        while time.monotonic() < end and (longest == 0.02 or outcomes(folder / name) <= total // 2):
            time.sleep(0.002)
        child.kill()
        child.wait()
        kills += 1
        if outcomes(folder / name) > total // 2:
            longest = 0.02
    return kills, outcomes(folder / name)


def finish(folder, name):
    """Lets another engine run what is left; returns what it was."""
    left = coulter(folder, "sweep", "script", name, "--for", "ids").split()
    engine = ENGINE or ("parallel" if shutil.which("parallel") else None)
    if engine is None:
        for start in range(0, len(left), 20):
            coulter(folder, "sweep", "run", name, "--id", ",".join(left[start : start + 20]))
        return "one process after the other", len(left)
    script = coulter(folder, "sweep", "script", name, "--for", engine, "--chunk", 20)
    path = folder / "study.sh"
    path.write_text(script)
    command = ["sbatch", "--wait", path.name] if engine == "slurm" else ["sh", path.name]
    if engine == "slurm":
        path.write_text(script.replace("#!/bin/bash\n", "#!/bin/bash\n#SBATCH --chdir=" + str(folder) + "\n"))
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{engine}: {done.returncode}\n{done.stdout}{done.stderr}")
    while engine == "hyperqueue" and coulter(folder, "sweep", "script", name, "--for", "ids"):
        time.sleep(0.2)
    return engine, len(left)


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def overhead(folder):
    """Processor time of a sweep over that of the same cases with `coulter run`, less one, and seconds per case: the median of pairs."""
    count = 10
    text = STUDY.split("[part.closed]")[0] + "[part.runs]\nmodels = \"solver\"\ndesign = \"sobol\"\n"
    text += f"points = {count}\n[part.runs.set]\n{COARSE % '0.012 m'}\n"
    (folder / "timed.toml").write_text(text)
    shares, alone = [], 0.0
    for turn in range(7):
        shutil.rmtree(folder / "timed", ignore_errors=True)
        coulter(folder, "sweep", "expand", "timed.toml", "-o", "timed")
        before = processor_time()
        coulter(folder, "sweep", "run", "timed", "--workers", 1)
        swept = processor_time() - before
        for number, line in enumerate((folder / "timed" / "cases.jsonl").read_text().splitlines()):
            sets = [word for one in json.loads(line)["set"] for word in ("--set", one)]
            coulter(folder, "run", "disc.toml", "-o", f"alone{turn}_{number}", "--threads", 1, *sets)
        alone = processor_time() - before - swept
        shares.append(swept / alone - 1.0)
    return statistics.median(shares), alone / count


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        shutil.copy(ROOT / "cases" / "light_disc.toml", folder / "disc.toml")
        (folder / "study.toml").write_text(STUDY)
        start = time.monotonic()
        coulter(folder, "sweep", "study.toml", "-o", "whole")
        # However fast the machine is, the pool gets somewhere before it is killed.
        longest = (1.3 if SHORT else 0.2) * (time.monotonic() - start)
        coulter(folder, "sweep", "expand", "study.toml", "-o", "killed")
        kills, ended = kill_again_and_again(folder, "killed", longest)
        engine, left = finish(folder, "killed")
        coulter(folder, "sweep", "collect", "killed")
        whole, killed = results(folder / "whole"), results(folder / "killed")
        differing = [path for path in sorted(whole.keys() | killed.keys()) if whole.get(path) != killed.get(path)]
        print(f"{POINTS + RUNS} cases: killed {kills} times, {ended} outcomes by then, {left} by {engine}")
        print(f"{len(whole)} files, {len(differing)} of them differ {differing[:5] if differing else ''}")
        if not SHORT:
            share, seconds = overhead(folder)
            print(f"overhead of a sweep: {100 * share:+.2f} % at {seconds:.2f} s per case")
        if differing:
            sys.exit(1)


main()
