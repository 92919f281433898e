# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives a Design its own objects where it has others: a copy that was made without them, and a Design whose
links somebody changed."""

from __future__ import annotations

from typing import Any

from .bodies import KINDS
from .proxy import SLOTS, type_of

# What an object has that is of use in a slot, where its type was lost.
_HAS = {"Target": "Mesh", "Cuts": "Edges", "Layout": "Poses", "Verification": "ContactTiles"}


def own_parts(obj: Any) -> None:
    """Copies the parts that another Design has as well."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is not None and any(other != obj and type_of(other) == type_of(obj) for other in part.InList):
            setattr(obj, slot, obj.Document.copyObject(part, False))


def relink(obj: Any) -> None:
    """Puts into each slot that holds an object of another kind the one of its kind that no Design has there,
    or none."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is None or _fits(part, slot):
            continue
        free = [other for other in obj.Document.Objects if _fits(other, slot) and not any(
            type_of(user) == type_of(obj) and getattr(user, slot) == other for user in other.InList)]
        setattr(obj, slot, free[0] if free else None)
        import FreeCAD

        FreeCAD.Console.PrintWarning(f"{obj.Label}: {part.Label} is no {slot}: "
                                     + (f"{free[0].Label} takes its place\n" if free else "it is left out\n"))


def _fits(part: Any, slot: str) -> bool:
    kind = KINDS.get(slot)
    if type_of(part) not in ("", "CurveUps::Bodies" if kind else f"CurveUps::{slot}"):
        return False
    return (_HAS.get(slot, "Shape") in part.PropertiesList or bool(type_of(part))) and (
        kind is None or getattr(part, "Kind", "") in ("", kind))
