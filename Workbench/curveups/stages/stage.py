# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines stages and results.

A stage is a pure function with a name: it says what it reads (other stages, and the parts of the
parameter table that its native code reads) and makes a result, an immutable value. A result gives its
own blocks of report.json, reasons, warnings and pictures; who shows them knows no stage by name.
"""

from __future__ import annotations

import hashlib
import math
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Callable, ClassVar, Mapping, Optional, Sequence, Union

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding, Value
from ..base.parameters import table
from ..base.progress import Progress


@dataclass(frozen=True)
class Row:
    """A line of report.json's "stages": a name that others rely on, seconds, steps."""

    name: str
    seconds: float
    iterations: int = 0


@dataclass(frozen=True)
class Picture:
    """What is to be drawn of a result, by `view` (report/pictures.py); `heading` opens a section."""

    heading: str
    caption: str
    view: str
    data: Mapping[str, Any] = field(default_factory=dict)


class Result(Value):
    """Base of all results: frozen dataclasses of numbers, texts, arrays and designs. Every method has an
    answer for results that have nothing to say."""

    lasting: ClassVar[bool] = True  # can be saved; otherwise it is made anew

    @property
    def content(self) -> str:
        """A digest of what later stages read of this: equal contents make equal results. Empty where
        only its origin tells (it is then as new as what it was made from)."""
        return ""

    @property
    def stopped(self) -> bool:
        """Whether this is the best so far of work that was stopped: what its field was_stopped says, where
        there is one."""
        return bool(getattr(self, "was_stopped", False))

    def settles(self) -> Mapping[str, Any]:
        """Parameters that this decides for all that follows."""
        return {}

    def report(self) -> dict[str, Any]:
        """Its blocks of report.json."""
        return {}

    def reasons(self) -> Sequence[Finding]:
        """Why the design is not valid, as far as this knows: its field `broken`, where there is one."""
        return tuple(getattr(self, "broken", ()))

    def advice(self) -> Sequence[Finding]:
        """What is to be said besides where the design does not hold."""
        return ()

    def warnings(self) -> Sequence[Finding]:
        """What may go wrong with a design that is valid: its field `warned`, where there is one."""
        return tuple(getattr(self, "warned", ()))

    def pictures(self) -> Sequence[Picture]:
        """What the page shows of this."""
        return ()

    def rows(self, seconds: float) -> Sequence[Row]:
        """Its lines among the report's stages, given how long it took in all."""
        return ()


# Gets the iterates of a stage: flat corners (M x 3 x 2, mm), insets (M x 2 x 3, mm), the layout's energy
# or the number of weak points that a repair has left, and the largest violation of constraints (mm).
Listener = Callable[[str, np.ndarray, np.ndarray, float, float], object]


@dataclass
class Job:
    """Where work reports and what may stop it: handed to every stage and, as a callable, to the native
    module. Stopping means the same everywhere: the best so far where there is one, else nothing."""

    progress: Optional[Progress] = None
    listen: Optional[Listener] = None
    stopped: bool = False
    stage: str = ""  # that is running

    def __call__(self, what: str, fraction: float = -1.0) -> bool:
        if not self.stopped and self.progress and not self.progress(what, fraction):
            self.stopped = True
        return not self.stopped

    def go_on(self, what: str, fraction: float = -1.0) -> None:
        """Reports, and raises Stopped where the work is to stop."""
        if not self(what, fraction):
            raise Stopped

    def listener(self, stage: str) -> Optional[Callable[..., bool]]:
        """For the native module: hands iterates on, where anybody listens."""
        listen = self.listen
        if listen is None:
            return None
        tell = listen

        def hand_on(T: np.ndarray, q: np.ndarray, figure: float, violation: float = math.nan) -> bool:
            tell(stage, T, q, figure, violation)
            return not self.stopped

        return hand_on


@dataclass(frozen=True)
class Inputs:
    """What a stage reads: results by the names it declared, and the parameters."""

    parameters: Any
    results: Mapping[str, Result]
    where: str = ""    # names the target or file in messages

    def __getitem__(self, name: str) -> Any:
        return self.results[name]


@dataclass(frozen=True)
class Stage:
    """`reads`: upstream stages; `parts`: whose parameters it reads (base/parameters.py), or a
    function of the parameters that says so, where some decide whether others are read at all; `on_failure`:
    the result of a failure that must not cost what there is already; `on_stop`: of a stop (with the stage
    that was stopped) where work before it is worth its files.

    Its roles. `label`: what users read for it. `asked_by`: the commands that ask for it by name (check, cuts,
    solve, verify, build, print); what it reads is made as well. `judges`: whether it has a say in the
    verdict, or a function of the parameters that says so. `shown`: whether the picture of a design is drawn
    from it."""

    name: str
    reads: tuple[str, ...]
    parts: Union[frozenset[str], Callable[[Any], frozenset[str]]]
    run: Callable[[Inputs, Job], Result]
    on_failure: Optional[Callable[[CurveUpsError, Inputs], Result]] = None
    on_stop: Optional[Callable[[str, Inputs], Result]] = None
    label: str = ""
    asked_by: tuple[str, ...] = ()
    judges: Union[bool, Callable[[Any], bool]] = False
    shown: bool = False

    def parameters(self, values: Any) -> tuple[str, ...]:
        """Names of the parameters that it reads where they have these values, from the one table."""
        return _parameters_of(self.parts(values) if callable(self.parts) else self.parts)

    def has_a_say(self, values: Any) -> bool:
        """Whether the verdict depends on it where the parameters have these values."""
        return self.judges(values) if callable(self.judges) else self.judges


@lru_cache(maxsize=None)
def _parameters_of(parts: frozenset[str]) -> tuple[str, ...]:
    return tuple(row.name for row in table() if parts & row.readers)


def moved_vertices(before: np.ndarray, after: np.ndarray, F: np.ndarray) -> list[dict[str, Any]]:
    """Of each vertex that is not where it was: its number, the tiles around it and by how much it moved
    (mm), the furthest first."""
    far = np.linalg.norm(after - before, axis=1)
    order = sorted(np.nonzero(far > 0)[0].tolist(), key=lambda v: (-far[v], v))
    around: dict[int, list[int]] = {v: [] for v in order}
    for tile, corners in enumerate(F.tolist()):
        for v in corners:
            if v in around:
                around[v].append(tile)
    return [{"vertex": v, "tiles": around[v], "mm": float(far[v])} for v in order]


def digest(*parts: Any) -> str:
    """A digest of texts and arrays; numbers count bit by bit."""
    found = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            part = np.ascontiguousarray(part)
            found.update(f"{part.dtype.str}{part.shape}".encode())
            found.update(part.tobytes())
        else:
            found.update(str(part).encode())
        found.update(b"\0")
    return found.hexdigest()
