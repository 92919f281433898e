# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests marked `freecad` run inside of FreeCAD (tests/support/freecad_tests.py). CONTRIBUTING says how to
write one."""

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from freecad_process import FreeCADProcess  # noqa: E402
from freecad_tests import (INSIDE, pytest_collection_modifyitems, pytest_configure,  # noqa: E402,F401
                           pytest_pycollect_makemodule)
from running import PYTHON, dome, environment  # noqa: E402
from sharing import shared  # noqa: E402


def design_document(folder, *settings, rings=3):
    """The document that the command line makes of a dome, by default of 54 tiles."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "dome.obj").write_text(dome(rings))
    done = subprocess.run([PYTHON, "-m", "curveups.cli", "design", folder / "dome.obj", "-o",
                           folder / "out", "--no-remesh", *settings], env=environment(),
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder / "out" / "dome.FCStd"


@pytest.fixture(scope="session")
def designed():
    """design_document itself, for a test that makes one of its own."""
    return design_document


@pytest.fixture(scope="session")
def dome_document():
    """Document of a dome of 54 tiles. All tests share the file: a test that changes it saves elsewhere."""
    return shared("document", design_document) / "out" / "dome.FCStd"


@pytest.fixture
def elsewhere(request, tmp_path_factory):
    """Call a function of the test's file in another FreeCAD, and return its value and FreeCAD's output.
    home: the parts of the workbench that it has, one of freecad_process.HOMES. ends: FreeCAD has to end by
    itself afterwards."""

    def call(function, *arguments, home="workbench", window=False, ends=False, timeout=300):
        process = FreeCADProcess(tmp_path_factory.mktemp("elsewhere"), home, window)
        try:
            process.send(("call", str(request.path), function.__name__, arguments))
            kind, value = process.receive(timeout)
            if ends:
                process.hang_up()
                process.wait(timeout)
        finally:
            process.end()
        assert kind == "done", value
        return value, process.said()

    return call


@pytest.fixture
def pictures(tmp_path):
    """Folder of a test's pictures."""
    import robot

    robot.keep_pictures_in(tmp_path / "pictures")
    return tmp_path / "pictures"


if INSIDE:
    import FreeCAD
    import FreeCADGui
    from PySide import QtGui

    # As the profile has them.
    _SCHEMA = FreeCAD.Units.getSchema()
    _STYLE = QtGui.QApplication.instance().styleSheet() if FreeCAD.GuiUp else ""

    @pytest.fixture(autouse=True)
    def fresh():
        """Every test begins and ends without documents, panels, a selection or a run."""
        _tidy_up()
        yield
        _tidy_up()

    def _tidy_up():
        if FreeCAD.GuiUp:
            import robot

            FreeCADGui.Control.closeDialog()
            FreeCADGui.Selection.clearSelection()
            robot.QtGui.QApplication.instance().setStyleSheet(_STYLE)
        if FreeCAD.Units.getSchema() != _SCHEMA:
            FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", _SCHEMA)
            FreeCAD.Units.setSchema(_SCHEMA)
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        if FreeCAD.GuiUp:
            robot.settle(100)
            robot.at_rest()
            robot.clear_report()
