# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would help a design that stays invalid or is badly stretched: cuts, other parameters."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .native import native
from .progress import Progress
from .verdict import small_pins

# A layout is badly stretched where the conformal map scales its tiles this differently, or where
# this share of the membrane between pins is slack.
STRETCHED_SPREAD, STRETCHED_SLACK = 12.0, 0.02
UNASKED = 2  # cuts that are proposed where none were asked for


@dataclass
class Suggestions:
    """Cuts that were made because `--auto-cuts` asked for them, and those that are proposed."""

    applied: list[Any] = field(default_factory=list)   # native CutSuggestion
    proposed: list[Any] = field(default_factory=list)
    remedies: list[str] = field(default_factory=list)  # other parameters, one sentence each

    def sentences(self) -> list[str]:
        """What would help, one sentence each."""
        return [describe(cut) for cut in self.proposed] + self.remedies

    def __bool__(self) -> bool:
        return bool(self.applied or self.proposed)


def joined(edges: list[np.ndarray]) -> np.ndarray:
    """Edge lists one after the other."""
    return np.vstack([np.zeros((0, 2), np.int32), *edges]).astype(np.int32)


def stretch_of(design: Any) -> dict:
    """How far the layout is stretched, as report.json has it."""
    return _figures(native.layout_figures(design))


def is_stretched(stretch: dict, contacts: int) -> bool:
    """Whether a layout is so uneven that cuts are looked for."""
    return (stretch["scale_spread"] > STRETCHED_SPREAD
            or stretch["slack_springs"] > STRETCHED_SLACK * 2 * contacts)


def propose(outcome: Any, progress: Progress) -> None:
    """Fills `outcome.suggestions` with cuts and remedies for a design as it ended."""
    found, design = outcome.suggestions, outcome.design
    weak = weak_contacts(outcome)
    target = outcome.target
    search = native.suggest_cuts(target.V, target.F, design.cuts, design.parameters, UNASKED, weak,
                                 progress)
    found.proposed = list(search.cuts)
    outcome.stopped = outcome.stopped or search.stopped
    found.remedies = _remedies(outcome, weak)


def stretch_warning(outcome: Any) -> dict:
    """The entry among the report's warnings that a badly stretched layout gets."""
    stretch = outcome.stretch
    return {"what": f"the layout is badly stretched: its flat map scales tiles {stretch['scale_spread']:.3g} "
                    f"times differently, and the membrane is slack at {stretch['slack_springs']} places",
            "kind": "stretched", "tiles": [],
            "remedy": "cut it as suggested" if outcome.suggestions.proposed else
                      "no cut was found that is worth it"}


def weak_contacts(outcome: Any) -> list[tuple[int, int]]:
    """Tile pairs of contacts below f_min."""
    if outcome.verification is None:
        return []
    forces = outcome.verification.blocks.get("contact_forces", {})
    return [(int(a), int(b)) for a, b in forces.get("invalid_contacts", ())]


def describe(cut: Any) -> str:
    """One line on a cut and its predicted effect."""
    text = f"a cut of {cut.length_mm:.0f} mm {cut.reason}"
    if cut.before is None or cut.after is None:
        return text
    a, b = cut.before, cut.after
    return (f"{text} (predicted: flat area {a.area_ratio:.2f} to {b.area_ratio:.2f} times the actuated, "
            f"slack membrane at {a.slack_springs} to {b.slack_springs} places, "
            f"energy per contact {a.energy_per_contact:.2f} to {b.energy_per_contact:.2f})")


def to_list(found: Suggestions) -> list[dict]:
    """The block "suggested_cuts" of report.json, in the order in which cuts are to be made."""
    return [{"edges": [[int(a), int(b)] for a, b in cut.edges], "length_mm": cut.length_mm,
             "reason": cut.reason, "applied": applied,
             "predicted": {"before": _figures(cut.before), "after": _figures(cut.after)}}
            for cuts, applied in ((found.applied, True), (found.proposed, False)) for cut in cuts]


def _figures(figures: Any) -> dict | None:
    if figures is None:
        return None
    return {"scale_spread": figures.scale_spread, "area_ratio": figures.area_ratio,
            "energy_per_contact": figures.energy_per_contact, "spring_mean": figures.spring_mean,
            "slack_springs": int(figures.slack_springs)}


def _remedies(outcome: Any, weak: list[tuple[int, int]]) -> list[str]:
    """Values of parameters for pins without room and membranes without tension."""
    design, repair = outcome.design, outcome.repair
    below, _ = small_pins(outcome)
    pins = {int(side[0]) for side in below}
    if repair is not None:
        # Gaps are a matter of room between tiles; all other obstacles are pins'.
        pins |= {int(tile) for contact in repair.blocked
                 if contact.obstacle not in ("", "gap") for tile in contact.held}
    if not pins and not weak:
        return []
    values, get = native.find_remedies(design, sorted(pins), weak), design.parameters.get
    sentences = []
    if values.H_body is not None:
        sentences.append(f"tiles of H_body = {values.H_body:g} mm instead of {get('H_body'):g} give "
                         "the pins named a quarter more than A_pin_min")
    if values.L is not None:
        sentences.append(f"tiles of L = {values.L:g} mm instead of {get('L'):.3g} do so too"
                         if sentences else
                         f"tiles of L = {values.L:g} mm instead of {get('L'):.3g} give the pins named "
                         "a quarter more than A_pin_min")
    if values.tau is not None:
        sentences.append(f"membranes stretched to tau = {values.tau:g} instead of {get('tau'):g} would "
                         "be taut at all weak contacts")
    return sentences
