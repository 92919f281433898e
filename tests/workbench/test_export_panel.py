# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Export, by the mouse: what it leaves, and what it opens afterwards."""

import json
import os
import threading
import time
from types import SimpleNamespace

import FreeCAD
import FreeCADGui
import pytest
from curveups.project.worker import WORKER
from curveups.report import exports
from curveups.window import qt
from robot import click, close_panel, fill, keys, picture, press, settle, until, widget
from steps import LIVE, opened, panel, quit_freecad

pytestmark = pytest.mark.freecad(window=True)


def test_what_comes_after_an_export_is_a_click_away(dome_document, tmp_path, pictures, monkeypatch):
    """A folder holds one design: the report of another is replaced."""
    document, design = opened(dome_document)
    folder = tmp_path / "prints"
    folder.mkdir()
    (folder / "report.json").write_text(json.dumps({"name": "someone-elses"}))
    press("CurveUps_Export")
    form = panel().form
    form.folder.setText(str(folder))
    announced = form.chosen.text().split(", ")
    pages = []
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: pages.append(url.toLocalFile()))
    click(form.write)
    until(lambda: not LIVE.busy and "open the report" in form.line.text(), 120, "the files")
    assert json.loads((folder / "report.json").read_text("utf-8"))["name"] == design.Label
    assert sorted(announced) == sorted(os.listdir(folder)), announced
    picture("written")
    form.line.setFocus()
    for _ in range(3):
        keys("Tab")
        keys("Return")
        settle(200)
    assert pages == [str(folder / name) for name in ("", "report.html", f"{design.Label}-print.3mf")], pages
    close_panel()


def lingering(late):
    """A writer of files that goes on after its STL file until it is stopped. late: set by then."""
    write_bodies = exports.write_bodies

    def slow(folder, name, model, kind, job, title=None):
        def write(ending, kind, path, job, title):
            model.write(ending, kind, path, job, title)
            if ending == "stl":
                late.set()
                while not job.stopped:
                    time.sleep(0.01)

        write_bodies(folder, name, SimpleNamespace(write=write), kind, job, title)

    return slow


@pytest.mark.all
@pytest.mark.parametrize("end", ["cancel", "close"])
def test_an_export_that_is_cut_off_leaves_no_report(dome_document, tmp_path, pictures, monkeypatch, end):
    """Cancel, or closing the document, leaves no new file beside a report of others."""
    document, design = opened(dome_document)
    press("CurveUps_Export")
    form = panel().form
    form.folder.setText(str(tmp_path / "prints"))
    click(form.write)
    until(lambda: not LIVE.busy and "open the report" in form.line.text(), 120, "the files")

    late = threading.Event()
    monkeypatch.setattr(exports, "write_bodies", lingering(late))
    fill(form.deviation, "0.02 mm")
    click(form.write)
    until(late.is_set, 120, "a file in the middle")
    assert any(name.startswith(".") for name in os.listdir(tmp_path / "prints"))
    if end == "cancel":
        click(form.cancel)
    else:
        FreeCAD.closeDocument(document.Name)
    until(lambda: WORKER.idle, 60, "the thread to end")
    assert not [name for name in os.listdir(tmp_path / "prints") if name.startswith((".", "report"))]
    if end == "cancel":
        picture("cancelled")
        close_panel()


def quit_in_mid_export(path, folder, left):
    document, _ = opened(path)
    document.Comment = "changed"
    late = threading.Event()
    exports.write_bodies = lingering(late)
    press("CurveUps_Export")
    fill(widget("folder"), folder)
    click(widget("write"))
    until(late.is_set, 120, "a file in the middle")

    def look():
        assert any(name.startswith(".") for name in os.listdir(folder))

    quit_freecad(left, look)


@pytest.mark.all
def test_FreeCAD_can_be_quit_in_mid_export(elsewhere, dome_document, tmp_path):
    """FreeCAD ends by itself: no thread is left, and no file beside a report of others."""
    folder, left = tmp_path / "prints", tmp_path / "left"
    folder.mkdir()
    (folder / "report.json").write_text(json.dumps({"name": "Design", "valid": True}))
    elsewhere(quit_in_mid_export, str(dome_document), str(folder), str(left), window=True, ends=True)
    assert left.read_text("utf-8") == "[0] False False"
    assert not [name for name in os.listdir(folder) if name.startswith((".", "report"))]


@pytest.mark.all
def test_each_design_remembers_where_its_files_went(dome_document, tmp_path, pictures):
    document, first = opened(dome_document)
    second = document.copyObject(first, True)
    second.Label = "Second"
    document.recompute()
    folders = {first.Name: tmp_path / "one", second.Name: tmp_path / "two"}
    before = list(document.UndoNames)

    def folder_of(design):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(design)
        press("CurveUps_Export")
        until(lambda: panel() is not None and panel().design == design, 10, "its panel")
        settle(500)  # it may take the focus
        return panel().form.folder

    for design in (first, second):
        field = folder_of(design)
        assert field.text() not in map(str, folders.values())
        fill(field, str(folders[design.Name]))
        assert field.toolTip() == str(folders[design.Name])  # longer than the field
        click(panel().form.write)
        until(lambda: not LIVE.busy and "open the folder" in panel().form.line.text(), 120, "the files")
    for design in (first, second):
        assert folder_of(design).text() == str(folders[design.Name])
    assert {path.name for path in folders[second.Name].iterdir()} >= {"Second-print.3mf", "report.json"}
    assert list(document.UndoNames) == before
    close_panel()
    document.saveAs(str(tmp_path / "saved.FCStd"))
    names = first.Name, second.Name
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(str(tmp_path / "saved.FCStd"))
    settle(500)
    for name in names:
        assert folder_of(document.getObject(name)).text() == str(folders[name])
    close_panel()
