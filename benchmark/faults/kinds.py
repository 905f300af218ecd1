"""The faults: each function meets a case with one kind of fault, at several places."""
import itertools
import os
import pathlib
import random
import resource
import shlex
import shutil
import signal
import subprocess
import time

from . import judge, power_loss
from .system_calls import LONGEST, WRITES, run


def spread(items, number):
    """Returns at most `number` items, evenly spread, with the first and the last one."""
    items = list(items)
    if len(items) <= number:
        return items
    return [items[round(i * (len(items) - 1) / max(1, number - 1))] for i in range(number)]


class Trial:
    """A case with its state before the run and after an undisturbed run."""

    def __init__(self, case, bench):
        self.case, self.bench = case, bench
        self.env = dict(bench.env, TMPDIR=bench.root) if case.prefix else bench.env  # mpirun needs more than a page
        self.folder, self.log = bench.folder, bench.log
        bench.write_inputs(self.folder)
        for before in case.before:
            outcome = run(self.command(before, prefix=[]), self.folder, env=self.env)
            assert outcome.status == 0, f"{case.name}: {before}: {outcome.err}"
        self.old = judge.snapshot(self.folder)
        self.traced = bench.traces and not case.prefix
        self.first = self.run_once(log=self.log if self.traced else None, data=True)
        assert self.first.status == 0, f"{case.name}: {case.run}: {self.first.err}"
        self.new = judge.snapshot(self.folder)
        assert self.run_once().status == 0, case.name
        again = judge.snapshot(self.folder)
        self.stable = {n for n, content in again.items() if content == self.new.get(n)}  # reports contain times
        self.temporary = self.temporary_names(self.first)
        written = shlex.split(case.run)
        self.results = {n for n in self.new if n not in self.old or self.old[n] != self.new[n] or n in written[2:]}

    def command(self, arguments=None, prefix=None):
        case = self.case
        arguments = case.run if arguments is None else arguments
        if case.python:
            return [self.bench.python, "-c", arguments]
        prefix = case.prefix if prefix is None else prefix
        return [*prefix, self.bench.program, *shlex.split(arguments)]

    @property
    def names(self):
        """Names that a user of the command knows: files of the command line, and files of its results."""
        if self.case.python:
            return []
        words = [word for word in shlex.split(self.case.run) if "." in word or word.startswith("o")]
        return words + [os.path.basename(place) for place in self.new]

    def run_once(self, arguments=None, **options):
        judge.restore(self.old, self.folder)
        if self.case.prefix:
            options.pop("log", None)
        return run(self.command(arguments), self.folder, env=self.env, **options)

    def inside(self, path):
        return path == self.folder or path.startswith((self.folder + "/", self.bench.elsewhere + "/"))

    def temporary_names(self, outcome):
        """Returns the files that a run created and that are no results."""
        made = [c for c in outcome.calls if c.creates and not c.failed and self.inside(c.path)]
        created = {os.path.relpath(c.path, self.folder) for c in made}
        return sorted(n for n in created - set(self.old) - set(self.new) if not judge.RESCUED.fullmatch(n))

    def check(self, kind, place, outcome, *, names=False, **options):
        """Judges a run and the folder after it."""
        faults = judge.faults_of_messages(
            outcome, names=self.names if names else (), python=self.case.python, prefixed=bool(self.case.prefix),
            temporary={os.path.basename(n) for n in self.temporary_names(outcome)}
            - {os.path.basename(n) for n in self.new} - {"output", "messages"},
            elsewhere=self.bench.elsewhere if names else "",
        )  # fmt: skip
        if outcome.status == 0 and outcome.out != self.first.out:
            faults.append(("status 0, but the output differs", outcome.out[-200:]))
        now = judge.snapshot(self.folder)
        faults += judge.faults_of_files(self.old, self.new, now, results=self.results, complete=None if outcome.status else self.stable, **options)
        left = self.bench.left_elsewhere()
        prevented = any(c.name.startswith("unlink") or "O_DIRECTORY" in c.arguments for c in outcome.injected)
        faults += [] if prevented else left
        self.bench.record(kind, self.case, place, faults, outcome.seconds)
        return now


def full_disk(trial, points):
    """Fills the disk so that some pages are left, and limits the number of files."""
    bench = trial.bench
    if not bench.is_small_disk:
        return
    size = lambda state: sum(-(-len(content) // 4096) for content in state.values() if isinstance(content, bytes))
    largest = max([-(-len(c) // 4096) for c in trial.new.values() if isinstance(c, bytes)])
    need = max(0, size(trial.new) - size(trial.old)) + largest + 1
    for free in spread(range(need), points):
        with bench.filled(free, trial):
            outcome = run(trial.command(), trial.folder, env=trial.env)
        trial.check("full disk", f"{free} free pages", outcome, names=True)


INJECTED = [  # kind, calls, errors
    ("ENOSPC at a write", WRITES, "ENOSPC"),
    ("EIO at a write", WRITES, "EIO"),
    ("EIO at fsync", ("fsync", "fdatasync"), "EIO"),
    ("EIO at close", ("close",), "EIO"),
    ("EIO at rename", ("rename", "renameat", "renameat2"), "EIO"),
    ("EIO at a read", ("read", "readv", "pread64"), "EIO"),
    ("EIO at unlink", ("unlink", "unlinkat"), "EIO"),
    ("ENOSPC at open", ("openat", "open", "creat", "mkdir"), "ENOSPC"),
    ("EMFILE at open", ("openat", "open", "creat"), "EMFILE"),
    ("ENOLCK at flock", ("flock",), "ENOLCK"),
]


def _places(trial, names):
    """Returns the successful calls of these names on files of the folder or on temporary files."""
    return [c for c in trial.first.calls if c.name in names and not c.failed and trial.inside(c.path)]


def failing_calls(trial, points):
    """Makes single system calls fail."""
    for kind, names, error in INJECTED if trial.traced else []:
        calls = _places(trial, names)
        if kind == "ENOSPC at open":
            calls = [c for c in calls if c.creates or c.name == "mkdir"]
        for call in spread(calls, points):
            fault = f"{call.name}:error={error}:when={call.number}"
            outcome = trial.run_once(log=trial.log, faults=[fault])
            where = f"{call.name} {call.number} ({os.path.relpath(call.path, trial.folder)})"
            hit = outcome.injected
            if not hit or any(not trial.inside(c.path) for c in hit):
                continue  # another process of the run has other calls
            trial.check(kind, where, outcome, names=True, ignored=_not_removed(outcome, trial))
            if kind == "EIO at a read" and outcome.status and not any(w in outcome.err for w in ("cannot read", "Input/output")):
                trial.bench.complain(kind, trial.case, where, "an error does not tell that reading failed", outcome.err)


def _not_removed(outcome, trial):
    """Returns the files whose removal the fault prevented."""
    return [os.path.relpath(c.path, trial.folder) for c in outcome.injected if c.name in ("unlink", "unlinkat")]


def stopped_processes(trial, points):
    """Kills the run, or removes its folder, when it begins a system call on a file."""
    if not trial.traced:
        return
    names = (*WRITES, "openat", "rename", "renameat", "fsync", "close", "mkdir", "unlink", "flock")
    calls = _places(trial, names)
    last = max((i for i, c in enumerate(calls) if c.name.startswith("rename")), default=-1)
    for call in spread(calls, points):
        where = f"{call.name} {call.number} ({os.path.relpath(call.path, trial.folder)})"
        outcome = trial.run_once(log=trial.log, faults=[f"{call.name}:signal=SIGKILL:when={call.number}"])
        if outcome.status in (-9, 137):
            now = judge.snapshot(trial.folder)
            faults = judge.faults_of_files(trial.old, trial.new, now, results=trial.results, killed=True)
            faults += _next_run(trial, now)
            trial.bench.left_elsewhere()
            trial.bench.record("SIGKILL, and the next run", trial.case, where, faults, outcome.seconds)
        if call not in calls[: last + 1]:
            continue  # all results were there when the folder was removed
        gone = "o" if "--output o " in trial.case.run else "."
        judge.restore(trial.old, trial.folder)
        outcome = run(
            trial.command(), trial.folder, env=trial.env, log=trial.log,
            faults=[f"{call.name}:signal=SIGSTOP:when={call.number}"],
            at_stop=lambda: shutil.rmtree(os.path.join(trial.folder, gone), ignore_errors=True),
        )  # fmt: skip
        if gone == ".":
            faults = judge.faults_of_messages(outcome, python=trial.case.python)
            trial.bench.record("removed folder", trial.case, where, faults, outcome.seconds)
        else:
            trial.check("removed folder", where, outcome, names=True, ignored=["o"] if outcome.status else [])


def _next_run(trial, now):
    """Returns what is wrong with the run after a killed one: it continues a checkpoint if there is one."""
    arguments = trial.case.run
    if "o/checkpoint.dsc" in now and "--output o " in arguments and "--resume" not in arguments:
        command = shlex.split(arguments)[0]
        arguments = f"{command} --resume o/checkpoint.dsc --steps 1 --output o"
        if command == "grains":
            arguments += "2"  # it needs another folder
    outcome = run(trial.command(arguments), trial.folder, env=trial.env)
    if outcome.status != 0:
        is_new = "contains the steps of another run" in outcome.err  # the killed run had begun them
        return [] if is_new else [("the run after a killed one fails", outcome.err[-300:])]
    if "o2" in arguments:
        return []
    left = judge.snapshot(trial.folder)
    names = [n for n in left if n not in now and n not in trial.new and judge.TEMPORARY.search(n)]
    names += [n for n in now if n in left and n not in trial.old and n not in trial.new]
    return [("the run after a killed one leaves a temporary file of it", n) for n in names]


def planted_links(trial, _):
    """Plants links at the names of temporary files of an earlier run, and at names that can be guessed."""
    guessed = []
    for place in trial.new:
        stem, extension = os.path.splitext(place)
        guessed += [f"{stem}.partial{extension}", f"{stem}.partial~{extension}", f"{stem}.tmp{extension}"]
        guessed += [place + end for end in (".probe", ".tmp", ".part", ".lock", "~")]
    planted = [n for n in dict.fromkeys(trial.temporary + guessed) if not n.startswith("..") and n not in trial.old and n not in trial.new]
    victim = pathlib.Path(trial.folder + "_victim")
    made = pathlib.Path(trial.folder + "_made")
    for kind, target in ("a file", victim), ("nothing", made), ("a folder", pathlib.Path(trial.folder).parent):
        judge.restore(trial.old, trial.folder)
        victim.write_text("precious")
        made.unlink(missing_ok=True)
        for name in planted:
            if os.path.isdir(os.path.dirname(os.path.join(trial.folder, name)) or "."):
                os.symlink(target, os.path.join(trial.folder, name))
        outcome = run(trial.command(), trial.folder, env=trial.env)
        faults = [("a file behind a planted link is changed", kind)] if victim.read_text() != "precious" else []
        faults += [("a file behind a planted link is made", kind)] if made.exists() else []
        for name in planted:  # the links are not results
            if os.path.islink(os.path.join(trial.folder, name)):
                os.unlink(os.path.join(trial.folder, name))
        now = judge.snapshot(trial.folder)
        faults += judge.faults_of_files(trial.old, trial.new, now, results=trial.results, complete=None if outcome.status else trial.stable)
        faults += judge.faults_of_messages(outcome, python=trial.case.python, prefixed=bool(trial.case.prefix))
        trial.bench.record("planted links", trial.case, f"to {kind}", faults, outcome.seconds)
    if trial.traced:
        again = trial.temporary_names(trial.run_once(log=trial.log))
        faults = [("the name of a temporary file can be foreseen", n) for n in set(again) & set(trial.temporary) if not n.endswith("lock")]
        trial.bench.record("planted links", trial.case, "names of two runs", faults, 0)


def limits(trial, points):
    """Limits the memory, the size of a file, and the number of open files."""
    if trial.case.prefix or trial.case.python or trial.case.slow:
        return
    command = trial.case.run.replace("--threads 1", "--threads 2")
    largest = max(len(content) for content in trial.new.values() if isinstance(content, bytes))
    sizes = [largest * i // (points // 2) for i in range(points // 2)]
    for name, limit, values in (
        ("ulimit -v", resource.RLIMIT_AS, trial.bench.memory_sizes(trial, command, points // 2)),
        ("ulimit -f", resource.RLIMIT_FSIZE, sizes),
        ("ulimit -n", resource.RLIMIT_NOFILE, [64, 16, 8, 6, 5, 4, 3][:points]),
    ):
        for value in values:
            outcome = trial.run_once(command, limits={limit: value})
            if "error while loading shared libraries" in outcome.err:
                continue  # the program did not start
            trial.check(name, str(value), outcome, names=name == "ulimit -f")


def lost_power(trial, _):
    """Replays the calls of the undisturbed run, and cuts them after each one."""
    if not trial.traced:
        return
    for number, kind, faults in power_loss.replay(
        trial.first.calls, trial.old, trial.new, trial.folder,
        lambda now: judge.faults_of_files(trial.old, trial.new, now, results=trial.results, killed=True),
    ):  # fmt: skip
        call = trial.first.calls[number] if number < len(trial.first.calls) else None
        where = f"{kind}, after {call.name} {os.path.relpath(call.path, trial.folder)}" if call else kind
        trial.bench.record("power loss", trial.case, where, faults, 0)


PAIRS = [  # name, run before, first run, second run
    ("one folder", "", "offset tet.off --distance 0.01 --steps 2 --output o --report a.json", "offset tet.off --distance 0.02 --steps 3 --output o --report b.json"),
    ("one folder, continued", "offset tet.off --distance 0.01 --steps 1 --output o", "offset --resume o/checkpoint.dsc --steps 1 --output o", "offset --resume o/checkpoint.dsc --distance 0.02 --steps 2 --output o"),
    ("one folder and report", "", "mean-curvature square.wkt --steps 3 --output o --report r.json", "mean-curvature square.wkt --dt 0.001 --steps 4 --output o --report r.json"),
    ("one folder of grains", "", "grains --number 8 --edges 5 --steps 2 --every 1 --output o", "grains --number 8 --edges 5 --seed 2 --steps 2 --every 1 --output o"),
    ("one folder of fluids", "", "fluid drop2.json --steps 2 --output o", "fluid drop2.json --steps 4 --output o"),
    ("one folder of points", "", "reconstruct points.xyz -o a.off --output o", "reconstruct points.xyz -o b.off --tolerance 0.05 --output o"),
    ("one file", "convert octahedron.off k.off", "convert octahedron.off k.off", "convert tet.off k.off"),
    ("one report", "", "offset tet.off --distance 0.01 --steps 2 --report r.json", "offset tet.off --distance 0.02 --steps 3 --report r.json"),
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
        processes.append(subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True))
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


OF_CASES = [full_disk, failing_calls, stopped_processes, planted_links, limits, lost_power]
