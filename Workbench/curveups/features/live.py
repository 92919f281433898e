# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live projects behind a Design: made from what the document stores, kept by its proxy."""

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
from .target import is_target, source_of


def project_of(obj: Any) -> Project:
    """From target to verdict under the properties as they are: what Solve runs. Raises CurveUpsError
    where a property can't be used."""
    project, target = stored(obj), obj.Target
    project.parameters = settings_of(obj)
    if is_target(target) and (target.Source or target.File or target.BuiltIn):
        given = project.given()
        source = given.get("source")
        found = source_of(target, cast(Optional[Source], source.result if source else None))
        if source is None or found is not source.result:
            project.give("source", found)
        by_number = project.out_of_date("target") == ()
        request = request_of(obj.Cuts, by_number)
        known = given.get("cut request")
        if known is None or known.content != request.content:
            project.give("cut request", request)
    return project


def design_project_of(obj: Any) -> Project:
    """The layout as it stands under the geometry and physics that the properties say: what Verify and
    the solids are made from. Raises CurveUpsError where there is no layout or a property can't be used."""
    finished = stored(obj).latest("design")
    if finished is None:
        raise CurveUpsError("there is no layout yet", obj.Label, "run Solve")
    parameters = properties.read_parameters(obj, _base(finished), of_layout=False)
    proxy = obj.Proxy
    if proxy.standing is None or proxy.standing.latest("design").content != finished.content:
        # Not the verification that came with it: that is known by what it was made from.
        given = FinishedDesign(finished.design, None, finished.unsettled)
        known = {name: made for name, made in stored(obj).made().items() if name != "design"}
        proxy.standing = Project(finished.design.name, parameters, {"design": given}, obj.Label, known)
    proxy.standing.parameters = parameters
    return proxy.standing


def settings_of(obj: Any) -> Any:
    """The native Parameters that the properties say. Raises CurveUpsError that names property, range
    and remedy."""
    return properties.read_parameters(obj, _base(stored(obj).latest("design")))


def _base(finished: Any) -> Any:
    """What is no property: as the design was made, but for stages, which commands choose."""
    if finished is None:
        return native.Parameters()
    found, defaults = native.Parameters(finished.design.parameters), native.Parameters()
    for row in table():
        if row.level == "switch":
            found.set(row.name, defaults.get(row.name))
    return found


def stored(obj: Any) -> Project:
    """What the document holds, under whatever parameters; see project_of and design_project_of."""
    if obj.Proxy.project is None:
        keep(obj, saved_results.from_text(obj.Results, obj.Label) if obj.Results else {})
    return cast(Project, obj.Proxy.project)


def warnings_of(obj: Any) -> list[Finding]:
    """What stored results of a layout that is current warn of, where they are current, too; the path from
    flat has a panel of its own. Raises CurveUpsError where they can't be read."""
    made, keys, values = stored(obj).made(), read_keys(obj), properties.values_of(obj)
    return [found for name in BY_NAME if name in made and name != RISEN
            for found in made[name].result.warnings()
            if changes(name, keys.records, values, (*GIVEN, "design")) == ()]


def keep(obj: Any, made: Mapping[str, Made]) -> None:
    """What the document holds from now on, as it is read from it."""
    given = {name: made[name].result for name in ("source", "cut request") if name in made}
    if "source" not in given and "design" in made:
        given = {"design": made["design"].result}
    others = {name: one for name, one in made.items() if name not in given}
    parameters = _base(made["design"].result if "design" in made else None)
    obj.Proxy.project = Project(obj.Label, parameters, given, obj.Label, others)
    obj.Proxy.standing = None
