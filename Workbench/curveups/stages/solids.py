# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies and solids of a design, their checks, and the limits of printers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Iterable, Mapping, Optional, Sequence

from ..base.findings import Finding, all_of, failed
from ..base.native import native
from ..base.parameters import parameter
from .stage import Inputs, Job, Result, Row, Stage

PRINTERS = Path(__file__).parents[3] / "resources" / "printers"
KINDS = ("tiles", "support", "anchors")
GLUED_FIRST = "front"  # side: a slab lies below its pin tops; bridges are broken from the back


@dataclass(frozen=True)
class Bodies(Result):
    """All printed bodies; native code builds their solids at the first use."""

    lasting: ClassVar[bool] = False
    model: Optional[Any] = None        # native PrintModel; None where the work was stopped or failed
    warned: tuple[Finding, ...] = ()
    broken: tuple[Finding, ...] = ()   # why there are none
    joints: Mapping[str, Any] = field(default_factory=dict)  # block of report.json, with joint=holes

    def report(self) -> dict[str, Any]:
        return {"joints": dict(self.joints)} if self.joints else {}

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("solids", seconds),) if self.model else ()


def _make(inputs: Inputs, job: Job) -> Bodies:
    model = native.make_print_model(inputs["design"].design.with_parameters(inputs.parameters), job)
    joints = joints_of(model, inputs.parameters)
    return Bodies(model, (*_lacks(model), *not_joined(joints, inputs.parameters)), joints=joints)


@dataclass(frozen=True)
class Solids(Result):
    """Solids of all bodies; no model where there are none."""

    lasting: ClassVar[bool] = False
    model: Optional[Any] = None
    broken: tuple[Finding, ...] = ()

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds that have bodies."""
        volumes = self.model.volumes if self.model else {}
        return tuple(kind for kind in KINDS if volumes.get(kind, 0) > 0)

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("solids", seconds),) if self.model else ()


def _build(inputs: Inputs, job: Job) -> Solids:
    model = inputs["bodies"].model
    if model is not None and job("building solids", 0.0):
        model.build_solids(job)
    return Solids(model)


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
               label="Bodies", asked_by=("build", "print"), judges=True)
STAGE = Stage("solids", ("bodies",), frozenset(), _build, on_stop=lambda stage, inputs: Solids(),
              on_failure=lambda error, inputs: Solids(broken=(failed("unbuilt", error),)),
              label="Solids", asked_by=("build", "print"), judges=True)


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
    model = inputs["solids"].model
    if model is None:
        return Check()
    job("checking solids", 0.0)
    unsound, reasons = model.judge_solids(job)
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
              "min_clearance_flat_mm": clearance, "max_overlap_actuated_mm3": overlap}
    printer = read_printer(inputs.parameters.get("printer"))
    warned = (*_printer_warnings(model, inputs.parameters, box, clearance, printer),
              *_fit_warnings(inputs.parameters, printer))
    broken = (*all_of(reasons), *too_thin(inputs["figures"].relaxed, printer))
    return Check(printed, solids, broken, warned)


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


CHECK = Stage("check", ("solids", "figures", "clearances"), frozenset({"check", "tiles"}), _check,
              on_stop=lambda stage, inputs: Check(
                  note=Finding("stopped.unchecked") if inputs["solids"].model else None),
              label="Check of the solids", asked_by=("print",), judges=True)


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


def _fit_warnings(parameters: Any, printer: dict) -> Sequence[Finding]:
    """Warning where walls that meet without bumps do not stand back by as much as prints grow."""
    if parameters.get("bumps") == "bumps" or parameters.get("xy_compensation") >= printer["growth_mm"]:
        return ()
    return (Finding.about("growth", set=parameters.get("xy_compensation"), printer=printer["name"],
                          grows=printer["growth_mm"]),)


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


def joints_of(model: Any, parameters: Any) -> dict[str, Any]:
    """Block of report.json: edges between pieces, holes, their sizes (mm) and the pairs of tiles (rows of F)
    without room for them; empty with joint=none. model: native PrintModel."""
    if parameters.get("joint") == "none":
        return {}
    joined, closed, holes = model.joints
    return {"edges": len(joined) + len(closed), "holes": int(holes), "hole_mm": native.JOINT_HOLE,
            "wall_mm": parameters.get("p_floor"), "without": [[int(a), int(b)] for a, b in closed]}


def not_joined(joints: Mapping[str, Any], parameters: Any) -> Sequence[Finding]:
    """Warning of nothing to join, or of edges without holes."""
    if not joints:
        return ()
    if not joints["edges"]:
        return (Finding("joint.none"),)
    if not joints["without"]:
        return ()
    pairs = tuple((a, b) for a, b in joints["without"])
    return (Finding.about("joint", (tile for pair in pairs for tile in pair), closed=len(pairs),
                          edges=joints["edges"], pairs=pairs),)
