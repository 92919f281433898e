# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters as properties of a document object: types, units, groups, tooltips from one table."""

from __future__ import annotations

from typing import Any

from ..native import native

READ_ONLY, TRANSIENT, HIDDEN, OUTPUT = 1, 2, 4, 8

_TYPES = {"integer": "App::PropertyInteger", "switch": "App::PropertyBool",
          "choice": "App::PropertyEnumeration", "tiles": "App::PropertyString"}
# Types whose editor shows the unit. Where a FreeCAD lacks one (density before 0.21) the number is
# plain and its tooltip names the unit.
_UNIT_TYPES = {"mm": "App::PropertyLength", "mm2": "App::PropertyArea",
               "MPa": "App::PropertyPressure", "g/cm3": "App::PropertyDensity"}
_UNITS = {"mm2": "mm^2", "g/cm3": "g/cm^3"}  # as FreeCAD spells them


def add_parameters(obj: Any, parameters: Any) -> None:
    """One property for each parameter that `obj` lacks, with the value of `parameters`.

    Those that need the layout solved again are read-only: recomputing never solves.
    """
    supported = obj.supportedProperties()
    for row in native.parameter_table():
        if row.name in obj.PropertiesList or row.group in ("Files", "Stages"):
            continue
        kind = _TYPES.get(row.type) or _UNIT_TYPES.get(row.unit)
        if kind not in supported:
            kind = "App::PropertyFloat"
        free = row.tier == "rebuild"
        tip = row.meaning + _range(row)
        if not free:
            tip += " Read-only: it needs a new layout."
        obj.addProperty(kind, row.name, row.group, tip, 0 if free else READ_ONLY)
        if row.choices:
            setattr(obj, row.name, list(row.choices))
        value = parameters.get(row.name)
        if hasattr(getattr(obj, row.name), "getValueAs"):
            value = f"{value!r} {_UNITS.get(row.unit, row.unit)}"  # FreeCAD's own unit may be another
        setattr(obj, row.name, value)


def value_of(obj: Any, row: Any) -> Any:
    """What the property of a parameter says, in the parameter's unit."""
    value = getattr(obj, row.name)
    if hasattr(value, "getValueAs"):
        return value.getValueAs(_UNITS.get(row.unit, row.unit)).Value
    return value


def _range(row: Any) -> str:
    if row.type in ("switch", "choice", "tiles"):
        return ""
    unit = f" {row.unit}" if row.unit else ""
    return f" From {row.minimum:g} to {row.maximum:g}{unit}."


def apply_to(obj: Any, parameters: Any) -> list[str]:
    """Takes the free parameters over from the properties; the names of those that changed.

    A property that is equal up to the digits which a document keeps leaves the parameter its bits.
    """
    changed = []
    for row in native.parameter_table():
        if row.tier != "rebuild" or row.name not in obj.PropertiesList:
            continue
        value = value_of(obj, row)
        before = parameters.get(row.name)
        if isinstance(before, float):
            same = abs(value - before) <= 1e-12 * max(abs(value), abs(before))
        else:
            same = value == before
        if not same:
            parameters.set(row.name, value)
            changed.append(row.name)
    return changed
