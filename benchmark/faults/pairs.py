"""Two runs at once that write into one folder or one file."""
import itertools
import os
import random
import shlex
import signal
import subprocess
import time

from . import judge
from .system_calls import LONGEST, run

OFFSET = "offset tet.off --distance 0.01"
PAIRS = [  # name, run before, first run, second run
    ("one folder", "", f"{OFFSET} --steps 2 --output o --report a.json",
     "offset tet.off --distance 0.02 --steps 3 --output o --report b.json"),
    ("one folder, continued", f"{OFFSET} --steps 1 --output o", "offset --resume o/checkpoint.dsc --steps 1 --output o",
     "offset --resume o/checkpoint.dsc --distance 0.02 --steps 2 --output o"),
    ("one folder and report", "", "mean-curvature square.wkt --dt 0.0005 --steps 3 --output o --report r.json",
     "mean-curvature square.wkt --dt 0.001 --steps 4 --output o --report r.json"),
    ("one folder of grains", "", "grains --number 8 --edges 5 --steps 2 --every 1 --output o",
     "grains --number 8 --edges 5 --seed 2 --steps 2 --every 1 --output o"),
    ("one folder of fluids", "", "fluid drop2.json --steps 2 --output o", "fluid drop2.json --steps 4 --output o"),
    ("one folder of points", "", "reconstruct points.xyz -o a.off --output o",
     "reconstruct points.xyz -o b.off --tolerance 0.05 --output o"),
    ("one file", "convert octahedron.off k.off", "convert octahedron.off k.off", "convert tet.off k.off"),
    ("one report", "", f"{OFFSET} --steps 2 --report r.json",
     "offset tet.off --distance 0.02 --steps 3 --report r.json"),
]  # fmt: skip


def two_processes(bench, tries):
    """Starts two runs at once that write into one folder or one file: all files must be of one run."""
    for name, before, *runs in PAIRS:
        commands = [_alone(bench, r) for r in runs]
        bench.write_inputs(bench.folder)
        if before:
            assert run(_alone(bench, before), bench.folder).status == 0
        old, results, seconds = judge.snapshot(bench.folder), {}, 0
        for order in ((0,), (1,), (0, 1), (1, 0)):
            judge.restore(old, bench.folder)
            outcomes = [run(commands[i], bench.folder) for i in order]
            if all(o.status == 0 for o in outcomes):
                results[order] = judge.snapshot(bench.folder)
            seconds = max(seconds, outcomes[0].seconds)
        generator = random.Random(1)
        for number in range(tries):
            delay = generator.uniform(0, 1.1) * seconds
            order = (0, 1) if number % 2 else (1, 0)
            judge.restore(old, bench.folder)
            outcomes = _at_once([commands[i] for i in order], delay, bench.folder)
            winners = tuple(i for i, o in zip(order, outcomes) if o.status == 0)
            faults = _mixed(results, winners, judge.snapshot(bench.folder))
            faults += list(itertools.chain.from_iterable(judge.faults_of_messages(o) for o in outcomes))
            bench.record("two processes", None, f"{name}, {delay * 1000:.0f} ms", faults, 0)


def _alone(bench, arguments):
    threads = [] if arguments.startswith("convert") else ["--threads", "1"]
    return [bench.program, *shlex.split(arguments), *threads, "--quiet"]


def _at_once(commands, delay, folder):
    processes, begin = [], time.monotonic()
    for command in commands:
        processes.append(
            subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, start_new_session=True)
        )  # fmt: skip
        if len(processes) == 1:
            time.sleep(delay)
    outcomes = []
    for process in processes:
        try:
            _, err = process.communicate(timeout=LONGEST)
            status = process.returncode
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            _, err = process.communicate()
            status = "hangs"
        outcomes.append(judge.Messages(status, err.decode(errors="replace"), time.monotonic() - begin))
    return outcomes


def _mixed(results, winners, now):
    """Returns what is wrong with the files after two runs: they must be what the runs that succeeded leave alone,
    one after the other."""
    possible = [r for order, r in results.items() if set(order) == set(winners)]
    if not possible:
        return [("both runs write into one folder" if winners else "both runs are refused", "")]

    def differences(result):
        return [n for n in sorted(set(result) | set(now)) if not _same(n, result.get(n, 0), now.get(n, 0))]

    different = min(map(differences, possible), key=len)
    return [("a result is not of the run that succeeded", n) for n in different]


def _same(name, first, second):
    return first == second or (name.endswith(".json") and first and second and judge.same_run(first, second))
