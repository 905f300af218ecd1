"""Progress, interrupts, threads and memory."""

from __future__ import annotations

import gc
import resource
import signal
import subprocess
import sys
import textwrap
import threading
import time

import dsc
import numpy as np
import pytest
from shapes import ball, disk


def test_progress_is_reported():
    phases = []
    ball(0.08)
    dsc.Complex3.from_function(
        lambda p: (p[:, 0] > 0).astype(int),
        box=[(-1, -1, -1), (1, 1, 1)],
        edge=0.1,
        progress=lambda phase: phases.append(phase),
    )
    assert phases and all(isinstance(phase, str) for phase in phases)


def test_a_callback_stops_a_function():
    c = ball(0.1)
    with pytest.raises(dsc.Interrupted):
        for _ in range(1000):
            c.improve(quality_threshold=0.9, progress=lambda phase: False)
            c.offset(0.01, progress=lambda phase: False)
    assert c.is_valid()


def test_an_exception_of_the_callback_passes_through():
    def progress(phase):
        raise KeyError("mine")

    c = ball(0.1)
    with pytest.raises(KeyError, match="mine"):
        for _ in range(1000):
            c.offset(0.01, progress=progress)
    assert c.is_valid()


SCRIPT = """
import dsc, numpy as np
labels = lambda p: (np.linalg.norm(p, axis=1) < .5).astype(int)
try:
    print("ready", flush=True)
    {statement}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.parametrize(
    "statement",
    [
        "dsc.Complex3.from_function(labels, [(-1, -1, -1), (1, 1, 1)], .02)",
        """c = dsc.Complex3.from_function(labels, [(-1, -1, -1), (1, 1, 1)], .1)
    while True: c.offset(.001)""",
    ],
)
def test_ctrl_c(statement):
    """Ctrl-C while building, and while moving. The bound is loose, since the machine may be busy."""
    program = textwrap.dedent(SCRIPT).format(statement=statement)
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(0.5)
        start = time.monotonic()
        process.send_signal(signal.SIGINT)
        rest = process.stdout.read()
        assert "interrupted" in rest
        assert time.monotonic() - start < 5


def test_other_threads_run_meanwhile():
    c = ball(0.08)
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    for _ in range(5):
        c.offset(0.01)
    duration = time.monotonic() - start
    done.set()
    thread.join()
    assert len(ticks) > 20 * duration  # the lock of the interpreter was released


def test_reads_and_changes_during_a_change():
    """Another thread is refused; the velocity function of the same thread may read, not change."""
    c = disk()
    seen = {}
    entered, may_leave = threading.Event(), threading.Event()

    def velocity(points, t):
        seen["volume"] = c.volumes[1]
        with pytest.raises(dsc.BusyError):
            c.offset(0.1)
        entered.set()
        may_leave.wait(10)
        return np.zeros_like(points)

    thread = threading.Thread(target=lambda: c.advect(velocity, 0, 0.1))
    thread.start()
    assert entered.wait(10)
    for read in (lambda: c.volumes, c.interface, c.cells, c.to_bytes, lambda: c.offset(0.1), c.copy):
        with pytest.raises(dsc.BusyError):
            read()
    may_leave.set()
    thread.join()
    assert seen["volume"] == c.volumes[1]


def test_complexes_of_different_threads_are_independent():
    results = {}

    def work(name):
        c = disk()
        for _ in range(5):
            c.offset(0.01)
        results[name] = c.to_bytes()

    threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results[0] == results[1] == results[2]


def test_memory_is_returned():
    def use():
        c = dsc.Complex2.from_polygons([[[(0, 0), (1, 0), (1, 1), (0, 1)]]])
        c.offset(0.01)
        c.copy()

    for _ in range(100):
        use()
    gc.collect()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(1000):
        use()
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 20_000  # kilobytes
