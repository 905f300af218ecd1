#!/usr/bin/env python3
"""Runs each command of the program on disks, in folders and beside processes that fail.

Usage: benchmark/edge.py [options] PROGRAM

The faults: a full disk, system calls that fail, a folder that is removed, SIGKILL, links that are planted at names of
temporary files, two processes at once, limits of memory, of the size of files and of open files, and a loss of power
after each system call. After each run, every file must have its previous content or be whole, no temporary file
may be left, and an error must be one line that names a file of the command. strace logs system calls and makes them
fail; root may mount a small file system in memory, which becomes full.

Prints the number of tries and of failures for each kind of fault. Ends with status 1 if there is a failure, and with
77 if faults cannot be injected.
"""
import argparse
import collections
import contextlib
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

from faults import cases, judge, kinds, pairs, system_calls


class Bench:
    """What all trials share: the program, a folder on a small disk, and the counts."""

    def __init__(self, options, root):
        self.program, self.python, self.root = os.path.abspath(options.program), sys.executable, root
        self.folder, self.log = os.path.join(root, "disk", "run"), os.path.join(root, "log")
        self.traces = system_calls.can_trace()
        self.env = dict(os.environ, LC_ALL="C", ASAN_OPTIONS="detect_leaks=0")
        if options.python:
            self.env["PYTHONPATH"] = options.python
        self.is_quick = options.quick
        self.report = options.failures and open(options.failures, "a", buffering=1)
        self.tries, self.failures, self.slowest = collections.Counter(), collections.Counter(), 0.0
        self.complaints = collections.defaultdict(list)
        self.elsewhere = os.path.join(root, "disk", "tmp")  # for temporary files of the program
        os.makedirs(os.path.dirname(self.folder))
        mount = ["mount", "-t", "tmpfs", "-o", "size=64m", "tmpfs", os.path.join(root, "disk")]
        self.is_small_disk = subprocess.run(mount, capture_output=True).returncode == 0
        os.mkdir(self.elsewhere)
        self.env["TMPDIR"] = self.elsewhere

    def close(self):
        if self.is_small_disk:
            subprocess.run(["umount", "-l", os.path.join(self.root, "disk")])

    def left_elsewhere(self):
        """Removes the temporary files of a run, and returns them as faults."""
        left = os.listdir(self.elsewhere)
        judge.restore({}, self.elsewhere)
        return [("a temporary file is left", f"$TMPDIR/{name}") for name in left]

    def write_inputs(self, folder):
        judge.restore({}, folder)
        cases.write_inputs(folder)

    @contextlib.contextmanager
    def filled(self, pages, trial):
        """Restores the files of a trial on a disk that has a number of free pages."""
        judge.restore(trial.old, trial.folder)
        ballast = os.path.join(self.root, "disk", "ballast")
        disk = os.statvfs(self.root + "/disk")
        with open(ballast, "wb") as file:
            os.posix_fallocate(file.fileno(), 0, max(1, disk.f_bfree * disk.f_bsize // 4096 - pages) * 4096)
        try:
            yield
        finally:
            os.unlink(ballast)

    def memory_sizes(self, trial, command, number):
        """Returns limits of memory from the least that starts the program to the least that suffices."""

        def least(first, last, starts):
            while last - first > first // 50 + (1 << 20):
                middle = (first + last) // 2
                first, last = (first, middle) if starts(middle) else (middle, last)
            return last

        def starts(size):
            limits = {resource.RLIMIT_AS: size}
            return system_calls.run([self.program, "--help"], trial.folder, limits=limits).status == 0

        first = least(1 << 20, 1 << 30, starts)
        last = least(first, 1 << 33, lambda n: trial.run_once(command, limits={resource.RLIMIT_AS: n}).status == 0)
        return [first + (last - first) * i // number for i in range(number + 1)]

    def record(self, kind, case, place, faults, seconds):
        self.tries[kind] += 1
        self.failures[kind] += bool(faults)
        self.slowest = max(self.slowest, seconds)
        for complaint, detail in faults:
            places = self.complaints[kind, complaint]
            places.append(f"{case.name if case else 'pair'}: {place}: {detail}".strip())
            if self.report and len(places) <= 40:
                self.report.write(f"{kind} | {complaint} | {places[-1]!r}\n")

    def print_table(self, examples):
        print(f"{'fault':<28}{'tries':>8}{'failures':>10}")
        for kind, tries in self.tries.items():
            print(f"{kind:<28}{tries:>8}{self.failures[kind]:>10}")
        print(f"{'all':<28}{sum(self.tries.values()):>8}{sum(self.failures.values()):>10}")
        print(f"longest run: {self.slowest:.1f} s")
        worst = sorted(self.complaints.items(), key=lambda item: -len(item[1]))
        for (kind, complaint), places in worst[:examples]:
            print(f"{len(places):6} {kind}: {complaint}")
            for text in places[:3]:
                print(f"         {text!r}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--points", type=int, default=20, help="places of a fault in a run")
    parser.add_argument("--pairs", type=int, default=100, help="tries of each pair of processes")
    parser.add_argument("--python", help="folder of the Python module")
    parser.add_argument("--only", default="", help="regular expression for the names of cases, or pairs")
    parser.add_argument("--faults", default="", help="regular expression for full_disk, failing_calls, ...")
    parser.add_argument("--examples", type=int, default=10, help="complaints to print")
    parser.add_argument("--failures", help="file that gets a line for each failure")
    parser.add_argument("--quick", action="store_true", help="a few seconds")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # removes the folders
    with tempfile.TemporaryDirectory(prefix="dsc_edge_") as root:
        bench = Bench(options, root)
        try:
            if not bench.traces:
                print("strace is missing, or may not trace: install it, or permit ptrace")
                return 77
            run_all(bench, options)
        except (KeyboardInterrupt, SystemExit):
            print("stopped; the table has what was done")
        finally:
            bench.close()
        bench.print_table(options.examples)
        return 1 if sum(bench.failures.values()) else 0


QUICK = ("offset --resume", "improve", "view")


def run_all(bench, options):
    points, tries = (2, 1) if options.quick else (options.points, options.pairs)
    for case in cases.all_cases(options.python):
        if not re.search(options.only, case.name) or (options.quick and case.name not in QUICK):
            continue
        begin, failures = time.monotonic(), sum(bench.failures.values())
        try:
            trial = kinds.Trial(case, bench)
        except AssertionError as error:
            bench.record("no fault", case, "undisturbed", [("the run fails", str(error))], 0)
            continue
        for name, content in trial.new.items():
            if isinstance(content, bytes) and (fault := judge.validate.fault_of(name, content)):
                if not fault.startswith("is neither"):
                    print(f"{case.name}: the undisturbed result {name} {fault}")
        for kind in kinds.OF_CASES:
            if re.search(options.faults, kind.__name__):
                kind(trial, 2 if case.slow else points)
        failures = sum(bench.failures.values()) - failures
        print(f"{case.name}: {failures} failures, {time.monotonic() - begin:.0f} s", flush=True)
    if re.search(options.only, "pairs") and re.search(options.faults, "two_processes"):
        pairs.two_processes(bench, tries)


if __name__ == "__main__":
    sys.exit(main())
