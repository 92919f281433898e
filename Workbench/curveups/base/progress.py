# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on standard error, and stopping by signals.

A `Progress` is what jobs and native calls take: called with what is being done and how much of
it (0 to 1, negative where unknown), it answers whether to go on.
"""

from __future__ import annotations

import signal
import sys
import threading
import time
from contextlib import contextmanager
from types import FrameType
from typing import Any, Callable, Iterator, Optional

Progress = Callable[[str, float], bool]


STOPPING = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]


class Interrupt:
    """Turns SIGINT, SIGTERM and SIGHUP into a flag while it is entered. A second one ends the program at
    once, but not while files are being written (`shielded`) or a module is loaded: extensions make an
    ImportError of what interrupts them."""

    def __init__(self) -> None:
        self.requested = False
        self._shields = 0
        self._before: dict[int, Any] = {}

    def __enter__(self) -> "Interrupt":
        if threading.current_thread() is not threading.main_thread():
            return self  # no other thread gets signals
        for number in STOPPING:
            if number == signal.SIGINT or signal.getsignal(number) is not signal.SIG_IGN:  # nohup ignores
                self._before[number] = signal.signal(number, self._handle)
        return self

    def _handle(self, _: int, frame: Optional[FrameType]) -> None:
        if self.requested and not self._shields and not _loading(frame):
            raise KeyboardInterrupt
        self.requested = True

    @contextmanager
    def shielded(self) -> Iterator[None]:
        """What stops in good time by itself, and must not be cut off."""
        self._shields += 1
        try:
            yield
        finally:
            self._shields -= 1

    def __exit__(self, *_: Any) -> None:
        for number, before in self._before.items():
            signal.signal(number, before or signal.SIG_DFL)


def _loading(frame: Optional[FrameType]) -> bool:
    """Whether a module is being loaded where the program stands."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


class Reporter:
    """A bar that is redrawn on a terminal, a plain line per kind of work otherwise."""

    WIDTH = 30

    def __init__(self, interrupt: Interrupt, quiet: bool):
        self._interrupt = interrupt
        self._stream = sys.stderr
        self._quiet = quiet
        self._terminal = not quiet and self._stream.isatty()
        self._what = ""
        self._said: set[str] = set()
        self._drawn = 0.0
        self._open = False  # a bar stands on the current line

    def __call__(self, what: str, fraction: float = -1.0) -> bool:
        if not self._quiet:
            self._bar(what, fraction) if self._terminal else self._line(what)
        return not self._interrupt.requested

    def say(self, text: str) -> None:
        """A line of its own."""
        if not self._quiet:
            self.close()
            self._write(f"{text}\n")

    def close(self) -> None:
        """Takes the bar away."""
        if self._open:
            self._write("\r\033[K")
            self._open = False
        self._what = ""

    def _line(self, what: str) -> None:
        # Details behind a colon change with every step; a log wants the work's name once.
        # Parallel work takes turns in reporting, so a name that was said is not said again.
        kind = what.split(":")[0]
        if kind not in self._said:
            self._write(f"curveups: {kind}\n")
            self._said.add(kind)

    def _bar(self, what: str, fraction: float) -> None:
        now = time.monotonic()
        if what == self._what and now - self._drawn < 0.05 and fraction < 1:
            return
        self._what, self._drawn, self._open = what, now, True
        if fraction >= 0:
            full = round(min(fraction, 1.0) * self.WIDTH)
            bar = f"[{'#' * full}{'.' * (self.WIDTH - full)}] {100 * min(fraction, 1.0):3.0f} %"
        else:  # a mark that moves
            at = int(5 * now) % self.WIDTH
            bar = f"[{'-' * at}#{'-' * (self.WIDTH - 1 - at)}]"
        self._write(f"\r\033[K{bar} {what}"[:110])

    def _write(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except (OSError, ValueError):  # closed or full: work goes on in silence
            self._quiet, self._open = True, False
