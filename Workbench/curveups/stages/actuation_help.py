# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would help a piece that does not arrive: the design is made anew with other friction, bumps, gaps and
thickness, and with a cut, each change alone, then those together that help, and rises from flat each time."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Iterator, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding
from ..base.native import native, translated
from ..base.parameters import parameter, with_values
from ..base.releases import CUT
from ..base.value import Value
from . import actuation, settle
from .stage import Inputs, Job, Result, Row, Stage

# What is tried, as factors of what is set.
_FACTORS = {"friction_coefficient": (0.5, 0.25), "d_gap_min": (0.7, 1.4), "H_body": (0.75, 0.5)}
_KEEPS_LAYOUT = ("friction_coefficient",)
_NO_EDGES = np.zeros((0, 2), np.int32)


@dataclass(frozen=True)
class Change(Value):
    """values: of parameters, by name. edges: mesh edges that are cut besides, C x 2; length: of them, mm."""

    values: Mapping[str, Any] = field(default_factory=dict)
    edges: np.ndarray = field(default_factory=lambda: _NO_EDGES)
    length: float = 0.0

    def entry(self) -> dict[str, Any]:
        """As in actuation.json."""
        cuts = {"cuts": self.edges.tolist()} if len(self.edges) else {}
        return {**self.values, **cuts}

    def findings(self) -> tuple[Finding, ...]:
        """What is changed, as a sentence says it."""
        cut = (Finding.about("help_change.cut", length=self.length),) if len(self.edges) else ()
        return (*(Finding.about("help_change" if isinstance(value, str) else "size", name=name, value=value)
                  for name, value in self.values.items()), *cut)


@dataclass(frozen=True)
class Trial(Value):
    """What a change leads to. valid: whether the design is with it. arrives, shortfall (mm), open_contacts:
    of its path; None, nan and none where it gave no answer. error: why there is no such design."""

    change: Change
    valid: bool = False
    arrives: Optional[bool] = None
    shortfall: float = float("nan")
    open_contacts: tuple[tuple[int, int], ...] = ()
    contacts: int = 0
    error: Optional[str] = None

    @property
    def rank(self) -> tuple[Any, ...]:
        """The best comes first: designs that are valid before others, then those that arrive, then those that
        come nearest."""
        answered = self.arrives is not None
        return (self.error is not None, not self.valid, not self.arrives, not answered,
                self.shortfall if answered else 0.0)

    @property
    def finding(self) -> Finding:
        """As a sentence says it."""
        changes = self.change.findings()
        if self.error is not None:
            return Finding.about("help_refused", changes=changes, error=self.error)
        known = "" if self.valid else ".invalid"
        if self.arrives is None:
            return Finding.about(f"help_restless{known}", changes=changes)
        if self.arrives:
            return Finding.about(f"help_arrives{known}", changes=changes, shortfall=self.shortfall)
        tiles = (tile for pair in self.open_contacts for tile in pair)
        return Finding.about(f"help_short{known}", tiles, changes=changes, shortfall=self.shortfall,
                             open=len(self.open_contacts), count=self.contacts)

    def entry(self) -> dict[str, Any]:
        """As in actuation.json."""
        known = {} if self.arrives is None else {"shortfall_mm": self.shortfall,
                                                 "open_contacts": [list(pair) for pair in self.open_contacts],
                                                 "contacts": self.contacts}
        return {"change": self.change.entry(), "what": str(self.finding), "arrives": self.arrives, **known,
                "valid": None if self.error is not None else self.valid}


@dataclass(frozen=True)
class ActuationHelp(Result):
    """All that was tried, the best first. before: how far the design as it is comes, mm."""

    trials: tuple[Trial, ...] = ()
    before: float = 0.0
    was_stopped: bool = False

    @property
    def nearer(self) -> list[Trial]:
        """Valid designs that come nearer than the present one, or arrive."""
        return [one for one in self.trials if _helps(one, self.before)]

    def report(self) -> dict[str, Any]:
        return {"actuation": {"help": [one.entry() for one in self.trials]}} if self.trials else {}

    def findings(self) -> list[Finding]:
        """What helps, the best first."""
        if not self.trials:
            return []
        if not self.nearer:
            return [Finding.about("help_none", tried=len(self.trials))]
        return [one.finding for one in self.nearer]

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("actuation trials", seconds, len(self.trials)),) if self.trials else ()


def _helps(one: Trial, before: float) -> bool:
    return one.valid and (one.arrives is True or one.shortfall < before)


def _run(inputs: Inputs, job: Job) -> ActuationHelp:
    found = inputs[actuation.STAGE.name]
    if found.block["arrives"] is not False:
        return ActuationHelp()
    design, before = inputs["design"].design.with_parameters(inputs.parameters), found.block["shortfall_mm"]
    release, trials = found.block.get("release", CUT), []  # type: str, list[Trial]
    try:
        with translated(inputs.where):
            changes = [*_other_values(design.parameters), *_cuts(design, job)]
        for number, change in enumerate(changes):
            trials.append(_try(design, change, number / (len(changes) + 1), inputs.where, job, release))
        together = _together(trials, before)
        if together is not None:
            trials.append(_try(design, together, len(changes) / (len(changes) + 1), inputs.where, job,
                               release))
    except Stopped:
        job.stopped = True
    return ActuationHelp(tuple(sorted(trials, key=lambda one: one.rank)), before, job.stopped)


def _other_values(parameters: Any) -> Iterator[Change]:
    for name, factors in _FACTORS.items():
        row = parameter(name)
        for factor in factors:
            value = float(f"{factor * parameters.get(name):.2g}")
            if row.minimum <= value <= row.maximum and value != parameters.get(name):
                yield Change({name: value})
    # Dimples move as plain walls do.
    yield Change({"bumps": "none" if parameters.get("bumps") == "bumps" else "bumps"})


def _cuts(design: Any, job: Job) -> Iterator[Change]:
    """The cut that the search proposes next, where it proposes one."""
    found = native.suggest_cuts(design.V, design.F, design.cuts, design.parameters, 1, [], job)
    for cut in found.cuts:
        yield Change({}, np.array(cut.edges, np.int32).reshape(-1, 2), float(cut.length_mm))


def _together(trials: Sequence[Trial], before: float) -> Optional[Change]:
    """Of each parameter the value that helps most; None where a single change does, or only one helps."""
    helping = sorted((one for one in trials if _helps(one, before)), key=lambda one: one.rank)
    if any(one.arrives for one in helping):
        return None
    values: dict[str, Any] = {}
    edges, length = _NO_EDGES, 0.0
    for one in helping:
        values = {**one.change.values, **values}
        if len(one.change.edges):
            edges, length = one.change.edges, one.change.length
    return Change(values, edges, length) if len(values) + (length > 0) > 1 else None


def _try(design: Any, change: Change, fraction: float, where: str, job: Job, release: str) -> Trial:
    """Raises Stopped where it is stopped before it has an answer."""
    said = "trying " + ", ".join(map(str, change.findings()))

    def tell(what: str, part: float = -1.0) -> bool:
        return job(said, fraction)

    told = Job(tell)
    if not told(said):
        raise Stopped
    try:
        with translated(where):
            changed, valid = _made(design, change, told)
            found = native.actuate_design(changed, progress=told, answers=False, release=release).block
    except CurveUpsError as error:
        return Trial(change, error=error.what)
    if told.stopped:
        raise Stopped
    if found["arrives"] is None:
        return Trial(change, valid)
    pairs = tuple((int(a), int(b)) for a, b in found["open_contacts"])
    return Trial(change, valid, found["arrives"], found["shortfall_mm"], pairs, found["contacts"])


def _made(design: Any, change: Change, job: Job) -> tuple[Any, bool]:
    """The design with a change, laid out anew and repaired where its layout depends on that; and whether it
    is valid."""
    parameters = with_values(design.parameters, change.values)
    parameters.check()
    if not len(change.edges) and all(name in _KEEPS_LAYOUT for name in change.values):
        changed = design.with_parameters(parameters)
        return changed, bool(native.verify_design(changed, progress=job).valid)
    return relaid(design, design.V, parameters, np.vstack([design.cuts, change.edges]).astype(np.int32), job)


def relaid(design: Any, surface: np.ndarray, parameters: Any, cuts: np.ndarray, job: Job) -> tuple[Any, bool]:
    """A design of the same target and triangles on `surface` (N x 3, mm), laid out and repaired; and whether
    it is valid. Raises what the native functions raise."""
    faces, given = np.asarray(design.F), design.target
    wanted = given if given is not None and np.array_equal(given[1], faces) else (design.V, faces)
    found = native.solve_layout(surface, faces, cuts, parameters, job)
    laid = native.Design(design.name, parameters, surface, faces, found.T, found.q, cuts, wanted)
    repaired = native.repair_design(laid, progress=job)
    return repaired.design, repaired.status == "valid"


STAGE = Stage("actuation help", ("design", actuation.STAGE.name),
              settle.PARTS | {"layout", "repair"}, _run, None,
              lambda stage, inputs: ActuationHelp(was_stopped=True), label="What would help",
              asked_by=("try changes",))
