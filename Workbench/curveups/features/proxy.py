# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of all document objects of ours: a stored type, and a proxy that can be attached anew.

A FreeCAD without this workbench drops proxies when it saves. The text in `CurveUpsType` stays, and
document.py makes the proxy from it when the document is opened.
"""

from __future__ import annotations

from typing import Any, Callable, ClassVar, Optional

READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8  # as addProperty takes them

# Slots of a Design, in the order of the tree.
SLOTS = ("Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors")

# Set by a window: gives an object its view; after an edit, builds the solids of a Design on the worker or,
# with False, ends that. Without a window solids are built as a Design is recomputed.
attach_view: Optional[Callable[[Any], None]] = None
build_later: Optional[Callable[[Any, bool], None]] = None

Row = tuple[str, str, str, str, int]  # of a table of properties: as add() takes them


class Proxy:
    """Behaviour of a document object. `obj` keeps all data: a proxy can be lost and made again."""

    TYPE: ClassVar[str] = ""
    PROPERTIES: ClassVar[tuple[Row, ...]] = ()
    # FreeCAD restores proxies without __init__, and sets properties one after another: until all are set,
    # they are no edits.
    ready = False

    def __init__(self, obj: Any):
        add_type(obj, self.TYPE)
        self.add_properties(obj)
        obj.Proxy = self
        self.ready = True

    def add_properties(self, obj: Any) -> None:
        """Add the properties that `obj` lacks: all of them for a new object. An object below a Design has
        some that say whether it is up to date, for the tree and for scripts."""
        add_part_properties(obj, self.TYPE)
        for row in self.PROPERTIES:
            add(obj, *row)

    def execute(self, obj: Any) -> None:
        """Compute nothing: commands make results."""

    def onDocumentRestored(self, obj: Any) -> None:
        self.add_properties(obj)
        self.ready = True
        show(obj)

    def dumps(self) -> dict:
        return {"type": self.TYPE}

    def loads(self, state: Any) -> None:
        pass

    __getstate__ = dumps
    __setstate__ = loads


def add_type(obj: Any, kind: str) -> None:
    """Store the kind of object that `obj` is to CurveUps."""
    add(obj, "String", "CurveUpsType", "Base", "What this object is to CurveUps.", READ_ONLY | HIDDEN)
    write(obj, "CurveUpsType", kind)


def add_part_properties(obj: Any, kind: str) -> None:
    """Add the properties of every object below a Design."""
    add_type(obj, kind)
    add(obj, "String", "Status", "Base",
        "empty, current, out of date, invalid or running.", READ_ONLY | OUTPUT)
    add(obj, "String", "Reason", "Base", "Why it is in this state.", READ_ONLY | OUTPUT)


def add(obj: Any, kind: str, name: str, group: str, tip: str, status: int = 0) -> None:
    """Add a property that `obj` lacks. kind: "String" is App::PropertyString."""
    if name not in obj.PropertiesList:
        obj.addProperty(f"App::Property{kind}", name, group, tip, status)


def write(obj: Any, name: str, value: Any) -> None:
    """Set a property to another value: an equal value would still count as an edit."""
    if getattr(obj, name) != value:
        setattr(obj, name, value)


def type_of(obj: Any) -> str:
    """Kind of object that `obj` is to CurveUps; empty for objects of others, and for links to ours."""
    return getattr(obj, "CurveUpsType", "") if "CurveUpsType" in obj.PropertiesList else ""


def designs(document: Any) -> list[Any]:
    """Design objects of a document, in the order of their making."""
    return [obj for obj in document.Objects if type_of(obj) == "CurveUps::Design"]


def design_of(obj: Any) -> Optional[Any]:
    """The Design that an object is, or is a part of; None for others."""
    if obj is None or type_of(obj) == "CurveUps::Design":
        return obj
    for other in obj.InList:
        if type_of(other) == "CurveUps::Design" and any(getattr(other, slot) == obj for slot in SLOTS):
            return other
    return None


def show(obj: Any) -> None:
    """Give an object its icon and menu, where there is a window."""
    if attach_view is not None:
        attach_view(obj)
