# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids of a Design, and what holds of it, for geometry that changed since it was judged."""

from __future__ import annotations

import json
from typing import Any, Optional

from ..base.errors import CurveUpsError
from ..base.native import problem
from ..project.project import Results
from ..stages.stage import Job
from . import live, properties, status
from .bodies import KINDS, write_body
from .figures import write_volumes
from .proxy import write

GOALS = ("figures", "bodies", "solids")


def needed(obj: Any) -> bool:
    """Whether the solids are not those of the design and values as they are."""
    solved = status.record(obj, "Solved")
    if not solved:
        return False
    now = properties.parameters_of(obj)
    for slot in KINDS:
        body = getattr(obj, slot)
        if body is not None:
            built = status.record(body, "BuiltFrom")
            if built.get("design") != solved.get("design") or status.changed_names(
                    now, built.get("parameters", {})):
                return True
    return False


def failed(obj: Any) -> bool:
    """Whether it is known that no solids can be made of the design and values as they are."""
    return bool(status.known_of_values(obj).get("failure"))


def follow(obj: Any, job: Optional[Job] = None) -> None:
    """Builds what is needed; a failure is kept as the state of the design, not raised."""
    if problem() is not None or not needed(obj) or failed(obj):
        return
    try:
        take(obj, live.design_project_of(obj).run(GOALS, job, strict=True))
    except CurveUpsError as error:
        fail(obj, error)


def take(obj: Any, results: Results) -> None:
    """The solids of a run's results become the document's, and the constraints' reasons the design's.
    Not to be called inside of a transaction: it would copy all solids."""
    import FreeCAD

    model = results["solids"].model
    if model is None:  # stopped, or known not to be possible
        for reason in (*results["bodies"].reasons(), *results["solids"].reasons()):
            fail(obj, CurveUpsError(reason))
        return
    values = properties.named(results.parameters)
    read = {properties.property_name(name) for stage in ("bodies", "solids")
            for name in results.made[stage].key}
    origin = {"design": status.record(obj, "Solved").get("design", ""), "parameters": {
        name: value for name, value in values.items()
        if name in read and properties.tier_of(obj, name) == "rebuild"}}
    for slot, kind in KINDS.items():
        body = getattr(obj, slot)
        if body is not None:
            write_body(body, model.shape(kind), origin, obj.Placement)
    write_volumes(obj, model.volumes, KINDS)
    _record(obj, values, reasons=list(results["figures"].reasons()))
    obj.Proxy.refresh(obj)
    for warning in results["bodies"].warnings():
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {warning['what']}\n")


def fail(obj: Any, error: CurveUpsError) -> None:
    """No solids can be made of the values as they are: the old ones stay, and the design says so."""
    _record(obj, properties.parameters_of(obj), failure=str(error))
    obj.Proxy.refresh(obj)


def _record(obj: Any, values: dict[str, Any], reasons: Any = (), failure: str = "") -> None:
    kept = {name: value for name, value in values.items()
            if properties.tier_of(obj, name) == "rebuild"}
    write(obj, "Rebuilt", json.dumps({"design": status.record(obj, "Solved").get("design", ""),
                                      "parameters": kept, "reasons": list(reasons), "failure": failure}))
