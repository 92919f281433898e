# SPDX-License-Identifier: LGPL-2.1-or-later
"""The row of a panel that says where files of a design go: its widgets `folder` and `browse`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ...base.errors import CurveUpsError
from ...features import actions
from ...features.proxy import HIDDEN
from ..qt import QtWidgets, translate


class FolderRow:
    """The view of the design keeps the folder, as it keeps what the overlay shows: no step of undo."""

    def __init__(self, form: Any, design: Any, kept: str, what: str):
        """kept: the property of the view. what: follows the design's name in that of the folder."""
        self._form, self._design, self._kept = form, design, kept
        form.folder.textChanged.connect(lambda text: form.folder.setToolTip(text))  # it may be long
        form.folder.setText(self._first(what))
        form.browse.clicked.connect(lambda *_: self._browse())

    @property
    def path(self) -> str:
        """Raises CurveUpsError where there is none."""
        folder = str(self._form.folder.text())
        if not folder:
            raise CurveUpsError(translate("CurveUpsExport", "there is no folder"), "",
                                translate("CurveUpsExport", "choose one"))
        return folder

    def keep(self) -> None:
        """For the next time."""
        view = self._design.ViewObject
        if self._kept not in view.PropertiesList:
            view.addProperty("App::PropertyString", self._kept, "Overlay", "Where files went last.", HIDDEN)
        setattr(view, self._kept, self._form.folder.text())

    def _first(self, what: str) -> str:
        """Where the design's files went last; beside its document at first, or where that folder is of
        another machine."""
        kept = Path(getattr(self._design.ViewObject, self._kept, ""))
        if kept.name and kept.parent.is_dir():
            return str(kept)
        saved = self._design.Document.FileName
        place = Path(saved).parent if saved else Path.home()
        return str(place / f"{actions.file_name(self._design)}-{what}")

    def _browse(self) -> None:
        folder = QtWidgets.QFileDialog.getExistingDirectory(
            self._form, translate("CurveUpsExport", "Folder for the files"), self._form.folder.text())
        if folder:
            self._form.folder.setText(str(folder))
