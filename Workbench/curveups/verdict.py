# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a design is valid, and why not: interfaces' definition in one place."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Optional

from .errors import tile_list, tile_name

TOLERANCE = 1e-6  # mm, as core/tolerances.hpp


@dataclass
class Verdict:
    """valid is None where the design could not be judged; the reasons say why in any case."""

    valid: Optional[bool] = None
    reasons: list[str] = field(default_factory=list)


def judge(outcome: Any) -> Verdict:
    """The verdict on an outcome of the pipeline."""
    broken = _geometry(outcome) + _solids(outcome.solids)
    if outcome.verify_failure:
        broken.append(outcome.verify_failure)
    if outcome.verification is not None:
        physical = outcome.verification.to_dict()
        if not physical["valid"]:
            broken += list(physical["reasons"])
            if outcome.repair is not None:
                broken += [contact.reason for contact in outcome.repair.blocked]
            broken += _remedies(outcome)
        if outcome.recheck is not None and not outcome.recheck.valid:
            broken += [f"on a membrane mesh of half the size: {reason}"
                       for reason in outcome.recheck.reasons]
        return Verdict(not broken, broken)
    if broken:
        return Verdict(False, broken)
    return Verdict(None, [outcome.verify_note] if outcome.verify_note else [])


def _remedies(outcome: Any) -> list[str]:
    """What would help, with values where they are known, in general words otherwise."""
    known = [f"suggested: {sentence}" for sentence in outcome.suggestions.sentences()]
    return known or (list(outcome.repair.suggestions) if outcome.repair is not None else [])


def small_pins(outcome: Any) -> tuple[list, list]:
    """Pin sides below the floor (not valid), and those between it and A_pin_min (a warning)."""
    floor = outcome.design.parameters.get("A_pin_floor")
    sides = outcome.figures.constraints.small_pins
    return [s for s in sides if s[2] < floor], [s for s in sides if s[2] >= floor]


def _geometry(outcome: Any) -> list[str]:
    figures, reasons = outcome.figures, []
    constraints = figures.constraints
    if constraints.max_gap_violation_mm > TOLERANCE:
        pairs = [f"{tile_name(a)}-{tile_name(b)}" for a, b in constraints.close_pairs[:6]]
        reasons.append(f"flat tiles are {constraints.max_gap_violation_mm:.3g} mm nearer than "
                       "d_gap_min" + (f" ({', '.join(pairs)})" if pairs else ""))
    if constraints.max_pin_bound_violation_mm > TOLERANCE:
        reasons.append(f"pin insets leave their bounds by "
                       f"{constraints.max_pin_bound_violation_mm:.3g} mm")
    below, _ = small_pins(outcome)
    if below:
        tiles = sorted({side[0] for side in below})
        reasons.append(f"{len(below)} pin sides are smaller than A_pin_floor ({tile_list(tiles)})")
    if figures.unresolved:
        tiles = sorted({int(t) for pair in figures.unresolved for t in pair})
        reasons.append(f"{len(figures.unresolved)} pairs of tiles overlap when actuated and no "
                       f"plane parts them ({tile_list(tiles)})")
    if reasons and unsettled(outcome):
        reasons.append(unsettled(outcome))
    return reasons


def unsettled(outcome: Any) -> str:
    """What to say of a layout that the optimiser gave up: a reason where a constraint is violated, a
    warning where all hold, since then nothing but its quality is in doubt. Empty where it settled."""
    layout = outcome.layout
    if layout is None or layout.converged or layout.stopped:
        return ""
    return f"the layout did not converge in {layout.iterations} iterations"


def warn_unsettled(outcome: Any) -> list[dict]:
    """The report's warning of a layout that did not settle and violates nothing."""
    text = unsettled(outcome)
    if not text or text in _geometry(outcome):
        return []
    return [{"what": f"{text}; all constraints hold", "kind": "layout", "tiles": []}]


def _solids(solids: Any) -> list[str]:
    if solids is None:
        return []
    reasons = []
    if solids.unsound:
        more = f" and {len(solids.unsound) - 3} more" if len(solids.unsound) > 3 else ""
        reasons.append(f"solids are not sound: {'; '.join(solids.unsound[:3])}{more}")
    if solids.min_clearance_flat_mm <= 0:  # the distance of bodies that overlap is 0 as well
        reasons.append("solids meet in the flat layout")
    if solids.max_overlap_actuated_mm3 > TOLERANCE:
        reasons.append(f"actuated tiles overlap by {solids.max_overlap_actuated_mm3:.3g} mm3")
    return reasons
