# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of Export and of Fabrication Kit: which files, under which names, and where."""

from __future__ import annotations

from abc import abstractmethod
from functools import partial
from html import escape
from pathlib import Path
from typing import Any

import FreeCAD

from ...base.errors import CurveUpsError
from ...base.native import native
from ...features import actions
from ...features.document import settings_of
from ...features.proxy import HIDDEN
from ...features.status import OUT_OF_DATE
from ...kit.files import Order, last_order, print_names
from ...report.exports import Choice, choices, file_names
from ...stages.solids import KINDS
from .. import runs
from ..notice import errors_shown, link, shown
from ..qt import QtCore, QtWidgets, translate
from ..run import LIVE, Task
from ..units import show_number
from . import preferences
from .panel import Panel, enable, fit_columns


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


class _FilesPanel(Panel):
    """Names the files before they are written, and says what speaks against printing the design as it is."""

    @abstractmethod
    def _names(self) -> list[str]:
        """Raises CurveUpsError where the mask does not do."""

    def show(self) -> None:
        """What speaks against it."""
        found = actions.doubts(self.design)
        self.form.doubts.setText("<br>".join(f"<b>{shown(one)}</b>" for one in found))
        self.form.doubts.setVisible(bool(found))

    def _show_names(self) -> None:
        try:
            names = self._names()
        except CurveUpsError as error:
            names = [str(error)]
        self.form.chosen.setText(", ".join(names))


class ExportPanel(_FilesPanel):
    """It changes nothing of the design. What is being written is written to its end."""

    def __init__(self, design: Any):
        super().__init__(design, "export", translate("CurveUpsExport", "Export {name}", name=design.Label))
        self._parameters = settings_of(design)
        form = self.form
        fit_columns(form.files)
        self._tick_files()
        form.deviation.setProperty("unit", "mm")
        form.deviation.setProperty("minimum", 0.0001)
        show_number(form.deviation, FreeCAD.Units.Quantity(f"{self._parameters.get('mesh_deviation')} mm"))
        form.names.setText(preferences.group().GetString("ExportMask", Choice.mask))
        self._folder = FolderRow(form, design, "ExportFolder", "print")
        form.write.clicked.connect(lambda *_: self.write())
        form.files.itemChanged.connect(lambda *_: self._show_names())
        form.names.textChanged.connect(lambda *_: self._show_names())
        form.insist.toggled.connect(lambda *_: self._show_running(LIVE.runs_on(design)))
        self._show_names()
        self._follow()

    def choice(self) -> Choice:
        """What is ticked and typed."""
        form = self.form
        files = tuple(item.data(0, QtCore.Qt.UserRole).split(".") for item in self._items()
                      if item.checkState(0) == QtCore.Qt.Checked)
        return Choice(tuple((kind, ending) for kind, ending in files), form.names.text(),
                      float(form.deviation.property("rawValue")), form.reports.isChecked(),
                      actions.doubts(self.design), form.insist.isChecked())

    def write(self) -> None:
        """Writes the files on the worker; the line on top says how that went."""
        self._say("")
        with errors_shown(translate("CurveUpsExport", "Export")):
            choice, folder = self.choice(), self._folder.path
            file_names(self.design.Label, choice)  # says what is wrong with them before anything starts
            work = actions.export_work(self.design, folder, choice)
            LIVE.start(self.design, Task(translate("CurveUpsExport", "Export"), work,
                                         partial(self._written, folder, choice)))
            self._folder.keep()
            preferences.group().SetString("ExportMask", choice.mask)

    def _written(self, folder: str, choice: Choice, design: Any, names: list[str]) -> None:
        arguments = folder, choice.files, choice.mask, choice.deviation, choice.reports, choice.insist
        runs.finish("export", design, names, *map(repr, arguments))
        said = escape(translate("CurveUpsExport", "files in {folder}: {count}", count=len(names),
                                folder=folder))
        self._say(f"{said}<br>{' · '.join(_links(Path(folder), names))}")
        FreeCAD.Console.PrintMessage(f"CurveUps: {', '.join(names)} -> {folder}\n")

    def _items(self) -> list[Any]:
        files = self.form.files
        return [files.topLevelItem(row) for row in range(files.topLevelItemCount())]

    def _tick_files(self) -> None:
        wanted = {(kind, one.ending) for one in native.print_formats() for kind in one.wanted}
        for kind, ending in choices():
            item = QtWidgets.QTreeWidgetItem([_bodies(kind), ending.upper()])
            item.setData(0, QtCore.Qt.UserRole, f"{kind}.{ending}")
            item.setCheckState(0, QtCore.Qt.Checked if (kind, ending) in wanted else QtCore.Qt.Unchecked)
            self.form.files.addTopLevelItem(item)

    def show(self) -> None:
        """What speaks against it, and whether one may insist."""
        super().show()
        self.form.insist.setVisible(bool(self.form.doubts.text()))

    def _names(self) -> list[str]:
        return list(file_names(self.design.Label, self.choice()).values())

    def _show_running(self, running: bool) -> None:
        form = self.form
        refused = bool(actions.doubts(self.design)) and not form.insist.isChecked()
        enable(form.write, LIVE.obstacle() or (
            translate("CurveUpsExport", "The design is doubtful: insist on its files") if refused else ""))
        enable(form.files, LIVE.obstacle() if running else "")


def _links(folder: Path, names: list[str]) -> list[str]:
    """What one may want to open after an export, as links."""
    found = [(folder, translate("CurveUpsExport", "open the folder"))]
    found += [(folder / name, translate("CurveUpsExport", "open the report"))
              for name in names if name == "report.html"]
    found += [(folder / name, translate("CurveUpsExport", "open {name} in the slicer", name=name))
              for name in names if name.endswith(".3mf")]
    return [link(escape(path.absolute().as_uri()), escape(text)) for path, text in found]


def _bodies(kind: str) -> str:
    return {"tiles": translate("CurveUpsExport", "Tiles"),
            "support": translate("CurveUpsExport", "Support"),
            "anchors": translate("CurveUpsExport", "Anchors"),
            "print": translate("CurveUpsExport", "Whole print"),
            "actuated": translate("CurveUpsExport", "Tiles in shape")}.get(kind, kind)


class KitPanel(_FilesPanel):
    """It changes nothing of the design but that it has a kit."""

    def __init__(self, design: Any):
        super().__init__(design, "kit", translate("CurveUps_Kit", "Kit of {name}", name=design.Label))
        form = self.form
        self._parameters = settings_of(design)
        self._folder = FolderRow(form, design, "KitFolder", "kit")
        order = last_order(Path(form.folder.text()))
        form.quantity.setValue(order.quantity)
        form.names.setText(order.mask)
        form.names.textChanged.connect(lambda *_: self._show_names())
        form.quantity.valueChanged.connect(lambda *_: self._show_names())
        form.write.clicked.connect(lambda *_: self.write())
        self._show_names()
        self._follow()
        if not design.Kit.startswith(OUT_OF_DATE):
            self._show_links()

    def order(self) -> Order:
        """What is chosen; sheets are in the window's language."""
        return Order(self.form.quantity.value(), self.form.names.text(), translate("CurveUps_Sheets", "en"))

    def write(self) -> None:
        """Writes the kit on the worker; the line on top then leads to its files."""
        self._say("")
        with errors_shown(translate("CurveUps_Kit", "Fabrication Kit")):
            folder, order = self._folder.path, self.order()
            self._names()  # says what is wrong with them before anything starts

            def written(design: Any, made: actions.WrittenKit) -> None:
                runs.finish("kit", design, made, repr(folder), f"quantity={order.quantity}",
                            f"mask={order.mask!r}", f"language={order.language!r}")
                self._show_links()

            work = actions.kit_work(self.design, folder, order)
            LIVE.start(self.design, Task(translate("CurveUps_Kit", "Fabrication Kit"), work, written))
            self._folder.keep()

    def show(self) -> None:
        """What the sheets will say of the design, and whether the kit is of the design as it is."""
        super().show()
        self.form.note.setVisible(self.design.Kit.startswith(OUT_OF_DATE))

    def _show_links(self) -> None:
        """What is opened first of a kit, where there is one."""
        if self.form is None:
            return
        folder, name = Path(self.form.folder.text()), actions.file_name(self.design)
        files = (("", translate("CurveUps_Kit", "open the folder")),
                 (f"{name}-shop.pdf", translate("CurveUps_Kit", "the order for the print shop")),
                 (f"{name}-assembly.html", translate("CurveUps_Kit", "the steps of assembly")),
                 (f"{name}-latex-front.pdf", translate("CurveUps_Kit", "the front template")),
                 (f"{name}-latex-back.pdf", translate("CurveUps_Kit", "the back template")))
        if all((folder / file).exists() for file, _ in files):
            self._say(" · ".join(link(escape((folder / file).absolute().as_uri()), escape(text))
                                 for file, text in files))

    def _names(self) -> list[str]:
        return list(print_names(self.design.Label, self._parameters, KINDS, self.order()).values())

    def _show_running(self, running: bool) -> None:
        enable(self.form.write, runs.reason("kit", self.design))
