# SPDX-License-Identifier: LGPL-2.1-or-later
"""Live projects behind a Design: made from what the document stores, kept by its proxy."""

from __future__ import annotations

from typing import Any, Mapping, Optional, cast

from ..base.errors import CurveUpsError
from ..base.findings import Finding
from ..base.native import native
from ..base.parameters import table
from ..project import saved_results
from ..project.keys import changes
from ..project.project import Made, Project
from ..stages import BY_NAME, RISEN
from ..stages.design import FinishedDesign
from ..stages.surface import Source
from . import properties
from .parts import request_of
from .status import GIVEN, read_keys
from .target import is_target, source_of, write_stamp


def project_of(obj: Any) -> Project:
    """Project from target to verdict under the present properties: Solve runs it. Raises CurveUpsError where
    a property can't be used."""
    project, target = stored(obj), obj.Target
    project.parameters = settings_of(obj)
    if is_target(target) and (target.Source or target.File or target.BuiltIn):
        if "Touched" in target.State:  # no recompute has seen its source
            write_stamp(target)
        given = project.given()
        known = given["source"].result if "source" in given else None
        source = source_of(target, cast(Optional[Source], known))
        if source is not known:
            project.give("source", source)
        request = request_of(obj.Cuts, by_number=project.out_of_date("target") == ())
        if "cut request" not in given or given["cut request"].content != request.content:
            project.give("cut request", request)
    return project


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
    """Parameters that are no property: those of the design, but for stages, which commands choose."""
    if finished is None:
        return native.Parameters()
    parameters, defaults = native.Parameters(finished.design.parameters), native.Parameters()
    for row in table():
        if row.level == "switch":
            parameters.set(row.name, defaults.get(row.name))
    return parameters


def stored(obj: Any) -> Project:
    """Results that the document holds, under whatever parameters; see project_of and design_project_of."""
    if obj.Proxy.project is None:
        keep(obj, saved_results.from_text(obj.Results, obj.Label) if obj.Results else {})
    return cast(Project, obj.Proxy.project)


def warnings_of(obj: Any) -> list[Finding]:
    """Warnings of stored results that are current; the path from flat has a panel of its own. Raises
    CurveUpsError where they can't be read."""
    made, keys, values = stored(obj).made(), read_keys(obj), properties.values_of(obj)
    return [warning for name in BY_NAME if name in made and name != RISEN
            for warning in made[name].result.warnings()
            if changes(name, keys.records, values, (*GIVEN, "design")) == ()]


def keep(obj: Any, made: Mapping[str, Made]) -> None:
    """Make results, as read from the document, those of its live project."""
    given = {name: made[name].result for name in ("source", "cut request") if name in made}
    if "source" not in given and "design" in made:
        given = {"design": made["design"].result}
    others = {name: result for name, result in made.items() if name not in given}
    parameters = _base(made["design"].result if "design" in made else None)
    obj.Proxy.project = Project(obj.Label, parameters, given, obj.Label, others)
    obj.Proxy.standing = None
