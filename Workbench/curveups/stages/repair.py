# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of weak contacts: poses, pins and, where these do not do, vertices (Eq. 3)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of
from ..base.native import native
from .design import design_digest
from .stage import Inputs, Job, Result, Row, Stage, moved_vertices
from .verification import verification_of

_ADVICE = ("advice.cut_gaps", "advice.pin_room", "advice.pull")  # where contacts stay weak


@dataclass(frozen=True)
class Repair(Result):
    """The design as it is after repair: the layout's own where none was needed."""

    design: Any
    verification: Optional[Result] = None     # of the design, where it is known
    status: str = ""                          # empty where repair did not run
    block: Optional[dict] = None              # of report.json
    blocked: tuple[dict, ...] = ()            # contacts that stay weak: tiles, reason
    suggestions: tuple[Finding, ...] = ()
    warned: tuple[Finding, ...] = ()

    @property
    def content(self) -> str:
        return design_digest(self.design)

    @property
    def stopped(self) -> bool:
        return self.status == "stopped"

    def report(self) -> dict[str, Any]:
        return {} if self.block is None else {"repair": self.block}

    def advice(self) -> Sequence[Finding]:
        return [contact["reason"] for contact in self.blocked]

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("refine", seconds, len(self.block["steps"])),) if self.block else ()


def _run(inputs: Inputs, job: Job) -> Repair:
    before, verified = inputs["layout"].design, inputs["verification of the layout"]
    known = verified.verification
    asked = inputs.parameters.get("run_repair")
    does = known.valid and not inputs.parameters.get("self_shaping")
    if does or known.note or known.failure or not asked:
        return Repair(before, verified.verdict)
    design = before.with_parameters(inputs.parameters)
    found = native.repair_design(design, job, job.listener("repair"), known.solved)
    changed = design_digest(found.design) != design_digest(design)
    blocked: tuple[dict[str, Any], ...] = tuple(
        {"tiles": list(contact.tiles), "reason": Finding.of(contact.reason)} for contact in found.blocked)
    suggestions = tuple(map(Finding, _ADVICE)) if blocked else ()
    if found.breakdown:
        suggestions += (Finding.about("broken_down", said=found.breakdown),)
    weak = {frozenset(contact["tiles"]) for contact in blocked}
    mended = [list(pair) for pair in known.weak_contacts if frozenset(pair) not in weak] if changed else []
    block = {
        "status": found.status, "restored_mm": found.restored_mm, "largest_move_mm": found.largest_move_mm,
        "largest_vertex_move_mm": found.largest_vertex_move_mm,
        "steps": [{"weak_points": int(step.weak_points), "least_force_of_f_min": step.least_force,
                   "least_floor_of_f_min": step.least_floor, "vertices": bool(step.vertices),
                   "fresh_mesh": bool(step.fresh_mesh)} for step in found.steps],
        "blocked": [{"tiles": contact["tiles"], "reason": str(contact["reason"])} for contact in blocked],
        "cuts": list(map(str, all_of(found.cuts))),
        "suggestions": list(map(str, suggestions)), "mended": mended,
        "moved_vertices": moved_vertices(before.V, found.design.V, before.F)}
    verdict = verified.verdict
    if changed:
        verdict = verification_of(found.verification, found.design) if found.verification else None
    return Repair(found.design if changed else before, verdict, found.status, block, blocked, suggestions)


def _failed(error: CurveUpsError, inputs: Inputs) -> Repair:
    # No repair can begin from here: the design ends as it is, with the verdict it has.
    return Repair(inputs["layout"].design, inputs["verification of the layout"].verdict,
                  warned=(Finding("repair", (), {"error": error.what}),))


STAGE = Stage("repair", ("layout", "verification of the layout"),
              frozenset({"tiles", "layout", "bodies", "physics", "repair"}), _run, _failed,
              lambda stage, inputs: Repair(inputs["layout"].design,
                                           inputs["verification of the layout"].verdict),
              label="Repair", asked_by=("solve",))
