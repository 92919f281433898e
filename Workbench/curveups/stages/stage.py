# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defines stages and results.

A stage is a pure function with a name. It declares its inputs (other stages, and the parts of the parameter
table that its native code reads) and returns a result, an immutable value. A result has its own blocks of
report.json, reasons, warnings and pictures; reports know no stage by name.
"""

from __future__ import annotations

import hashlib
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
    """An entry of "stages" in report.json, whose names are stable."""

    name: str
    seconds: float
    iterations: int = 0


@dataclass(frozen=True)
class Picture:
    """A picture of a result. view: module of report/ and its function that draws `data`. heading: opens a
    section."""

    heading: str
    caption: str
    view: str
    data: Mapping[str, Any] = field(default_factory=dict)


class Result(Value):
    """Base of all results: frozen dataclasses of numbers, texts, arrays and designs."""

    lasting: ClassVar[bool] = True  # saved in documents; otherwise made anew
    read_later: ClassVar[tuple[str, ...]] = ()  # fields that later stages read

    @property
    def content(self) -> str:
        """Digest of everything that later stages read of this: equal contents give equal results. Empty where
        results are compared by their inputs instead."""
        return digest(*(getattr(self, name) for name in self.read_later)) if self.read_later else ""

    @property
    def stopped(self) -> bool:
        """True for the best so far of work that was stopped (field `was_stopped`)."""
        return bool(getattr(self, "was_stopped", False))

    def fixes(self) -> Mapping[str, Any]:
        """Parameters that this fixes for all later stages."""
        return {}

    def report(self) -> dict[str, Any]:
        """Blocks of report.json."""
        return {}

    def reasons(self) -> Sequence[Finding]:
        """Reasons why the design is not valid (field `broken`)."""
        return tuple(getattr(self, "broken", ()))

    def advice(self) -> Sequence[Finding]:
        """Advice on a design that is not valid."""
        return ()

    def warnings(self) -> Sequence[Finding]:
        """Risks of a design that may be valid (field `warned`)."""
        return tuple(getattr(self, "warned", ()))

    def pictures(self) -> Sequence[Picture]:
        """Pictures for report.html."""
        return ()

    def rows(self, seconds: float) -> Sequence[Row]:
        """Entries of "stages" in report.json; seconds: time of the whole stage."""
        return ()


@dataclass(frozen=True)
class Block(Result):
    """A block of report.json, an object or a list; empty where the work was stopped."""

    name: str
    block: Any = ()
    warned: tuple[Finding, ...] = ()
    broken: tuple[Finding, ...] = ()

    def report(self) -> dict[str, Any]:
        return {self.name: self.block} if self.block else {}


# Called with each iterate of a stage: flat corners (M x 3 x 2, mm), insets (M x 2 x 3, mm), the layout's
# energy or the number of weak points left by repair, and the largest violation of constraints (mm).
Listener = Callable[[str, np.ndarray, np.ndarray, float, float], object]


@dataclass
class Job:
    """Progress sink and stop flag of one piece of work; the native module calls it as a Progress. Stopped
    work returns the best so far, or nothing."""

    progress: Optional[Progress] = None
    listen: Optional[Listener] = None
    stopped: bool = False
    stage: str = ""  # running now

    def __call__(self, what: str, fraction: float = -1.0) -> bool:
        if not self.stopped and self.progress and not self.progress(what, fraction):
            self.stopped = True
        return not self.stopped

    def go_on(self, what: str, fraction: float = -1.0) -> None:
        """Reports progress. Raises Stopped after a stop."""
        if not self(what, fraction):
            raise Stopped

    def listener(self, stage: str) -> Optional[Callable[..., bool]]:
        """Callback of the native module that passes iterates on; None without a listener."""
        if self.listen is None:
            return None
        listen: Listener = self.listen

        def pass_on(*iterate: Any) -> bool:
            listen(stage, *iterate)
            return not self.stopped

        return pass_on


@dataclass(frozen=True)
class Inputs:
    """Inputs of a stage: results by the names in `reads`, and the parameters."""

    parameters: Any
    results: Mapping[str, Result]
    where: str = ""    # the target or file, for messages

    def __getitem__(self, name: str) -> Any:
        return self.results[name]


@dataclass(frozen=True)
class Stage:
    """reads: names of upstream stages. parts: readers of the parameters that it uses (base/parameters.py), or
    a function of the parameters that returns them. on_failure: result after an error, where earlier results
    are worth keeping; else the error is raised. on_stop: likewise after a stop; it gets the name of the
    stopped stage.

    Roles. label: name for users. commands: commands that run it and its upstream stages (check, cuts, solve,
    verify, build, print, ...). judges: contributes to the verdict; or a function of the parameters that
    tells. shown: the picture of a design is drawn from it."""

    name: str
    reads: tuple[str, ...]
    parts: Union[frozenset[str], Callable[[Any], frozenset[str]]]
    run: Callable[[Inputs, Job], Result]
    on_failure: Optional[Callable[[CurveUpsError, Inputs], Result]] = None
    on_stop: Optional[Callable[[str, Inputs], Result]] = None
    label: str = ""
    commands: tuple[str, ...] = ()
    judges: Union[bool, Callable[[Any], bool]] = False
    shown: bool = False

    def parameters(self, values: Any) -> tuple[str, ...]:
        """Names of the parameters that it reads at these values."""
        return _parameters_of(self.parts(values) if callable(self.parts) else self.parts)

    def contributes(self, values: Any) -> bool:
        """True where the verdict depends on it at these values of the parameters."""
        return self.judges(values) if callable(self.judges) else self.judges


@lru_cache(maxsize=None)
def _parameters_of(parts: frozenset[str]) -> tuple[str, ...]:
    return tuple(row.name for row in table() if parts & row.readers)


def moved_vertices(before: np.ndarray, after: np.ndarray, F: np.ndarray) -> list[dict[str, Any]]:
    """Entry for each vertex that moved: number, adjacent tiles, distance (mm); the farthest first."""
    far = np.linalg.norm(after - before, axis=1)
    order = sorted(np.flatnonzero(far).tolist(), key=lambda v: (-far[v], v))
    return [{"vertex": v, "tiles": np.flatnonzero((F == v).any(axis=1)).tolist(), "mm": float(far[v])}
            for v in order]


def digest(*parts: Any) -> str:
    """Digest of texts and arrays, bit by bit."""
    hashed = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            part = np.ascontiguousarray(part)
            hashed.update(f"{part.dtype.str}{part.shape}".encode())
            hashed.update(part.tobytes())
        else:
            hashed.update(str(part).encode())
        hashed.update(b"\0")
    return hashed.hexdigest()
