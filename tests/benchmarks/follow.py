# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs that follow changes of their CAD parts: tiles and cuts kept, verdict, processor time beside that of
a design from nothing (of the first changes, and where a design is not valid). Five parts, ten changes of a
dimension each: eight of up to 10 %, two of 25 %."""

from __future__ import annotations

import argparse
import math
from functools import partial
from time import process_time
from typing import Any, Callable, Mapping

import numpy as np

from curveups.base import freecad_session
from curveups.base.errors import CurveUpsError
from curveups.base.native import native
from curveups.project.following import carry_along
from curveups.project.project import Project
from curveups.stages import stages_of
from curveups.stages.cut_request import CutRequest
from curveups.stages.following import Earlier
from curveups.stages.stage import Job, digest
from curveups.stages.surface import Source
from curveups.targets.cad_files import read_shape

FreeCAD, Part = freecad_session.load("Part")
Dimensions = Mapping[str, float]  # mm

# Factors of a part's dimensions, which take turns.
FACTORS = (1.03, 0.95, 1.1, 0.9, 1.05, 0.97, 1.08, 0.92, 1.25, 0.75)


def spline(points: Any) -> Any:
    curve = Part.BSplineCurve()
    curve.interpolate([FreeCAD.Vector(*point) for point in points])
    return curve


def spline_surface(height: Callable[[float, float], float], length: float, width: float) -> Any:
    """Face through 7 x 7 points. height: z by x and y from -1 to 1."""
    places = np.linspace(-1, 1, 7)
    surface = Part.BSplineSurface()
    surface.interpolate([[FreeCAD.Vector(x * length / 2, y * width / 2, height(x, y)) for y in places]
                         for x in places])
    return surface.toShape()


def bowl(radius: float, depth: float, flange: float) -> Any:
    """A revolved bowl with a flange."""
    profile = [(radius * s, 0, depth * (1 - math.cos(math.pi * s / 2) ** 1.5))
               for s in (0, 0.2, 0.4, 0.6, 0.8)]
    profile += [(radius + flange * s, 0, depth * (1 + 0.02 * s)) for s in (0.2, 0.6, 1)]
    curve = spline(profile).toShape()
    return curve.revolve(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 360)


def visor(width: float, height: float, bulge: float) -> Any:
    """A lofted visor."""
    wires = []
    for z, share in ((0, 1.0), (0.5, 1.08), (1, 0.92)):
        angles = np.linspace(-1, 1, 9)
        points = [(share * width / 2 * math.sin(1.1 * a) / math.sin(1.1),
                   -share * bulge * math.cos(1.1 * a) / (1 - math.cos(1.1)), height * z) for a in angles]
        wires.append(Part.Wire(spline(points).toShape()))
    return Part.makeLoft(wires, False, False)


def shell(length: float, width: float, height: float, fillet: float) -> Any:
    """A filleted shell: a box without its lid."""
    box = Part.makeBox(length, width, height)
    edges = [edge for edge in box.Edges if edge.CenterOfMass.z < height - 1e-6]
    rounded = box.makeFillet(fillet, edges)
    return Part.Shell([face for face in rounded.Faces if face.CenterOfMass.z < height - 1e-6])


def patch(length: float, width: float, rise: float, hole: float, place: float) -> Any:
    """A curved patch with a hole."""
    face = spline_surface(lambda x, y: -rise * (x * x + 0.6 * y * y), length, width)
    return face.cut(Part.makeCylinder(hole, 200, FreeCAD.Vector(place, 0, -100))).Faces[0]


def saddle(length: float, width: float, rise: float, sag: float) -> Any:
    """A saddle by points of a spline surface."""
    return spline_surface(lambda x, y: rise * x * x - sag * y * y, length, width)


# Parts by their dimensions, and a cut, mm: two points about on the part, for the middles of its dimensions.
PARTS: tuple[tuple[Callable[..., Any], Dimensions, Any], ...] = (
    (bowl, {"radius": 50, "depth": 20, "flange": 14}, ((64, 0, 20), (25, 0, 5))),
    (visor, {"width": 130, "height": 80, "bulge": 40}, ((0, -73, 80), (0, -79, 40))),
    (shell, {"length": 110, "width": 90, "height": 30, "fillet": 25}, ((110, 45, 30), (60, 45, 0))),
    (patch, {"length": 120, "width": 100, "rise": 14, "hole": 16, "place": 10}, ((60, 0, -14), (26, 0, -1))),
    (saddle, {"length": 120, "width": 100, "rise": 14, "sag": 12}, ((60, 0, 14), (20, 0, 2))))


def project_of(make: Callable[..., Any], dimensions: Dimensions, L: float, cut: Any) -> Project:
    """Project of a part. cut: its points; None: none."""
    shape = make(**dimensions)
    parameters = native.Parameters()
    parameters.set("L", L)
    source = Source(make.__name__, stamp=digest(str(dimensions)), will_be_cut=True,
                    read=lambda deflection, choice, go_on: read_shape(shape, deflection, go_on, choice,
                                                                      make.__name__))
    lines = () if cut is None else (np.array(cut, float),)
    return Project(make.__name__, parameters, {"source": source, "cut request": CutRequest(polylines=lines)})


def solved(project: Project, prepare: Callable[[Job], object] = lambda job: None) -> tuple[Any, float]:
    """Results, and processor time from the triangles of the part on: FreeCAD makes them alike for both."""
    job = Job()
    project.run(("surface",), job)
    begun = process_time()
    prepare(job)
    return project.run(stages_of("solve"), job), process_time() - begun


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--L", type=float, default=7.0, help="length of the tiles' edges, mm")
    parser.add_argument("--parts", nargs="*", default=[make.__name__ for make, *_ in PARTS])
    options = parser.parse_args()
    valid = changes = tiles = kept = near_tiles = near_kept = 0
    shares = []
    for make, dimensions, cut in PARTS:
        if make.__name__ not in options.parts:
            continue
        before, seconds = solved(project_of(make, dimensions, options.L, cut))
        design = before["design"].design
        print(f"{make.__name__}: {len(design.F)} tiles, {before.verdict.word}, {seconds:.1f} s", flush=True)
        names = list(dimensions)
        for number, factor in enumerate(FACTORS):
            name = names[number % len(names)]
            changed = {**dimensions, name: dimensions[name] * factor}
            changes += 1
            try:
                project = project_of(make, changed, options.L, None)
                results, seconds = solved(project, partial(carry_along, project, Earlier.of(design)))
            except CurveUpsError as error:
                print(f"  {name} * {factor}: {error}", flush=True)
                continue
            target, verdict = results["target"], results.verdict
            followed = target.followed.mesh is not None
            numbers = target.tiling.figures.get("kept", 0)
            valid += followed and verdict.valid is True
            if factor in (1.25, 0.75):
                tiles, kept = tiles + len(design.F), kept + numbers
            else:
                near_tiles, near_kept = near_tiles + len(design.F), near_kept + numbers
            cuts = f"; {target.followed.lost} cuts lost" if followed else ""
            print(f"  {name} * {factor}: {target.tiling}{cuts}; {verdict.word}, {seconds:.1f} s", flush=True)
            if number < 2 or not (followed and verdict.valid):
                anew, time_anew = solved(project_of(make, changed, options.L, None))
                shares += [seconds / time_anew] if followed else []
                print(f"    anew: {anew.verdict.word}, {time_anew:.1f} s", flush=True)
            for reason in verdict.reasons[:2]:
                print(f"    {reason}")
    print(f"followed and valid: {valid} of {changes}; numbers kept: {near_kept / max(1, near_tiles):.1%} "
          f"up to 10 %, {kept / max(1, tiles):.1%} at 25 %; time over that of a design anew: median "
          f"{np.median(shares):.2f}, most {max(shares):.2f}")


if __name__ == "__main__":
    main()
