# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the shape of the built piece and the way there: actuation.json, frames.json, frames.fold,
actuation.html and NAME-built.step."""

from __future__ import annotations

import base64
import json
from importlib.resources import files
from pathlib import Path
from typing import Any, Iterator

import numpy as np
from .. import __version__
from ..base.errors import Stopped
from ..base.native import native
from ..base.output import Folder
from ..project.project import Results
from ..stages import RISEN
from ..stages.actuation import DRAG, Actuation, moved
from ..stages.stage import Job, Picture
from . import html
from .data import to_text

OPEN = (4, 75)  # hue and saturation (%) of tiles whose contacts stay open


def front_corners(design: Any, rows: np.ndarray) -> np.ndarray:
    """M x 3 x 3: the tiles' front corners in a frame."""
    return moved(np.asarray(design.V)[np.asarray(design.F)], rows)


def moving_view(piece: Actuation) -> str:
    """The frames, to be played, turned by dragging and stepped through; one a page. Corners are 16-bit
    numbers."""
    corners = np.stack([front_corners(piece.design, rows).reshape(-1, 3) for rows in piece.frames])
    corners -= corners.mean(1, keepdims=True)  # the layout may lie far from the target
    size = max(float(np.linalg.norm(corners, axis=2).max()), 1e-9)  # it fits however it is turned
    whole = np.round(corners * (32767 / size)).astype("<i2")
    marks = open_tiles(piece)
    return html.render(
        "moving.html", count=len(corners), data=base64.b64encode(whole.tobytes()).decode("ascii"),
        doing=[html.STATE_NAMES[load] for load in piece.loads], marks=marks, hue=OPEN,
        frames=[frame + 1 for frame in marks], times=np.round(piece.time, 6).tolist(),
        energies=np.round(piece.energy, 3).tolist(),
        script=html.markup(files(__package__).joinpath("frames.js").read_text("utf-8")))


def open_tiles(piece: Actuation) -> dict[int, list[bool]]:
    """Tiles of open contacts in the frames in which the piece comes to rest, where there are some."""
    marks = {}
    for state in piece.states.values():
        of_tile = np.zeros(len(piece.design.F), bool)
        of_tile[[tile for pair in state["open_contacts"] for tile in pair]] = True
        if state["converged"] and of_tile.any() and "last_frame" in state:
            marks[state["last_frame"]] = of_tile.tolist()
    return marks


FORMAT, VERSION = "curveups-actuation", 1
FRAMES_FORMAT, FRAMES_VERSION = "curveups-frames", 1
ANSWER, FRAMES, FOLD, PAGE = "actuation.json", "frames.json", "frames.fold", "actuation.html"


def write_actuation(results: Results, path: Path, job: Job) -> bool:
    """Writes all files of a run that made the path and the bodies; whether that, or the path before it, was
    stopped. actuation.json goes first and comes last."""
    piece, step, stopped = results[RISEN], f"{results.name}-built.step", job.stopped
    with Folder(path) as folder:
        folder.remove(ANSWER, FRAMES, FOLD, PAGE, step)
        folder.write_text(FRAMES, _compact(_frames(piece)))
        folder.write_text(FOLD, _compact(_fold(piece, results.name)))
        folder.write_text(PAGE, _page(piece, results.name))
        try:
            write_frame(results["bodies"].model, piece.tiles(piece.built), folder, step, job)
        except (Stopped, native.Cancelled):
            stopped = True
        folder.write_text(ANSWER, to_text({
            "format": FORMAT, "version": VERSION, "name": results.name,
            "status": "stopped" if stopped else "complete", "tiles": len(piece.design.F),
            "actuation": piece.block, "findings": [finding.entry() for finding in piece.findings()],
            "software": {"curveups": __version__}, "files": dict(folder.files)}))
    return stopped


def write_frame(model: Any, rows: np.ndarray, folder: Folder, name: str, job: Job) -> None:
    """Writes the tiles of a PrintModel where a frame has them, as STEP."""
    job.go_on(f"writing {name}")
    folder.write(name, lambda place: model.posed(rows).write("step", "actuated", str(place), job))


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
    """Text of actuation.html."""
    return html.render("actuation.html", title=name, findings=piece.findings(), block=piece.block, drag=DRAG,
                       moving=moving_view(piece) if len(piece.time) else None, maps=list(_maps(piece)))


def _maps(piece: Actuation) -> Iterator[Picture]:
    """Tiles of each state, coloured by their distances from the target, on one scale."""
    for state in piece.states:
        corners = front_corners(piece.design, piece.tiles(state)).reshape(-1, 3)
        yield Picture("", f"{html.STATE_NAMES[state].capitalize()}: distance of each tile from the target.",
                      "pictures.distance_view",
                      {"V": corners, "F": np.arange(len(corners)).reshape(-1, 3),
                       "values": piece.deviation(state), "most": float(piece.deviations.max())})
