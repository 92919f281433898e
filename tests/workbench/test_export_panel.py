# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Export, by the mouse: what it asks before it replaces, and what it opens afterwards."""

import json

import FreeCADGui
import pytest
from curveups.window import qt
from robot import QtGui, click, close_panel, in_dialog, keys, picture, press, settle, until, widget
from steps import LIVE, example, panel

pytestmark = pytest.mark.freecad(window=True)


def test_the_report_of_another_design_is_not_replaced_without_asking(tmp_path, pictures, monkeypatch):
    made, design = example(L=14)
    FreeCADGui.runCommand("CurveUps_Solve")
    until(lambda: not LIVE.busy, 120, "the run to end")
    panel().reject()
    folder = tmp_path / "prints"
    folder.mkdir()
    theirs = json.dumps({"name": "someone-elses"})
    (folder / "report.json").write_text(theirs)
    press("CurveUps_Export")
    form = widget("ExportPanel")
    form.findChild(QtGui.QLineEdit, "folder").setText(str(folder))
    write, line = form.findChild(QtGui.QPushButton, "write"), form.findChild(QtGui.QLabel, "line")

    def answer(key):
        picture("asked")
        assert "someone-elses" in QtGui.QApplication.activeModalWidget().text()
        keys(key)

    in_dialog(lambda: click(write), lambda: answer("Escape"))
    assert not LIVE.busy and (folder / "report.json").read_text("utf-8") == theirs
    assert [path.name for path in folder.iterdir()] == ["report.json"]
    in_dialog(lambda: click(write), lambda: answer("alt+y"))
    until(lambda: "open the report" in line.text(), 120, "the files")
    assert json.loads((folder / "report.json").read_text("utf-8"))["name"] == "half-sphere"
    assert (folder / "half-sphere-report.json").read_bytes() == (folder / "report.json").read_bytes()
    # What comes next is a click away: folder, report, slicer. Its own report is replaced without a word.
    opened = []
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    click(write)
    until(lambda: not LIVE.busy and "open the report" in line.text(), 120, "the files again")
    picture("written")
    line.setFocus()
    for _ in range(3):
        keys("Tab")
        keys("Return")
        settle(200)
    assert opened == [str(folder / name) for name in ("", "report.html", "half-sphere-print.3mf")], opened
    close_panel()
