# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives each document object its view provider."""

from __future__ import annotations

import codecs
from typing import Any

import FreeCAD

from ...features.proxy import type_of
from ..qt import QtCore
from . import following
from .design import DesignView
from .part import CutsView, LayoutView, ShapeView, VerificationView

# A view measures all of its shape when it gets a class, 0.3 s for thousands of solids, and FreeCAD has just
# given the stored one (part.py) to those of a document that is opened: ours follow, one after another.
PEACE = 300  # ms before each
_waiting: list[tuple[str, str, type]] = []  # document, object, the class of its view

# What FreeCAD gives a view that lost its Python, after it has shown it: some FreeCADs without this
# workbench store no view of ours.
_SHOWN_BY_FREECAD = 1
_KINDS = {"CurveUps::Design": DesignView, "CurveUps::Cuts": CutsView, "CurveUps::Layout": LayoutView,
          "CurveUps::Verification": VerificationView, "CurveUps::Target": ShapeView,
          "CurveUps::Bodies": ShapeView}


def lacks_view(obj: Any) -> bool:
    """Whether an object of ours has lost its view."""
    return type_of(obj) in _KINDS and obj.ViewObject.Proxy in (None, _SHOWN_BY_FREECAD)


def attach(obj: Any) -> None:
    """Gives an object of ours its view, where it has a Python one and lacks it."""
    following.install()
    view, kind = getattr(obj, "ViewObject", None), _KINDS.get(type_of(obj))
    if view is None or kind is None or "Proxy" not in view.PropertiesList:
        return
    if kind is ShapeView and view.Proxy == _SHOWN_BY_FREECAD:
        view.Visibility = False
    if isinstance(view.Proxy, codecs.Codec):
        _waiting.append((obj.Document.Name, obj.Name, kind))
        QtCore.QTimer.singleShot(PEACE * len(_waiting), _replace_next)
    elif not isinstance(view.Proxy, kind):
        attached = view.Proxy == _SHOWN_BY_FREECAD  # to nothing; and no view is attached twice
        kind(view)
        if attached and kind is not ShapeView:
            view.Proxy.attach(view)
            view.DisplayMode = view.Proxy.getDisplayModes(view)
            view.Visibility = False
            view.Visibility = True


def _replace_next() -> None:
    """Gives the view that has waited longest ours, where it still has its stored class: no edit of the
    document."""
    document_name, name, kind = _waiting.pop(0)
    document = FreeCAD.listDocuments().get(document_name)
    obj = document.getObject(name) if document else None
    if obj is not None and isinstance(obj.ViewObject.Proxy, codecs.Codec):
        obj.ViewObject.setPropertyStatus("Proxy", "NoModify")
        kind(obj.ViewObject)
        obj.ViewObject.setPropertyStatus("Proxy", "-NoModify")
