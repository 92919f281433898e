# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scripts in FreeCAD with this checkout linked as a Mod folder, and in one that lacks it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from running import dome, environment  # noqa: E402
from window import freecad_home  # noqa: E402


@pytest.fixture(scope="session")
def homes(tmp_path_factory):
    return {known: freecad_home(tmp_path_factory.mktemp("home"), known) for known in (True, False)}


@pytest.fixture(scope="session")
def freecad(homes):
    """Runs Python text in freecadcmd; the text has to call `done()` at its end."""

    def run(text, with_workbench=True, **names):
        folder = homes[with_workbench]
        script = folder / "script.py"
        head = "".join(f"{name} = {str(value)!r}\n" for name, value in names.items())
        script.write_text(head + "def done():\n    print('script-is-done', flush=True)\n" + text)
        env = {**os.environ, "HOME": str(folder)}
        env.pop("PYTHONPATH", None)
        ran = subprocess.run(
            ["freecadcmd", "-c",
             f"import runpy; runpy.run_path({str(script)!r}, run_name='__main__')"],
            env=env, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
        assert "script-is-done" in ran.stdout, ran.stdout + ran.stderr
        return ran.stdout + ran.stderr

    return run


def design_document(folder, *settings):
    """The document that the command line makes of a dome of 54 tiles."""
    (folder / "dome.obj").write_text(dome(3))
    done = subprocess.run([sys.executable, "-m", "curveups.cli", "design", folder / "dome.obj", "-o",
                           folder / "out", "--no-remesh", *settings], env=environment(),
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder / "out" / "dome.FCStd"


@pytest.fixture(scope="session")
def document(tmp_path_factory):
    return design_document(tmp_path_factory.mktemp("document"))


@pytest.fixture(scope="session")
def bowl(tmp_path_factory):
    """The dome seen from inside: its back faces are larger than its front faces."""
    return design_document(tmp_path_factory.mktemp("bowl"), "--set", "flip=on")
