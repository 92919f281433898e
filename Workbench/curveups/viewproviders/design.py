# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object in the tree."""

from __future__ import annotations

from pathlib import Path
from typing import Any

ICON = Path(__file__).parents[3] / "resources" / "icons" / "CurveUpsWorkbench.svg"


class DesignView:
    """Icon of a Design, and its bodies below it."""

    def __init__(self, view: Any):
        self.object = view.Object
        view.Proxy = self

    def attach(self, view: Any) -> None:
        self.object = view.Object

    def getIcon(self) -> str:
        return str(ICON)

    def claimChildren(self) -> list:
        return [other for other in self.object.InList if getattr(other, "Design", None) == self.object]

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        self.object = None

    __getstate__ = dumps
    __setstate__ = loads
