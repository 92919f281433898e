# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as the user's unit schema writes them."""

from __future__ import annotations

import math

import FreeCAD


def user_unit(unit: str, size: float) -> tuple[float, str]:
    """A factor and a unit for values of about `size` in `unit` (as FreeCAD spells it; empty for ratios):
    the user sees value * factor in that unit."""
    if not unit:
        return 1.0, ""
    one = FreeCAD.Units.Quantity(f"1 {unit}")
    quantity = FreeCAD.Units.Quantity((size or 1.0) * one.Value, one.Unit)
    _, per_unit, name = quantity.getUserPreferred()
    return one.Value / per_unit, name


def short(value: float) -> str:
    """Three digits, without exponents where that is readable."""
    if not math.isfinite(value):
        return "–"
    if value == 0 or abs(value) >= 1e5 or abs(value) < 1e-3:
        return f"{value:.3g}"
    return f"{value:.{max(0, 2 - math.floor(math.log10(abs(value))))}f}"


def text_of(value: float, unit: str, size: float) -> str:
    """A value with its unit, which is that for values of about `size`."""
    if not math.isfinite(value):
        return "–"
    factor, name = user_unit(unit, size)
    return f"{short(value * factor)} {name}".rstrip()
