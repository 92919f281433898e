# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters as properties of a Design: names, types, units, groups and tooltips from one table."""

from __future__ import annotations

import re
from typing import Any, Iterator, Optional

from ..base.errors import CurveUpsError
from ..base.native import native, translated
from ..base.parameters import Parameter, parameter, table
from ..stages.solids import density_of

# Two names belong to objects below a Design.
_NAMES = {"support": "SupportKind", "anchors": "WithAnchors"}

_TYPES = {"switch": "Bool", "choice": "Enumeration", "tiles": "String", "faces": "String",
          "opening": "String", "pieces": "String"}
# Types whose editor shows the unit. Where a FreeCAD lacks one (density before 0.21) the number is
# plain and its tooltip names the unit.
_UNIT_TYPES = {"mm": "Length", "mm2": "Area", "deg": "Angle", "MPa": "Pressure", "g/cm3": "Density"}
UNITS = {"mm2": "mm^2", "g/cm3": "g/cm^3"}  # as FreeCAD spells them

# In the order of work.
GROUPS = ("Target", "Tiles", "Layout", "Physics", "Repair", "Bumps", "Support", "Anchors", "Files")
RESULT, FIGURES = "0 Result", "9 Figures"
WHEN = {"rebuild": "Takes effect at once.", "verify": "Takes effect with Verify.",
        "layout": "Takes effect with Solve.",
        "files": "Takes effect with the next export."}


def property_name(parameter: str) -> str:
    """Name of a parameter's property: HBody for H_body, DGapMin for d_gap_min."""
    return _NAMES.get(parameter) or "".join(word[:1].upper() + word[1:] for word in parameter.split("_"))


def rows() -> Iterator[Parameter]:
    """Rows of the parameter table that a Design has as properties, basic ones first."""
    return iter(sorted((row for row in table() if row.level != "switch"), key=lambda row: not row.basic))


def parameter_of(name: str) -> Optional[Parameter]:
    """Row of a property; None for others."""
    return next((row for row in rows() if property_name(row.name) == name), None)


def values_of(obj: Any) -> dict[str, Any]:
    """All parameters, in their units; those without a property at their defaults. Needs no native module."""
    return {row.name: value_of(obj, name) if (name := property_name(row.name)) in obj.PropertiesList
            else row.default for row in table()}


def add_parameters(obj: Any, parameters: Any) -> None:
    """Add a property for each parameter that `obj` lacks, with the value of `parameters`."""
    supported = obj.supportedProperties()
    for row in rows():
        name = property_name(row.name)
        if name in obj.PropertiesList:
            continue
        kind = _TYPES.get(row.type) or _UNIT_TYPES.get(row.unit)
        if f"App::Property{kind}" not in supported:
            kind = "Float"
        # The property editor sorts by name: what is seldom needed comes after the rest of its group.
        group = f"{GROUPS.index(row.group) + 1} {row.group}{'' if row.basic else ', more'}"
        obj.addProperty(f"App::Property{kind}", name, group, tip_of(row))
        if row.choices:
            setattr(obj, name, list(row.choices))
        _set(obj, row, parameters.get(row.name))


def tip_of(row: Any) -> str:
    """Tooltip of a parameter's property. Windows translate it whole, in the context App::Property, as
    FreeCAD's property editor does."""
    unit = f" {row.unit}" if row.unit else ""
    ends = f" From {row.minimum:g} to {row.maximum:g}{unit}." if row.type == "number" else ""
    return f"{row.meaning}{ends} {WHEN[row.effect]}"


def write_parameters(obj: Any, parameters: Any) -> None:
    """Set the properties that differ from `parameters`; expressions on them stay and win."""
    for row in rows():
        write_parameter(obj, row.name, parameters.get(row.name))


def write_parameter(obj: Any, name: str, value: Any) -> None:
    """Set the property of a parameter to another value."""
    row = parameter(name)
    if not same(value_of(obj, property_name(name)), value):
        _set(obj, row, value)


def read_parameters(obj: Any, base: Any, of_layout: bool = True) -> Any:
    """Native Parameters of the properties. `base` gives parameters without a property and, without
    `of_layout`, those that need a new layout. A property that is equal up to the digits of a document leaves
    the parameter its bits. Raises CurveUpsError."""
    parameters = native.Parameters(base)
    for row in rows():
        if not (of_layout or row.keeps_layout):
            continue
        name = property_name(row.name)
        value = value_of(obj, name)
        if not same(value, parameters.get(row.name)):
            _refuse_wrong(obj, row, name, value)
            with translated(f"{obj.Label}.{name}"):
                parameters.set(row.name, value)
    with translated(obj.Label):
        parameters.check()
    return parameters


def follow_printer(obj: Any) -> None:
    """Set Density to that of the printer's material, as the command line does, unless it was set to another
    value."""
    common = parameter("density").default
    weights = {name: density_of(name) for name in parameter("printer").choices}
    if any(same(value_of(obj, "Density"), known) for known in (common, *weights.values())):
        write_parameter(obj, "density", weights[obj.Printer])


def value_of(obj: Any, name: str) -> Any:
    """Value of a parameter's property, in the parameter's unit."""
    value = getattr(obj, name)
    if hasattr(value, "getValueAs"):
        kind = obj.getTypeIdOfProperty(name).removeprefix("App::Property")
        unit = next(unit for unit, known in _UNIT_TYPES.items() if known == kind)
        return value.getValueAs(UNITS.get(unit, unit)).Value
    return value


def named(template: str) -> str:
    """Template of a sentence that names parameters as their properties; its placeholders stay."""
    names = "|".join(row.name for row in rows() if "_" in row.name)
    return re.sub(rf"(?<![{{\w])({names})\b", lambda match: property_name(match[0]), template)


def same(a: Any, b: Any) -> bool:
    """Compare up to the digits that a document keeps."""
    if isinstance(a, float) and isinstance(b, (int, float)) and not isinstance(b, bool):
        return abs(a - b) <= 1e-12 * max(abs(a), abs(b))
    return a == b


def _set(obj: Any, row: Any, value: Any) -> None:
    name = property_name(row.name)
    if hasattr(getattr(obj, name), "getValueAs"):
        value = f"{value!r} {UNITS.get(row.unit, row.unit)}"  # FreeCAD's own unit may be another
    setattr(obj, name, value)


def _refuse_wrong(obj: Any, row: Any, name: str, value: Any) -> None:
    """Raise CurveUpsError for a number out of range, in the words and units of the property editor."""
    if row.type != "number" or row.minimum <= value <= row.maximum:
        return
    raise CurveUpsError(f"{name} can't be {shown(row, value)}", obj.Label,
                        f"give {shown(row, row.minimum)} to {shown(row, row.maximum)}")


def shown(row: Any, value: float) -> str:
    """Write a parameter's value in the user's unit schema."""
    return str(quantity(row, value).UserString) if row.unit in _UNIT_TYPES else f"{value:g}"


def quantity(row: Any, value: float) -> Any:
    """Make FreeCAD's quantity of a parameter's value."""
    import FreeCAD

    return FreeCAD.Units.Quantity(f"{value!r} {UNITS.get(row.unit, row.unit)}")
