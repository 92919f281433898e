# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact physical model: membranes, contact forces and the verdict on them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of, failed
from ..base.native import native
from .stage import Inputs, Job, Picture, Result, Row, Stage


@dataclass(frozen=True)
class Verification(Result):
    """Result of the physical model; empty blocks where it was not computed."""

    note: Optional[Finding] = None     # why it was not computed: the verdict stays open
    failure: Optional[Finding] = None  # why it failed: the design is not valid
    valid: bool = False
    blocks: Mapping[str, Any] = field(default_factory=dict)
    broken: tuple[Finding, ...] = ()   # reasons
    warned: tuple[Finding, ...] = ()
    complete: bool = True              # False without a verdict: weak points end the work early
    design: Any = None                 # native Design, for pictures
    arrays: Mapping[str, np.ndarray] = field(default_factory=dict)  # per contact and per tile
    # Front and back, for pictures: most of a verification, made anew on request.
    membranes: tuple[Mapping[str, np.ndarray], ...] = field(default=(), metadata={"transient": True})
    # Native SolvedDesign, from which repair and settling start; None in a saved result.
    solved: Any = field(default=None, compare=False, metadata={"transient": True})

    @property
    def judged(self) -> bool:
        """True where there is a verdict."""
        return not self.note

    @property
    def weak_contacts(self) -> list[tuple[int, int]]:
        """Tile pairs of contacts below f_min."""
        pairs = self.blocks.get("contact_forces", {}).get("invalid_contacts", ())
        return [(int(a), int(b)) for a, b in pairs]

    def report(self) -> dict[str, Any]:
        return {**self.blocks, "worst_contacts": self.worst_contacts()} if self.blocks else {}

    def worst_contacts(self, most: int = 5) -> list[dict[str, Any]]:
        """Contacts of least normal force, N, the weakest first; tiles are rows of F."""
        if not len(self.arrays.get("contact_tiles", ())):
            return []
        order = np.argsort(self.arrays["contact_normal_min"], kind="stable")[:most]
        return [{"tiles": [int(tile) for tile in self.arrays["contact_tiles"][k]],
                 **{name: float(self.arrays[f"contact_{name}"][k])
                    for name in ("normal_min", "normal_mean", "friction_ratio")}} for k in order]

    def rows(self, seconds: float) -> Sequence[Row]:
        if not self.judged:
            return ()
        physics = self.blocks.get("physics", {})
        return (Row("verify", seconds, sum(sum(physics.get(f"newton_iterations_{mesh}", ()))
                                           for mesh in ("coarse", "fine"))),)

    def pictures(self) -> Sequence[Picture]:
        if not len(self.arrays.get("contact_tiles", ())):
            return ()
        pairs, friction = self.arrays["contact_tiles"], np.zeros(len(self.design.F))
        for column in range(2):
            np.fmax.at(friction, pairs[:, column], self.arrays["contact_friction_ratio"])
        weak = self.weak_contacts
        marked = " Contacts below f_min are marked." if weak else ""
        forces = {"design": self.design, "values": self.arrays["tile_normal_force"], "label": "N",
                  "marked": weak}
        return (
            Picture("Contact forces", f"Least normal force at each tile's contact points.{marked}",
                    "pictures.flat_layout", forces),
            Picture("", f"Largest friction that any of a tile's contacts needs.{marked}",
                    "pictures.flat_layout",
                    {**forces, "values": friction, "label": "friction / normal force"}),
            *self._membrane_pictures())

    def _membrane_pictures(self) -> Sequence[Picture]:
        if not self.membranes or not all(len(side["triangles"]) for side in self.membranes):
            return ()
        return (Picture(
            "Membranes",
            "The larger principal stretch of both membranes when actuated (tau = "
            f"{self.design.parameters.get('tau'):g} before), on the flat layout seen from the front. The "
            "scale leaves out the hundredth at either end; all but a hundredth of the area is stretched by "
            f"{self.blocks['physics'].get('stretch_99', 0.0):.4g} at most. Wrinkled places are tinted, slack "
            "ones grey, and the pins, to which the membranes are glued, are left white.",
            "pictures.stretch_view", {"membranes": self.membranes}),)


def verification_of(report: Any, design: Any) -> Verification:
    """Verification by a native VerificationReport of a native Design."""
    names = ("contact_tiles", "contact_normal_min", "contact_normal_mean", "contact_friction_ratio",
             "tile_normal_force")
    sides = tuple({name: np.asarray(getattr(side, name))
                   for name in ("flat", "triangles", "stretch", "tension")} for side in report.membranes)
    return Verification(valid=report.valid, blocks=report.blocks, broken=all_of(report.reasons),
                        warned=all_of(report.warnings), complete=report.complete, design=design,
                        arrays={name: np.asarray(getattr(report, name)) for name in names}, membranes=sides,
                        solved=report.solved)


def _verify(design: Any, inputs: Inputs, job: Job, weak_is_enough: bool = False) -> Verification:
    """Runs the model on a native Design. weak_is_enough: without a verdict where points are weak."""
    if not inputs.parameters.get("run_verification"):
        return Verification(note=Finding("unverified.off"))
    design = design.with_parameters(inputs.parameters)
    return verification_of(native.verify_design(design, job, weak_is_enough), design)


@dataclass(frozen=True)
class LayoutVerification(Result):
    """Verification of the layout, for repair."""

    verification: Verification

    @property
    def verdict(self) -> Optional[Verification]:
        """Verification of the design where repair leaves the layout as it is; None where it is incomplete."""
        return self.verification if self.verification.complete else None

    def rows(self, seconds: float) -> Sequence[Row]:
        return self.verification.rows(seconds)


def _verify_design(inputs: Inputs, job: Job) -> Verification:
    finished = inputs["design"]
    return finished.verification or _verify(finished.design, inputs, job)


def _failed(error: CurveUpsError, inputs: Inputs) -> Verification:
    # Files of the layout are written; without a verdict it must not pass as valid.
    failure = failed("verification_failed", error)
    return Verification(failure=failure, broken=(failure,))


def _stopped(stage: str, inputs: Inputs) -> Verification:
    return Verification(note=Finding.about("stopped", stage=stage.split(" of ")[0]))


PARTS = frozenset({"tiles", "bodies", "physics"})
OF_LAYOUT = Stage("verification of the layout", ("layout",), PARTS,
                  lambda inputs, job: LayoutVerification(
                      _verify(inputs["layout"].design, inputs, job, weak_is_enough=True)),
                  lambda error, inputs: LayoutVerification(_failed(error, inputs)),
                  lambda stage, inputs: LayoutVerification(_stopped(stage, inputs)),
                  label="First verification", commands=("solve",), shown=True)
STAGE = Stage("verification", ("design",), PARTS, _verify_design, _failed, _stopped,
              label="Verification", commands=("solve", "verify"), judges=True, shown=True)
