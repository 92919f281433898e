# SPDX-License-Identifier: LGPL-2.1-or-later
"""The finished design: its constraints, the deviation of its surface from the target as it was given, and the
clearances between its tiles."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Iterator, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of, failed
from ..base.native import native, translated
from ..base.parameters import table
from .stage import Block, Inputs, Job, Picture, Result, Stage, digest


def design_digest(design: Any) -> str:
    """Digest of a native Design without its parameters and name."""
    target = design.target or ()
    return digest(design.V, design.F, design.T, design.q, design.cuts, *target)


@dataclass(frozen=True)
class DesignResult(Result):
    """Result of which later stages read the design alone."""

    design: Any  # native Design

    @property
    def content(self) -> str:
        return design_digest(self.design)


@dataclass(frozen=True)
class FinishedDesign(DesignResult):
    """A design after layout and repair, or one that was given."""

    verification: Optional[Result] = None  # of this design, where repair has computed it
    unsettled: Optional[Finding] = None    # of its layout

    def fixes(self) -> Mapping[str, Any]:
        """Parameters whose change needs a new layout."""
        values = self.design.parameters
        return {row.name: values.get(row.name) for row in table()
                if not row.keeps_layout and row.level != "switch"}

    def pictures(self) -> Sequence[Picture]:
        data = {"design": self.design}
        return (Picture("Actuated", "The tiles in the target shape, front side light.",
                        "pictures.actuated_view", data),
                Picture("Flat layout", "As it is printed, seen from the front; the pins that carry the "
                                       "membrane in dark.",
                        "pictures.flat_layout", data))


def _finish(inputs: Inputs) -> FinishedDesign:
    repair = inputs["repair"]
    return FinishedDesign(repair.design, repair.verification, inputs["layout"].unsettled)


STAGE = Stage("design", ("layout", "repair"), frozenset(), lambda inputs, job: _finish(inputs),
              on_stop=lambda stage, inputs: _finish(inputs),
              label="Design", commands=("solve",), shown=True)


@dataclass(frozen=True)
class Figures(Result):
    """Counts, areas and constraints of a design under the current parameters."""

    blocks: dict[str, Any]  # of report.json
    broken: tuple[Finding, ...] = ()  # reasons
    warned: tuple[Finding, ...] = ()

    def report(self) -> dict[str, Any]:
        return self.blocks


def relaxed_warnings(relaxed: Sequence[dict[str, Any]]) -> Iterator[Finding]:
    """Warning for each kind of relaxed bounds (as in report.json): figures of the one relaxed most, tiles of
    all."""
    for what in sorted({bound["what"] for bound in relaxed}):
        bounds = [bound for bound in relaxed if bound["what"] == what]
        worst = max(bounds, key=lambda bound: abs(bound["to"] - bound["from"]))
        yield Finding.about(f"relaxed.{what}", {bound["tile"] for bound in bounds}, count=len(bounds),
                            before=worst["from"], after=worst["to"], side=worst["side"],
                            tile=(worst["tile"],))


def with_doubt(figures: Figures, unsettled: Optional[Finding]) -> Figures:
    """Figures of a layout that did not converge: a reason beside others, a warning where only its quality is
    in doubt."""
    if unsettled is None:
        return figures
    if figures.broken:
        return replace(figures, broken=(*figures.broken, unsettled))
    return replace(figures, warned=(Finding("layout", (), unsettled.figures), *figures.warned))


def _evaluate(inputs: Inputs) -> Figures:
    design, get = inputs["design"].design.with_parameters(inputs.parameters), inputs.parameters.get
    figures = native.evaluate_design(design)
    constraints = figures.constraints
    blocks = {
        "tiles": len(design.F), "cuts": len(design.cuts), "contacts": len(figures.contacts),
        "area": {"actuated_cm2": figures.actuated_area_mm2 / 100, "flat_cm2": figures.flat_area_mm2 / 100,
                 "ratio": figures.flat_area_mm2 / figures.actuated_area_mm2},
        "constraints": constraints.block,
        "truncation": {"pairs_of_type": figures.truncation_types,
                       "three_point_contacts": figures.three_point_contacts,
                       "hinges": len(figures.hinges)},
        "relaxed": list(constraints.relaxed)}
    warned = [Finding.about("small_pin.side", [pin.tile], side=pin.side, tile=(pin.tile,), area_mm2=pin.area)
              for pin in sorted(constraints.small_pins, key=lambda pin: pin.area)
              if pin.area >= get("A_pin_floor")]
    warned += relaxed_warnings(constraints.relaxed)
    if figures.flat_clearance_mm < get("d_gap_min"):  # what bumps leave of the gap
        warned.append(Finding.about("flat_gap", left=figures.flat_clearance_mm, asked=get("d_gap_min")))
    if figures.shortened:
        warned.append(Finding.about("shortened", np.ravel(figures.shortened), count=len(figures.shortened),
                                    pairs=tuple((a, b) for a, b in figures.shortened)))
    if figures.hinges:
        contacts = tuple(figures.hinges)
        warned.append(Finding.about("hinge.design", count=len(contacts), contacts=contacts))
    return with_doubt(Figures(blocks, all_of(figures.reasons), tuple(warned)), inputs["design"].unsettled)


FIGURES = Stage("figures", ("design",), frozenset({"tiles", "layout"}),
                lambda inputs, job: _evaluate(inputs), on_stop=lambda stage, inputs: _evaluate(inputs),
                label="Constraints", commands=("solve", "verify", "build", "print"), judges=True)


def _measure_deviation(inputs: Inputs, job: Job) -> Block:
    design, (V, F) = inputs["design"].design, inputs["target"].given
    return Block("deviation", native.surface_deviation(design.V, design.F, V, F, job).block)  # mm


DEVIATION = Stage("deviation", ("target", "design"), frozenset(), _measure_deviation,
                  on_stop=lambda stage, inputs: Block("deviation"),
                  label="Deviation", commands=("solve",))


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
                   label="Clearances", commands=("solve", "verify"), judges=True)
