# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design's first layout is brought into view, once: the surface that it is of would cover it, and it may
lie elsewhere. Undo of the run takes both back. Panels that show the target before hide the surface, too."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, Optional

from ..features.document import designs, has_layout
from .overlay.cameras import active_view, aim

_cameras: dict[tuple[str, str], str] = {}  # before the first layout, by names of document and design


class Reveal:
    """Of one run on a design, or one panel; without a layout before, it does something."""

    def __init__(self, design: Any):
        self._first = not has_layout(design)
        self._hidden: Optional[Any] = None    # the surface, hidden only while the run goes on
        self._fitted: Optional[tuple] = None  # the camera as this left it

    def begin(self, design: Any) -> None:
        """There is a picture to show."""
        self.uncover(design)
        self.fit(design)

    def uncover(self, design: Any) -> None:
        """Hides the surface until the end."""
        source = getattr(design.Target, "Source", None)
        if self._first and self._hidden is None and source is not None and source.Visibility:
            self._hidden, source.Visibility = source, False

    def end(self) -> None:
        """What was hidden is shown again: a run that ends well hides it in its own transaction."""
        if self._hidden is not None:
            with suppress(ReferenceError):  # it was deleted meanwhile
                self._hidden.Visibility = True
            self._hidden = None

    def fit(self, design: Any) -> None:
        """Brings the whole picture into view, unless the user has looked elsewhere since. To be called last:
        FreeCAD 1 moves the camera there in an event loop, in which the run may end and another begin."""
        view = active_view(design.Document.Name)
        if not self._first or view is None or self._fitted not in (None, aim(view)):
            return
        if self._fitted is None:
            _cameras[design.Document.Name, design.Name] = view.getCamera()
        view.fitAll()
        self._fitted = aim(view)


def forget_cameras(document: str) -> None:
    """A document is closed: another may come to have its name."""
    for key in [key for key in _cameras if key[0] == document]:
        del _cameras[key]


def follow_undo(document: Any) -> None:
    """After an undo or a cancel: the camera goes back where there is no layout any more."""
    for design in designs(document):
        view, camera = active_view(document.Name), _cameras.get((document.Name, design.Name))
        if view is not None and camera and not has_layout(design):
            del _cameras[document.Name, design.Name]
            view.setCamera(camera)
