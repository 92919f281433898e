# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the shape of the built piece and the way there: actuation.json, frames.json, frames.fold,
actuation.html and NAME-built.step."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any, Optional

import numpy as np

from .. import __version__
from ..base.errors import Stopped
from ..base.native import native
from ..base.output import Folder
from ..project.compensation import Compensation
from ..project.project import Results
from ..stages import RISEN
from ..stages.actuation import DRAG, Actuation
from ..stages.stage import Job
from . import html
from .data import to_text
from .moving import front_corners, moving_view, states_table

FORMAT, VERSION = "curveups-actuation", 1
FRAMES_FORMAT, FRAMES_VERSION = "curveups-frames", 1
ANSWER, FRAMES, FOLD, PAGE = "actuation.json", "frames.json", "frames.fold", "actuation.html"


def write_actuation(results: Results, path: Path, job: Job,
                    compensation: Optional[Compensation] = None) -> bool:
    """Writes all files of a run that made the path and the bodies; whether that, or the path before it, was
    stopped. actuation.json goes first and comes last. compensation: what the design comes from, where it goes
    into a design.json as well."""
    piece, step, stopped = results[RISEN], f"{results.name}-built.step", job.stopped
    with Folder(path) as folder:
        folder.remove(ANSWER, FRAMES, FOLD, PAGE, step)
        folder.write_text(FRAMES, _compact(_frames(piece)))
        folder.write_text(FOLD, _compact(_fold(piece, results.name)))
        folder.write_text(PAGE, _page(piece, results.name))
        if compensation:
            folder.write_text("design.json", native.write_design(results.design))
        try:
            write_frame(results["bodies"].model, piece.frame(piece.built), folder, step, job)
        except (Stopped, native.Cancelled):
            stopped = True
        folder.write_text(ANSWER, to_text({
            "format": FORMAT, "version": VERSION, "name": results.name,
            "status": "stopped" if stopped else "complete", "tiles": len(piece.design.F),
            "actuation": piece.block, "findings": [one.entry() for one in piece.findings()],
            **({"compensation": compensation.report()} if compensation else {}),
            "software": {"curveups": __version__}, "files": dict(folder.files)}))
    return stopped


def write_frame(model: Any, rows: np.ndarray, folder: Folder, name: str, job: Job) -> None:
    """The tiles of a PrintModel where a frame has them, as STEP."""
    job.go_on(f"writing {name}")
    posed = model.posed(rows)
    folder.write(name, lambda place: posed.write("step", "actuated", str(place), job))


def _compact(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")) + "\n"


def _frames(piece: Actuation) -> dict[str, Any]:
    """Lengths to 1e-6 mm; energies in N mm."""
    rows = [{"load": load, "time": float(time), "energy": float(energy), "stretch": float(stretch),
             "poses": np.round(poses, 9).tolist()}
            for load, time, energy, stretch, poses in
            zip(piece.loads, piece.time, piece.energy, piece.stretch, piece.frames)]
    return {"format": FRAMES_FORMAT, "version": FRAMES_VERSION, "frames": rows}


def _fold(piece: Actuation, name: str) -> dict[str, Any]:
    """FOLD 1.2: every tile has corners of its own, which move from frame to frame. Its sides are edges: some
    readers don't find them in the faces."""
    design, count = piece.design, len(piece.design.F)
    corners = np.arange(3 * count).reshape(count, 3)
    sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    frames = [{"frame_title": f"{time:.6g} s", "frame_classes": ["foldedForm"], "frame_parent": 0,
               "frame_inherit": True, "vertices_coords": _coordinates(front_corners(design, rows))}
              for time, rows in zip(piece.time, piece.frames)]
    return {"file_spec": 1.2, "file_creator": f"CurveUps {__version__}", "file_title": name,
            "file_classes": ["animation"], "frame_title": "design", "frame_classes": ["foldedForm"],
            "frame_attributes": ["3D", "convexFaces"], "frame_unit": "mm",
            "vertices_coords": _coordinates(np.asarray(design.V)[np.asarray(design.F)]),
            "edges_vertices": sides.tolist(), "edges_assignment": ["B"] * len(sides),
            "faces_vertices": corners.tolist(), "file_frames": frames}


def _coordinates(corners: np.ndarray) -> list[list[float]]:
    return np.round(corners.reshape(-1, 3), 6).tolist()


def _page(piece: Actuation, name: str) -> str:
    """actuation.html: the moving picture, then the states."""
    return html.page(name, [
        f"<h1>{escape(name)}: from flat to shape</h1>",
        *(f"<p>{escape(str(one))}</p>" for one in piece.findings()),
        html.picture(moving_view(piece), DRAG),
        "<h2>Where it comes to rest</h2>", states_table(piece.block)])
