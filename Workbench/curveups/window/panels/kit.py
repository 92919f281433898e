# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Fabrication Kit: the order, names of print files, the folder, and links to what is in it."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any

from ...base.errors import CurveUpsError
from ...features import actions
from ...features.document import settings_of
from ...features.status import OUT_OF_DATE
from ...kit.files import Order, last_order, print_names
from ...stages.solids import KINDS
from .. import runs
from ..notice import errors_shown, link, shown
from ..qt import translate
from ..run import LIVE, Task
from .export import FolderRow
from .panel import Panel, enable


class KitPanel(Panel):
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
            self._names(order)

            def written(design: Any, made: actions.WrittenKit) -> None:
                runs.finish("kit", design, made, repr(folder), f"quantity={order.quantity}",
                            f"mask={order.mask!r}", f"language={order.language!r}")
                self._show_links()

            work = actions.kit_work(self.design, folder, order)
            LIVE.start(self.design, Task(translate("CurveUps_Kit", "Fabrication Kit"), work, written))
            self._folder.keep()

    def show(self) -> None:
        """What the sheets will say of the design, and whether the kit is of the design as it is."""
        found = actions.doubts(self.design)
        self.form.doubts.setText("<br>".join(f"<b>{shown(one)}</b>" for one in found))
        self.form.doubts.setVisible(bool(found))
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

    def _names(self, order: Order) -> list[str]:
        return list(print_names(self.design.Label, self._parameters, KINDS, order).values())

    def _show_names(self) -> None:
        try:
            names = self._names(self.order())
        except CurveUpsError as error:
            names = [str(error)]
        self.form.chosen.setText(", ".join(names))

    def _show_running(self, running: bool) -> None:
        enable(self.form.write, runs.reason("kit", self.design))
