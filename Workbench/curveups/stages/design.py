# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finished design: how well it keeps its constraints, how far its surface is from the target as the user
gave it, and how near its tiles come to one another."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of, failed
from ..base.native import native, translated
from ..base.parameters import table
from .stage import Inputs, Job, Picture, Result, Stage, digest


def design_digest(design: Any) -> str:
    """Of all but its parameters and name."""
    target = design.target or ()
    return digest(design.V, design.F, design.T, design.q, design.cuts, *target)


@dataclass(frozen=True)
class FinishedDesign(Result):
    """A design that is laid out and, where that was asked for, repaired; or one that was given."""

    design: Any                          # native Design
    verification: Optional[Result] = None  # of this very design, where there is one already
    unsettled: Optional[Finding] = None  # of its layout

    @property
    def content(self) -> str:
        return design_digest(self.design)

    def settles(self) -> Mapping[str, Any]:
        """What only a new layout can follow."""
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
    """Counts, areas and constraints of a design under the parameters as they are."""

    tiles: int
    cuts: int
    figures: dict[str, Any]
    small_pins: tuple[tuple[int, str, float], ...]  # tile, side, mm2: from A_pin_floor to A_pin_min
    hinges: tuple[int, ...]
    broken: tuple[Finding, ...]  # reasons
    unsettled: Optional[Finding]
    relaxed: tuple[dict[str, Any], ...] = ()  # bounds that gave way, as in report.json
    shortened: tuple[tuple[int, int], ...] = ()  # tiles parted at the cost of an interface
    flat_gap: tuple[float, float] = (0.0, 0.0)  # what bumps leave of d_gap_min, and that, mm

    def report(self) -> dict[str, Any]:
        return {"tiles": self.tiles, "cuts": self.cuts, **self.figures, "relaxed": list(self.relaxed)}

    def reasons(self) -> Sequence[Finding]:
        return (*self.broken, self.unsettled) if self.broken and self.unsettled else self.broken

    def warnings(self) -> Sequence[Finding]:
        found: list[Finding] = []
        if self.unsettled and not self.broken:  # nothing but the layout's quality is in doubt
            found.append(Finding("layout", (), self.unsettled.figures))
        found += [Finding.about("small_pin.side", [tile], side=side, tile=(tile,), area_mm2=area)
                  for tile, side, area in self.small_pins]
        for what in sorted({bound["what"] for bound in self.relaxed}):
            found.append(_relaxed_warning(what, [bound for bound in self.relaxed if bound["what"] == what]))
        left, asked = self.flat_gap
        if left < asked:
            found.append(Finding.about("flat_gap", left=left, asked=asked))
        if self.shortened:
            found.append(Finding.about("shortened", np.ravel(self.shortened), count=len(self.shortened),
                                       pairs=self.shortened))
        if self.hinges:
            found.append(Finding.about("hinge.design", count=len(self.hinges), contacts=self.hinges))
        return found


def _relaxed_warning(what: str, bounds: Sequence[dict[str, Any]]) -> Finding:
    """What is said of bounds of one kind that gave way: the farthest of them in words, all by their tiles."""
    worst = max(bounds, key=lambda bound: abs(bound["to"] - bound["from"]))
    return Finding.about(f"relaxed.{what}", {bound["tile"] for bound in bounds}, count=len(bounds),
                         before=worst["from"], after=worst["to"], side=worst["side"], tile=(worst["tile"],))


def _evaluate(inputs: Inputs) -> Figures:
    finished = inputs["design"]
    design = finished.design.with_parameters(inputs.parameters)
    found = native.evaluate_design(design)
    constraints, floor = found.constraints, inputs.parameters.get("A_pin_floor")
    blocks = {
        "contacts": len(found.contacts),
        "area": {"actuated_cm2": found.actuated_area_mm2 / 100, "flat_cm2": found.flat_area_mm2 / 100,
                 "ratio": found.flat_area_mm2 / found.actuated_area_mm2},
        "constraints": {
            "max_rigidity_mm": constraints.max_rigidity_mm,
            "max_gap_violation_mm": constraints.max_gap_violation_mm,
            "max_pin_bound_violation_mm": constraints.max_pin_bound_violation_mm,
            "max_pin_area_violation_mm2": constraints.max_pin_area_violation_mm2,
            "pin_sides_below_area": len(constraints.small_pins),
            "overlaps": len(constraints.close_pairs)},
        "truncation": {"pairs_of_type": [int(n) for n in found.truncation_types],
                       "three_point_contacts": int(found.three_point_contacts),
                       "hinges": len(found.hinges)},
    }
    small = tuple(pin for pin in constraints.small_pins if pin[2] >= floor)
    return Figures(len(design.F), len(design.cuts), blocks, small,
                   tuple(int(k) for k in found.hinges), all_of(found.reasons), finished.unsettled,
                   tuple(constraints.relaxed), tuple((int(a), int(b)) for a, b in found.shortened),
                   (found.flat_clearance_mm, inputs.parameters.get("d_gap_min")))


FIGURES = Stage("figures", ("design",), frozenset({"tiles", "layout"}),
                lambda inputs, job: _evaluate(inputs), on_stop=lambda stage, inputs: _evaluate(inputs),
                label="Constraints", asked_by=("solve", "verify", "build", "print"), judges=True)


@dataclass(frozen=True)
class Deviation(Result):
    """Distances in mm, the largest ones within 0.005 mm; None where the work was stopped."""

    mean: Optional[float] = None
    rms: Optional[float] = None
    largest: Optional[float] = None
    hausdorff: Optional[float] = None

    def report(self) -> dict[str, Any]:
        if self.mean is None:
            return {}
        return {"deviation": {"mean_mm": self.mean, "rms_mm": self.rms, "max_mm": self.largest,
                              "hausdorff_mm": self.hausdorff}}


def _measure_deviation(inputs: Inputs, job: Job) -> Deviation:
    target, design = inputs["target"], inputs["design"].design
    V, F = target.given
    return Deviation(*native.surface_deviation(design.V, design.F, V, F, job))


DEVIATION = Stage("deviation", ("target", "design"), frozenset(), _measure_deviation,
                  on_stop=lambda stage, inputs: Deviation(),
                  label="Deviation", asked_by=("solve",))


@dataclass(frozen=True)
class Clearances(Result):
    """How near printed tiles come to one another and how much actuated ones overlap, in closed form: a
    verdict without solids covers it. None where the work was stopped or tiles can't be made (`broken`)."""

    flat_mm: Optional[float] = None        # least distance of two tiles; infinite with one tile
    overlap_mm3: Optional[float] = None    # largest volume that two share when actuated
    broken: tuple[Finding, ...] = ()       # reasons
    note: Optional[Finding] = None         # why this is not known

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
        # Tiles that can't be made are no input that can't be read: the verdict says it.
        return Clearances(broken=(failed("unprintable", error),))
    return Clearances(flat, overlap, all_of(reasons))


CLEARANCES = Stage("clearances", ("design",), frozenset({"tiles", "bodies"}), _measure_clearances,
                   on_stop=lambda stage, inputs: Clearances(note=Finding.about("stopped", stage=stage)),
                   label="Clearances", asked_by=("solve", "verify"), judges=True)
