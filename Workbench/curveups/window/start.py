# SPDX-License-Identifier: LGPL-2.1-or-later
"""Code for FreeCAD's start: everything else of the window is imported when it is used first."""

from __future__ import annotations

from typing import Any

from ..features import proxy


def install() -> None:
    """Gives document objects their views, from the first one on."""
    proxy.attach_view = _attach


def _attach(obj: Any) -> None:
    from .viewproviders.design import attach

    attach(obj)
