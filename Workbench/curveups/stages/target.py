# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh that becomes tiles: cleaned, checked and remeshed."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, require_no_error
from ..base.native import native
from ..base.parameters import parameter
from .cut_request import interior_edges, mesh_edges
from .following import Following, follow
from .stage import Inputs, Job, Result, Row, Stage

# Holes with a shorter edge than so many L are filled: most tiles would reach across.
HOLE_EDGE = 4.0
# Corners of ragged boundaries are found by the course of the boundary within so many L.
CORNER_REACH = 0.5
# Findings of check_mesh after which edge lengths mean nothing.
BROKEN = ("empty", "index-out-of-range", "not-finite")


@dataclass(frozen=True)
class Target(Result):
    """V (N x 3, mm) and F (M x 3)."""

    read_later = ("V", "F", "own_length", "wall")
    V: np.ndarray
    F: np.ndarray
    source_V: np.ndarray             # mesh before remeshing
    source_F: np.ndarray
    mean_edge: float
    edge_cv: float
    chord_error: float
    notes: tuple[str, ...]
    warned: tuple[Finding, ...]
    own_length: Optional[float]      # L, where the mesh is taken as it is
    wall: Optional[float] = None     # thickness of the part as drawn, mm
    unmended: Optional[tuple[np.ndarray, np.ndarray]] = None  # V, F as given, where mending changed them
    actions: tuple[str, ...] = ()    # of mending
    mended_by: float = 0.0           # Hausdorff distance of the two, mm
    creases: Optional[np.ndarray] = None  # E x 2, edges of source_F that stay, of a CAD part
    tiling: Optional[Finding] = None  # how it came, where there was an earlier one to follow
    followed: Optional[Following] = field(default=None, compare=False, metadata={"transient": True})

    @property
    def given(self) -> tuple[np.ndarray, np.ndarray]:
        """V and F as the user gave them: deviations are measured from these."""
        return self.unmended or (self.source_V, self.source_F)

    @property
    def followed_along(self) -> bool:
        """True for tiles that follow earlier ones."""
        return self.tiling is not None and self.tiling.kind == "followed"

    def fixes(self) -> Mapping[str, Any]:
        return {} if self.own_length is None else {"L": self.own_length}

    def report(self) -> dict[str, Any]:
        block: dict[str, Any] = {"mean_edge_mm": self.mean_edge, "edge_cv": self.edge_cv,
                                 "sagitta_mm": self.chord_error, "notes": list(self.notes)}
        if self.tiling is not None:
            block["tiling"] = {"followed": self.followed_along, **{
                name: str(figure) if isinstance(figure, Finding) else figure
                for name, figure in self.tiling.figures.items()}}
        return {"target": block}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("remesh", seconds),)


def _run(inputs: Inputs, job: Job) -> Target:
    source, surface, L = inputs["source"], inputs["surface"], inputs.parameters.get("L")
    job("checking the target")
    V, F, notes = surface.V, surface.F, list(surface.notes)
    mended: dict[str, Any] = {}
    uncrossed = False  # True where no faces run through one another: the search takes seconds
    if source.remesh:
        # Otherwise the mesh is taken as it is: cuts name its vertices by number.
        clean = native.clean_mesh(V, F, job)
        V, F = clean.V, clean.F
        notes += clean.notes
        if inputs.parameters.get("mend") == "on":
            V, F, mended, uncrossed = _mend(V, F, L, clean.notes, job)
    else:
        findings = native.check_mesh(V, F, 1.0, True, job)
        require_no_error([finding for finding in findings if finding.kind in BROKEN], inputs.where)
        L = _own_length(V, F, inputs.where)
    findings = native.check_mesh(V, F, L, source.will_be_cut, job, without_crossings=uncrossed)
    try:
        warned = require_no_error(findings, inputs.where)
    except CurveUpsError as error:
        if not source.remesh or inputs.parameters.get("mend") == "on":
            raise
        raise _with_mending(error, V, F, L, source.will_be_cut, job) from error
    if not source.remesh:
        ends = V[mesh_edges(F)[0]]
        lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        return Target(V, F, V, F, float(lengths.mean()), float(lengths.std() / lengths.mean()), 0.0,
                      tuple(notes), warned, L, surface.wall)
    creases = _creases(surface, V, F)
    mesh = None
    if source.follows is not None:
        followed = follow(source.follows, V, F, inputs.parameters, creases, job)
        mended.update(tiling=followed.said, followed=followed)
        warned += followed.warnings()
        mesh = followed.mesh
    if mesh is None:
        mesh = remesh(V, F, L, inputs.parameters, job, creases)
    return Target(mesh.V, mesh.F, V, F, mesh.mean_edge, mesh.edge_cv, mesh.chord_error, tuple(notes), warned,
                  None, surface.wall, creases=creases, **mended)


def remesh(V: np.ndarray, F: np.ndarray, L: float, parameters: Any, job: Job,
           creases: Optional[np.ndarray] = None) -> Any:
    """Native RemeshResult of a clean mesh. creases: edges (E x 2) that stay; None: those where facets turn by
    more than crease_angle."""
    kept = {"crease_angle": parameters.get("crease_angle")} if creases is None else {"features": creases}
    return native.remesh(V, F, L, job, **kept,
                         corner_reach=CORNER_REACH * L if parameters.get("mend") == "on" else 0.0)


def _creases(surface: Any, V: np.ndarray, F: np.ndarray) -> Optional[np.ndarray]:
    """Creases of a CAD part that cleaning and mending have kept: interior edges (E x 2) of V, F; None for
    other targets."""
    sharp = surface.creases
    if sharp is None or not len(sharp):
        return sharp
    number = {tuple(point): v for v, point in enumerate(V.tolist())}
    ends = [[number.get(tuple(point), -1) for point in pair] for pair in surface.V[sharp].tolist()]
    kept = {(min(pair), max(pair)) for pair in ends} & interior_edges(F)
    return np.array(sorted(kept), np.int32).reshape(-1, 2)


def _mend(V: np.ndarray, F: np.ndarray, L: float, cleaned: Sequence[str],
          job: Job) -> tuple[np.ndarray, np.ndarray, dict[str, Any], bool]:
    """Mended V and F, the members of Target that describe mending, and MendedMesh.without_crossings. cleaned:
    notes of clean_mesh."""
    if not len(F) or not np.isfinite(V).all():  # check_mesh refuses it
        return V, F, {}, False
    mesh = native.mend_mesh(V, F, L, HOLE_EDGE * L, job)
    if not mesh.actions:
        return V, F, {"actions": tuple(cleaned)}, mesh.without_crossings
    far = native.surface_deviation(mesh.V, mesh.F, V, F, job).hausdorff_mm
    members = {"actions": (*cleaned, *mesh.actions), "mended_by": far, "unmended": (V, F)}
    return mesh.V, mesh.F, members, mesh.without_crossings


def _with_mending(error: CurveUpsError, V: np.ndarray, F: np.ndarray, L: float, will_be_cut: bool,
                  job: Job) -> CurveUpsError:
    """The error, with mending as a remedy where that removes every error."""
    if not len(F) or not np.isfinite(V).all():
        return error
    mesh = native.mend_mesh(V, F, L, HOLE_EDGE * L, job)
    if any(finding.is_error for finding in native.check_mesh(mesh.V, mesh.F, L, will_be_cut, job)):
        return error
    mended = Finding.about("advice.mend_surface", actions=", ".join(mesh.actions))
    return CurveUpsError(error.what, error.where, f"{error.remedy}; or {mended}", error.status,
                         finding=error.finding)


STAGE = Stage("target", ("source", "surface"), frozenset({"target"}), _run,
              label="Target", commands=("solve",), shown=True)


def _own_length(V: np.ndarray, F: np.ndarray, where: str) -> float:
    length = float(native.mean_edge_length(V, F))
    row = parameter("L")
    if not row.minimum <= length <= row.maximum:
        raise CurveUpsError(
            f"the mesh's mean edge length is {length:.4g} mm", where,
            f"tiles have {row.minimum:g} to {row.maximum:g} mm: set scale for another unit, or remesh")
    return length
