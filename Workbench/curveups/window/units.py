# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as the user's unit schema writes them."""

from __future__ import annotations

import math
from typing import Any, Callable

import FreeCAD

_FREECADS = {"mm": "mm", "mm2": "mm^2", "mm3": "mm^3", "N": "N", "MPa": "MPa"}
_MOST_DECIMALS = 9


def user_unit(unit: str, size: float) -> tuple[float, str]:
    """Factor and unit for values of about `size` in `unit` (as FreeCAD spells it; empty for ratios): the user
    sees value * factor in that unit."""
    if not unit:
        return 1.0, ""
    base = FreeCAD.Units.Quantity(f"1 {unit}")
    quantity = FreeCAD.Units.Quantity((size or 1.0) * base.Value, base.Unit)
    _, per_unit, name = quantity.getUserPreferred()
    if "*" in name:  # the schema has no unit for it: inches know no force
        return 1.0, unit
    return base.Value / per_unit, name


def short(value: float) -> str:
    """Write three digits, without exponents where that is readable."""
    if not math.isfinite(value):
        return "–"
    if value == 0 or abs(value) >= 1e5 or abs(value) < 1e-3:
        return f"{value:.3g}"
    return f"{value:.{max(0, 2 - math.floor(math.log10(abs(value))))}f}"


def text_of(value: float, unit: str, size: float) -> str:
    """Write a value with its unit, which is that for values of about `size`."""
    if not math.isfinite(value):
        return "–"
    factor, name = user_unit(unit, size)
    return f"{short(value * factor)} {name}".rstrip()


def whole(quantity: Any) -> str:
    """Write FreeCAD's quantity with three digits."""
    _, per_unit, unit = quantity.getUserPreferred()
    return f"{short(quantity.Value / per_unit)} {unit}"


def show_number(field: Any, value: Any) -> None:
    """Show a number or a quantity in FreeCAD's field, with the user's decimals, or as many more as three
    digits need: 0.02 mm are 0.000787 in."""
    quantity = FreeCAD.Units.Quantity(value)
    size, decimals = abs(quantity.Value / quantity.getUserPreferred()[1]), quantity.Format["Precision"]
    while decimals < _MOST_DECIMALS and abs(round(size, decimals) - size) > 0.005 * size:
        decimals += 1
    quantity.Format = {**quantity.Format, "Precision": decimals}
    field.setProperty("value", quantity)


def quantity(number: float, how: str, unit: str) -> str:
    """Write a number of a sentence with its unit; as `how` says where the user's lengths are millimetres."""
    if user_unit("mm", 10.0)[1] == "mm":
        return f"{number:{how}} {unit}"
    return text_of(number, _FREECADS[unit], number)


def in_user_units(heading: str) -> tuple[str, Callable[[float, str], str]]:
    """Heading that ends in the unit of its numbers ("pin area, mm2") with the user's unit, and a function
    that writes a number: as Python does where the unit stays."""
    what, _, unit = heading.rpartition(", ")
    factor, name = user_unit(_FREECADS[unit], 1.0) if unit in _FREECADS else (1.0, unit)
    if factor == 1.0:
        return heading, format
    return f"{what}, {name}", lambda number, how: short(number * factor)
