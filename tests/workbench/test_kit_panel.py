# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Fabrication Kit, by the mouse and keys: what is chosen is in the files, links open them."""

import json

import FreeCAD
import pytest
from curveups.project.worker import WORKER
from curveups.window import qt
from robot import at_rest, click, close_panel, cut_off, fill, keys, picture, press, settle, until
from steps import LIVE, opened, panel

pytestmark = pytest.mark.freecad(window=True)


def test_a_kit_is_ordered_written_and_opened(dome_document, tmp_path, pictures, monkeypatch):
    document, design = opened(dome_document)
    steps = list(document.UndoNames)
    press("CurveUps_Kit")
    form = panel().form
    assert form.line.text() == "" and not form.note.isVisible() and not form.doubts.isVisible()
    assert form.folder.text().endswith("-kit") and form.quantity.value() == 1
    folder = tmp_path / "for the shop"
    fill(form.folder, str(folder))

    # A mask that does not do is refused before anything is written.
    fill(form.names, "{name}")
    assert "two files would be called" in form.chosen.text()
    click(form.write)
    assert not LIVE.busy and "two files would be called" in form.line.text() and not folder.exists()

    fill(form.names, "{quantity}-{name}-{body}")
    fill(form.quantity, "3")
    assert "3x-Design-print.3mf" in form.chosen.text() and cut_off(form) == []
    picture("chosen")
    click(form.write)
    at_rest(300)
    written = json.loads((folder / "kit.json").read_text("utf-8"))
    assert (written["quantity"], written["status"], written["language"]) == (3, "complete", "en")
    named = {name for name in written["files"] if "print." in name}
    assert named == {"3x-Design-print.3mf", "3x-Design-print.step"}
    assert design.Kit == "current" and document.UndoNames == steps
    picture("written")

    # What comes next is a click away.
    pages = []
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: pages.append(url.toLocalFile()))
    form.line.setFocus()
    for _ in range(5):
        keys("Tab")
        keys("Return")
        settle(200)
    files = ("shop.pdf", "assembly.html", "latex-front.pdf", "latex-back.pdf")
    assert pages == [str(folder), *(str(folder / f"Design-{name}") for name in files)], pages

    # Opened again it shows the order and the way to its files; of another design the kit is out of date.
    close_panel()
    press("CurveUps_Kit")
    form = panel().form
    assert (form.folder.text(), form.quantity.value()) == (str(folder), 3)
    assert form.names.text() == "{quantity}-{name}-{body}" and "the order" in form.line.text()
    design.AnchorRadius = design.AnchorRadius.Value + 1
    document.recompute()
    until(lambda: form.note.isVisible(), 10, "the note")
    picture("out of date")
    close_panel()
    press("CurveUps_Kit")
    form = panel().form
    assert form.note.isVisible() and form.line.text() == ""

    # Cancelled it leaves no kit that seems whole.
    click(form.write)
    until(lambda: "writing" in form.doing.text(), 120, "the first file")
    click(form.cancel)
    until(lambda: not LIVE.busy, 10, "the end")
    assert WORKER.wait(60)
    assert json.loads((folder / "kit.json").read_text("utf-8"))["status"] == "stopped"
    assert design.Kit.startswith("out of date: ") and form.line.text() and "the order" not in form.line.text()
    FreeCAD.closeDocument(document.Name)
    at_rest()
    assert panel() is None
