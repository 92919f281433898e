# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects below a Design: cuts, layout and forces as lists for scripts, figures, and solids."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

from ..base.errors import CurveUpsError
from ..project.project import Results
from ..stages.cut_request import CutRequest
from . import properties
from .proxy import HIDDEN, OUTPUT, READ_ONLY, Proxy, Row, add, write
from .status import Keys, write_keys

# Property, its type, unit, meaning, place in report.json.
FIGURES = (
    ("TileCount", "Integer", "", "Tiles", "tiles"),
    ("ContactCount", "Integer", "", "Contacts between tiles", "contacts"),
    ("CutCount", "Integer", "", "Edges that are cut", "cuts"),
    ("AreaRatio", "Float", "", "Flat area over actuated area", "area.ratio"),
    ("FlatArea", "Area", "cm2", "Flat area", "area.flat_cm2"),
    ("ActuatedArea", "Area", "cm2", "Actuated area", "area.actuated_cm2"),
    ("LargestViolation", "Distance", "mm", "Largest violation of a gap", "constraints.max_gap_violation_mm"),
    ("SmallPins", "Integer", "", "Sides of pins below APinMin", "constraints.pin_sides_below_area"),
    ("MinNormalForce", "Force", "N", "Least normal force at a contact point", "contact_forces.normal_min"),
    ("MeanNormalForce", "Force", "N", "Mean normal force at contact points", "contact_forces.normal_mean"),
    ("MaxFriction", "Float", "", "Largest friction over normal force", "contact_forces.friction_ratio_max"),
    ("MeanDeviation", "Distance", "mm", "Mean distance from the target", "deviation.mean_mm"),
    ("MaxDeviation", "Distance", "mm", "Largest distance from the target", "deviation.max_mm"),
    ("SettledDeviation", "Distance", "mm", "Mean distance of the settled shape from the design",
     "settled.scan.mean_mm"),
    ("LargestSlip", "Distance", "mm", "Largest slip between tiles that settle", "settled.largest_slip_mm"),
    ("FrictionNeeded", "Float", "", "Least coefficient of friction at which forces in balance exist",
     "friction_needed.coefficient"),
    ("HoldingFriction", "Float", "", "Least coefficient of friction at which the shape holds",
     "settled.holding_friction"),
    ("TileVolume", "Volume", "cm3", "Volume of the tiles", ""),
    ("SupportVolume", "Volume", "cm3", "Volume of the support", ""),
    ("AnchorVolume", "Volume", "cm3", "Volume of the anchors", ""),
)
_UNITS = {name: unit for name, _, unit, *_ in FIGURES}
_VOLUMES = {"tiles": "TileVolume", "support": "SupportVolume", "anchors": "AnchorVolume"}  # by kind of body


def add_figures(obj: Any, with_units: bool) -> None:
    """Add figures that a Design or, with units, a Verification lacks. A sheet that sets a parameter reads
    those of the Verification, which depends on nothing; those of the Design are hidden, for scripts."""
    status = READ_ONLY | OUTPUT | (0 if with_units else HIDDEN)
    for name, kind, unit, meaning, _ in FIGURES:
        if with_units or not unit:
            add(obj, kind, name, properties.FIGURES, f"{meaning}.", status)
        else:
            add(obj, "Float", name, properties.FIGURES, f"{meaning}, {unit}.", status)


def write_figures(obj: Any, results: Results, solved: bool) -> None:
    """Write the figures of a run's results; all others become 0 with another layout (solved)."""
    report: dict[str, Any] = {}
    for result in results.values():
        report.update(result.report())
    for name, _, _, _, path in FIGURES:
        value: Any = report
        for key in path.split("."):
            value = value.get(key) if isinstance(value, Mapping) else None
        if isinstance(value, (int, float)):
            _write_figure(obj, name, value)
        elif solved and path:
            _write_figure(obj, name, 0)


def forget_settled(obj: Any) -> None:
    """Write 0 for the figures of settled forces that are not known."""
    for name, _, _, _, path in FIGURES:
        if path.startswith(("settled.", "friction_needed.")):
            _write_figure(obj, name, 0)


def write_volumes(obj: Any, volumes: Mapping[str, float]) -> None:
    """Write the volumes of bodies, mm3 by kind."""
    for kind, name in _VOLUMES.items():
        _write_figure(obj, name, volumes[kind] / 1000)


def _write_figure(obj: Any, name: str, value: Any) -> None:
    import FreeCAD

    write(obj, name, value)
    unit = _UNITS[name].replace("2", "^2").replace("3", "^3")
    write(obj.Verification, name, FreeCAD.Units.Quantity(f"{value!r} {unit}") if unit else value)


class CutsProxy(Proxy):
    """Behaviour of Cuts. Edges are pairs of the Target's vertices; points keep their coordinates, for a
    target that is divided anew."""

    TYPE = "CurveUps::Cuts"

    PROPERTIES = (
        ("IntegerList", "Edges", "Cuts", "Pairs of the Target's vertices: edges across which tiles are "
         "disconnected. Takes effect with Solve.", 0),
        ("VectorList", "Points", "Cuts", "Where the edges are, mm: polylines one after another.", 0),
        ("IntegerList", "PointCounts", "Cuts", "How many points each polyline has.", 0))


def write_cuts(obj: Any, edges: np.ndarray, V: np.ndarray) -> None:
    """Write edges (C x 2 vertices of V; N x 3, mm)."""
    import FreeCAD

    edges = np.asarray(edges, int).reshape(-1, 2)
    write(obj, "Points", [FreeCAD.Vector(*map(float, V[v])) for edge in edges for v in edge])
    write(obj, "PointCounts", [2] * len(edges))
    write(obj, "Edges", [int(v) for v in edges.ravel()])


def edges_of(obj: Any) -> np.ndarray:
    """Edges of Cuts, C x 2. Raises CurveUpsError where the list has an odd length."""
    if len(obj.Edges) % 2:
        raise CurveUpsError("the list of cuts has an odd number of vertices", obj.Label,
                            "remove one from its Edges")
    return np.array(obj.Edges, np.int32).reshape(-1, 2)


def request_of(obj: Any, by_number: bool) -> CutRequest:
    """Request for these cuts: by numbers of edges, or by coordinates where the target is divided anew."""
    if obj is None or not obj.Edges:
        return CutRequest()
    if by_number or not obj.Points:
        return CutRequest(edges=edges_of(obj), where=obj.Label)
    points, lines = [tuple(point) for point in obj.Points], []
    for count in obj.PointCounts:
        lines.append(np.array(points[:count], float).reshape(-1, 3))
        del points[:count]
    return CutRequest(polylines=tuple(lines), where=obj.Label)


def _results(group: str, *rows: tuple[str, str, str]) -> tuple[Row, ...]:
    """Properties that only runs write: type, name, tooltip."""
    return tuple((kind, name, group, tip, READ_ONLY | OUTPUT) for kind, name, tip in rows)


class LayoutProxy(Proxy):
    """Behaviour of a Layout."""

    TYPE = "CurveUps::Layout"
    PROPERTIES = _results(
        "Layout",
        ("FloatList", "Poses", "Flat corners of the tiles, mm: three times x, y for each."),
        ("FloatList", "Insets",
         "Insets of the pins, mm: three of the front and three of the back for each tile."),
        ("VectorList", "Vertices", "The actuated front vertices, mm."),
        ("IntegerList", "Faces", "Three vertices for each tile."),
        ("Bool", "Converged", "Whether the optimiser came to its end."),
        ("Integer", "Iterations", "Steps of the optimiser."),
        ("Float", "Energy", "Sum of the layout's energies."))


def write_layout(obj: Any, results: Mapping[str, Any], design: Any) -> None:
    """Write the layout of a run's results and of the design that they ended with."""
    import FreeCAD

    obj.Poses = np.ravel(design.T).tolist()
    obj.Insets = np.ravel(design.q).tolist()
    obj.Vertices = [FreeCAD.Vector(*row) for row in design.V.tolist()]
    obj.Faces = np.ravel(design.F).tolist()
    layout = results.get("layout")
    if layout is not None:
        obj.Converged, obj.Iterations = layout.converged, layout.block["iterations"]
        obj.Energy = sum(layout.block["energies"].values())


# Arrays of a verification by the properties that have them.
_ARRAYS = {"ContactTiles": "contact_tiles", "ContactNormalMin": "contact_normal_min",
           "ContactNormalMean": "contact_normal_mean", "ContactFriction": "contact_friction_ratio",
           "TileNormalForce": "tile_normal_force"}


class VerificationProxy(Proxy):
    """Behaviour of a Verification."""

    TYPE = "CurveUps::Verification"

    PROPERTIES = _results(
        "Verification",
        ("IntegerList", "ContactTiles", "The two tiles of each contact, counted from 0."),
        ("FloatList", "ContactNormalMin", "Least normal force at a contact's points, N."),
        ("FloatList", "ContactNormalMean", "Mean normal force at a contact's points, N."),
        ("FloatList", "ContactFriction", "Friction over normal force that a contact needs."),
        ("FloatList", "TileNormalForce", "Least normal force at a tile's contact points, N."),
        ("IntegerList", "WeakContacts",
         "Pairs of tiles whose contact is below the least force, counted from 0."))

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        add_figures(obj, with_units=True)


def write_verification(obj: Any, verification: Optional[Any]) -> None:
    """Write the forces of the stage's result; none without one."""
    arrays = verification.arrays if verification is not None else {}
    for name, array in _ARRAYS.items():
        setattr(obj, name, np.ravel(arrays.get(array, ())).tolist())
    weak = verification.weak_contacts if verification is not None else ()
    obj.WeakContacts = [tile for pair in weak for tile in pair]


class BodiesProxy(Proxy):
    """Behaviour of an object that holds one kind of body of a design."""

    TYPE = "CurveUps::Bodies"

    PROPERTIES = (
        ("String", "Kind", "Base", "Which of the design's bodies.", READ_ONLY),
        ("String", "Keys", "Base", "What this was built from.", READ_ONLY | HIDDEN | OUTPUT))


def write_body(obj: Any, shape: Any, keys: Keys, placement: Any) -> None:
    """Store a shape, and the keys of what it was built from."""
    # The shape is placed, not the object, which would go through all its solids once more.
    if not placement.isIdentity():
        shape.Placement = placement
    obj.Shape = shape
    write_keys(obj, keys)
    obj.purgeTouched()
