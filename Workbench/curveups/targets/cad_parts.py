# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chooses the surface of a CAD part that becomes the target: one skin of a wall, faces by their numbers, a
closed body without one of its faces. Shapes and faces are FreeCAD's Part; faces are numbered from 1, as
FreeCAD does (Face1)."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any, Optional, Sequence

from ..base import freecad_session
from ..base.errors import CurveUpsError
from .cad_walls import Wall, find_wall

_PLANAR = 1e-4      # of the part's size: how far a planar face may be from the plane that is named
_SEWN = 1e-3        # of the part's size: gaps between faces that are closed
_MEETING = 5e-3     # of the part's size: bodies with a smaller gap are meant to be one
_MOST_SEWN = 400    # faces: sewing with a tolerance takes the square of their number


@dataclass(frozen=True)
class Choice:
    """Values of the parameters of these names."""

    skin: str = "outer"
    faces: str = ""
    open: str = "auto"
    crease_angle: float = 180.0


@dataclass
class Chosen:
    """Faces of the target; `opposite`: those of the other skin, where the middle between them is wanted."""

    faces: list[Any] = field(default_factory=list)
    opposite: list[Any] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    wall: Optional[float] = None  # mm, the thickest


def choose(shape: Any, choice: Choice, where: str) -> Chosen:
    """Raises CurveUpsError where there is nothing of the kind that is asked for."""
    chosen = Chosen()
    if choice.faces:
        chosen.faces = _numbered(shape, choice.faces, where)
        if choice.open != "auto":
            chosen.faces = _opened(chosen.faces, choice.open, shape, chosen.notes, where)
        return chosen
    bodies = _bodies(_sewn(shape, chosen.notes))
    _refuse_gaps(bodies, shape, where)
    if len(bodies) > 1:
        chosen.notes.append(f"there are {len(bodies)} bodies: "
                            + ", ".join(_described(body) for body in bodies[:6])
                            + (f" and {len(bodies) - 6} more" if len(bodies) > 6 else ""))
    for body in bodies:
        closed = bool(body.ShapeType == "Solid" or body.ShapeType == "Shell" and body.isClosed())
        wall = find_wall(body) if closed else None
        faces = _skin(chosen, body, wall, choice) if wall else list(body.Faces)
        if closed and not (wall and wall.rim) or choice.open not in ("auto", "largest", "none"):
            faces = _opened(faces, choice.open, shape, chosen.notes, where)
        chosen.faces += faces
    if choice.skin != "outer" and chosen.wall is None:
        raise CurveUpsError(f"there is no {choice.skin} skin: nothing of the part is a wall with two sides",
                            where, "name the faces (--set faces=Face1,Face2), or leave skin at outer")
    return chosen


def _skin(chosen: Chosen, body: Any, wall: Wall, choice: Choice) -> list[Any]:
    own, other = (wall.inner, wall.outer) if choice.skin == "inner" else (wall.outer, wall.inner)
    thickness = _exact(body, wall)
    chosen.wall = max(thickness, chosen.wall or 0.0)
    if choice.skin == "middle":
        chosen.opposite += [body.Faces[k] for k in other]
    chosen.notes.append(f"{_described(body)} has a wall {thickness:.4g} mm thick: taken is its {choice.skin} "
                        f"skin ({len(own)} faces; the other skin has {len(other)}, the rim {len(wall.rim)})")
    return [body.Faces[k] for k in own]


def _exact(body: Any, wall: Wall) -> float:
    """The wall's thickness at the middle of the outer skin's largest face; as it was found among facets where
    that is at an edge or a hole."""
    _, part = freecad_session.load("Part")
    face = max((body.Faces[k] for k in wall.outer), key=lambda face: face.Area)
    u0, u1, v0, v1 = face.ParameterRange
    point = part.Vertex(face.valueAt((u0 + u1) / 2, (v0 + v1) / 2))
    distance = float(point.distToShape(part.Compound([body.Faces[k] for k in wall.inner]))[0])
    return distance if abs(distance - wall.thickness) < 0.05 * wall.thickness else wall.thickness


def _numbered(shape: Any, text: str, where: str) -> list[Any]:
    count = len(shape.Faces)
    numbers: list[int] = []
    for word in re.split(r"[\s,]+", text.strip()):
        first, _, last = word.partition("-")
        low, high = int(first.replace("Face", "")), int((last or first).replace("Face", ""))
        if not 1 <= low <= high <= count:
            raise CurveUpsError(f"there is no {word}", where, f"the part has Face1 to Face{count}")
        numbers += range(low, high + 1)
    return [shape.Faces[number - 1] for number in dict.fromkeys(numbers)]


def _bodies(shape: Any) -> list[Any]:
    """Solids, shells that are of none, faces that are of no shell."""
    bodies = list(shape.Solids)
    known = {face.hashCode() for body in bodies for face in body.Faces}
    for shell in shape.Shells:
        if not known & {face.hashCode() for face in shell.Faces}:
            bodies.append(shell)
    known = {face.hashCode() for body in bodies for face in body.Faces}
    return bodies + [face for face in shape.Faces if face.hashCode() not in known]


def _sewn(shape: Any, notes: list[str]) -> Any:
    """Faces that lie edge to edge without having the edge in common become one shell, and the two ends of a
    closed face one seam."""
    before = _free_edges(shape)
    if shape.Solids or not before:
        return shape
    _, part = freecad_session.load("Part")
    best = shape
    for fuzzy in (False, True):
        if fuzzy and not 1 < len(shape.Faces) <= _MOST_SEWN:
            break
        try:
            if fuzzy:
                tolerance = _SEWN * shape.BoundBox.DiagonalLength
                faces = list(best.Faces)
                sewn = faces[0].generalFuse(faces[1:], tolerance)[0]
            else:
                sewn = part.Compound(list(shape.Faces))
            sewn.sewShape()
        except Exception:  # FreeCAD raises its own types: the faces stay apart
            continue
        after = _free_edges(sewn)
        if after < before and abs(sewn.Area - shape.Area) < 1e-2 * shape.Area:
            best, before = sewn, after
            if fuzzy:
                notes.append(f"gaps of up to {tolerance:.2g} mm between faces are closed")
        if before == 0:
            break
    return best


def _refuse_gaps(bodies: Sequence[Any], shape: Any, where: str) -> None:
    """Raise CurveUpsError for sheets that nearly meet, which would become pieces of their own."""
    sheets = [body for body in bodies if body.ShapeType in ("Shell", "Face") and _free_edges(body)]
    for number, sheet in enumerate(sheets):
        for other in sheets[:number]:
            gap, places, _ = other.distToShape(sheet)
            if gap < _MEETING * shape.BoundBox.DiagonalLength:
                first, second = (_nearest_face(shape, place) for place in places[0])
                raise CurveUpsError(f"{first} and {second} nearly meet: there is a gap of {gap:.2g} mm",
                                    where, "join them in the CAD, or name the faces to take (faces)")


def _nearest_face(shape: Any, point: Any) -> str:
    _, part = freecad_session.load("Part")
    vertex = part.Vertex(point)
    return f"Face{min((face.distToShape(vertex)[0], k) for k, face in enumerate(shape.Faces, 1))[1]}"


def _free_edges(shape: Any) -> int:
    """Edges of one face alone, but for seams."""
    seen: dict[int, int] = {}
    for face in shape.Faces:
        for edge in face.Edges:
            if not edge.Degenerated:
                seen[edge.hashCode()] = seen.get(edge.hashCode(), 0) + (2 if edge.isSeam(face) else 1)
    return sum(1 for count in seen.values() if count == 1)


def _described(body: Any) -> str:
    box = body.BoundBox
    return (f"a {body.ShapeType.lower()} of {len(body.Faces)} faces, {box.XLength:.4g} x {box.YLength:.4g} x "
            f"{box.ZLength:.4g} mm")


def _opened(faces: Sequence[Any], opening: str, shape: Any, notes: list[str], where: str) -> list[Any]:
    """Faces without the face, or the part, that `opening` names."""
    if opening == "none":
        return list(faces)
    if opening in ("auto", "largest"):
        return _without_largest(faces, opening, shape, notes, where)
    axis, relation, number = opening[0], opening[1], float(opening[2:])
    size = shape.BoundBox.DiagonalLength
    if relation == "=":
        kept = [face for face in faces if not _lies_in(face, axis, number, _PLANAR * size)]
        if len(kept) in (0, len(faces)):
            raise CurveUpsError(f"{'no planar' if kept else 'every'} face lies in {axis} = {number:g}", where,
                                f"give another plane, or one side of it (open={axis}>{number:g})")
        return kept
    kept = _cut(faces, axis, number, relation == ">", shape)
    if not kept:
        raise CurveUpsError(f"nothing of the part has {axis} {relation} {number:g}", where,
                            "give another plane with open")
    notes.append(f"cut off at {axis} = {number:g}")
    return kept


def _without_largest(faces: Sequence[Any], opening: str, shape: Any, notes: list[str],
                     where: str) -> list[Any]:
    # Of faces of the same size the lowest: boxes stand on what is open.
    planar = [face for face in faces if face.Surface.TypeId == "Part::GeomPlane"]
    if not planar or len(faces) == 1:
        if opening == "largest":
            raise CurveUpsError("the part has no planar face to leave open", where,
                                "cut it at a plane (open=z>0), or give cuts")
        return list(faces)
    most = max(face.Area for face in planar)
    left = min((face for face in planar if face.Area > 0.999 * most), key=lambda face: face.CenterOfMass.z)
    name = next((f"Face{k}" for k, other in enumerate(shape.Faces, 1) if left.isSame(other)), "a face")
    notes.append(f"the part is closed: its largest planar face ({name}, {left.Area:.4g} mm2) "
                 "is left open")
    return [face for face in faces if not face.isSame(left)]


def _lies_in(face: Any, axis: str, number: float, tolerance: float) -> bool:
    if face.Surface.TypeId != "Part::GeomPlane":
        return False
    box, name = face.BoundBox, axis.upper()
    return (abs(getattr(box, f"{name}Min") - number) < tolerance
            and abs(getattr(box, f"{name}Max") - number) < tolerance)


def _cut(faces: Sequence[Any], axis: str, number: float, above: bool, shape: Any) -> list[Any]:
    """Parts of faces on one side of a plane."""
    freecad, part = freecad_session.load("Part")
    low, high = ({name: getattr(shape.BoundBox, f"{name.upper()}{end}") + room for name in "xyz"}
                 for end, room in (("Min", -1), ("Max", 1)))
    (low if above else high)[axis] = number
    if low[axis] >= high[axis]:
        return []
    side = part.makeBox(*(high[name] - low[name] for name in "xyz"), freecad.Vector(*low.values()))
    return list(part.Shell(list(faces)).common(side).Faces)
