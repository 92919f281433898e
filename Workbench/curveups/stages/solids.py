# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies and solids of a design, their checks, and the limits of printers."""

from __future__ import annotations

import io
import json
import threading
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Iterable, Iterator, Mapping, Optional, Sequence

from ..base import freecad_session
from ..base.errors import CurveUpsError
from ..base.findings import Finding, failed
from ..base.native import native
from ..base.parameters import parameter
from .stage import Inputs, Job, Result, Row, Stage

PRINTERS = Path(__file__).parents[3] / "resources" / "printers"
KINDS = ("tiles", "support", "anchors")
GLUED_FIRST = "front"  # side: a slab lies below its pin tops; bridges are broken from the back


@dataclass(frozen=True)
class Bodies(Result):
    """All printed bodies."""

    lasting: ClassVar[bool] = False
    model: Optional[Any] = None        # native PrintModel; None where the work was stopped or failed
    warned: tuple[Finding, ...] = ()
    broken: tuple[Finding, ...] = ()   # why there are none
    joints: Mapping[str, Any] = field(default_factory=dict)  # block of report.json, with joint=holes

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds that have bodies."""
        volumes = self.model.volumes if self.model else {}
        return tuple(kind for kind in KINDS if volumes.get(kind, 0) > 0)

    def report(self) -> dict[str, Any]:
        return {"joints": dict(self.joints)} if self.joints else {}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("solids", seconds),) if self.model else ()


def _make(inputs: Inputs, job: Job) -> Bodies:
    model = native.make_print_model(inputs["design"].design.with_parameters(inputs.parameters), job)
    joints = _joints(model, inputs.parameters)
    return Bodies(model, (*_lacks(model), *_not_joined(joints)), joints=joints)


@dataclass(frozen=True)
class Solids(Result):
    """Solids of all bodies as Shapes of FreeCAD, by kind; empty where there are none."""

    lasting: ClassVar[bool] = False
    shapes: Mapping[str, Sequence[Any]] = field(default_factory=dict)
    broken: tuple[Finding, ...] = ()

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("solids", seconds),) if self.shapes else ()


def _build(inputs: Inputs, job: Job) -> Solids:
    model = inputs["bodies"].model
    if model is None:
        return Solids()
    bodies = {kind: model.bodies(kind) for kind in KINDS}
    solids = iter(part_solids([body for kind in KINDS for body in bodies[kind]], job))
    return Solids({kind: [next(solids) for _ in bodies[kind]] for kind in KINDS})


_AT_ONCE = 128  # bodies whose text is made in one call
_LARGE = 1_000_000  # bytes; Part takes 20 ms for as many


class _Yielding(io.BytesIO):
    """Lets other threads run whenever Part's reader, which holds Python's lock, asks for more bytes."""

    def read(self, size: Optional[int] = -1) -> bytes:
        return super().read(size)


def part_solids(bodies: Sequence[Any], job: Job) -> list[Any]:
    """Solids of native PrintBodies as Shapes of FreeCAD. Raises CurveUpsError where FreeCAD can't be loaded
    or fails, Stopped."""
    _, part = freecad_session.load("Part")
    # Signals arrive on the main thread: raised while Part reads, their exceptions would end the text.
    file = io.BytesIO if threading.current_thread() is threading.main_thread() else _Yielding
    solids: list[Any] = []
    for body, text in zip(bodies, _texts(bodies)):
        job.go_on("building solids", len(solids) / len(bodies))
        solid = part.Shape()
        try:
            if len(text) < _LARGE:
                solid.importBrepFromString(text.decode("ascii"), False)
            else:
                solid.importBrep(file(text))
            solid.ShapeType  # raises where there is none
        except Exception as error:  # of Part's own types
            raise CurveUpsError(f"OpenCASCADE failed building {body.name} ({error})", "",
                                "report this with the design file") from error
        solids.append(solid)
    return solids


def _texts(bodies: Sequence[Any]) -> Iterator[bytes]:
    """BREP texts of native PrintBodies."""
    for first in range(0, len(bodies), _AT_ONCE):
        yield from native.brep_texts(bodies[first:first + _AT_ONCE])


def _lacks(model: Any) -> list[Finding]:
    warnings = []
    bare = list(model.bare_interfaces)
    if bare:
        warnings.append(Finding.about("bare_interface", (tile for a, b, _ in bare for tile in (a, b)),
                                      count=len(bare), why=Finding(f"bare.{bare[0][2]}")))
    loose = list(map(int, model.loose_tiles))
    if loose:
        warnings.append(Finding.about("loose", loose, count=len(loose)))
    if model.loose_anchors:
        warnings.append(Finding.about("loose.anchors", count=int(model.loose_anchors)))
    return warnings


PARTS = frozenset({"tiles", "bodies", "support", "files"})
BODIES = Stage("bodies", ("design",), PARTS, _make, on_stop=lambda stage, inputs: Bodies(),
               on_failure=lambda error, inputs: Bodies(broken=(failed("unprintable", error),)),
               label="Bodies", commands=("build", "print"), judges=True)
STAGE = Stage("solids", ("bodies",), frozenset(), _build, on_stop=lambda stage, inputs: Solids(),
              on_failure=lambda error, inputs: Solids(broken=(failed("unbuilt", error),)),
              label="Solids", commands=("build",), judges=True)


@dataclass(frozen=True)
class Check(Result):
    """Figures of the print: lengths in mm, volumes in cm3."""

    print_block: Mapping[str, Any] = field(default_factory=dict)   # of report.json, without files
    solids_block: Mapping[str, Any] = field(default_factory=dict)
    broken: tuple[Finding, ...] = ()  # reasons
    warned: tuple[Finding, ...] = ()
    note: Optional[Finding] = None    # why solids were not checked: the verdict stays open

    def report(self) -> dict[str, Any]:
        if not self.print_block:
            return {}
        return {"solids": dict(self.solids_block), "print": dict(self.print_block)}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("check", seconds),) if self.print_block else ()


def _check(inputs: Inputs, job: Job) -> Check:
    model = inputs["bodies"].model
    if model is None:
        return Check()
    job("checking solids", 0.0)
    check_all = inputs.parameters.get("check_all")
    unsound, checked = check_solids(model, check_all, job)
    clearances = inputs["clearances"]
    clearance = clearances.flat_mm if clearances.flat_mm is not None else model.min_clearance_flat()
    overlap = clearances.overlap_mm3 if clearances.overlap_mm3 is not None else 0.0
    box = [float(x) for x in model.bbox]
    smallest = min((size for _, _, size, _ in model.thinnest), default=0.0)
    printed: dict[str, Any] = {
        "bbox_mm": box, "pieces": int(model.piece_count), **amounts([model]), "smallest_feature_mm": smallest,
        "overhang_mm": max(model.overhangs, default=0.0)}
    solids = {"tiles": int(model.tile_count), "invalid": len(unsound),
              "volume_cm3": printed["tile_volume_cm3"],
              "min_clearance_flat_mm": clearance, "max_overlap_actuated_mm3": overlap,
              "checked_by_opencascade": "all" if check_all and checked else checked}
    printer = read_printer(inputs.parameters.get("printer"))
    thin = too_thin(inputs["figures"].blocks["relaxed"], printer)
    return Check(printed, solids, (*_reasons(unsound), *thin),
                 tuple(_printer_warnings(model, inputs.parameters, box, clearance, printer)))


# Solids of a kind in the sample that OpenCASCADE checks, and the most planar faces of one: a slab has
# thousands, which take it seconds.
_SAMPLE, _MOST_SAMPLED_FACES = 16, 256
_VOLUME_TOLERANCE = 1e-9  # relative
_MOST_NAMED = 3  # unsound solids in a sentence

Unsound = Sequence[tuple[Any, str]]  # native PrintBodies and why they are unsound


def check_solids(model: Any, check_all: bool, job: Job) -> tuple[Unsound, list[str]]:
    """Unsound bodies of a native PrintModel, and the names of those whose solids OpenCASCADE checked: evenly
    spaced ones of each kind, or all; none where bodies are unsound already or FreeCAD can't be loaded."""
    kinds = [model.bodies(kind) for kind in KINDS]
    bodies = [body for kind in kinds for body in kind]
    unsound = [(body, why) for body, why in zip(bodies, native.check_bodies(bodies, job)) if why]
    if unsound:
        return unsound, []
    sample = bodies if check_all else [body for kind in kinds for body in _sample_of(kind)]
    try:
        freecad_session.load("Part")
    except CurveUpsError:
        return [], []
    for number, body in enumerate(sample):
        job.go_on("checking solids", number / len(sample))
        why = opencascade_finds(body, job)
        if why:
            unsound.append((body, why))
    return unsound, [body.name for body in sample]


def _sample_of(kind: Sequence[Any]) -> list[Any]:
    bodies = [body for body in kind if body.faces <= _MOST_SAMPLED_FACES]
    count = min(len(bodies), _SAMPLE)
    return [bodies[k * len(bodies) // count] for k in range(count)]


def opencascade_finds(body: Any, job: Job) -> str:
    """Reason why OpenCASCADE finds the solid of a native PrintBody unsound; empty where it is sound."""
    solid, = part_solids([body], job)
    if not solid.isValid():
        return "invalid"
    if not solid.isClosed():
        return "open"
    return "volume" if abs(solid.Volume - body.volume) > _VOLUME_TOLERANCE * body.volume else ""


def _reasons(unsound: Unsound) -> Sequence[Finding]:
    """Reason why unsound solids make a design not valid."""
    if not unsound:
        return ()
    named = tuple(Finding.about("unsound.solid", body=body.name, why=why)
                  for body, why in unsound[:_MOST_NAMED])
    more = len(unsound) - len(named)
    return (Finding.about("unsound.many" if more else "unsound",
                          (body.tile for body, _ in unsound if body.tile >= 0),
                          solids=named, **({"more": more} if more else {})),)


def amounts(models: Sequence[Any]) -> dict[str, Any]:
    """Bodies, volumes (cm3) and glued areas (mm2) of native PrintModels that are one print together."""
    def volume(kind: str) -> float:
        return float(sum(model.volumes[kind] for model in models) / 1000)

    sides = models[0].glued_areas
    return {"bodies": sum(int(model.body_count) for model in models), "tile_volume_cm3": volume("tiles"),
            "support_volume_cm3": volume("support"), "anchor_volume_cm3": volume("anchors"),
            "glue": {"first": GLUED_FIRST, **{
                f"{side}_{what}_mm2": sum(model.glued_areas[side][what] for model in models)
                for side in sides for what in sides[side]}}}


CHECK = Stage("check", ("bodies", "figures", "clearances"), frozenset({"check", "tiles"}), _check,
              on_stop=lambda stage, inputs: Check(
                  note=Finding("stopped.unchecked") if inputs["bodies"].model else None),
              label="Check of the solids", commands=("print",), judges=True)


def _printer_warnings(model: Any, parameters: Any, box: Sequence[float], clearance: float, printer: dict
                      ) -> list[Finding]:
    """Warnings of limits of the printer: bed, materials, gaps, features, overhangs."""
    get, warnings = parameters.get, []

    def warn(kind: str, tiles: Iterable[int] = (), **figures: Any) -> None:
        warnings.append(Finding.about(kind, tiles, printer=printer["name"], **figures))

    soluble = native.support_kind(parameters).soluble and model.volumes["support"] > 0
    if not fits_bed(box, printer):
        warn("bed", x=box[0], y=box[1], z=box[2])
    if soluble and printer["materials"] < 2:
        warn("material")
    if clearance < printer["smallest_gap_mm"]:
        warn("gap.printer", clearance=clearance, least=printer["smallest_gap_mm"])
    if soluble and clearance < printer["smallest_feature_mm"]:
        warn("feature.slab", clearance=clearance, least=printer["smallest_feature_mm"])
    thin = [row for row in model.thinnest if row[2] < printer["smallest_feature_mm"]]
    if thin:
        body, place, size, _ = min(thin, key=lambda row: row[2])
        warn("feature", (row[3] for row in thin if row[3] >= 0), count=len(thin), body=body, place=place,
             size=size)
    if get("bumps") != "none" and get("bump_height") < printer["resolution_mm"]:
        warn("resolution.bumps", height=get("bump_height"), least=printer["resolution_mm"])
    if get("bumps") == "dimples" and native.DIMPLE_CLEARANCE < printer["resolution_mm"]:
        warn("resolution.dimples", clearance=native.DIMPLE_CLEARANCE, least=printer["resolution_mm"])
    if overhangs(max(model.overhangs, default=0.0), parameters, printer):
        most = printer["overhang_mm"]
        warn("overhang.front_down" if get("orientation") == "front-down" else "overhang",
             [tile for tile, size in enumerate(model.overhangs) if size > most], reach=max(model.overhangs),
             H_pin=get("H_pin"), most=most)
    if get("bumps") != "bumps" and get("xy_compensation") < printer["growth_mm"]:  # walls meet
        warn("growth", set=get("xy_compensation"), grows=printer["growth_mm"])
    return warnings


def overhangs(reach: float, parameters: Any, printer: dict) -> bool:
    """True where tiles that overhang their pins by `reach` (mm) need supports by the slicer."""
    most = printer["overhang_mm"]
    return most is not None and not native.support_kind(parameters).soluble and reach > most


def too_thin(relaxed: Sequence[Mapping[str, Any]], printer: dict) -> tuple[Finding, ...]:
    """Reason where relaxed bounds are below a printer's smallest feature. relaxed: as in report.json."""
    least = printer["smallest_feature_mm"]
    thin = [bound for bound in relaxed if bound["what"] == "p_min" and bound["to"] < least]
    if not thin:
        return ()
    tiles = tuple(sorted({bound["tile"] for bound in thin}))
    return (Finding.about("thin_p_min", tiles, least=min(bound["to"] for bound in thin), at=tiles,
                          printer=printer["name"], makes=least),)


def read_printer(name: str) -> dict:
    """Data of a printer: bed, resolution, smallest gap and feature, growth of walls, number of materials,
    largest overhang (None: any), density of its material where it has its own, sources."""
    return json.loads((PRINTERS / f"{name}.json").read_text(encoding="utf-8"))


def density_of(printer: str) -> float:
    """Density of a printer's material, g/cm3."""
    return float(read_printer(printer).get("density", parameter("density").default))


def fits_bed(box: Sequence[float], printer: dict) -> bool:
    """True where a print of this size fits, turned by a right angle or not."""
    return fits(box, printer["bed_mm"]) or fits_turned(box, printer)


def fits_turned(box: Sequence[float], printer: dict) -> bool:
    """True where it fits only turned by a right angle."""
    return not fits(box, printer["bed_mm"]) and fits((box[1], box[0], box[2]), printer["bed_mm"])


def fits(box: Sequence[float], bed: Sequence[float]) -> bool:
    """True where a box fits as it stands. Both are x and y, or x, y and z, mm."""
    return all(side <= room for side, room in zip(box, bed))


def _joints(model: Any, parameters: Any) -> dict[str, Any]:
    """Block of report.json: edges between pieces, holes, their sizes (mm) and the pairs of tiles (rows of F)
    without room for them; empty with joint=none. model: native PrintModel."""
    if parameters.get("joint") == "none":
        return {}
    joined, closed, holes = model.joints
    return {"edges": len(joined) + len(closed), "holes": int(holes), "hole_mm": native.JOINT_HOLE,
            "wall_mm": parameters.get("p_floor"), "without": [[int(a), int(b)] for a, b in closed]}


def _not_joined(joints: Mapping[str, Any]) -> Sequence[Finding]:
    """Warning of nothing to join, or of edges without holes."""
    if joints and not joints["edges"]:
        return (Finding("joint.none"),)
    pairs = tuple((a, b) for a, b in joints.get("without", ()))
    if not pairs:
        return ()
    return (Finding.about("joint", (tile for pair in pairs for tile in pair), closed=len(pairs),
                          edges=joints["edges"], pairs=pairs),)
