# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes how a piece gets from flat to shape: actuation.json, frames.json, frames.fold, actuation.html and
NAME-settled.step; reads frames to begin from."""

from __future__ import annotations

import base64
import json
import zlib
from html import escape
from pathlib import Path
from typing import Any, Mapping, Optional

import numpy as np

from .. import __version__
from ..base.errors import CurveUpsError, Stopped, tile_list, tile_name
from ..base.native import native
from ..base.output import Folder
from ..project.compensation import Compensation
from ..project.project import Results
from ..stages import BY_NAME, HELP, RISEN, START
from ..stages.actuation import HANDS, Actuation, ActuationStart, findings, path_digest
from ..stages.stage import Job, digest
from . import html, tables
from .data import to_text
from .moving import answers, changes_tried, front_corners, moving_view, released

FORMAT, VERSION = "curveups-actuation", 1
FRAMES_FORMAT, FRAMES_VERSION = "curveups-frames", 1
_MOST_MEMORY = 2**30  # bytes: more is no path's
ANSWER, FRAMES, FOLD, PAGE = "actuation.json", "frames.json", "frames.fold", "actuation.html"


def read_start(text: str, count: int) -> ActuationStart:
    """Where tiles begin: "flat", "target" or FRAMES.json[:NUMBER], by default the last of its frames."""
    if text == "flat":
        return ActuationStart()
    if text == "target":
        return ActuationStart(text, np.tile((0.0, 0, 0, 1, 0, 0, 0), (count, 1)))
    path, colon, number = text.rpartition(":")
    if not colon or not number.isdecimal():
        path, number = text, ""
    try:
        found = json.loads(Path(path).read_text(encoding="utf-8-sig"))
        if found["format"] != FRAMES_FORMAT:
            raise ValueError
        frames = found["frames"]
        frame = frames[int(number) if number else -1]
        rows = np.array(frame["poses"], float).reshape(-1, 7)
        memory, of = _memory(frame)
    except OSError as error:
        raise CurveUpsError(f"the frames can't be read: {error.strerror}", path,
                            "give flat, target or a frames.json of 'curveups actuate'") from None
    except IndexError:
        raise CurveUpsError(f"there is no frame {number}", path,
                            f"give one of 0 to {len(frames) - 1}" if frames else "it has none") from None
    except (ValueError, KeyError, TypeError, RecursionError, zlib.error):
        raise CurveUpsError("these are no frames", path,
                            "give a frames.json of 'curveups actuate'") from None
    return ActuationStart(text, rows, memory=memory, of=of)


def _memory(frame: Mapping[str, Any]) -> tuple[Optional[np.ndarray], str]:
    """Of a frame, and of which design; none where it has none. Raises what damaged data raises."""
    if "memory" not in frame:
        return None, ""
    unpack = zlib.decompressobj()
    data = unpack.decompress(base64.b64decode(frame["memory"], validate=True), _MOST_MEMORY)
    if not unpack.eof:  # it is cut off, or has no end
        raise ValueError
    return np.frombuffer(data, "<f8").astype(float), str(frame["memory_of"])


def write_actuation(results: Results, path: Path, job: Job,
                    compensation: Optional[Compensation] = None, former: Optional[bytes] = None) -> bool:
    """Writes all files of a run that made the path and the bodies; whether that, or the path before it, was
    stopped. actuation.json goes first and comes last. compensation: what the design comes from, where it goes
    into a design.json as well. former: a body (STL) over which to press a piece that jams."""
    found, step, dome = results[RISEN], f"{results.name}-settled.step", f"{results.name}-former.stl"
    helped, stopped = results.get(HELP), job.stopped
    block = {**found.block, **(helped.report().get("actuation", {}) if helped else {})}
    with Folder(path) as folder:
        folder.remove(ANSWER, FRAMES, FOLD, PAGE, step, dome)
        folder.write_text(FRAMES, _compact(_frames(found)))
        folder.write_text(FOLD, _compact(_fold(found, results.name)))
        folder.write_text(PAGE, _page(found, results.name, block))
        if former is not None:
            body = former
            folder.write(dome, lambda place: place.write_bytes(body))
        if compensation:
            folder.write_text("design.json", native.write_design(results.design))
        try:
            write_frame(results["bodies"].model, found.frame(found.path_count - 1), folder, step, job)
        except (Stopped, native.Cancelled):
            stopped = True
        folder.write_text(ANSWER, to_text({
            "format": FORMAT, "version": VERSION, "name": results.name,
            "status": "stopped" if stopped else "complete", "tiles": len(found.design.F),
            "from": results[START].begin,
            "of": made_from(results.design, results.parameters), "actuation": block,
            "findings": [one.entry() for one in found.findings()],
            **({"compensation": compensation.report()} if compensation else {}),
            "software": {"curveups": __version__}, "files": dict(folder.files)}))
    return stopped


def made_from(design: Any, parameters: Any) -> str:
    """A digest of a design and of the parameters that its path depends on."""
    own = native.Parameters()
    for name in BY_NAME[RISEN].parameters(parameters):
        if name != "density" or parameters.get("gravity") != "off":  # weight, which follows the printer
            own.set(name, parameters.get(name))
    return digest(native.write_design(design.with_parameters(own).with_name("path")))


def read_answer(folder: Path, design: Any, parameters: Any) -> dict[str, Any]:
    """The block of the actuation.json in a folder; empty where that is not of this design, or not whole and
    from flat."""
    try:
        found = json.loads((folder / ANSWER).read_text("utf-8"))
        current = found["of"] == made_from(design, parameters) and found["from"] == "flat" \
            and found["status"] == "complete"
        list(map(str, findings(found["actuation"])))  # what a damaged one can't say
        return dict(found["actuation"]) if current else {}
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return {}


def write_frame(model: Any, rows: np.ndarray, folder: Folder, name: str, job: Job) -> None:
    """The tiles of a PrintModel where a frame has them, as STEP."""
    job.go_on(f"writing {name}")
    posed = model.posed(rows)
    folder.write(name, lambda place: posed.write("step", "actuated", str(place), job))


def _compact(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":")) + "\n"


def _frames(found: Actuation) -> dict[str, Any]:
    """Lengths to 1e-6 mm; energies in N mm. The path's frames have what contacts remember."""
    rows: list[dict[str, Any]] = [
        {"time": float(time), "energy": float(energy), "friction": float(friction), "stretch": float(stretch),
         "poses": np.round(poses, 9).tolist()}
        for time, energy, friction, stretch, poses in
        zip(found.time, found.energy, found.friction, found.stretch, found.frames)]
    for row, phase in zip(rows, found.phase_names):
        row["phase"] = phase
    of = path_digest(found.design)
    for row, memory in zip(rows, found.memories):
        if len(memory):
            packed = zlib.compress(memory.astype("<f8").tobytes())
            row |= {"memory": base64.b64encode(packed).decode("ascii"), "memory_of": of}
    hands = [{**row, "work": float(work)} for row, work in zip(rows, found.hand_work)][found.path_count:]
    return {"format": FRAMES_FORMAT, "version": FRAMES_VERSION, "frames": rows[:found.path_count],
            **({"hands": hands} if hands else {})}


def _fold(found: Actuation, name: str) -> dict[str, Any]:
    """FOLD 1.2: every tile has corners of its own, which move from frame to frame. Its sides are edges: some
    readers don't find them in the faces."""
    design, count = found.design, len(found.design.F)
    corners = np.arange(3 * count).reshape(count, 3)
    sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    frames = [{"frame_title": f"{time:.6g} s", "frame_classes": ["foldedForm"], "frame_parent": 0,
               "frame_inherit": True, "vertices_coords": _coordinates(front_corners(design, rows))}
              for time, rows in zip(found.time[:found.path_count], found.frames)]
    return {"file_spec": 1.2, "file_creator": f"CurveUps {__version__}", "file_title": name,
            "file_classes": ["animation"], "frame_title": "design", "frame_classes": ["foldedForm"],
            "frame_attributes": ["3D", "convexFaces"], "frame_unit": "mm",
            "vertices_coords": _coordinates(np.asarray(design.V)[np.asarray(design.F)]),
            "edges_vertices": sides.tolist(), "edges_assignment": ["B"] * len(sides),
            "faces_vertices": corners.tolist(), "file_frames": frames}


def _coordinates(corners: np.ndarray) -> list[list[float]]:
    return np.round(corners.reshape(-1, 3), 6).tolist()


def _page(found: Actuation, name: str, block: Mapping[str, Any]) -> str:
    """actuation.html: the moving picture, then the answers."""
    kind = {True: "valid", False: "invalid", None: "open"}[block["arrives"]]
    said, *others = found.findings()
    remedy = said.remedy()
    parts = [f"<h1>{escape(name)}: from flat to shape</h1>",
             f'<p><span class="verdict {kind}">{escape(str(said))}</span></p>',
             *(f"<p>{escape(text)}</p>" for text in (*map(str, others), remedy) if text),
             html.picture(moving_view(found), "Drag to turn. Fronts are yellow, backs are blue.")]
    if found.pressed_tiles:
        parts += ["<h2>By hand</h2>", *html.pictured("hands", HANDS, found=found), _touches(block)]
    if said.tiles:
        parts.append(f'<p class="note">Tiles of open contacts: {escape(tile_list(said.tiles))}</p>')
    parts += released(block)
    tried = changes_tried(block)
    parts += ["<h2>What would help</h2>", *tried] if tried else []
    parts += ["<h2>Answers</h2>", answers(block)]
    ends = [("from the target", block["from_target"])]
    if "sampled" in block:
        ends = [*(("flat", one) for one in block["sampled"]), *ends,
                ("from the target", block["frictionless_from_target"])]
    if "by_hand" in block:
        ends += [("jammed, shaken", block["by_hand"]["shaken"]), ("jammed, by hand", block["by_hand"]["end"])]
    parts += ["<h2>Where paths end</h2>", tables.table([_end(*one) for one in ends], (
        "Begins", "Friction", "Arrives", "Short by, mm", "Open contacts", "Scan mean / largest, mm",
        "Energy, N mm"))]
    return html.page(name, parts)


def _touches(block: Mapping[str, Any]) -> str:
    return tables.table(
        [(", ".join(f"{one:.2f}" for one in touch["direction"]), touch["way"], touch["force_n"],
          ", ".join(map(tile_name, touch["tiles"]))) for touch in block["hands"]],
        ("Direction x, y, z", "Way", "Force a tile, N", "Tiles"))


def _end(begins: str, end: dict[str, Any]) -> tuple[Any, ...]:
    return (begins, end["friction_coefficient"], "no answer" if end["arrives"] is None else end["arrives"],
            end["shortfall_mm"], len(end["open_contacts"]),
            f"{end['scan']['mean_mm']:.2f} / {end['scan']['max_mm']:.2f}", end["energy_n_mm"])
