# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finished design: its constraints, the deviation of its surface from the target as it was given, and the
clearances between its tiles."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of, failed
from ..base.native import native, translated
from ..base.parameters import table
from .stage import Inputs, Job, Picture, Result, Stage, digest


def design_digest(design: Any) -> str:
    """Digest of a native Design without its parameters and name."""
    target = design.target or ()
    return digest(design.V, design.F, design.T, design.q, design.cuts, *target)


@dataclass(frozen=True)
class FinishedDesign(Result):
    """A design after layout and repair, or one that was given."""

    design: Any                            # native Design
    verification: Optional[Result] = None  # of this design, where repair has computed it
    unsettled: Optional[Finding] = None    # of its layout

    @property
    def content(self) -> str:
        return design_digest(self.design)

    def fixes(self) -> Mapping[str, Any]:
        """Parameters whose change needs a new layout."""
        values = self.design.parameters
        return {row.name: values.get(row.name) for row in table()
                if not row.keeps_layout and row.level != "switch"}

    def pictures(self) -> Sequence[Picture]:
        data = {"design": self.design}
        return (Picture("Actuated", "The tiles in the target shape, front side light.", "actuated", data),
                Picture("Flat layout", "As it is printed, seen from the front; the pins that carry the "
                                       "membrane in dark.", "flat", data))


def _finish(inputs: Inputs) -> FinishedDesign:
    repair = inputs["repair"]
    return FinishedDesign(repair.design, repair.verification, inputs["layout"].unsettled)


STAGE = Stage("design", ("layout", "repair"), frozenset(), lambda inputs, job: _finish(inputs),
              on_stop=lambda stage, inputs: _finish(inputs),
              label="Design", asked_by=("solve",), shown=True)


@dataclass(frozen=True)
class Figures(Result):
    """Counts, areas and constraints of a design under the current parameters."""

    tiles: int
    cuts: int
    figures: dict[str, Any]
    small_pins: tuple[tuple[int, str, float], ...]  # tile, side, mm2: from A_pin_floor to A_pin_min
    hinges: tuple[int, ...]
    broken: tuple[Finding, ...]  # reasons
    unsettled: Optional[Finding]
    relaxed: tuple[dict[str, Any], ...] = ()  # bounds that were relaxed, as in report.json
    shortened: tuple[tuple[int, int], ...] = ()  # pairs parted by shortening an interface
    flat_gap: tuple[float, float] = (0.0, 0.0)  # gap that bumps leave, and d_gap_min, mm

    def report(self) -> dict[str, Any]:
        return {"tiles": self.tiles, "cuts": self.cuts, **self.figures, "relaxed": list(self.relaxed)}

    def reasons(self) -> Sequence[Finding]:
        return (*self.broken, self.unsettled) if self.broken and self.unsettled else self.broken

    def warnings(self) -> Sequence[Finding]:
        warnings: list[Finding] = []
        if self.unsettled and not self.broken:  # nothing but the layout's quality is in doubt
            warnings.append(Finding("layout", (), self.unsettled.figures))
        warnings += [Finding.about("small_pin.side", [tile], side=side, tile=(tile,), area_mm2=area)
                     for tile, side, area in self.small_pins]
        for what in sorted({bound["what"] for bound in self.relaxed}):
            bounds = [bound for bound in self.relaxed if bound["what"] == what]
            warnings.append(_relaxed_warning(what, bounds))
        left, asked = self.flat_gap
        if left < asked:
            warnings.append(Finding.about("flat_gap", left=left, asked=asked))
        if self.shortened:
            warnings.append(Finding.about("shortened", np.ravel(self.shortened), count=len(self.shortened),
                                          pairs=self.shortened))
        if self.hinges:
            warnings.append(Finding.about("hinge.design", count=len(self.hinges), contacts=self.hinges))
        return warnings


def _relaxed_warning(what: str, bounds: Sequence[dict[str, Any]]) -> Finding:
    """Warning of relaxed bounds of one kind: figures of the one relaxed most, tiles of all."""
    worst = max(bounds, key=lambda bound: abs(bound["to"] - bound["from"]))
    return Finding.about(f"relaxed.{what}", {bound["tile"] for bound in bounds}, count=len(bounds),
                         before=worst["from"], after=worst["to"], side=worst["side"], tile=(worst["tile"],))


def _evaluate(inputs: Inputs) -> Figures:
    finished = inputs["design"]
    design = finished.design.with_parameters(inputs.parameters)
    figures = native.evaluate_design(design)
    constraints, floor = figures.constraints, inputs.parameters.get("A_pin_floor")
    blocks = {
        "contacts": len(figures.contacts),
        "area": {"actuated_cm2": figures.actuated_area_mm2 / 100, "flat_cm2": figures.flat_area_mm2 / 100,
                 "ratio": figures.flat_area_mm2 / figures.actuated_area_mm2},
        "constraints": constraints.block,
        "truncation": {"pairs_of_type": figures.truncation_types,
                       "three_point_contacts": figures.three_point_contacts,
                       "hinges": len(figures.hinges)},
    }
    small = tuple((pin.tile, pin.side, pin.area) for pin in constraints.small_pins if pin.area >= floor)
    return Figures(len(design.F), len(design.cuts), blocks, small,
                   tuple(figures.hinges), all_of(figures.reasons), finished.unsettled,
                   tuple(constraints.relaxed), tuple((a, b) for a, b in figures.shortened),
                   (figures.flat_clearance_mm, inputs.parameters.get("d_gap_min")))


FIGURES = Stage("figures", ("design",), frozenset({"tiles", "layout"}),
                lambda inputs, job: _evaluate(inputs), on_stop=lambda stage, inputs: _evaluate(inputs),
                label="Constraints", asked_by=("solve", "verify", "build", "print"), judges=True)


@dataclass(frozen=True)
class Deviation(Result):
    """block: distances in mm; empty where the work was stopped."""

    block: Mapping[str, float] = field(default_factory=dict)  # of report.json

    def report(self) -> dict[str, Any]:
        return {"deviation": dict(self.block)} if self.block else {}


def _measure_deviation(inputs: Inputs, job: Job) -> Deviation:
    target, design = inputs["target"], inputs["design"].design
    V, F = target.given
    return Deviation(native.surface_deviation(design.V, design.F, V, F, job).block)


DEVIATION = Stage("deviation", ("target", "design"), frozenset(), _measure_deviation,
                  on_stop=lambda stage, inputs: Deviation(),
                  label="Deviation", asked_by=("solve",))


@dataclass(frozen=True)
class Clearances(Result):
    """Clearance of printed tiles and overlap of actuated ones, in closed form, without solids. None where the
    work was stopped or tiles can't be made (`broken`)."""

    flat_mm: Optional[float] = None        # least distance of two tiles; infinite with one tile
    overlap_mm3: Optional[float] = None    # largest volume that two share when actuated
    broken: tuple[Finding, ...] = ()       # reasons
    note: Optional[Finding] = None         # why the verdict stays open

    def report(self) -> dict[str, Any]:
        if self.flat_mm is None:
            return {}
        return {"clearances": {"min_flat_mm": self.flat_mm if math.isfinite(self.flat_mm) else None,
                               "max_overlap_actuated_mm3": self.overlap_mm3}}


def _measure_clearances(inputs: Inputs, job: Job) -> Clearances:
    design = inputs["design"].design.with_parameters(inputs.parameters)
    try:
        with translated(inputs.where):
            flat, overlap, reasons = native.measure_clearances(design, job)
    except CurveUpsError as error:
        # A reason of the verdict, not an error of the input.
        return Clearances(broken=(failed("unprintable", error),))
    return Clearances(flat, overlap, all_of(reasons))


CLEARANCES = Stage("clearances", ("design",), frozenset({"tiles", "bodies"}), _measure_clearances,
                   on_stop=lambda stage, inputs: Clearances(note=Finding.about("stopped", stage=stage)),
                   label="Clearances", asked_by=("solve", "verify"), judges=True)
