# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object: parameters, the results made from them, and whether these still belong together.

Results are kept as text, so that reopening a document needs no solving and changes no bit.
"""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Iterator, Optional

from .. import __version__
from ..base.errors import CurveUpsError
from ..base.findings import Finding, Style, refused
from ..base.native import native, problem
from ..project.project import Project
from . import properties, rebuild, status, target
from .parts import add_figures
from .proxy import HIDDEN, OUTPUT, READ_ONLY, SLOTS, Proxy, add, show, type_of, write


# Tooltips of properties by their names.
_RESULTS = {"Verdict": "valid, not valid, not judged, or out of date.",
            "Holds": "holds, does not hold, or not settled: whether the settled shape stays.",
            "Reasons": "Why.",
            "Status": "empty, current, out of date, invalid or running.",
            "Kit": "Of the fabrication kit: empty, current, or out of date and why.",
            "Actuation": "Of the path from flat: empty, current, or out of date and why."}
_HIDDEN = {"Results": "Everything that was computed.", "Keys": "What results were made from.",
           "RebuiltKeys": "What solids were made from.",
           "KitKeys": "What the fabrication kit was made from."}


class DesignProxy(Proxy):
    """Behaviour of a Design object."""

    TYPE = "CurveUps::Design"
    # The live projects (live.py), and whether a command works on this design. A class's own defaults:
    # FreeCAD makes proxies of a document without calling __init__.
    project: Optional[Project] = None
    standing: Optional[Project] = None
    running = False
    _refreshing = False
    _told: tuple[str, ...] = ()  # reasons that the report view has already

    def add_properties(self, obj: Any) -> None:
        for slot in SLOTS:
            add(obj, "Link", slot, "Base", f"{slot} of this design.", READ_ONLY | HIDDEN)
        add(obj, "Placement", "Placement", "Base", "Where the design stands.")
        for name, tip in _RESULTS.items():
            kind = "StringList" if name == "Reasons" else "String"
            add(obj, kind, name, properties.RESULT, tip, READ_ONLY | OUTPUT)
        add_figures(obj, with_units=False)
        for name, tip in _HIDDEN.items():
            add(obj, "String", name, "Base", tip, READ_ONLY | HIDDEN | OUTPUT)
        add(obj, "String", "CurveUpsVersion", "Base", "The version that made this object.", READ_ONLY)
        if not obj.CurveUpsVersion:
            obj.CurveUpsVersion = __version__
        if problem() is None:
            properties.add_parameters(obj, native.Parameters())

    def execute(self, obj: Any) -> None:
        """Without a window, makes the solids for the values as they are; with one they follow after the
        edit (window/viewproviders/following.py), so that undo holds no solids and nobody waits."""
        import FreeCAD

        if target.is_target(obj.Target):
            target.notice(obj.Target)
        if not FreeCAD.GuiUp:
            rebuild.follow(obj)
        self.refresh(obj)
        wrong = tuple(obj.Reasons) if obj.Status == status.INVALID else ()
        for reason in wrong if wrong != self._told else ():
            FreeCAD.Console.PrintError(f"{obj.Label}: {reason}\n")
        self._told = wrong

    def onChanged(self, obj: Any, name: str) -> None:
        if self._refreshing or not self.ready:
            return
        if name == "Results":
            self.project = self.standing = None
        if name == "Placement":
            for slot in SLOTS:
                part = getattr(obj, slot)
                if part is not None and "Placement" in part.PropertiesList:
                    part.Placement = obj.Placement
                    part.purgeTouched()
        elif name in _WATCHED or properties.parameter_of(name):
            if name == "Printer" and not obj.Document.Transacting:  # undo brings Density back itself
                properties.follow_printer(obj)
            self.refresh(obj)

    def refresh(self, obj: Any) -> None:
        """Verdict, reasons and states, from what the document holds now."""
        if self._refreshing:
            return
        self._refreshing = True
        try:
            found = self.state(obj)
            write(obj, "Verdict", found.verdict)
            write(obj, "Holds", found.holds)
            write(obj, "Reasons", [reason.sentence(_NAMED) for reason in found.reasons])
            write(obj, "Status", found.state)
            for name, parts in (("Kit", found.kit), ("Actuation", found.actuation)):
                if name in obj.PropertiesList:
                    write(obj, name, ": ".join(filter(None, parts)))
            for slot, (state, reason) in found.parts.items():
                part = getattr(obj, slot)
                if part is not None and {"Status", "Reason"} <= set(part.PropertiesList):
                    write(part, "Status", state)
                    write(part, "Reason", reason)
        finally:
            self._refreshing = False

    def state(self, obj: Any) -> status.Status:
        """What is current, and why something is not, from what the document holds now."""
        return status.status_of(obj, self.refused(obj), self.running)

    @contextmanager
    def many_changes(self) -> Iterator[None]:
        """States are not brought up to date meanwhile: who makes the changes does so once, at their end."""
        before, self._refreshing = self._refreshing, True
        try:
            yield
        finally:
            self._refreshing = before

    def refused(self, obj: Any) -> Optional[Finding]:
        """Why the properties' values can't be used; None where they can, or nobody can tell."""
        if problem() is not None:
            return None
        try:
            properties.read_parameters(obj, native.Parameters())
        except CurveUpsError as error:
            return refused(error)
        return None

    def onDocumentRestored(self, obj: Any) -> None:
        super().onDocumentRestored(obj)
        if obj.Document.Importing:  # a copy
            _own_parts(obj)
        if obj.Target is not None:
            show(obj.Target)  # it has no proxy that would
        self.refresh(obj)


_NAMED = Style(properties.named)

# A change of these is a change of state.
_WATCHED = (*SLOTS, "Results", "Keys", "RebuiltKeys", "KitKeys")


def _own_parts(obj: Any) -> None:
    """Copies the parts that another Design has as well: a Design that was copied without them."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is not None and any(other != obj and type_of(other) == type_of(obj) for other in part.InList):
            setattr(obj, slot, obj.Document.copyObject(part, False))
