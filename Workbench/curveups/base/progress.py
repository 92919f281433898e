# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on standard error, and stopping by SIGINT.

Jobs and native calls take a `Progress`: it is called with the name of the current work and its fraction
(0 to 1, negative where unknown), and returns whether to go on.
"""

from __future__ import annotations

import signal
import sys
import threading
import time
from typing import Any, Callable

Progress = Callable[[str, float], bool]


class Interrupt:
    """Turns SIGINT into a flag while entered; a second SIGINT ends the program at once."""

    def __init__(self) -> None:
        self.requested = False
        self._before: Any = None

    def __enter__(self) -> "Interrupt":
        if threading.current_thread() is threading.main_thread():  # no other thread gets signals
            self._before = signal.signal(signal.SIGINT, self._handle)
        return self

    def _handle(self, *_: Any) -> None:
        if self.requested:
            raise KeyboardInterrupt
        self.requested = True

    def __exit__(self, *_: Any) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)


class Reporter:
    """A bar that is redrawn on a terminal, a plain line per kind of work otherwise."""

    WIDTH = 30

    def __init__(self, interrupt: Interrupt, quiet: bool):
        self._interrupt, self._quiet, self._stream = interrupt, quiet, sys.stderr
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
        # Details behind a colon change with every step, and parallel work takes turns: each name once.
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
        self._stream.write(text)
        self._stream.flush()
