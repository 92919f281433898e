# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of weak contacts: poses, pins and, where these are not enough, vertices (Eq. 3)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of
from ..base.native import native
from .design import DesignResult, design_digest
from .stage import Inputs, Job, Result, Row, Stage, moved_vertices
from .verification import verification_of

_ADVICE = ("advice.cut_gaps", "advice.pin_room", "advice.pull")  # where contacts stay weak


@dataclass(frozen=True)
class Repair(DesignResult):
    """The design after repair; the layout's own where none was needed."""

    verification: Optional[Result] = None     # of the design, where it is known
    status: str = ""                          # empty where repair did not run
    block: Optional[dict] = None              # of report.json
    blocked: tuple[Finding, ...] = ()         # why contacts stay weak
    suggestions: tuple[Finding, ...] = ()
    warned: tuple[Finding, ...] = ()

    @property
    def stopped(self) -> bool:
        return self.status == "stopped"

    def report(self) -> dict[str, Any]:
        return {} if self.block is None else {"repair": self.block}

    def advice(self) -> Sequence[Finding]:
        return self.blocked

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("refine", seconds, len(self.block["steps"])),) if self.block else ()


def _run(inputs: Inputs, job: Job) -> Repair:
    before, verified = inputs["layout"].design, inputs["verification of the layout"]
    known = verified.verification
    needless = known.valid and not inputs.parameters.get("self_shaping")
    if needless or known.note or known.failure or not inputs.parameters.get("run_repair"):
        return Repair(before, verified.verdict)
    design = before.with_parameters(inputs.parameters)
    repaired = native.repair_design(design, job, job.listener("repair"), known.solved)
    changed = design_digest(repaired.design) != design_digest(design)
    reasons = all_of(contact.reason for contact in repaired.blocked)
    suggestions = tuple(map(Finding, _ADVICE)) if reasons else ()
    if repaired.breakdown:
        suggestions += (Finding.about("broken_down", said=repaired.breakdown),)
    weak = {frozenset(contact.tiles) for contact in repaired.blocked}
    mended = [list(pair) for pair in known.weak_contacts if frozenset(pair) not in weak] if changed else []
    block = {
        **repaired.block,
        "blocked": [{"tiles": contact.tiles, "reason": str(reason)}
                    for contact, reason in zip(repaired.blocked, reasons)],
        "cuts": list(map(str, all_of(repaired.cuts))),
        "suggestions": list(map(str, suggestions)), "mended": mended,
        "moved_vertices": moved_vertices(before.V, repaired.design.V, before.F)}
    verdict = verified.verdict
    if changed:
        verdict = repaired.verification and verification_of(repaired.verification, repaired.design)
    return Repair(repaired.design if changed else before, verdict, repaired.status, block, reasons,
                  suggestions)


def _failed(error: CurveUpsError, inputs: Inputs) -> Repair:
    # Repair can't begin: the layout stays, with its verdict.
    return Repair(inputs["layout"].design, inputs["verification of the layout"].verdict,
                  warned=(Finding("repair", (), {"error": error.what}),))


STAGE = Stage("repair", ("layout", "verification of the layout"),
              frozenset({"tiles", "layout", "bodies", "physics", "repair"}), _run, _failed,
              lambda stage, inputs: Repair(inputs["layout"].design,
                                           inputs["verification of the layout"].verdict),
              label="Repair", commands=("solve",))
