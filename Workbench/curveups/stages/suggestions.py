# SPDX-License-Identifier: LGPL-2.1-or-later
"""Suggests cuts for a target, and for a design that is not valid or badly stretched."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np

from ..base.errors import Stopped
from ..base.findings import Finding, Value, all_of, failed
from ..base.native import native
from .stage import Inputs, Job, Picture, Result, Row, Stage

# A layout is badly stretched above this ratio of scales of the conformal map, or above this share of slack
# membrane between pins.
STRETCHED_SPREAD, STRETCHED_SLACK = 12.0, 0.02
UNASKED = 2  # cuts proposed without a request


@dataclass(frozen=True)
class SuggestedCut(Value):
    """A cut and its predicted effect: figures of draft layouts, or None."""

    edges: np.ndarray
    length_mm: float
    reasons: tuple[Finding, ...]
    before: Optional[dict]
    after: Optional[dict]

    @property
    def finding(self) -> Finding:
        """The cut as a finding."""
        tiles = [tile for reason in self.reasons for tile in reason.tiles]
        about = {"length": self.length_mm, "why": self.reasons}
        if self.before is None or self.after is None:
            return Finding.about("cut", tiles, **about)
        predicted = {f"{name}_{when}": figures[key]
                     for when, figures in (("before", self.before), ("after", self.after))
                     for name, key in (("area", "area_ratio"), ("slack", "slack_springs"),
                                       ("energy", "energy_per_contact"))}
        return Finding.about("cut.predicted", tiles, **about, **predicted)

    def __str__(self) -> str:
        return str(self.finding)

    def entry(self, applied: bool) -> dict:
        """Entry of report.json."""
        return {"edges": [[int(a), int(b)] for a, b in self.edges], "length_mm": self.length_mm,
                "reason": "; ".join(map(str, self.reasons)), "applied": applied,
                "predicted": {"before": self.before, "after": self.after}}


def _search(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, most: int,
            weak: Sequence[tuple[int, int]], job: Job) -> tuple[tuple[SuggestedCut, ...], Any]:
    """Cuts in the order of their making, and the native result."""
    search = native.suggest_cuts(V, F, edges, parameters, most, list(weak), job)
    return tuple(SuggestedCut(np.array(cut.edges), cut.length_mm, all_of(cut.reasons),
                              cut.before.block if cut.before else None,
                              cut.after.block if cut.after else None)
                 for cut in search.cuts), search


@dataclass(frozen=True)
class CutSearch(Result):
    """Cuts suggested for a target before any layout; CutRequest.accept makes them."""

    before: np.ndarray  # existing cuts
    cuts: tuple[SuggestedCut, ...]
    layouts: int        # number of draft layouts
    seconds: float

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("cuts", seconds, self.layouts),)


def _search_target(inputs: Inputs, job: Job) -> CutSearch:
    start, edges = time.perf_counter(), inputs["cuts"].edges
    most = inputs["cut request"].suggested
    V, F = inputs["target smoothing"].V, inputs["target"].F
    cuts, search = _search(V, F, edges, inputs.parameters, most, (), job)
    if search.stopped:
        raise Stopped
    return CutSearch(edges, cuts, search.layouts, time.perf_counter() - start)


SEARCH = Stage("cut search", ("target", "target smoothing", "cut request", "cuts"),
               frozenset({"tiles", "layout"}), _search_target,
               label="Cuts", commands=("cuts",))


@dataclass(frozen=True)
class Suggestions(Result):
    """Cuts that were made on request, proposed cuts, general advice."""

    applied: tuple[SuggestedCut, ...] = ()
    proposed: tuple[SuggestedCut, ...] = ()
    general: tuple[Finding, ...] = ()   # of repair, without proposed cuts
    stretch: Optional[dict] = None      # figures of the layout
    warned: tuple[Finding, ...] = ()
    searched: bool = False
    was_stopped: bool = False
    design: Any = None

    def report(self) -> dict[str, Any]:
        cuts = [cut.entry(True) for cut in self.applied] + [cut.entry(False) for cut in self.proposed]
        blocks: dict[str, Any] = {"suggested_cuts": cuts} if cuts else {}
        if self.stretch is not None:
            blocks["layout"] = {"stretch": self.stretch}
        return blocks

    def advice(self) -> Sequence[Finding]:
        return [Finding("suggested", cut.finding.tiles, {"what_to_do": cut.finding})
                for cut in self.proposed] or self.general

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("cuts", seconds),) if self.searched else ()

    def pictures(self) -> Sequence[Picture]:
        if not (self.applied or self.proposed):
            return ()
        return (Picture("Suggested cuts", "Cuts that were made in blue, those proposed in red; the target "
                                          "from two sides.",
                        "pictures.cut_view",
                        {"design": self.design, "cuts": self.report()["suggested_cuts"]}),)


def _applied(inputs: Inputs) -> tuple[SuggestedCut, ...]:
    accepted = inputs["cut request"].accepted
    return accepted.cuts if accepted else ()


def _run(inputs: Inputs, job: Job) -> Suggestions:
    layout, verification, repair = inputs["layout"], inputs["verification"], inputs["repair"]
    design = inputs["design"].design.with_parameters(inputs.parameters)
    applied, general = _applied(inputs), repair.suggestions
    stretch = native.layout_figures(design).block
    contacts = inputs["figures"].blocks["contacts"]
    stretched = (stretch["scale_spread"] > STRETCHED_SPREAD
                 or stretch["slack_springs"] > STRETCHED_SLACK * 2 * contacts)
    invalid = verification.judged and not verification.failure and not verification.valid
    if not (stretched or invalid or not layout.converged):
        return Suggestions(applied, general=general, stretch=stretch, design=design)
    proposed, search = _search(inputs["target smoothing"].V, inputs["target"].F, design.cuts,
                               inputs.parameters, UNASKED, verification.weak_contacts, job)
    warned = (Finding.about("stretched" if proposed else "stretched.uncut", spread=stretch["scale_spread"],
                            slack=stretch["slack_springs"]),) if stretched else ()
    return Suggestions(applied, proposed, general, stretch, warned, True, search.stopped, design)


def _ended(inputs: Inputs, **how: Any) -> Suggestions:
    return Suggestions(_applied(inputs), general=inputs["repair"].suggestions,
                       design=inputs["design"].design, **how)


STAGE = Stage("suggestions", ("target", "target smoothing", "cut request", "layout", "repair", "design",
                              "figures", "verification"), frozenset({"tiles", "layout"}), _run,
              lambda error, inputs: _ended(inputs, warned=(failed("cuts", error),)),
              lambda stage, inputs: _ended(inputs, was_stopped=True),
              label="Suggestions", commands=("solve",))
