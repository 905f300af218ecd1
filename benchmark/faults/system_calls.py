"""Runs of a program: limits, a log of its system calls, and faults at chosen calls. The log is written by strace,
which also makes the calls fail."""
import collections
import dataclasses
import os
import re
import resource
import shutil
import signal
import subprocess
import time

WRITES = ("write", "writev", "pwrite64", "pwritev")
CALLS = WRITES + tuple(
    "read readv pread64 openat open creat close sendfile copy_file_range ftruncate fallocate rename renameat renameat2 "
    "unlink unlinkat mkdir mkdirat rmdir link linkat symlink symlinkat lseek fsync fdatasync syncfs sync flock".split()
)
LONGEST = 30.0  # seconds of a run

_line = re.compile(r"(\d+) +(\w+)\((.*)\) += (-?\d+|\?)(.*)$")
_start = re.compile(r"(\d+) +(\w+)\((.*) <unfinished \.\.\.>$")
_end = re.compile(r"(\d+) +<\.\.\. \w+ resumed>(.*)$")
_hex = r"((?:\\x[0-9a-f]{2})*)"
_text = re.compile(f'"{_hex}"')
_place = re.compile(rf"(?:\b\d+|AT_FDCWD)<{_hex}>")


@dataclasses.dataclass
class Outcome:
    status: int
    err: str
    out: str
    seconds: float
    calls: list

    @property
    def injected(self):
        return [call for call in self.calls if call.injected]


@dataclasses.dataclass
class Call:
    process: int
    name: str
    number: int  # of the calls of this name in this process
    arguments: str
    result: int
    error: str
    injected: bool
    texts: list  # arguments that are paths or data
    places: list  # paths of the descriptors
    folder: str  # working folder of the program

    @property
    def failed(self):
        return self.result < 0

    @property
    def path(self):
        """The file that the call opens, reads, changes or writes."""
        at = self.name in ("openat", "unlinkat", "mkdirat", "renameat", "renameat2")
        if at or self.name in ("open", "creat", "unlink", "mkdir", "rmdir", "rename"):
            text = self.texts[0].decode(errors="surrogateescape") if self.texts else ""
            return os.path.normpath(os.path.join(self.places[0] if at and self.places else self.folder, text))
        return self.places[0] if self.places else ""

    @property
    def target(self):
        """The new name of a renamed file."""
        at = self.places[1] if len(self.places) > 1 else self.folder
        return os.path.normpath(os.path.join(at, self.texts[1].decode(errors="surrogateescape")))

    @property
    def creates(self):
        return self.name == "creat" or (self.name in ("open", "openat") and "O_CREAT" in self.arguments)


def _bytes(text):
    return bytes.fromhex(text.replace("\\x", ""))


def read_log(path, folder):
    """Returns the calls in the order in which they ended."""
    calls, begun, numbers = [], {}, collections.Counter()
    with open(path, encoding="latin-1") as log:
        for line in log:
            line = line.rstrip("\n")
            if start := _start.match(line):
                numbers[start[1], start[2]] += 1
                begun[start[1]] = (start[2], start[3], numbers[start[1], start[2]])
                continue
            if end := _end.match(line):
                name, arguments, number = begun.pop(end[1], ("?", "", 0))
                whole = _line.match(f"{end[1]} {name}({arguments}{end[2]}")
            elif whole := _line.match(line):
                numbers[whole[1], whole[2]] += 1
                number = numbers[whole[1], whole[2]]
            if not whole or whole[4] == "?":
                continue
            places = [_bytes(place).decode(errors="surrogateescape") for place in _place.findall(whole[3])]
            calls.append(
                Call(int(whole[1]), whole[2], number, whole[3], int(whole[4]), whole[5], "(INJECTED)" in whole[5],
                     [_bytes(text) for text in _text.findall(whole[3])], places, folder)
            )
    return calls


def can_trace():
    """Returns whether strace is installed and may trace and inject faults."""
    if not shutil.which("strace"):
        return False
    test = ["strace", "-f", "--seccomp-bpf", "-o", os.devnull, "-e", "trace=fsync", "true"]
    return subprocess.run(test, capture_output=True).returncode == 0


def _preparation(limits):
    def set_limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        for limit, size in limits.items():
            resource.setrlimit(limit, (size, size))

    return set_limits


def run(command, folder, *, log=None, faults=(), data=False, limits=None, at_stop=None, env=None, out=subprocess.PIPE):
    """Runs a command. With `log`, its system calls are written there, with all data if `data`, and `faults` are
    options of strace like "write:error=EIO:when=3". `at_stop()` is called when such a fault stops the process."""
    if log:
        options = [option for fault in faults for option in ("-e", f"inject={fault}")]
        size = str(1 << 26) if data else "4096"
        trace = ["strace", "-f", "-y", "-xx", "-s", size, "-o", log, "-e", "trace=" + ",".join(CALLS)]
        if not any(":signal=" in fault for fault in faults):
            trace.append("--seccomp-bpf")  # faster, but strace then sends no signals
        command = [*trace, *options, *command]
        open(log, "w").close()
    begin = time.monotonic()
    process = subprocess.Popen(
        command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.PIPE, env=env,
        start_new_session=True, preexec_fn=_preparation(limits or {}),
    )
    try:
        if at_stop:
            _wait_for_stop(process, log, at_stop)
        text, err = process.communicate(timeout=max(1.0, LONGEST - (time.monotonic() - begin)))
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        text, err = process.communicate()
        status = "hangs"
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
    seconds = time.monotonic() - begin
    calls = read_log(log, folder) if log else []
    return Outcome(status, err.decode(errors="replace"), (text or b"").decode(errors="replace"), seconds, calls)


def _wait_for_stop(process, log, at_stop):
    """Calls `at_stop()` at the first stop, and continues all processes that are stopped until the run ends."""
    end, last, stopped = time.monotonic() + LONGEST, "", False
    with open(log, encoding="latin-1") as lines:
        while time.monotonic() < end and process.poll() is None:
            last += lines.readline()
            if not last.endswith("\n"):
                time.sleep(0.001)
                continue
            if "--- stopped by SIGSTOP" in last:
                if not stopped:
                    at_stop()
                stopped = True
                os.kill(int(last.split()[0]), signal.SIGCONT)
            last = ""
