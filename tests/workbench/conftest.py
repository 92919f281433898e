# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scripts in FreeCAD with this checkout linked as a Mod folder, and in one that lacks it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from running import ROOT, dome, environment  # noqa: E402
from window import freecad_home  # noqa: E402


@pytest.fixture(scope="session")
def homes(tmp_path_factory):
    """Home folders by what FreeCAD knows of the workbench: all, nothing, all but the native module, and
    all with a native module that can't be loaded."""
    known = {known: freecad_home(tmp_path_factory.mktemp("home"), known) for known in (True, False)}
    for name, module in (("no native", None), ("broken native", b"no library")):
        known[name] = freecad_home(tmp_path_factory.mktemp("home"), False)
        for mods in known[name].glob(".local/share/FreeCAD/**/Mod"):
            checkout_with(mods / "CurveUps", module)
    return known


def checkout_with(folder, module):
    """This checkout by links, with another native module: its bytes, or None."""
    package = folder / "Workbench" / "curveups"
    package.mkdir(parents=True)
    for place, names in ((ROOT, ("Init.py", "InitGui.py", "package.xml", "resources")),
                         (ROOT / "Workbench" / "curveups", None)):
        for path in place.iterdir():
            if path.name in names if names else not path.name.startswith(("_native", "__pycache__")):
                (folder / path.relative_to(ROOT)).symlink_to(path)
            elif not names and path.suffix == ".so" and module is not None:
                (package / path.name).write_bytes(module)


@pytest.fixture(scope="session")
def freecad(homes):
    """Runs Python text in freecadcmd; the text has to call `done()` at its end. home: a key of `homes`."""

    def run(text, home=True, **names):
        folder = homes[home]
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
def designed():
    """design_document itself, for a test that makes one of its own."""
    return design_document


@pytest.fixture(scope="session")
def document(tmp_path_factory):
    return design_document(tmp_path_factory.mktemp("document"))


@pytest.fixture(scope="session")
def bowl(tmp_path_factory):
    """The dome seen from inside: its back faces are larger than its front faces."""
    return design_document(tmp_path_factory.mktemp("bowl"), "--set", "flip=on")
