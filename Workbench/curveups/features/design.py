# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object: parameters, the results made from them, its states, and its solids.

Results are kept as text, so that reopening a document needs no solving and changes no bit. `execute` sets the
states, and builds solids of values that have none: at once, or on the worker of a window.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .. import __version__
from ..base.errors import CurveUpsError
from ..base.findings import Finding, refused
from ..base.native import native, problem
from ..project.keys import Record, key_of
from ..project.project import Project, Results
from ..stages import asked_by
from ..stages.solids import BODIES
from . import live, properties, proxy, status, target
from .parts import add_figures, write_body, write_volumes
from .proxy import HIDDEN, OUTPUT, READ_ONLY, SLOTS, Proxy, add, show, type_of
from .status import KINDS, Keys, read_keys, write_keys

SOLIDS = asked_by("build")  # stages

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
    # Live projects (live.py), and whether a command works on this design. They are attributes of the class,
    # since FreeCAD restores proxies without calling __init__.
    project: Optional[Project] = None
    standing: Optional[Project] = None
    running = False

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
        """Set the states, and have solids built for the values as they are: in a window after the edit, so
        that undo holds no solids and nobody waits."""
        if target.is_target(obj.Target):
            target.write_stamp(obj.Target)
        _place(obj)
        to_build = status.refresh(obj).to_build
        if proxy.build_later is not None:
            proxy.build_later(obj, to_build)
        elif to_build:
            build(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """Drop live projects of other results; give Density the weight of the printer's material."""
        if name == "Results":
            self.project = self.standing = None
        elif name == "Printer" and self.ready and not obj.Document.Transacting:  # undo has Density
            properties.follow_printer(obj)

    def state(self, obj: Any) -> status.Status:
        """States as the properties are now, edits that wait for a recompute included."""
        return status.status_of(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        super().onDocumentRestored(obj)
        if obj.Document.Importing:  # a copy
            _own_parts(obj)
        if obj.Target is not None:
            show(obj.Target)  # it has no proxy that would
        status.refresh(obj)


def _place(obj: Any) -> None:
    """Move the parts of a Design to where it stands. Shapes keep rotations up to rounding."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is not None and "Placement" in part.PropertiesList and not np.allclose(
                _numbers(part.Placement), _numbers(obj.Placement), rtol=1e-12, atol=1e-12):
            part.Placement = obj.Placement
            part.purgeTouched()


def _numbers(placement: Any) -> list[float]:
    """Base and quaternion. Methods of Rotation that compare would touch the object."""
    return [*placement.Base, *placement.Rotation.Q]


def _own_parts(obj: Any) -> None:
    """Copy the parts that another Design has as well: those of a Design that was copied without them."""
    for slot in SLOTS:
        part = getattr(obj, slot)
        if part is not None and any(other != obj and type_of(other) == type_of(obj) for other in part.InList):
            setattr(obj, slot, obj.Document.copyObject(part, False))


def lacks_solids(obj: Any) -> bool:
    """True where a state that was set last says so."""
    return any(body is not None and body.Status != status.CURRENT for body in (
        getattr(obj, slot) for slot in KINDS))


def build(obj: Any) -> None:
    """Build the solids now. A failure becomes the state of the design."""
    if problem() is not None:
        return
    try:
        take_solids(obj, live.design_project_of(obj).run(SOLIDS, strict=True))
    except CurveUpsError as error:
        fail_solids(obj, refused(error), bodies_record(obj))


def take_solids(obj: Any, results: Results) -> None:
    """Store the solids of a run's results, and the reasons of the constraints. Not to be called inside of a
    transaction, which would copy all solids."""
    import FreeCAD

    model = results["solids"].model
    if model is None:  # the run was stopped, or it is known that none can be built
        for reason in (*results["bodies"].reasons(), *results["solids"].reasons()):
            fail_solids(obj, reason, results.made[BODIES.name].record)
        return
    keys = Keys({name: results.made[name].record for name in SOLIDS},
                reasons=tuple(results["figures"].reasons()))
    for slot, kind in KINDS.items():
        body = getattr(obj, slot)
        if body is not None:
            write_body(body, model.shape(kind), keys, obj.Placement)
    write_volumes(obj, model.volumes)
    write_keys(obj, keys, "RebuiltKeys")
    status.refresh(obj)
    for warning in results["bodies"].warnings():
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {warning}\n")


def bodies_record(obj: Any) -> Record:
    """Record of bodies that would be made of the present values."""
    return Record(key_of(BODIES, read_keys(obj).records, properties.values_of(obj)))


def fail_solids(obj: Any, reason: Finding, record: Record) -> None:
    """Store that no solids can be made of the values in `record`. The old ones stay."""
    write_keys(obj, Keys({BODIES.name: record}, failed=True, reasons=(reason,)), "RebuiltKeys")
    status.refresh(obj)
