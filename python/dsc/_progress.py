"""A line on the terminal that shows the progress of a long function."""

from __future__ import annotations

import sys
import time
from typing import TextIO


class ProgressLine:
    """Shows the current phase and the elapsed time. `progress=True` uses such a line.

    stream: where the line is written; by default standard error. Nothing is written unless it is a
        terminal.
    """

    _delay = 0.5  # seconds before the line appears
    _interval = 0.1  # seconds between updates

    def __init__(self, stream: TextIO | None = None) -> None:
        self._stream = sys.stderr if stream is None else stream
        self._start = time.monotonic()
        self._next = self._start + self._delay
        self._width = 0

    def __call__(self, phase: str) -> None:
        """Updates the line."""
        now = time.monotonic()
        if now < self._next or not self._stream.isatty():
            return
        self._next = now + self._interval
        text = f"{phase}: {now - self._start:.1f} s"
        self._stream.write("\r" + text.ljust(self._width))
        self._stream.flush()
        self._width = len(text)

    def close(self) -> None:
        """Removes the line. The functions of the package call this for `progress=True`."""
        if self._width > 0:
            self._stream.write("\r" + " " * self._width + "\r")
            self._stream.flush()
            self._width = 0
