# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles, Support and Anchors: solids below a Design."""

from __future__ import annotations

import json
from typing import Any

from .proxy import HIDDEN, OUTPUT, READ_ONLY, PartProxy, add

KINDS = {"Tiles": "tiles", "Support": "support", "Anchors": "anchors"}  # by slot


class BodiesProxy(PartProxy):
    """Behaviour of an object that holds one kind of body of a design."""

    TYPE = "CurveUps::Bodies"

    def add_properties(self, obj: Any) -> None:
        super().add_properties(obj)
        add(obj, "App::PropertyString", "Kind", "Base", "Which of the design's bodies.", READ_ONLY)
        add(obj, "App::PropertyString", "BuiltFrom", "Base", "The design and values this was built from.",
            READ_ONLY | HIDDEN | OUTPUT)


def write_body(obj: Any, shape: Any, origin: dict[str, Any], placement: Any) -> None:
    """origin: digest of the design and parameters by property."""
    # In the shape: an object that is moved goes through all its solids once more.
    if not placement.isIdentity():
        shape.Placement = placement
    obj.Shape = shape
    obj.BuiltFrom = json.dumps(origin)
    obj.purgeTouched()
