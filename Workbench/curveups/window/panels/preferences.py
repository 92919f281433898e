# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has set for all designs: switches, and the parameters that new designs begin with."""

from __future__ import annotations

from typing import Any

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/CurveUps"


def group(name: str = "") -> Any:
    """FreeCAD's parameters of CurveUps, or a group of them."""
    return FreeCAD.ParamGet(f"{GROUP}/{name}" if name else GROUP)


def draws_live() -> bool:
    """Whether the layout is drawn while it is solved."""
    return group().GetBool("DrawLive", True)


def set_draws_live(value: bool) -> None:
    group().SetBool("DrawLive", value)


_WRITERS = {bool: "SetBool", int: "SetInt", float: "SetFloat", str: "SetString"}


def remember(design: Any, names: list[str]) -> None:
    """New designs begin with the values that these properties have; lengths in mm."""
    store = group("Defaults")
    for name in names:
        value = plain(getattr(design, name))
        getattr(store, _WRITERS[type(value)])(name, value)


def remembered(design: Any) -> dict[str, Any]:
    """Values by property name in which `design` differs from what new designs begin with; FreeCAD's own
    units."""
    found = {}
    for _, name, value in group("Defaults").GetContents() or ():
        if name in design.PropertiesList and plain(getattr(design, name)) != value:
            found[name] = value
    return found


def plain(value: Any) -> Any:
    """A property's value as a number of FreeCAD's own units, a text or a switch."""
    return value.Value if hasattr(value, "getValueAs") else value
