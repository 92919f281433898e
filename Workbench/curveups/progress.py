# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on standard error, and stopping by SIGINT.

A `Progress` is what jobs and native calls take: called with what is being done and how much of
it (0 to 1, negative where unknown), it answers whether to go on.
"""

from __future__ import annotations

import signal
import sys
import time
from typing import Any, Callable, Optional, TextIO

Progress = Callable[[str, float], bool]


class Interrupt:
    """Turns SIGINT into a flag while it is entered; a second SIGINT ends the program at once."""

    def __init__(self) -> None:
        self.requested = False
        self._before: Any = None

    def __enter__(self) -> "Interrupt":
        self._before = signal.signal(signal.SIGINT, self._handle)
        return self

    def _handle(self, *_: Any) -> None:
        if self.requested:
            raise KeyboardInterrupt
        self.requested = True

    def __exit__(self, *_: Any) -> None:
        signal.signal(signal.SIGINT, self._before or signal.SIG_DFL)


class Reporter:
    """A bar that is redrawn on a terminal, a plain line per kind of work otherwise."""

    WIDTH = 30

    def __init__(self, interrupt: Optional[Interrupt] = None, quiet: bool = False,
                 stream: Optional[TextIO] = None):
        self._interrupt = interrupt
        self._stream = stream or sys.stderr
        self._quiet = quiet
        self._terminal = self._stream.isatty()
        self._what = ""
        self._said: set[str] = set()
        self._drawn = 0.0
        self._open = False  # a bar stands on the current line

    def __call__(self, what: str, fraction: float = -1.0) -> bool:
        if not self._quiet:
            self._bar(what, fraction) if self._terminal else self._line(what)
        return self._interrupt is None or not self._interrupt.requested

    def say(self, text: str) -> None:
        """A line of its own."""
        if not self._quiet:
            self.close()
            print(text, file=self._stream, flush=True)

    def close(self) -> None:
        """Takes the bar away."""
        if self._open:
            self._stream.write("\r\033[K")
            self._stream.flush()
            self._open = False
        self._what = ""

    def _line(self, what: str) -> None:
        # Details behind a colon change with every step; a log wants the work's name once.
        # Parallel work takes turns in reporting, so a name that was said is not said again.
        kind = what.split(":")[0]
        if kind not in self._said:
            print(f"curveups: {kind}", file=self._stream, flush=True)
            self._said.add(kind)

    def _bar(self, what: str, fraction: float) -> None:
        now = time.monotonic()
        if what == self._what and now - self._drawn < 0.05 and fraction < 1:
            return
        self._what, self._drawn, self._open = what, now, True
        if fraction >= 0:
            full = round(min(fraction, 1.0) * self.WIDTH)
            bar = f"[{'#' * full}{'.' * (self.WIDTH - full)}] {100 * min(fraction, 1.0):3.0f} %"
        else:
            bar = f"[{'-' * self.WIDTH}]"
        self._stream.write(f"\r\033[K{bar} {what}"[:110])
        self._stream.flush()
