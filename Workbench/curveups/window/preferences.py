# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences for all designs: switches, and the parameters that new designs begin with."""

from __future__ import annotations

from typing import Any

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/CurveUps"
_WRITERS = {bool: "SetBool", int: "SetInt", float: "SetFloat", str: "SetString"}


def group(name: str = "") -> Any:
    """FreeCAD's preferences of CurveUps, or a group of them."""
    return FreeCAD.ParamGet(f"{GROUP}/{name}" if name else GROUP)


def draws_live() -> bool:
    """True if the layout is drawn while it is solved."""
    return group().GetBool("DrawLive", True)


def remember(design: Any, names: list[str]) -> None:
    """Let new designs begin with the values of these properties; lengths in mm."""
    store = group("Defaults")
    for name in names:
        value = plain(getattr(design, name))
        getattr(store, _WRITERS[type(value)])(name, value)


def remembered(design: Any) -> dict[str, Any]:
    """Remembered values that differ from those of `design`, by property name; FreeCAD's own units."""
    return {name: value for _, name, value in group("Defaults").GetContents() or ()
            if name in design.PropertiesList and plain(getattr(design, name)) != value}


def plain(value: Any) -> Any:
    """A property's value as a number in FreeCAD's own units, a text or a switch."""
    return value.Value if hasattr(value, "getValueAs") else value
