# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display."""

import os
import subprocess
from pathlib import Path

from running import ROOT

# Runs `work()` of the text once the window stands; a traceback goes to the log.
FRAME = """
import os, traceback
import FreeCAD, FreeCADGui
from PySide import QtCore, QtGui

def settle(milliseconds=200):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()

{work}

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


def freecad_home(folder, with_workbench):
    """A home folder whose FreeCAD has the checkout as a Mod, or has not."""
    for base in (folder / ".local/share/FreeCAD", folder / ".local/share/FreeCAD/v1-1"):
        (base / "Mod").mkdir(parents=True)
        if with_workbench:
            (base / "Mod" / "CurveUps").symlink_to(ROOT)
    return folder


def run_in_window(work, home, folder, timeout=300, **names):
    """Runs the text `work`, which defines work(), with `names` as its globals. Raises on failure."""
    folder = Path(folder)
    script, log = folder / "script.py", folder / "log"
    head = "".join(f"{name} = {str(value)!r}\n" for name, value in names.items())
    script.write_text(FRAME.format(work=head + work, log=str(log)))
    env = {**os.environ, "HOME": str(home), "QTWEBENGINE_DISABLE_SANDBOX": "1",
           "QTWEBENGINE_CHROMIUM_FLAGS": "--no-sandbox", "LIBGL_ALWAYS_SOFTWARE": "1"}
    env.pop("PYTHONPATH", None)
    ran = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1440x900x24 -dpi 96", "freecad", str(script)],
                         env=env, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                         timeout=timeout)
    if ran.returncode != 0:
        raise AssertionError((log.read_text() if log.exists() else "") + ran.stderr[-2000:])
    return ran.stdout + ran.stderr
