# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids of a Design, and what holds of it, for geometry that changed since it was judged."""

from __future__ import annotations

from typing import Any

from ..base.errors import CurveUpsError
from ..base.findings import Finding, refused
from ..base.native import problem
from ..project.keys import Record, key_of
from ..project.project import Results
from ..stages import BY_NAME, asked_by
from ..stages.solids import BODIES
from . import live, properties, status
from .parts import KINDS, write_body, write_volumes
from .status import Keys, read_keys, write_keys

GOALS = asked_by("build")


def needed(obj: Any) -> bool:
    """Whether the solids are not those of the design and values as they are."""
    keys, values = read_keys(obj), properties.values_of(obj)
    bodies = [body for slot in KINDS if (body := getattr(obj, slot)) is not None]
    return "design" in keys.records and any(
        status.body_changes(read_keys(body), keys, values) != [] for body in bodies)


def failed(obj: Any) -> bool:
    """Whether it is known that no solids can be made of the design and values as they are."""
    return status.known_of_values(obj, read_keys(obj), properties.values_of(obj)).failed


def follow(obj: Any) -> None:
    """Builds what is needed; a failure is kept as the state of the design, not raised."""
    if problem() is not None or not needed(obj) or failed(obj):
        return
    try:
        take(obj, live.design_project_of(obj).run(GOALS, strict=True))
    except CurveUpsError as error:
        fail(obj, refused(error))


def take(obj: Any, results: Results) -> None:
    """The solids of a run's results become the document's, and the constraints' reasons the design's.
    Not to be called inside of a transaction: it would copy all solids."""
    import FreeCAD

    model = results["solids"].model
    if model is None:  # stopped, or known not to be possible
        for reason in (*results["bodies"].reasons(), *results["solids"].reasons()):
            fail(obj, reason)
        return
    keys = Keys({name: results.made[name].record for name in GOALS},
                reasons=tuple(results["figures"].reasons()))
    for slot, kind in KINDS.items():
        body = getattr(obj, slot)
        if body is not None:
            write_body(body, model.shape(kind), keys, obj.Placement)
    write_volumes(obj, model.volumes)
    write_keys(obj, keys, "RebuiltKeys")
    obj.Proxy.refresh(obj)
    for warning in results["bodies"].warnings():
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {warning}\n")


def fail(obj: Any, reason: Finding) -> None:
    """No solids can be made of the values as they are: the old ones stay, and the design says so."""
    records = expected(read_keys(obj), properties.values_of(obj), (BODIES.name,))
    write_keys(obj, Keys(records, failed=True, reasons=(reason,)), "RebuiltKeys")
    obj.Proxy.refresh(obj)


def expected(keys: Keys, values: Any, stages: tuple[str, ...]) -> dict[str, Record]:
    """Records of what stages that read the design would make of it and of these values."""
    return {name: Record(key_of(BY_NAME[name], keys.records, values)) for name in stages
            if "design" in keys.records}
