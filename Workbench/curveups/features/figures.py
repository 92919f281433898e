# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stores figures of a design as properties, which spreadsheets and expressions read."""

from __future__ import annotations

from typing import Any, Mapping

from ..project.project import Results
from . import properties
from .proxy import OUTPUT, READ_ONLY, add, write

# Property, type, unit or meaning, path in report.json.
FIGURES = (
    ("TileCount", "App::PropertyInteger", "Tiles.", ("tiles",)),
    ("ContactCount", "App::PropertyInteger", "Contacts between tiles.", ("contacts",)),
    ("CutCount", "App::PropertyInteger", "Edges that are cut.", ("cuts",)),
    ("AreaRatio", "App::PropertyFloat", "Flat area over actuated area.", ("area", "ratio")),
    ("FlatArea", "App::PropertyFloat", "Flat area, cm2.", ("area", "flat_cm2")),
    ("ActuatedArea", "App::PropertyFloat", "Actuated area, cm2.", ("area", "actuated_cm2")),
    ("LargestViolation", "App::PropertyFloat", "Largest violation of a gap, mm.",
     ("constraints", "max_gap_violation_mm")),
    ("SmallPins", "App::PropertyInteger", "Sides of pins below APinMin.",
     ("constraints", "pin_sides_below_area")),
    ("MinNormalForce", "App::PropertyFloat", "Least normal force at a contact point, N.",
     ("contact_forces", "normal_min")),
    ("MeanNormalForce", "App::PropertyFloat", "Mean normal force at contact points, N.",
     ("contact_forces", "normal_mean")),
    ("MaxFriction", "App::PropertyFloat", "Largest friction over normal force.",
     ("contact_forces", "friction_ratio_max")),
    ("MeanDeviation", "App::PropertyFloat", "Mean distance from the target, mm.", ("deviation", "mean_mm")),
    ("MaxDeviation", "App::PropertyFloat", "Largest distance from the target, mm.", ("deviation", "max_mm")),
)
VOLUMES = {"Tiles": "TileVolume", "Support": "SupportVolume", "Anchors": "AnchorVolume"}  # by slot


def add_figures(obj: Any) -> None:
    """The properties that a Design lacks."""
    for name, kind, tip, _ in FIGURES:
        add(obj, kind, name, properties.FIGURES, tip, READ_ONLY | OUTPUT)
    for slot, name in VOLUMES.items():
        add(obj, "App::PropertyFloat", name, properties.FIGURES, f"Volume of the {slot.lower()}, cm3.",
            READ_ONLY | OUTPUT)


def write_figures(obj: Any, results: Results) -> None:
    """Those that a run's results have."""
    report: dict[str, Any] = {}
    for result in results.values():
        report.update(result.report())
    for name, _, _, path in FIGURES:
        value: Any = report
        for key in path:
            value = value.get(key) if isinstance(value, Mapping) else None
        if isinstance(value, (int, float)):
            write(obj, name, value)


def write_volumes(obj: Any, volumes: Mapping[str, float], kinds: Mapping[str, str]) -> None:
    """volumes: mm3 by kind; kinds: by slot."""
    for slot, kind in kinds.items():
        write(obj, VOLUMES[slot], volumes[kind] / 1000)
