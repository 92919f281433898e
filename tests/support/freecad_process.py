# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts a FreeCAD, with a window or without, that runs tests and functions of a file (inside_freecad.py)."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from running import ROOT

INSIDE = Path(__file__).with_name("inside_freecad.py")
# Home folders of FreeCAD: with the workbench, without it, without its native module, and with a native module
# that can't be loaded.
HOMES = ("workbench", "nothing", "no native", "broken native")
# Preferences of a user with the workbench, by words: a group and its entry.
CHOICES = {"german": ("General", '<FCText Name="Language">German</FCText>'),
           "dark": ("MainWindow", '<FCText Name="StyleSheet">Behave-dark.qss</FCText>'),
           "inch": ("Units", '<FCInt Name="UserSchema" Value="3"/>')}
# Displays of a window.
SCREENS: dict[Any, str] = {True: "1440x900x24 -dpi 96", "4K": "3840x2160x24 -dpi 192"}


class Ended(Exception):
    """FreeCAD crashed, hung or could not start. The text is the end of its log."""


class FreeCADProcess:
    """A FreeCAD in a new folder. It lives until end(), or until it crashes."""

    def __init__(self, folder: Path, home: str = "workbench", window: Any = False) -> None:
        self._log = folder / "log"
        place = freecad_home(folder / "home", home not in HOMES[1:])
        choose(place, [CHOICES[word] for word in home.split() if home not in HOMES])
        if home in HOMES[2:]:
            for mods in place.glob(".local/share/FreeCAD/**/Mod"):
                _checkout_with(mods / "CurveUps", b"no library" if home == "broken native" else None)
        ours, theirs = socket.socketpair()
        with open(self._log, "wb") as log:
            self._process = subprocess.Popen(
                command(INSIDE, window), stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                env=environment_in(place, CURVEUPS_CHANNEL=str(theirs.fileno())),
                pass_fds=(theirs.fileno(),), start_new_session=True)
        theirs.close()
        self._connection = Connection(ours.detach())

    def send(self, message: Any) -> None:
        try:
            self._connection.send(message)
        except OSError as error:
            raise Ended(self._ended()) from error

    def receive(self, seconds: float) -> Any:
        """The next message. Raises Ended if FreeCAD ends before, or sends nothing for so long."""
        try:
            if self._connection.poll(seconds):
                return self._connection.recv()
        except (EOFError, OSError) as error:
            raise Ended(self._ended()) from error
        raise Ended(f"no answer for {seconds:g} s\n{self._ended()}")

    def end(self) -> None:
        self._connection.close()
        try:
            os.killpg(self._process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self._process.wait()

    def hang_up(self) -> None:
        """Ask for nothing more."""
        self._connection.close()

    def wait(self, seconds: float) -> None:
        """Wait until FreeCAD has ended by itself."""
        self._process.wait(seconds)

    def said(self) -> str:
        return self._log.read_text(encoding="utf-8", errors="replace")

    def _ended(self) -> str:
        return f"FreeCAD ended. The end of its log:\n{self.said()[-4000:]}"


def command(script: Path, window: Any) -> list[str]:
    """Command that starts FreeCAD with a script; with a window (one of SCREENS) on a virtual display."""
    if window:
        return ["xvfb-run", "-a", "-s", f"-screen 0 {SCREENS[window]}", "freecad", str(script)]
    return ["freecadcmd", "-c", f"import runpy; runpy.run_path({str(script)!r}, run_name='__main__')"]


def environment_in(home: Path, **more: str) -> dict[str, str]:
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return {**kept, "HOME": str(home), "QTWEBENGINE_DISABLE_SANDBOX": "1",
            "QTWEBENGINE_CHROMIUM_FLAGS": "--no-sandbox", "LIBGL_ALWAYS_SOFTWARE": "1", **more}


def freecad_home(folder: Path, with_workbench: bool) -> Path:
    """A home folder whose FreeCAD has the checkout as a Mod, or no Mod."""
    for base in (folder / ".local/share/FreeCAD", folder / ".local/share/FreeCAD/v1-1"):
        (base / "Mod").mkdir(parents=True)
        if with_workbench:
            (base / "Mod" / "CurveUps").symlink_to(ROOT)
    return folder


def choose(home: Path, choices: list[tuple[str, str]]) -> None:
    """Write preferences."""
    groups = "".join(f'<FCParamGroup Name="{group}">{entry}</FCParamGroup>' for group, entry in choices)
    for name in reversed(("Root", "BaseApp", "Preferences")):
        groups = f'<FCParamGroup Name="{name}">{groups}</FCParamGroup>'
    for folder in (home / ".config/FreeCAD", home / ".config/FreeCAD/v1-1"):
        folder.mkdir(parents=True)
        (folder / "user.cfg").write_text(f"<FCParameters>{groups}</FCParameters>", encoding="utf-8")


def own_name(nodeid: str) -> str:
    """Name of a test within its file."""
    return nodeid.partition("::")[2]


def has_display() -> bool:
    return bool(shutil.which("xvfb-run") and shutil.which("xdotool"))


def _checkout_with(folder: Path, module: bytes | None) -> None:
    """Link this checkout, with another native module: its bytes, or None."""
    package = folder / "Workbench" / "curveups"
    package.mkdir(parents=True)
    for place, names in ((ROOT, ("Init.py", "InitGui.py", "package.xml", "resources", "tools")),
                         (ROOT / "Workbench" / "curveups", None)):
        for path in place.iterdir():
            if path.name in names if names else not path.name.startswith(("_native", "__pycache__")):
                (folder / path.relative_to(ROOT)).symlink_to(path)
            elif not names and path.suffix == ".so" and module is not None:
                (package / path.name).write_bytes(module)
