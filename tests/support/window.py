# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display."""

import subprocess
from pathlib import Path

from freecad_process import command, environment_in, freecad_home

__all__ = ["ROBOT", "freecad_home", "run_in_window"]

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


# To put before a script that uses the functions of robot.py; `pictures` has to be among its names.
ROBOT = f"""
import sys, time
sys.path.insert(0, {str(Path(__file__).parent)!r})
import robot
from robot import *
robot.keep_pictures_in(pictures)
"""


def run_in_window(work, home, folder, timeout=300, **names):
    """Runs the text `work`, which defines work(), with `names` as its globals. Raises on failure."""
    folder = Path(folder)
    script, log = folder / "script.py", folder / "log"
    head = "".join(f"{name} = {str(value)!r}\n" for name, value in names.items())
    script.write_text(FRAME.format(work=head + work, log=str(log)))
    ran = subprocess.run(command(script, window=True), env=environment_in(home), stdin=subprocess.DEVNULL,
                         capture_output=True, text=True, timeout=timeout)
    if ran.returncode != 0:
        raise AssertionError((log.read_text("utf-8") if log.exists() else "") + ran.stderr[-2000:])
    return ran.stdout + ran.stderr
