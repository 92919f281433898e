# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checkout as an addon: what FreeCAD reads of package.xml, and the tests that it lists."""

import subprocess

import curveups
import FreeCAD
import pytest
from freecad_process import environment_in, freecad_home
from running import ROOT


@pytest.mark.freecad
def test_package_file():
    package = FreeCAD.Metadata(str(ROOT / "package.xml"))
    assert package.Name == "CurveUps" and package.Version == curveups.__version__, package.Version
    assert package.FreeCADMin == "0.20.2", package.FreeCADMin
    assert (ROOT / package.Icon).is_file(), package.Icon
    assert {url["type"] for url in package.Urls} >= {"repository", "readme", "documentation", "bugtracker"}
    for licence in package.License:
        assert (ROOT / licence["file"]).is_file(), licence
    workbench, = package.Content["workbench"]
    assert workbench.Classname == "CurveUpsWorkbench"
    assert workbench.Classname in (ROOT / "InitGui.py").read_text(encoding="utf-8")
    assert {need["package"] for need in package.Depend} == {"numpy", "matplotlib", "scipy", "ezdxf", "jinja2"}
    for address in (url["location"] for url in package.Urls if url["type"] in ("readme", "documentation")):
        assert (ROOT / address.split(".invalid/")[1]).is_file(), address


def test_freecad_lists_and_runs_its_tests(tmp_path):
    home = freecad_home(tmp_path / "home", True)

    def said(*arguments):
        ran = subprocess.run(["freecadcmd", *arguments], env=environment_in(home), stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=300)
        return ran.stdout + ran.stderr

    assert "TestCurveUps" in said("-t").split()
    out = said("-t", "TestCurveUps")
    assert "test_stale_results_say_so" in out and "\nOK" in out, out
    assert "Ran 3 tests" in out, out
