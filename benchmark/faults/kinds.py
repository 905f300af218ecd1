"""The faults: each function meets a case with one kind of fault, at several places."""
import os
import pathlib
import resource
import shlex
import shutil

from . import judge, power_loss
from .system_calls import WRITES, run


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

    def faults_of_files(self, now, **options):
        return judge.faults_of_files(self.old, self.new, now, results=self.results, **options)

    def check(self, kind, place, outcome, *, names=False, more=(), **options):
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
        faults += self.faults_of_files(now, complete=None if outcome.status else self.stable, **options)
        left = self.bench.left_elsewhere()
        prevented = any(c.name.startswith("unlink") or "O_DIRECTORY" in c.arguments for c in outcome.injected)
        faults += [] if prevented else left
        self.bench.record(kind, self.case, place, [*faults, *more], outcome.seconds)
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
                trial.bench.left_elsewhere()
                continue  # another process of the run has other calls
            faults = []
            is_told = outcome.status == 0 or any(words in outcome.err for words in ("cannot read", "Input/output"))
            if kind == "EIO at a read" and not is_told and not trial.bench.is_quick:
                faults = [("an error does not tell that reading failed", outcome.err)]
            trial.check(kind, where, outcome, names=True, more=faults, ignored=_not_removed(outcome, trial))


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
    released = (i for i, c in enumerate(calls) if c.name == "unlink" and c.path.endswith("/.dsc-lock"))
    last = min(last, next(released, last))  # afterwards, the folder no longer belongs to the run
    for call in spread(calls, points):
        where = f"{call.name} {call.number} ({os.path.relpath(call.path, trial.folder)})"
        outcome = trial.run_once(log=trial.log, faults=[f"{call.name}:signal=SIGKILL:when={call.number}"])
        if outcome.status in (-9, 137):
            now = judge.snapshot(trial.folder)
            faults = trial.faults_of_files(now, killed=True)
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
        command, results = shlex.split(arguments)[0], arguments[arguments.index("--output o ") + len("--output o ") :]
        folder = "o2" if command == "grains" else "o"  # grains need another folder
        results = results.replace("--edge-per-thickness 0", "").replace("--edges 5", "")
        arguments = f"{command} --resume o/checkpoint.dsc --steps 1 --output {folder} {results}"
    outcome = run(trial.command(arguments), trial.folder, env=trial.env)
    if outcome.status != 0:
        is_new = "contains the steps of another run" in outcome.err  # the killed run had begun them
        return [] if is_new else [("the run after a killed one fails", outcome.err[-300:])]
    if "o2" in arguments:
        return []  # the folder of the killed run is left as it is
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
    names = [n for n in dict.fromkeys(trial.temporary + guessed) if not n.startswith("..")]
    planted = [n for n in names if n not in trial.old and n not in trial.new]
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
        faults += trial.faults_of_files(now, complete=None if outcome.status else trial.stable)
        faults += judge.faults_of_messages(outcome, python=trial.case.python, prefixed=bool(trial.case.prefix))
        trial.bench.record("planted links", trial.case, f"to {kind}", faults, outcome.seconds)
    if trial.traced:
        again = set(trial.temporary_names(trial.run_once(log=trial.log))) & set(trial.temporary)
        faults = [("the name of a temporary file can be foreseen", n) for n in again if not n.endswith("lock")]
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
            if "error while loading shared libraries" in outcome.err or "libgomp: Out of memory" in outcome.err:
                continue  # the program did not start
            trial.check(name, str(value), outcome, names=name == "ulimit -f")


def lost_power(trial, _):
    """Replays the calls of the undisturbed run, and cuts them after each one."""
    if not trial.traced:
        return

    def faults_of(now):
        return trial.faults_of_files(now, killed=True)

    for number, kind, faults in power_loss.replay(trial.first.calls, trial.old, trial.new, trial.folder, faults_of):
        call = trial.first.calls[number] if number < len(trial.first.calls) else None
        where = f"{kind}, after {call.name} {os.path.relpath(call.path, trial.folder)}" if call else kind
        trial.bench.record("power loss", trial.case, where, faults, 0)


OF_CASES = [full_disk, failing_calls, stopped_processes, planted_links, limits, lost_power]
