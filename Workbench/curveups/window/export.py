# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export Print Files and Fabrication Kit: which files, under which names, and where."""

from __future__ import annotations

from abc import abstractmethod
from functools import partial
from html import escape
from pathlib import Path
from typing import Any, Iterable

import FreeCAD

from ..base.errors import CurveUpsError
from ..base.native import native
from ..base.parameters import parameter
from ..features import actions
from ..features.document import settings_of
from ..features.properties import quantity
from ..features.proxy import HIDDEN
from ..features.status import OUT_OF_DATE, Keys
from ..kit.files import Order, last_order, print_names
from ..report.exports import Choice, all_names, choices
from ..stages.solids import KINDS
from . import preferences, run
from .binding import limit
from .notice import errors_shown, link, shown
from .panel import Panel, fit_columns, put
from .qt import QtCore, QtWidgets, translate
from .run import LIVE, Task
from .units import show_number


class _FilesPanel(Panel):
    """A panel that writes files of a design into a folder, names them before, and says why the design should
    not be printed as it is.

    The view of the design keeps the folder in a property: no step of undo."""

    _kept = ""  # property of the view
    _what = ""  # follows the design's name in that of the folder

    def prepare(self) -> None:
        """Show the folder, and the names of files as they are chosen."""
        form = self.form
        form.folder.textChanged.connect(lambda text: form.folder.setToolTip(text))  # it may be long
        form.folder.setText(self._first_folder())
        form.names.textChanged.connect(lambda *_: self._show_names())
        self.on_clicks(browse=self._browse, write=self.write)
        self._show_names()
        self.follow()

    @abstractmethod
    def write(self) -> None:
        """Write the files on the worker."""

    @abstractmethod
    def _names(self) -> Iterable[str]:
        """Names of the files. Raises CurveUpsError if the mask gives none."""

    def show(self) -> None:
        put(self.form.doubts, "<br>".join(f"<b>{shown(doubt)}</b>" for doubt in actions.doubts(self.design)))

    def _show_names(self) -> None:
        try:
            text = ", ".join(self._names())
        except CurveUpsError as error:
            text = str(error)
        self.form.chosen.setText(text)

    def _folder(self) -> str:
        """The chosen folder. Raises CurveUpsError if there is none."""
        folder = str(self.form.folder.text())
        if not folder:
            raise CurveUpsError(translate("CurveUpsExport", "there is no folder"), "",
                                translate("CurveUpsExport", "choose one"))
        return folder

    def _start(self, title: str, work: Any, finish: Any) -> None:
        """Start writing, and keep the folder for the next time."""
        LIVE.start(self.design, Task(title, work, finish))
        view = self.design.ViewObject
        if self._kept not in view.PropertiesList:
            view.addProperty("App::PropertyString", self._kept, "Overlay", "Where files went last.", HIDDEN)
        setattr(view, self._kept, self.form.folder.text())

    def _first_folder(self) -> str:
        """The folder of the last files; a new one beside the document, or if that was on another machine."""
        kept = Path(getattr(self.design.ViewObject, self._kept, ""))
        if kept.name and kept.parent.is_dir():
            return str(kept)
        saved = self.design.Document.FileName
        folder = Path(saved).parent if saved else Path.home()
        return str(folder / f"{actions.file_name(self.design)}-{self._what}")

    def _browse(self) -> None:
        folder = QtWidgets.QFileDialog.getExistingDirectory(
            self.form, translate("CurveUpsExport", "Folder for the files"), self.form.folder.text())
        if folder:
            self.form.folder.setText(str(folder))


class ExportPanel(_FilesPanel):
    """Print files and the report. The design stays as it is."""

    _kept, _what = "ExportFolder", "print"

    def __init__(self, design: Any):
        super().__init__(design, "export")
        form = self.form
        fit_columns(form.files, 0)
        self._list_files()
        form.deviation.setProperty("unit", "mm")
        row = parameter("mesh_deviation")
        limit(form.deviation, row)
        show_number(form.deviation, quantity(row, settings_of(design).get(row.name)))
        form.names.setText(preferences.group().GetString("ExportMask", Choice.mask))
        form.files.itemChanged.connect(lambda *_: self._show_names())
        form.reports.toggled.connect(lambda *_: self._show_names())
        form.insist.toggled.connect(lambda *_: self.show_reasons())
        self.reasons.update(write=lambda: LIVE.obstacle() or self._refusal(),
                            files=lambda: LIVE.obstacle() if LIVE.runs_on(design) else "")
        self.prepare()

    def choice(self) -> Choice:
        """Files that are ticked, and how they are written."""
        form = self.form
        items = map(form.files.topLevelItem, range(form.files.topLevelItemCount()))
        files = [item.data(0, QtCore.Qt.UserRole).split(".") for item in items
                 if item.checkState(0) == QtCore.Qt.Checked]
        return Choice(tuple((kind, ending) for kind, ending in files), form.names.text(),
                      float(form.deviation.property("rawValue")), form.reports.isChecked(),
                      actions.doubts(self.design), form.insist.isChecked())

    def write(self) -> None:
        self.say("")
        title = translate("CurveUpsExport", "Export")
        with errors_shown(title):
            choice, folder = self.choice(), self._folder()
            self._names()  # refuses wrong ones before anything starts
            self._start(title, actions.export_work(self.design, folder, choice),
                        partial(self._written, folder, choice))
            preferences.group().SetString("ExportMask", choice.mask)

    def _written(self, folder: str, choice: Choice, design: Any, names: list[str]) -> None:
        arguments = folder, choice.files, choice.mask, choice.deviation, choice.reports, choice.insist
        run.finish("export", design, names, *map(repr, arguments))
        files = [("", translate("CurveUpsExport", "open the folder"))]
        files += [(name, translate("CurveUpsExport", "open the report"))
                  for name in names if name == "report.html"]
        files += [(name, translate("CurveUpsExport", "open {name} in the slicer", name=name))
                  for name in names if name.endswith(".3mf")]
        count = escape(translate("CurveUpsExport", "files in {folder}: {count}", count=len(names),
                                 folder=folder))
        self.say(f"{count}<br>{_links(folder, files)}")
        FreeCAD.Console.PrintMessage(f"CurveUps: {', '.join(names)} -> {folder}\n")

    def _list_files(self) -> None:
        titles = {"tiles": translate("CurveUpsExport", "Tiles"),
                  "support": translate("CurveUpsExport", "Support"),
                  "anchors": translate("CurveUpsExport", "Anchors"),
                  "print": translate("CurveUpsExport", "Whole print"),
                  "actuated": translate("CurveUpsExport", "Tiles in shape")}
        wanted = {(kind, format.ending) for format in native.print_formats() for kind in format.wanted}
        for kind, ending in choices():
            item = QtWidgets.QTreeWidgetItem(self.form.files, [titles.get(kind, kind), ending.upper()])
            item.setData(0, QtCore.Qt.UserRole, f"{kind}.{ending}")
            item.setCheckState(0, QtCore.Qt.Checked if (kind, ending) in wanted else QtCore.Qt.Unchecked)

    def show(self) -> None:
        super().show()
        self.form.insist.setVisible(bool(self.form.doubts.text()))

    def _names(self) -> Iterable[str]:
        return all_names(self.design.Label, self.choice())

    def _refusal(self) -> str:
        if self.form.insist.isChecked() or not actions.doubts(self.design):
            return ""
        return translate("CurveUpsExport",
                         "This design has problems. Tick 'Write them anyway' to export its files")


class KitPanel(_FilesPanel):
    """The fabrication kit. The design stays as it is, but for the record that it has a kit."""

    _kept, _what = "KitFolder", "kit"

    def __init__(self, design: Any):
        super().__init__(design, "kit")
        form = self.form
        self._parameters = settings_of(design)
        order = last_order(Path(self._first_folder()))
        form.quantity.setValue(order.quantity)
        form.names.setText(order.mask)
        form.quantity.valueChanged.connect(lambda *_: self._show_names())
        self.reasons["write"] = lambda: run.reason("kit", design)
        self.prepare()
        if not design.Kit.startswith(OUT_OF_DATE):
            self._show_links()

    def order(self) -> Order:
        """The order as it is chosen; sheets are in the window's language."""
        return Order(self.form.quantity.value(), self.form.names.text(), translate("CurveUps_Sheets", "en"))

    def write(self) -> None:
        self.say("")
        title = translate("CurveUps_Kit", "Fabrication Kit")
        with errors_shown(title):
            folder, order = self._folder(), self.order()
            self._names()  # refuses wrong ones before anything starts

            def written(design: Any, kit: tuple[str, Keys]) -> None:
                run.finish("kit", design, kit, repr(folder), f"quantity={order.quantity}",
                           f"mask={order.mask!r}", f"language={order.language!r}")
                self._show_links()

            self._start(title, actions.kit_work(self.design, folder, order), written)

    def show(self) -> None:
        super().show()
        self.form.note.setVisible(self.design.Kit.startswith(OUT_OF_DATE))

    def _show_links(self) -> None:
        """Show the files that are opened first, if there is a kit."""
        if self.form is None:
            return
        folder, name = self.form.folder.text(), actions.file_name(self.design)
        files = [("", translate("CurveUps_Kit", "open the folder")),
                 (f"{name}-shop.pdf", translate("CurveUps_Kit", "the order for the print shop")),
                 (f"{name}-assembly.html", translate("CurveUps_Kit", "the steps of assembly")),
                 (f"{name}-latex-front.pdf", translate("CurveUps_Kit", "the front template")),
                 (f"{name}-latex-back.pdf", translate("CurveUps_Kit", "the back template"))]
        if all((Path(folder) / file).exists() for file, _ in files):
            self.say(_links(folder, files))

    def _names(self) -> Iterable[str]:
        return print_names(self.design.Label, self._parameters, KINDS, self.order()).values()


def _links(folder: str, files: list[tuple[str, str]]) -> str:
    """Links to files in a folder, by their names and texts; the folder itself has none."""
    return " · ".join(link(escape((Path(folder) / file).absolute().as_uri()), escape(text))
                      for file, text in files)
