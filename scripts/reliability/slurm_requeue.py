#!/usr/bin/env python3
"""Does a run under SLURM survive its time limit, by scripts/cluster/run.sbatch?

    slurm_requeue.py COULTER [--keep DIR]

As root, beside a SLURM of this one machine (one_node_slurm.sh). One process: the time limit comes, the run writes a checkpoint, the
job is put back into the queue, goes on, and ends; its histories and fields must be those of a run that was left alone, byte for byte.
With a COULTER that is built with `--features mpi` the same with two processes by srun and by mpirun, told by the signal that SLURM
sends before a time limit. A run that is cancelled leaves a checkpoint and is not queued again, nor is a request that is wrong.

Took eight minutes on two cores that others used as well. Exits with 1 if anything is not so. Python 3, standard library only.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/cluster/run.sbatch"
DISC = str(ROOT / "cases/light_disc.toml")
# Half a minute on one core that has nothing else to do; ten seconds.
CASES = {"fine": [DISC, "--set", 'grid.cell="11 mm"'], "coarse": [DISC, "--set", 'grid.cell="14 mm"']}
# How a job ends.
ENDS = ("COMPLETED", "FAILED", "CANCELLED", "TIMEOUT", "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "BOOT_FAIL", "DEADLINE")
problems = []


def complain(what):
    problems.append(what)
    print(f"  FAULT: {what}", flush=True)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def submit(name, case, options=(), launcher=None):
    """Puts a job into the queue."""
    # The last: processes that wait leave their core to others, as here every other program has the same two.
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
    os.environ.update(allowed | ({"LAUNCHER": launcher} if launcher else {}))
    words = ["--cpus-per-task=1", f"--output={name}.log", *options, str(SCRIPT), *case, "-o", name]
    return output("sbatch", "--parsable", *words).strip()


def job(number):
    """What SLURM says of a job."""
    return dict(re.findall(r"(\w+)=(\S*)", output("scontrol", "show", "job", number)))


def is_running_for(name, seconds):
    """Waits until a run has written its first checkpoint, and then as long."""
    first = Path(name) / "checkpoints/last.checkpoint"
    until = time.monotonic() + 60
    while not first.is_file() and time.monotonic() < until:
        time.sleep(0.1)
    time.sleep(seconds)


def ended(number, name):
    """The job when it has ended; it may come back to the queue. SLURM lets it wait there for most of a minute, here some seconds, in
    which what is left of the turn before disappears."""
    until, hurried = time.monotonic() + 240, set()
    while time.monotonic() < until:
        state = job(number)
        if state["JobState"] in ENDS:
            return state
        turn = state.get("Restarts")
        if state["JobState"] == "PENDING" and state["Reason"] == "BeginTime" and turn not in hurried:
            hurried.add(turn)
            subprocess.run(["scontrol", "update", f"JobId={number}", "StartTime=now+5"], capture_output=True, check=False)
        time.sleep(0.5)
    output("scancel", number)
    complain(f"{name}: the job does not end")
    return state


def compare(name, whole):
    # Several processes write the soil in pieces.
    suffixes = {".csv", ".vtr", ".vtp", ".pvd"} if name == "one" else {".csv", ".vtp"}
    files = [p.relative_to(whole) for p in Path(whole).rglob("*") if p.suffix in suffixes]
    for file in files:
        other = Path(name) / file
        if not other.is_file() or other.read_bytes() != (Path(whole) / file).read_bytes():
            complain(f"{name}: {file} differs")
    if len(files) < 3:
        complain(f"{name}: only {len(files)} files")
    return len(files)


def alone(coulter, case):
    """A run that is left alone; its folder has the name of the case."""
    subprocess.run([coulter, "run", *CASES[case], "--threads", "1", "-o", case], capture_output=True, check=True)


def requeued(number, name, case, began):
    """The job has finished after it was stopped, with the results of a run that was left alone."""
    state = ended(number, name)
    text = Path(f"{name}.log").read_text(errors="replace")
    turns = int(state.get("Restarts", 0)) + 1
    resumed = (Path(name) / "run.log").read_text().count("resumed at")
    if (state["JobState"], state["ExitCode"]) != ("COMPLETED", "0:0") or turns < 2 or resumed != turns - 1:
        complain(f"{name}: {state['JobState']} {state['ExitCode']}, {turns} turns, resumed {resumed} times\n{text[-3000:]}")
        return
    print(f"{name}: {turns} turns, {compare(name, case)} files compared, {time.monotonic() - began:.0f} s", flush=True)


def not_requeued(number, name, expected, code):
    state = ended(number, name)
    text = Path(f"{name}.log").read_text(errors="replace")
    if state["JobState"] != expected or state.get("Restarts") != "0" or f"{code}" not in text:
        complain(f"{name}: {state['JobState']} {state['ExitCode']}, {state.get('Restarts')} restarts\n{text[-3000:]}")
        return
    print(f"{name}: {state['JobState']}", flush=True)


def test(coulter):
    has_mpi = "libmpi" in output("ldd", coulter)
    began = time.monotonic()
    # SLURM looks at time limits every half minute.
    number = submit("one", CASES["fine"], ["--time=1", "--signal=B:USR1@55"])
    alone(coulter, "fine")
    requeued(number, "one", "fine", began)
    alone(coulter, "coarse")
    for launcher in ("srun --mpi=pmix --wait=60", "mpirun --bind-to none") if has_mpi else ():
        name, began = launcher.split()[0], time.monotonic()
        number = submit(name, CASES["coarse"], ["--ntasks=2"], launcher)
        is_running_for(name, 1)
        output("scancel", "--batch", "--signal=USR1", number)
        requeued(number, name, "coarse", began)
    number = submit("cancelled", CASES["fine"])
    is_running_for("cancelled", 1)
    output("scancel", number)
    not_requeued(number, "cancelled", "CANCELLED", "stopped with the job")
    not_requeued(submit("wrong", [DISC, "--set", "grid.cel=1"]), "wrong", "FAILED", "ended with 2")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter")
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    coulter = str(Path(arguments.coulter).resolve())
    if not arguments.inside:
        around = str(ROOT / "scripts/reliability/one_node_slurm.sh")
        os.execv(around, [around, sys.executable, __file__, "--inside", *sys.argv[1:]])
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        os.chdir(folder)
        os.environ["COULTER"] = coulter
        test(coulter)
        os.chdir("/")
    print(f"{len(problems)} faults")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
