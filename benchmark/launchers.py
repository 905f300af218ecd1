#!/usr/bin/env python3
"""Measures how runs of several processes end after signals and errors.

Usage: benchmark/launchers.py PROGRAM [TRIES [KINDS [PROCESSES]]]
       benchmark/launchers.py PROGRAM interrupts

PROGRAM is dsc of a build with dsc-mpi. mpirun (Open MPI) starts it with 2 and 5 processes (PROCESSES: 2,5).
Each run is ended TRIES times (default: 20) in each of these ways (KINDS: words with commas), at random
moments and, if one process is hit, on each rank in turn:
- INT, TERM, USR1: the signal is sent to mpirun; INT to its process group, as by a terminal.
- KILL: a rank is killed.
- exception, bad_alloc: an allocation of a rank throws std::runtime_error or std::bad_alloc.
- options: a rank has other options.
Prints for each way the longest time to the end of mpirun, the messages, and whether the checkpoint resumes
to the cells of a run without interruption, bit by bit. Ends with status 1 if an end takes more than 5
seconds, has no message, or a checkpoint does not resume so.

With "interrupts", measures the time from SIGINT to the line that names the checkpoint, and which files the
grace period of mpirun suffices for, on spheres of 14 160 and 99 224 triangles.
"""
import collections
import glob
import os
import random
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

from stopping import sphere

LONGEST = 5.0  # seconds from the fault to the end
STEPS = 12
MOTION = ["--axis", "1,2,3", "--angle", "3"]
INJECTION = r"""
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <sys/time.h>
#include <unistd.h>
namespace {
std::atomic<long> calls{0};
long at = -2; // -1: never
const char* kind = "";
const char* file = "";
void init() {
  char exe[4096] = "";
  const char* rank = getenv("OMPI_COMM_WORLD_RANK");
  const char* chosen = getenv("FAULT_RANK");
  at = -1;
  if (readlink("/proc/self/exe", exe, sizeof exe - 1) < 0 || strstr(exe, "dsc-mpi") == nullptr ||
      rank == nullptr || chosen == nullptr || strcmp(rank, chosen) != 0)
    return;
  file = getenv("FAULT_FILE");
  kind = getenv("FAULT_KIND");
  at = atol(getenv("FAULT_AT"));
}
struct Count {
  ~Count() {
    if (strcmp(kind, "count") == 0)
      if (FILE* out = fopen(file, "w")) {
        fprintf(out, "%ld", calls.load());
        fclose(out);
      }
  }
} count;
} // namespace
void* operator new(std::size_t size) {
  if (at == -2)
    init();
  if (at >= 0 && calls++ == at && strcmp(kind, "count") != 0) {
    timeval now;
    gettimeofday(&now, nullptr);
    if (FILE* out = fopen(file, "w")) {
      fprintf(out, "%.6f", now.tv_sec + 1e-6 * now.tv_usec);
      fclose(out);
    }
    if (strcmp(kind, "bad_alloc") == 0)
      throw std::bad_alloc();
    throw std::runtime_error("injected error");
  }
  if (void* result = malloc(size))
    return result;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { free(p); }
void operator delete(void* p, std::size_t) noexcept { free(p); }
"""
EXPECTED = {
    "INT": "dsc: interrupted|dsc: stopping",
    "TERM": "dsc: interrupted|dsc: stopping",
    "USR1": "dsc: interrupted",
    "KILL": "signal 9",
    "exception": "dsc: .*injected error",
    "bad_alloc": "dsc: .*not enough memory",
    "options": "dsc: process [0-9]+ has another command line",
}
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


class Launch:
    """A run of mpirun in a folder, as the leader of its process group."""

    def __init__(self, folder, words, **environment):
        self.err = open(os.path.join(folder, "stderr.txt"), "w+")
        preload = [w for name in environment for w in ("-x", name)]
        self.child = subprocess.Popen(
            ["mpirun", "--oversubscribe", *preload, *words], cwd=folder, start_new_session=True,
            env=dict(ENVIRONMENT, **environment), stdout=subprocess.DEVNULL, stderr=self.err)

    def ranks(self):
        """Returns the process ids of the ranks."""
        result = {}
        with open(f"/proc/{self.child.pid}/task/{self.child.pid}/children") as children:
            for pid in children.read().split():
                try:
                    with open(f"/proc/{pid}/environ", "rb") as environment:
                        found = re.search(rb"OMPI_COMM_WORLD_RANK=(\d+)", environment.read())
                except OSError:
                    continue
                if found:
                    result[int(found.group(1))] = int(pid)
        return result

    def message(self):
        self.err.seek(0)
        return self.err.read()


def cells(folder, step):
    """Returns the label and the corners of all cells of a step, bit by bit, in an order that does not depend on
    the ranks."""
    result = []
    for name in glob.glob(os.path.join(folder, f"volume_{step:06d}_*.vtu")):
        with open(name, "rb") as file:
            data = file.read()
        start = data.index(b"_", data.index(b"<AppendedData")) + 1

        def array(array_name):
            offset = re.search(rb'Name="%s"[^>]*offset="(\d+)"' % array_name, data)
            begin = start + int(offset.group(1))
            return data[begin + 8 : begin + 8 + int.from_bytes(data[begin : begin + 8], "little")]

        points, corners, labels = array(b"points"), array(b"connectivity"), array(b"label")
        corners = struct.unpack(f"<{len(corners) // 8}q", corners)
        for cell in range(len(labels) // 4):
            of_cell = [points[24 * v : 24 * v + 24] for v in corners[4 * cell : 4 * cell + 4]]
            result.append((labels[4 * cell : 4 * cell + 4], sorted(of_cell)))
    return sorted(result)


class Trials:
    def __init__(self, program, folder, processes):
        self.program, self.folder, self.processes = program, folder, processes
        self.command = [program, "rotate", "ball.off", *MOTION, "--quiet"]
        begin = time.monotonic()
        run = Launch(folder, ["-n", str(processes), *self.command, "--steps", str(STEPS), "--output", "all"])
        if run.child.wait() != 0:
            sys.exit(run.message())
        self.duration = time.monotonic() - begin
        self.allocations = []
        for rank in range(processes):
            shutil.rmtree(os.path.join(folder, "run"), ignore_errors=True)
            self.launch("run", rank, "count", 0).child.wait()
            with open(os.path.join(folder, "fault")) as count:
                self.allocations.append(int(count.read()))
        print(f"{processes} processes: {self.duration:.1f} s for {STEPS} steps, {self.allocations} allocations",
              file=sys.stderr, flush=True)

    def launch(self, output, rank=None, kind="", at=0):
        words = ["-n", str(self.processes), *self.command, "--steps", str(STEPS), "--output", output]
        if kind == "options":
            other = [*words[2:-3], str(STEPS + 1), *words[-2:]]
            words = ["-n", str(rank), *words[2:], ":"] if rank else []
            words += ["-n", "1", *other]
            rest = self.processes - 1 - rank
            words += [":", "-n", str(rest), *self.command, "--steps", str(STEPS), "--output", output] if rest else []
        if kind not in ("count", "exception", "bad_alloc"):
            return Launch(self.folder, words)
        fault = os.path.join(self.folder, "fault")
        if os.path.exists(fault):
            os.remove(fault)
        return Launch(self.folder, words, LD_PRELOAD=os.path.join(self.folder, "fault.so"), FAULT_RANK=str(rank),
                      FAULT_KIND=kind, FAULT_AT=str(at), FAULT_FILE=fault)

    def one(self, kind, trial, rng):
        """Returns seconds to the end, the first message of dsc, and what the checkpoint gives."""
        rank = trial % self.processes
        shutil.rmtree(os.path.join(self.folder, "run"), ignore_errors=True)
        run = self.launch("run", rank, kind, rng.randrange(self.allocations[rank]))
        moment = time.time()
        if kind in ("INT", "TERM", "USR1", "KILL"):
            time.sleep(rng.uniform(0.3, 0.9) * self.duration)
            pids = run.ranks()
            moment = time.time()
            if run.child.poll() is not None:
                return None, "ended before", "", ""
            if kind == "KILL":
                os.kill(pids[rank], signal.SIGKILL)
            elif kind == "INT":
                os.killpg(run.child.pid, signal.SIGINT)
            else:
                run.child.send_signal(getattr(signal, "SIG" + kind))
        try:
            run.child.wait(400)
        except subprocess.TimeoutExpired:
            run.child.kill()
        end = time.time()
        fault = os.path.join(self.folder, "fault")
        if kind in ("exception", "bad_alloc"):
            if not os.path.exists(fault):
                return None, "no fault", "", ""
            with open(fault) as at:
                moment = float(at.read())
        message = run.message()
        lines = [line for line in message.splitlines() if line.startswith(("dsc: ", "terminate", "mpirun noticed"))]
        told = re.search(EXPECTED[kind], message) is not None
        return end - moment, " / ".join(lines) or message[:300], told, self.resumed(kind)

    def resumed(self, kind):
        """Tells whether the checkpoint continues the run without interruption."""
        folder = os.path.join(self.folder, "run")
        path = os.path.join(folder, "checkpoint.dsc")
        if not os.path.exists(path):
            return "none yet"
        run = Launch(self.folder, ["-n", str(self.processes), self.program, "rotate", "--resume", path,
                                   "--steps", "2", "--output", folder, "--report", "r.json", "--quiet"])
        if run.child.wait() != 0:
            return "does not resume: " + run.message()
        with open(os.path.join(self.folder, "r.json")) as report:
            step = int(re.findall(r'"step": ?(\d+)', report.read())[-1])
        if step > STEPS:
            return "equal"  # the run had ended
        mine, expected = cells(folder, step), cells(os.path.join(self.folder, "all"), step)
        return "equal" if mine and mine == expected else "differs"


def trials(program, tries, kinds, numbers):
    failed = False
    print("| processes | way | tries | longest end (s) | with message | checkpoint |\n"
          "| ---: | --- | ---: | ---: | ---: | --- |")
    for processes in numbers:
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "ball.off"), "w") as out:
                out.write(sphere(8))
            with open(os.path.join(folder, "fault.cpp"), "w") as out:
                out.write(INJECTION)
            subprocess.run(["c++", "-O1", "-shared", "-fPIC", "fault.cpp", "-o", "fault.so"], cwd=folder, check=True)
            runs = Trials(program, folder, processes)
            for kind in kinds:
                rng = random.Random(kind)
                longest, told, tried, results = 0.0, 0, 0, collections.Counter()
                for trial in range(tries):
                    took, message, has_message, result = runs.one(kind, trial, rng)
                    if took is None:
                        continue
                    tried += 1
                    longest = max(longest, took)
                    told += has_message
                    results[result[:60]] += 1
                    print(f"  {processes} {kind} {trial}: {took:.2f} s, {has_message}, {result}; {message}",
                          file=sys.stderr, flush=True)
                failed = failed or longest > LONGEST or told < tried or set(results) - {"equal", "none yet"}
                print(f"| {processes} | {kind} | {tried} | {longest:.1f} | {told} | "
                      f"{', '.join(f'{n} {what}' for what, n in results.items())} |", flush=True)
    return failed


def interrupts(program):
    """Measures interrupts of mpirun on larger meshes."""
    print("| triangles | processes | output | line after (s) | end after (s) | line |\n| ---: | ---: | --- | ---: | ---: | --- |")
    for n, processes, delay in ((60, 2, 15), (60, 5, 25), (158, 2, 90)):
        for output in (None, "run"):
            with tempfile.TemporaryDirectory() as folder:
                with open(os.path.join(folder, "sphere.off"), "w") as out:
                    out.write(sphere(n))
                words = [program, "mean-curvature", "sphere.off", "--steps", "1000", "--quiet"]
                run = Launch(folder, ["-n", str(processes), *words,
                                      *(["--output", output, "--every", "1000"] if output else [])])
                time.sleep(delay)
                run.child.send_signal(signal.SIGINT)
                moment, line = time.time(), None
                while run.child.poll() is None:
                    if line is None and "dsc: interrupted" in run.message():
                        line = time.time()
                    time.sleep(0.02)
                end = time.time()
                lines = [text for text in run.message().splitlines() if text.startswith("dsc: ")]
                print(f"| {4 * n * (n - 1)} | {processes} | {'--output --every 1000' if output else 'none'} | "
                      f"{f'{line - moment:.2f}' if line else '-'} | {end - moment:.2f} | {lines[-1] if lines else '-'} |",
                      flush=True)


def main():
    program = os.path.abspath(sys.argv[1])
    if sys.argv[2:3] == ["interrupts"]:
        sys.exit(interrupts(program))
    tries = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    kinds = sys.argv[3].split(",") if len(sys.argv) > 3 else list(EXPECTED)
    numbers = [int(n) for n in sys.argv[4].split(",")] if len(sys.argv) > 4 else [2, 5]
    sys.exit(1 if trials(program, tries, kinds, numbers) else 0)


if __name__ == "__main__":
    main()
