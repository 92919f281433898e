# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display: the workbench registers, the document shows."""

import os
import shutil
import struct
import subprocess
import zlib

import pytest

SCRIPT = """
import os, sys, traceback
import FreeCAD, FreeCADGui
from PySide import QtCore

def work():
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    assert FreeCADGui.activeWorkbench().MenuText == 'CurveUps'
    assert os.path.isfile(FreeCADGui.activeWorkbench().Icon)
    document = FreeCAD.openDocument({path!r})
    gui = FreeCADGui.getDocument(document.Name)
    assert gui.getObject('Tiles').Visibility and gui.getObject('Anchors').Visibility
    gui.getObject('Support').Visibility = False
    assert type(gui.getObject('Design').Proxy).__name__ == 'DesignView'
    assert os.path.isfile(gui.getObject('Design').Proxy.getIcon())
    gui.getObject('Tiles').DisplayMode = 'Shaded'
    gui.getObject('Tiles').ShapeColor = (0.94, 0.70, 0.29)
    view = gui.activeView()
    view.viewIsometric()
    view.fitAll()
    view.saveImage({picture!r}, 800, 600, 'White')

def run():
    code = 0
    try:
        work()
    except BaseException:
        code = 1
        open({log!r}, 'w').write(traceback.format_exc())
    os._exit(code)

QtCore.QTimer.singleShot(500, run)
"""


def pixels(path):
    """The rows of an RGB(A) PNG, without any imaging library."""
    data = path.read_bytes()
    place, rows, header = 8, b"", None
    while place < len(data):
        size, kind = struct.unpack_from(">I4s", data, place)
        body = data[place + 8 : place + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            rows += body
        place += 12 + size
    return header, zlib.decompress(rows)


@pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no xvfb-run")
def test_document_in_a_window(document, homes, tmp_path):
    picture, log, script = tmp_path / "view.png", tmp_path / "log", tmp_path / "script.py"
    script.write_text(SCRIPT.format(path=str(document), picture=str(picture), log=str(log)))
    env = {**os.environ, "HOME": str(homes[True]), "QTWEBENGINE_DISABLE_SANDBOX": "1",
           "QTWEBENGINE_CHROMIUM_FLAGS": "--no-sandbox", "LIBGL_ALWAYS_SOFTWARE": "1"}
    env.pop("PYTHONPATH", None)
    ran = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "freecad", str(script)],
                         env=env, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                         timeout=240)
    assert ran.returncode == 0, (log.read_text() if log.exists() else "") + ran.stderr[-2000:]
    (width, height, depth, _), rows = pixels(picture)
    assert (width, height, depth) == (800, 600, 8)
    # Not blank: a picture of tiles does not compress to almost nothing.
    assert len(zlib.compress(rows)) > 20_000
