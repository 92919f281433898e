# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes how a piece gets from flat to shape: actuation.json, frames.json, frames.fold, actuation.html and
NAME-settled.step; reads frames to begin from."""

from __future__ import annotations

import base64
import json
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

from .. import __version__
from ..base.errors import CurveUpsError, Stopped, tile_list
from ..base.findings import Finding
from ..base.native import native
from ..base.output import Folder
from ..base.reading import read_text
from ..project.compensation import Compensation
from ..stages.stage import Job
from . import html, tables
from .data import to_text

FORMAT, VERSION = "curveups-actuation", 1
FRAMES_FORMAT, FRAMES_VERSION = "curveups-frames", 1
_CANVAS = "width:100%;background:#fff;border:1px solid #e8e1d3;border-radius:.4rem;touch-action:none"
ANSWER, FRAMES, FOLD, PAGE = "actuation.json", "frames.json", "frames.fold", "actuation.html"


def read_start(text: str, count: int) -> Optional[np.ndarray]:
    """Where tiles begin: none for "flat", a row of a frame per tile for "target" and FRAMES.json[:NUMBER], by
    default the last of its frames."""
    if text == "flat":
        return None
    if text == "target":
        return np.tile((0.0, 0, 0, 1, 0, 0, 0), (count, 1))
    path, colon, number = text.rpartition(":")
    if not colon or not number.isdecimal():
        path, number = text, ""
    try:
        found = json.loads(read_text(Path(path)))
        if found["format"] != FRAMES_FORMAT:
            raise ValueError
        frames = found["frames"]
        rows = np.array(frames[int(number) if number else -1]["poses"], float).reshape(-1, 7)
    except OSError as error:
        raise CurveUpsError(f"the frames can't be read: {error.strerror}", path,
                            "give flat, target or a frames.json of 'curveups actuate'") from None
    except IndexError:
        raise CurveUpsError(f"there is no frame {number}", path,
                            f"give one of 0 to {len(frames) - 1}" if frames else "it has none") from None
    except (ValueError, KeyError, TypeError, RecursionError):
        raise CurveUpsError("these are no frames", path,
                            "give a frames.json of 'curveups actuate'") from None
    return rows


def write_actuation(found: Any, design: Any, name: str, begin: str, model: Any, path: Path, job: Job,
                    compensation: Optional[Compensation] = None) -> bool:
    """Writes all files; whether that, or the path before it, was stopped. actuation.json goes first and
    comes last. begin: what the path begins from. model: the design's PrintModel. compensation: what the
    design comes from, where it goes into a design.json as well."""
    step = f"{name}-settled.step"
    stopped = job.stopped
    with Folder(path) as folder:
        folder.remove(ANSWER, FRAMES, FOLD, PAGE, step)
        folder.write_text(FRAMES, _compact(_frames(found)))
        folder.write_text(FOLD, _compact(_fold(found, design, name)))
        answer = build_answer(found, design, name, begin, stopped)
        if compensation:
            answer["compensation"] = compensation.report()
            folder.write_text("design.json", native.write_design(design))
        folder.write_text(PAGE, build_page(answer, found, design))
        try:
            if not job(f"writing {step}"):
                raise Stopped
            posed = model.posed(found.frames[-1])
            folder.write(step, lambda place: posed.write("step", "actuated", str(place), job))
        except (Stopped, native.Cancelled):
            stopped = True
        answer = {**answer, "status": _status(stopped), "files": dict(folder.files)}
        folder.write_text(ANSWER, to_text(answer))
    return stopped


def build_answer(found: Any, design: Any, name: str, begin: str, stopped: bool) -> dict[str, Any]:
    """actuation.json but for its files."""
    return {"format": FORMAT, "version": VERSION, "name": name, "status": _status(stopped),
            "tiles": len(design.F), "from": begin, "actuation": found.block,
            "findings": [one.entry() for one in findings(found.block)],
            "software": {"curveups": __version__}}


def findings(block: dict[str, Any]) -> list[Finding]:
    """The answer, then what keeps the piece from its shape."""
    if block["arrives"] is None:
        return [Finding.about("actuation_stopped" if block["stopped"] else "actuation_restless")]
    open_pairs = _pairs(block["open_contacts"])
    if block["arrives"]:
        found = [Finding.about("actuation_arrives", shortfall=block["shortfall_mm"])]
    elif open_pairs:
        found = [Finding.about("actuation_jammed", _tiles(open_pairs), shortfall=block["shortfall_mm"],
                               open=len(open_pairs), count=block["contacts"], contacts=open_pairs)]
    else:
        found = [Finding.about("actuation_short", shortfall=block["shortfall_mm"],
                               most=block["tolerance_mm"])]
    if block["trap"]:
        wedged = _pairs(block["sampled"][0]["wedged"])
        found.append(Finding.about("actuation_trapped" if wedged else "actuation_elsewhere", _tiles(wedged),
                                   distance=block["trap_distance_mm"], pairs=wedged))
    elif not block["arrives"] and block["reach_friction"] is not None:
        found.append(Finding.about("actuation_friction", reach=block["reach_friction"]))
    return found


def _pairs(pairs: Sequence[Sequence[int]]) -> tuple[tuple[int, ...], ...]:
    return tuple(tuple(pair) for pair in pairs)


def _tiles(pairs: Sequence[Sequence[int]]) -> list[int]:
    return [tile for pair in pairs for tile in pair]


def _status(stopped: bool) -> str:
    return "stopped" if stopped else "complete"


def _compact(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")) + "\n"


def _frames(found: Any) -> dict[str, Any]:
    """Lengths to 1e-6 mm; energies in N mm."""
    return {"format": FRAMES_FORMAT, "version": FRAMES_VERSION,
            "frames": [{"time": float(time), "energy": float(energy), "friction": float(friction),
                        "stretch": float(stretch), "poses": np.round(poses, 9).tolist()}
                       for time, energy, friction, stretch, poses in
                       zip(found.time, found.energy, found.friction, found.stretch, found.frames)]}


def front_corners(design: Any, rows: np.ndarray) -> np.ndarray:
    """M x 3 x 3: the tiles' front corners in a frame."""
    corners = np.asarray(design.V)[np.asarray(design.F)]
    w, axis = rows[:, None, 3:4], rows[:, None, 4:]
    across = 2 * np.cross(axis, corners)
    return corners + w * across + np.cross(axis, across) + rows[:, None, :3]


def _fold(found: Any, design: Any, name: str) -> dict[str, Any]:
    """FOLD 1.1: every tile has corners of its own, which move from frame to frame."""
    count = len(design.F)
    frames = [{"frame_title": f"{time:.6g} s", "frame_classes": ["foldedForm"], "frame_parent": 0,
               "frame_inherit": True, "vertices_coords": _coordinates(front_corners(design, rows))}
              for time, rows in zip(found.time, found.frames)]
    return {"file_spec": 1.1, "file_creator": f"CurveUps {__version__}", "file_title": name,
            "file_classes": ["animation"], "frame_title": "design", "frame_classes": ["foldedForm"],
            "frame_attributes": ["3D"], "frame_unit": "mm",
            "vertices_coords": _coordinates(np.asarray(design.V)[np.asarray(design.F)]),
            "faces_vertices": np.arange(3 * count).reshape(count, 3).tolist(), "file_frames": frames}


def _coordinates(corners: np.ndarray) -> list[list[float]]:
    return np.round(corners.reshape(-1, 3), 6).tolist()


def build_page(answer: dict[str, Any], found: Any, design: Any) -> str:
    """actuation.html: the moving picture, then the answers."""
    block = answer["actuation"]
    kind = {True: "valid", False: "invalid", None: "open"}[block["arrives"]]
    said, *others = findings(block)
    remedy = said.remedy()
    parts = [f"<h1>{escape(answer['name'])}: from flat to shape</h1>",
             f'<p><span class="verdict {kind}">{escape(str(said))}</span></p>',
             *(f"<p>{escape(text)}</p>" for text in (*map(str, others), remedy) if text),
             _moving(found, design)]
    if said.tiles:
        parts.append(f'<p class="note">Tiles of open contacts: {escape(tile_list(said.tiles))}</p>')
    parts += ["<h2>Answers</h2>", tables.table(_answers(block))]
    ends = [("from the target", block["from_target"])]
    if "sampled" in block:
        ends = [*(("flat", one) for one in block["sampled"]), *ends,
                ("from the target", block["frictionless_from_target"])]
    parts += ["<h2>Where paths end</h2>", tables.table([_end(*one) for one in ends], (
        "Begins", "Friction", "Arrives", "Short by, mm", "Open contacts", "Scan mean / largest, mm",
        "Energy, N mm"))]
    return html.page(answer["name"], parts)


def _answers(block: dict[str, Any]) -> list[tuple[Any, ...]]:
    rows: list[tuple[Any, ...]] = [
        ("It arrives by itself", block["arrives"]),
        ("Friction coefficient", block["friction_coefficient"]),
        ("Short of the shape that it keeps once it is there, mm", block["shortfall_mm"]),
        ("Tolerance (hold_tolerance), mm", block["tolerance_mm"]),
        ("Virtual scan: mean, largest, mm", [block["scan"]["mean_mm"], block["scan"]["max_mm"]])]
    if "sampled" in block:
        reach = block["reach_friction"]
        rows += [("Largest sampled friction at which it arrives", "none" if reach is None else reach),
                 ("Trap: without friction, flat and target end differently", block["trap"]),
                 ("Distance of these ends, mm", block["trap_distance_mm"])]
    return rows


def _end(begins: str, end: dict[str, Any]) -> tuple[Any, ...]:
    return (begins, end["friction_coefficient"], "no answer" if end["arrives"] is None else end["arrives"],
            end["shortfall_mm"], len(end["open_contacts"]),
            f"{end['scan']['mean_mm']:.2f} / {end['scan']['max_mm']:.2f}", end["energy_n_mm"])


def _moving(found: Any, design: Any) -> str:
    """The frames, to be played, turned by dragging and stepped through. Corners are 16-bit numbers."""
    corners = np.stack([front_corners(design, rows).reshape(-1, 3) for rows in found.frames])
    middle = 0.5 * (corners.min((0, 1)) + corners.max((0, 1)))
    size = max(float(np.linalg.norm(corners - middle, axis=2).max()), 1e-9)  # it fits however it is turned
    whole = np.round((corners - middle) * (32767 / size)).astype("<i2")
    data = base64.b64encode(whole.tobytes()).decode("ascii")
    script = files(__package__).joinpath("frames.js").read_text("utf-8")
    return (f'<figure><canvas id="piece" width="1200" height="760" style="{_CANVAS}"></canvas>'
            f'<p><button id="play">Play</button> <input id="frame" type="range" min="0" '
            f'max="{len(found.frames) - 1}" value="0" style="width:70%"> <span id="at"></span></p>'
            "<figcaption>Drag to turn. Fronts are yellow, backs are blue.</figcaption></figure>"
            f"<script>const FRAMES={len(found.frames)},DATA='{data}',"
            f"TIMES={np.round(found.time, 6).tolist()},"
            f"ENERGIES={np.round(found.energy, 3).tolist()};\n{script}</script>")
