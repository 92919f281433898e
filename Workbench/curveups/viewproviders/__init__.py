# SPDX-License-Identifier: LGPL-2.1-or-later
"""How document objects look in the tree. Only loaded with a window."""

from __future__ import annotations

from typing import Any

from ..features.proxy import type_of


# What FreeCAD gives a view that lost its Python, after it has shown it: some FreeCADs without this
# workbench store no view of ours.
_SHOWN_BY_FREECAD = 1


def attach(obj: Any) -> None:
    """Gives an object of ours its view, where it has a Python one and lacks it."""
    from . import following
    from .design import DesignView
    from .part import CutsView, LayoutView, ShapeView, VerificationView

    following.install()
    kinds = {"CurveUps::Design": DesignView, "CurveUps::Cuts": CutsView,
             "CurveUps::Layout": LayoutView, "CurveUps::Verification": VerificationView,
             "CurveUps::Target": ShapeView, "CurveUps::Bodies": ShapeView}
    view, kind = getattr(obj, "ViewObject", None), kinds.get(type_of(obj))
    if view is None or kind is None or "Proxy" not in view.PropertiesList:
        return
    if kind is ShapeView and view.Proxy == _SHOWN_BY_FREECAD:
        view.Visibility = False
    if not isinstance(view.Proxy, kind):
        kind(view)
