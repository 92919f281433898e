# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles, Support and Anchors: solids that follow a Design object."""

from __future__ import annotations

from typing import Any

from .properties import READ_ONLY


class BodiesProxy:
    """Behaviour of an object that holds one kind of body of a design."""

    TYPE = "CurveUps::Bodies"

    def __init__(self, obj: Any, design: Any, kind: str):
        obj.addProperty("App::PropertyLink", "Design", "Design", "The design this is built from.",
                        READ_ONLY)
        obj.addProperty("App::PropertyString", "Kind", "Design", "Which of its bodies.", READ_ONLY)
        obj.Design, obj.Kind = design, kind
        obj.Proxy = self

    def execute(self, obj: Any) -> None:
        """Takes the shape over; an error of the design has kept this from being called."""
        obj.Shape = obj.Design.Proxy.shape(obj.Design, obj.Kind)

    def dumps(self) -> dict:
        return {"type": self.TYPE}

    def loads(self, state: Any) -> None:
        pass

    __getstate__ = dumps
    __setstate__ = loads
