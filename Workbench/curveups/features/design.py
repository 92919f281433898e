# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object: parameters, the results made from them, its states, its solids, and the projects that
commands run.

Results are kept as text, so that reopening a document needs no solving and changes no bit. `execute` sets the
states, and builds solids of values that have none: at once, or on the worker of a window. The proxy keeps
projects as they were read.
"""

from __future__ import annotations

from typing import Any, Optional, cast

import numpy as np

from .. import __version__
from ..base.errors import CurveUpsError
from ..base.findings import Finding, refused
from ..base.native import native, problem
from ..base.parameters import without_switches
from ..project import saved_results
from ..project.keys import Record, changes, key_of
from ..project.project import Made, Project, Results
from ..stages import BY_NAME, RISEN, stages_of
from ..stages.design import FinishedDesign
from ..stages.following import Earlier
from ..stages.solids import BODIES
from ..stages.surface import Source
from . import properties, proxy, status, target
from .parts import add_figures, edges_of, request_of, write_body, write_volumes
from .proxy import HIDDEN, OUTPUT, READ_ONLY, SLOTS, Proxy, add, show, type_of
from .status import GIVEN, KINDS, Keys, read_keys, write_keys

SOLIDS = stages_of("build")  # stages
_FOLLOWED = {"source", "scale"}  # inputs of a target whose changes its tiles follow

# Tooltips of properties by their names.
_RESULTS = {"Verdict": "valid, not valid, not judged, or out of date.",
            "Holds": "holds, does not hold, or not settled: whether the settled shape stays.",
            "Reasons": "Why.",
            "Tiling": "How the tiles came where there were earlier ones: followed, or tiled anew and why.",
            "Status": "empty, current, out of date, invalid or running.",
            "Kit": "Of the fabrication kit: current, or out of date and why; empty where there is none.",
            "Actuation": "Of the path from flat: current, or out of date and why; empty where there is none."}
_HIDDEN = {"Results": "Everything that was computed.", "Keys": "What results were made from.",
           "RebuiltKeys": "What solids were made from.",
           "KitKeys": "What the fabrication kit was made from."}


class DesignProxy(Proxy):
    """Behaviour of a Design object."""

    TYPE = "CurveUps::Design"
    # Projects, and whether a command works on this design. They are attributes of the class,
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
        """Drop projects of other results; give Density the weight of the printer's material."""
        if name == "Results":
            self.project = self.standing = None
        elif name == "Printer" and self.ready and not obj.Document.Transacting:  # undo has Density
            properties.follow_printer(obj)

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
        take_solids(obj, design_project_of(obj).run(SOLIDS, strict=True))
    except CurveUpsError as error:
        fail_solids(obj, refused(error), bodies_record(obj))


def take_solids(obj: Any, results: Results) -> None:
    """Store the solids of a run's results, and the reasons of the constraints. Not to be called inside of a
    transaction, which would copy all solids."""
    import FreeCAD
    import Part

    shapes = results["solids"].shapes
    if not shapes:  # the run was stopped, or it is known that none can be built
        for reason in (*results["bodies"].reasons(), *results["solids"].reasons()):
            fail_solids(obj, reason, results.made[BODIES.name].record)
        return
    keys = Keys({name: results.made[name].record for name in SOLIDS},
                reasons=tuple(results["figures"].reasons()))
    for slot, kind in KINDS.items():
        body = getattr(obj, slot)
        if body is not None:
            write_body(body, Part.Compound(shapes[kind]), keys, obj.Placement)
    write_volumes(obj, results["bodies"].model.volumes)
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


def project_of(obj: Any) -> Project:
    """Project from target to verdict under the present properties: Solve runs it. Raises CurveUpsError where
    a property can't be used."""
    project, surface = stored(obj), obj.Target
    project.parameters = settings_of(obj)
    if target.is_target(surface) and (surface.Source or surface.File or surface.BuiltIn):
        if "Touched" in surface.State:  # no recompute has seen its source
            target.write_stamp(surface)
        given = project.given()
        known = given["source"].result if "source" in given else None
        source = target.source_of(surface, cast(Optional[Source], known))
        if source is not known:
            project.give("source", source)
        request = request_of(obj.Cuts, by_number=project.out_of_date("target") == ())
        if "cut request" not in given or given["cut request"].content != request.content:
            project.give("cut request", request)
    return project


def earlier_tiles(obj: Any, project: Project) -> Optional[Earlier]:
    """Tiles of a Design that its target is to carry along: nothing but its source or its scale has changed.
    project: project_of the Design."""
    made, changed = project.made(), project.out_of_date("target")
    if not changed or not _FOLLOWED.issuperset(changed) or not project.latest("source").remesh:
        return None
    tiles, finished = project.latest("target"), project.latest("design")
    cuts = edges_of(obj.Cuts) if obj.Cuts is not None else np.zeros((0, 2), np.int32)
    if len(cuts) and not 0 <= cuts.min() <= cuts.max() < len(tiles.V):
        return None
    laid_out = finished is not None and np.array_equal(finished.design.F, tiles.F)
    return Earlier(tiles.V, tiles.F, cuts, (finished.design.T, finished.design.q) if laid_out else None,
                   float(made["surface"].key["scale"]))


def design_project_of(obj: Any) -> Project:
    """Project of the layout as it stands under the present geometry and physics: Verify runs it, and solids
    are built from it. Raises CurveUpsError where there is no layout or a property can't be used."""
    finished = stored(obj).latest("design")
    if finished is None:
        raise CurveUpsError("there is no layout yet", obj.Label, "run Solve")
    parameters = properties.read_parameters(obj, _base(finished), of_layout=False)
    proxy = obj.Proxy
    if proxy.standing is None or proxy.standing.latest("design").content != finished.content:
        # Without the verification that came with it: that is known by its key.
        given = FinishedDesign(finished.design, None, finished.unsettled)
        known = {name: made for name, made in stored(obj).made().items() if name != "design"}
        proxy.standing = Project(finished.design.name, parameters, {"design": given}, obj.Label, known)
    proxy.standing.parameters = parameters
    return proxy.standing


def settings_of(obj: Any) -> Any:
    """Native Parameters of the properties. Raises CurveUpsError that names property, range and remedy."""
    return properties.read_parameters(obj, _base(stored(obj).latest("design")))


def _base(finished: Any) -> Any:
    """Parameters that are no property."""
    return without_switches(finished and finished.design)


def stored(obj: Any) -> Project:
    """Results that the document holds, under whatever parameters; see project_of and design_project_of. None
    where they can't be read: the report view says so."""
    if obj.Proxy.project is None:
        made = _read_results(obj)
        given = {name: made[name].result for name in ("source", "cut request") if name in made}
        if "source" not in given and "design" in made:
            given = {"design": made["design"].result}
        others = {name: result for name, result in made.items() if name not in given}
        parameters = _base(made["design"].result if "design" in made else None)
        obj.Proxy.project = Project(obj.Label, parameters, given, obj.Label, others)
    return cast(Project, obj.Proxy.project)


def _read_results(obj: Any) -> dict[str, Made]:
    import FreeCAD

    try:
        return saved_results.from_text(obj.Results, obj.Label) if obj.Results else {}
    except CurveUpsError as error:
        if problem() is not None:
            raise
        FreeCAD.Console.PrintWarning(f"{error}\n")
        return {}


def warnings_of(obj: Any) -> list[Finding]:
    """Warnings of stored results that are current; the path from flat has a panel of its own."""
    made, keys, values = stored(obj).made(), read_keys(obj), properties.values_of(obj)
    return [warning for name in BY_NAME if name in made and name != RISEN
            for warning in made[name].result.warnings()
            if changes(name, keys.records, values, (*GIVEN, "design")) == ()]
