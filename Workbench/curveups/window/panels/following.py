# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of the panels that show an overlay and follow it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import FreeCADGui

from ..overlays import overlay_of
from ..qt import QtCore


class Following(ABC):
    """Base of a task panel with a `form`; `show` is called when the overlay has changed. The panel closes
    when the design goes."""

    form: Any

    def _follow(self, design: Any) -> None:
        self._overlay = overlay_of(design)
        # Once for many changes: a legend that is dragged changes with every move of the mouse.
        self._later = QtCore.QTimer(self.form)
        self._later.setSingleShot(True)
        self._later.timeout.connect(lambda: self._look())
        self._overlay.observers.append(self._changed)
        self.show()

    @abstractmethod
    def show(self) -> None:
        """Takes over what the overlay shows."""

    def _changed(self) -> None:
        try:
            self._later.start(0)
        except RuntimeError:  # the form went with its window
            self._let_go()

    def _look(self) -> None:
        if self._overlay.closed:
            self._let_go()
            FreeCADGui.Control.closeDialog()
        else:
            self.show()

    def _let_go(self) -> None:
        if self._changed in self._overlay.observers:
            self._overlay.observers.remove(self._changed)

    def reject(self) -> bool:
        """The close button, and FreeCAD's."""
        self._let_go()
        FreeCADGui.Control.closeDialog()
        return True

    def isAllowedAlterDocument(self) -> bool:
        """Nothing here holds the document."""
        return True

    def isAllowedAlterView(self) -> bool:
        return True

    def isAllowedAlterSelection(self) -> bool:
        return True
