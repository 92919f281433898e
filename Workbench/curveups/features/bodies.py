# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles, Support and Anchors: solids below a Design."""

from __future__ import annotations

from typing import Any

from .keys import Keys, write_keys
from .proxy import HIDDEN, OUTPUT, READ_ONLY, PartProxy, add

KINDS = {"Tiles": "tiles", "Support": "support", "Anchors": "anchors"}  # by slot


class BodiesProxy(PartProxy):
    """Behaviour of an object that holds one kind of body of a design."""

    TYPE = "CurveUps::Bodies"

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        add(obj, "App::PropertyString", "Kind", "Base", "Which of the design's bodies.", READ_ONLY)
        add_keys(obj)


def add_keys(obj: Any) -> None:
    """Where a body says what it was built from."""
    add(obj, "App::PropertyString", "Keys", "Base", "What this was built from.", READ_ONLY | HIDDEN | OUTPUT)


def write_body(obj: Any, shape: Any, keys: Keys, placement: Any) -> None:
    """keys: of what it was built from."""
    # In the shape: an object that is moved goes through all its solids once more.
    if not placement.isIdentity():
        shape.Placement = placement
    obj.Shape = shape
    write_keys(obj, keys)
    obj.purgeTouched()
