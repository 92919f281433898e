# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps the overlays: commands, panels and solvers get theirs from `overlay_of(design)`."""

from __future__ import annotations

from typing import Any

_OVERLAYS: dict[tuple[str, str], Any] = {}  # by names of document and object


def add(design: Any, overlay: Any) -> None:
    """Registers the Overlay of a Design object."""
    _OVERLAYS[design.Document.Name, design.Name] = overlay


def overlay_of(design: Any) -> Any:
    """The Overlay of a Design object. Raises KeyError where it has none: without a window, or a design
    that never got its view."""
    key = (design.Document.Name, design.Name)
    if key not in _OVERLAYS:
        # Undone deletions bring a view provider back without attaching it anew.
        kept = getattr(getattr(design.ViewObject, "Proxy", None), "overlay", None)
        if kept is None:
            raise KeyError(key)
        _OVERLAYS[key] = kept
        kept.closed = False
        kept.refresh()
    return _OVERLAYS[key]


def overlays(document: str = "") -> list:
    """All there are, or those of a document by its name."""
    return [one for (name, _), one in _OVERLAYS.items() if document in ("", name)]


def forget(document: str, name: str = "") -> None:
    """Lets go of a document's overlays, or of one by the name of its object."""
    for key in [key for key in _OVERLAYS if key[0] == document and name in ("", key[1])]:
        _OVERLAYS.pop(key).close()
