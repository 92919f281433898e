# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user has set for all designs: switches, and the parameters that new designs begin with."""

from __future__ import annotations

from typing import Any

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/CurveUps"


def _group(name: str = "") -> Any:
    return FreeCAD.ParamGet(f"{GROUP}/{name}" if name else GROUP)


def draws_live() -> bool:
    """Whether the layout is drawn while it is solved."""
    return _group().GetBool("DrawLive", True)


def set_draws_live(value: bool) -> None:
    _group().SetBool("DrawLive", value)


def shows_all() -> bool:
    """Whether panels show parameters that are seldom needed as well."""
    return _group().GetBool("AllParameters", False)


def set_shows_all(value: bool) -> None:
    _group().SetBool("AllParameters", value)


def export_mask() -> str:
    """How files were named last."""
    return _group().GetString("ExportMask", "{name}-{body}")


def set_export_mask(mask: str) -> None:
    _group().SetString("ExportMask", mask)


_WRITERS = {bool: "SetBool", int: "SetInt", float: "SetFloat", str: "SetString"}


def remember(design: Any, names: list[str]) -> None:
    """New designs begin with the values that these properties have; lengths in mm."""
    store = _group("Defaults")
    for name in names:
        value = plain(getattr(design, name))
        getattr(store, _WRITERS[type(value)])(name, value)


def remembered(design: Any) -> dict[str, Any]:
    """Values by property name in which `design` differs from what new designs begin with; FreeCAD's own
    units."""
    found = {}
    for _, name, value in _group("Defaults").GetContents() or ():
        if name in design.PropertiesList and plain(getattr(design, name)) != value:
            found[name] = value
    return found


def plain(value: Any) -> Any:
    """A property's value as a number of FreeCAD's own units, a text or a switch."""
    return value.Value if hasattr(value, "getValueAs") else value
