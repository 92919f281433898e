# SPDX-License-Identifier: LGPL-2.1-or-later
"""How document objects look in the tree. Only loaded with a window."""

from __future__ import annotations

import codecs
from functools import partial
from typing import Any

import FreeCAD

from ..features.proxy import type_of
from ..qt import QtCore

# A view measures all of its shape when it gets a class, 0.3 s for thousands of solids, and FreeCAD has just
# given the stored one (part.py) to those of a document that is opened: ours follow when there is peace.
PEACE = 300  # ms

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
    if isinstance(view.Proxy, codecs.Codec):
        QtCore.QTimer.singleShot(PEACE, partial(_replace, obj.Document.Name, obj.Name, kind))
    elif not isinstance(view.Proxy, kind):
        kind(view)


def _replace(document_name: str, name: str, kind: type) -> None:
    """Gives a view that still has its stored class ours, which is no edit of the document."""
    document = FreeCAD.listDocuments().get(document_name)
    obj = document.getObject(name) if document else None
    if obj is not None and isinstance(obj.ViewObject.Proxy, codecs.Codec):
        obj.ViewObject.setPropertyStatus("Proxy", "NoModify")
        kind(obj.ViewObject)
        obj.ViewObject.setPropertyStatus("Proxy", "-NoModify")
