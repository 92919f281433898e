# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stores figures of a design as properties, which spreadsheets and expressions read."""

from __future__ import annotations

from typing import Any, Mapping

from ..project.project import Results
from . import properties
from .proxy import HIDDEN, OUTPUT, READ_ONLY, add, write

# Property, type, unit, meaning, path in report.json.
FIGURES = (
    ("TileCount", "App::PropertyInteger", "", "Tiles", ("tiles",)),
    ("ContactCount", "App::PropertyInteger", "", "Contacts between tiles", ("contacts",)),
    ("CutCount", "App::PropertyInteger", "", "Edges that are cut", ("cuts",)),
    ("AreaRatio", "App::PropertyFloat", "", "Flat area over actuated area", ("area", "ratio")),
    ("FlatArea", "App::PropertyArea", "cm2", "Flat area", ("area", "flat_cm2")),
    ("ActuatedArea", "App::PropertyArea", "cm2", "Actuated area", ("area", "actuated_cm2")),
    ("LargestViolation", "App::PropertyDistance", "mm", "Largest violation of a gap",
     ("constraints", "max_gap_violation_mm")),
    ("SmallPins", "App::PropertyInteger", "", "Sides of pins below APinMin",
     ("constraints", "pin_sides_below_area")),
    ("MinNormalForce", "App::PropertyForce", "N", "Least normal force at a contact point",
     ("contact_forces", "normal_min")),
    ("MeanNormalForce", "App::PropertyForce", "N", "Mean normal force at contact points",
     ("contact_forces", "normal_mean")),
    ("MaxFriction", "App::PropertyFloat", "", "Largest friction over normal force",
     ("contact_forces", "friction_ratio_max")),
    ("MeanDeviation", "App::PropertyDistance", "mm", "Mean distance from the target",
     ("deviation", "mean_mm")),
    ("MaxDeviation", "App::PropertyDistance", "mm", "Largest distance from the target",
     ("deviation", "max_mm")),
    ("SettledDeviation", "App::PropertyDistance", "mm", "Mean distance of the settled shape from the design",
     ("settled", "scan", "mean_mm")),
    ("LargestSlip", "App::PropertyDistance", "mm", "Largest slip between tiles that settle",
     ("settled", "largest_slip_mm")),
    ("HoldingFriction", "App::PropertyFloat", "", "Least coefficient of friction at which the shape holds",
     ("settled", "holding_friction")),
    ("TileVolume", "App::PropertyVolume", "cm3", "Volume of the tiles", ()),
    ("SupportVolume", "App::PropertyVolume", "cm3", "Volume of the support", ()),
    ("AnchorVolume", "App::PropertyVolume", "cm3", "Volume of the anchors", ()),
)
_UNITS = {name: unit for name, _, unit, *_ in FIGURES}
_VOLUMES = {"tiles": "TileVolume", "support": "SupportVolume", "anchors": "AnchorVolume"}  # by kind of body


def add_figures(obj: Any, with_units: bool) -> None:
    """The properties that a Design or, with units, a Verification lacks. A sheet that sets a parameter reads
    those of the Verification, which depends on nothing; those of the Design are hidden, for scripts."""
    status = READ_ONLY | OUTPUT | (0 if with_units else HIDDEN)
    for name, kind, unit, meaning, _ in FIGURES:
        if with_units or not unit:
            add(obj, kind, name, properties.FIGURES, f"{meaning}.", status)
        else:
            add(obj, "App::PropertyFloat", name, properties.FIGURES, f"{meaning}, {unit}.", status)


def write_figures(obj: Any, results: Results, solved: bool) -> None:
    """Those that a run's results have; the others become 0 with another layout (solved)."""
    report: dict[str, Any] = {}
    for result in results.values():
        report.update(result.report())
    for name, _, _, _, path in FIGURES:
        value: Any = report
        for key in path:
            value = value.get(key) if isinstance(value, Mapping) else None
        if isinstance(value, (int, float)):
            _write(obj, name, value)
        elif solved and path:
            _write(obj, name, 0)


def write_volumes(obj: Any, volumes: Mapping[str, float]) -> None:
    """volumes: mm3 by kind of body."""
    for kind, name in _VOLUMES.items():
        _write(obj, name, volumes[kind] / 1000)


def _write(obj: Any, name: str, value: Any) -> None:
    import FreeCAD

    write(obj, name, value)
    unit = _UNITS[name].replace("2", "^2").replace("3", "^3")
    write(obj.Verification, name, FreeCAD.Units.Quantity(f"{value!r} {unit}") if unit else value)
