# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD parts as people draw them, made by FreeCAD in a process of its own: `make(folder, "bowl", ...)` writes
bowl.brep and so on."""

import math
import subprocess
import sys
from pathlib import Path

from running import environment

from curveups.base import freecad_session

_SCRIPT = "import sys; sys.path.insert(0, {here!r}); import cad; cad.write({folder!r}, {names!r})"


def make(folder, *names, ending="brep"):
    """Paths of the parts by name."""
    subprocess.run([freecad_session.python(), "-c",
                    _SCRIPT.format(here=str(Path(__file__).parent), folder=str(folder),
                                   names=[f"{name}.{ending}" for name in names])],
                   env=environment(), check=True, capture_output=True)
    return {name: Path(folder) / f"{name}.{ending}" for name in names}


def write(folder, names):
    """In the child."""
    for name in names:
        stem, _, ending = name.rpartition(".")
        shape = PARTS[stem]()
        if not shape.isValid():
            raise ValueError(f"{stem} is not valid")
        getattr(shape, f"export{ending.capitalize()}")(f"{folder}/{name}")


def _part():
    freecad, part = freecad_session.load("Part")
    return freecad.Vector, part


def bowl(wall=3.0, radius=45.0):
    """Half of a hollow ball; its rim is flat."""
    vector, part = _part()
    half = (vector(0, 0, 0), vector(0, 0, 1), -90, 0)
    return part.makeSphere(radius, *half).cut(part.makeSphere(radius - wall, *half))


def rounded_bowl():
    """With both edges of the rim rounded."""
    shape = bowl(4.0)
    rim = [edge for edge in shape.Edges if abs(edge.BoundBox.ZMax) < 1e-6 and abs(edge.BoundBox.ZMin) < 1e-6]
    return shape.makeFillet(1.9, rim)


def lid():
    """A box lid with fillets of 6 mm outside and of 4 mm inside, open below: 80 x 60 x 20 mm, 2 mm thick."""
    box = _filleted_box()
    return box.makeThickness([face for face in box.Faces if abs(face.CenterOfMass.z) < 1e-6], -2, 1e-4)


def lid_sharp_inside():
    """The same outside, with sharp corners inside."""
    vector, part = _part()
    return _filleted_box().cut(part.makeBox(76, 56, 18, vector(2, 2, 0)))


def _filleted_box():
    _, part = _part()
    box = part.makeBox(80, 60, 20)
    edges = [edge for edge in box.Edges if edge.BoundBox.ZMax > 1]
    return box.makeFillet(6, edges)


def pipe():
    _, part = _part()
    return part.makeCylinder(20, 60).cut(part.makeCylinder(17, 60))


def tee():
    vector, part = _part()

    def solid(less):
        return part.makeCylinder(20 - less, 100, vector(0, 0, -50)).fuse(
            part.makeCylinder(14 - less, 50, vector(0, 0, 0), vector(1, 0, 0)))

    return solid(0).cut(solid(2))


def loft():
    """A vase through circles; inside circles 2.5 mm smaller, so that its wall is not even."""
    vector, part = _part()

    def solid(less):
        return part.makeLoft([part.Wire(part.makeCircle(radius - less, vector(0, 0, z)))
                              for radius, z in ((20, 0), (28, 20), (22, 45), (30, 70))], True)

    return solid(0).cut(solid(2.5))


def plate():
    _, part = _part()
    return part.makeBox(100, 80, 3)


def block():
    _, part = _part()
    return part.makeBox(30, 20, 10)


def ball():
    _, part = _part()
    return part.makeSphere(40)


def hollow():
    _, part = _part()
    return part.makeSphere(40).cut(part.makeSphere(37))


def two_bodies():
    vector, part = _part()
    return part.Compound([part.makeBox(30, 20, 10), part.makeBox(12, 12, 12, vector(60, 0, 0))])


def gaping():
    """Two sheets side by side with a gap of 0.004 mm between them."""
    vector, part = _part()
    return part.Compound([part.makePlane(40, 30), part.makePlane(40, 30, vector(40.004, 0, 0))])


def apart(gap=0.2):
    """Two sheets side by side with a gap between them."""
    vector, part = _part()
    return part.Compound([part.makePlane(40, 30), part.makePlane(40, 30, vector(40 + gap, 0, 0))])


def tube():
    """Lofted, of one face that is closed."""
    vector, part = _part()
    return part.makeLoft([part.Wire(part.Circle(vector(0, 0, z), vector(0, 0, 1), radius).toShape())
                          for z, radius in ((0, 30), (30, 24), (60, 32))])


def vase_of_halves():
    vector, part = _part()
    profile = part.BSplineCurve()
    profile.interpolate([vector(20, 0, 0), vector(32, 0, 20), vector(24, 0, 45), vector(30, 0, 60)])
    wire = part.Wire(profile.toShape())
    halves = [wire.revolve(vector(0, 0, 0), vector(0, 0, 1), 180) for _ in range(2)]
    halves[1].rotate(vector(0, 0, 0), vector(0, 0, 1), 180)
    return part.Compound(halves)


def torus_of_halves():
    vector, part = _part()
    ring = part.Wire(part.Circle(vector(40, 0, 0), vector(0, 1, 0), 15).toShape())
    halves = [ring.revolve(vector(0, 0, 0), vector(0, 0, 1), 180) for _ in range(2)]
    halves[1].rotate(vector(0, 0, 0), vector(0, 0, 1), 180)
    return part.Compound(halves)


def lemon():
    """Cap of a surface that an arc of a circle off the axis makes: it has a pole."""
    vector, part = _part()
    points = [vector(45 * math.cos(angle) - 15, 0, 45 * math.sin(angle))
              for angle in (math.acos(1 / 3), math.radians(35), 0.0)]
    return part.Wire(part.Arc(*points).toShape()).revolve(vector(0, 0, 0), vector(0, 0, 1), 360)


def folded():
    """A sheet of three planes, 50 mm along y; folds of 8 and 35 degrees."""
    vector, part = _part()
    points, at, turn = [vector(0, 0, 0)], vector(0, 0, 0), 0.0
    for bend, length in ((0, 30), (8, 30), (35, 30)):
        turn += math.radians(bend)
        at = at + vector(length * math.cos(turn), 0, length * math.sin(turn))
        points.append(at)
    return part.makePolygon(points).extrude(vector(0, 50, 0))


def sharp_lid():
    """A box lid with sharp edges, open below: 80 x 60 x 20 mm, 2 mm thick."""
    vector, part = _part()
    return part.makeBox(80, 60, 20).cut(part.makeBox(76, 56, 18, vector(2, 2, 0)))


def dished():
    """A flat disc of radius 25 mm with a cone around it."""
    vector, part = _part()
    profile = part.makePolygon([vector(0, 0, 0), vector(25, 0, 0), vector(40, 0, 10)])
    return profile.revolve(vector(0, 0, 0), vector(0, 0, 1), 360)


PARTS = {function.__name__: function for function in (
    bowl, rounded_bowl, lid, lid_sharp_inside, pipe, tee, loft, plate, block, ball, hollow, two_bodies,
    gaping, apart, tube, vase_of_halves, torus_of_halves, lemon, folded, sharp_lid, dished)}

if __name__ == "__main__":
    sys.exit(write(sys.argv[1], sys.argv[2:]))
