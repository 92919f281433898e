# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a picture was made from, and whether that is still so."""

from __future__ import annotations

from typing import Any, Optional

from ...features.status import OUT_OF_DATE
from ...stages import BY_NAME
from ..qt import translate
from ..units import text_of
from .fields import Field
from .scene import Scene


class State:
    """What a scene is made from: equal for projects that are drawn alike."""

    def __init__(self, project: Any, of_target: bool):
        self._made = [project.latest(name) for name, stage in BY_NAME.items() if stage.shown]
        self._values = project.parameters.to_dict(), project.out_of_date("feasibility"), of_target

    def same(self, other: Optional["State"]) -> bool:
        return other is not None and self._values == other._values and all(
            mine is theirs for mine, theirs in zip(self._made, other._made))


def age(design: Any, one: Optional[Field], scene: Optional[Scene]) -> str:
    """Why what a field shows, or without one the tiles, is out of date; empty where it is not."""
    part = getattr(design, _slot(one, scene), None)
    if part is None or part.Status != OUT_OF_DATE:
        return ""
    return translate("CurveUps_Overlay", "out of date: {why}", why=part.Reason)


def text(one: Optional[Field], scene: Scene) -> str:
    """What the values of a field, or without one the tiles, are of."""
    get = scene.parameters.get
    length, tau = text_of(get("L"), "mm", get("L")), f"{get('tau'):g}"
    return {
        "Target": translate("CurveUps_Overlay", "of the target, L = {length}", length=length),
        "Layout": translate("CurveUps_Overlay", "of the layout, L = {length}, Tau = {tau}", length=length,
                            tau=tau),
        "Verification": translate("CurveUps_Overlay", "of the verified layout, L = {length}, Tau = {tau}",
                                  length=length, tau=tau)}[_slot(one, scene)]


def _slot(one: Optional[Field], scene: Optional[Scene]) -> str:
    if one is not None:
        return one.part
    return "Target" if scene is None or scene.flat is None else "Layout"
