# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives each document object its view provider."""

from __future__ import annotations

from typing import Any

from ...features.proxy import type_of
from . import following
from .design import DesignView
from .part import CutsView, LayoutView, ShapeView, VerificationView

_KINDS = {"CurveUps::Design": DesignView, "CurveUps::Cuts": CutsView, "CurveUps::Layout": LayoutView,
          "CurveUps::Verification": VerificationView, "CurveUps::Target": ShapeView,
          "CurveUps::Bodies": ShapeView}


def attach(obj: Any) -> None:
    """Gives an object of ours its view, where it has a Python one and lacks it."""
    following.install()
    view, kind = getattr(obj, "ViewObject", None), _KINDS.get(type_of(obj))
    if view is None or kind is None or "Proxy" not in view.PropertiesList:
        return
    if isinstance(view.Proxy, kind):
        return
    attached = view.Proxy is not None  # in a FreeCAD without this workbench; FreeCAD attaches a view once
    kind(view)
    if attached:
        view.Proxy.attach(view)
    if attached and kind is not ShapeView:
        view.DisplayMode = view.Proxy.getDisplayModes(view)
        view.Visibility = False
        view.Visibility = True
