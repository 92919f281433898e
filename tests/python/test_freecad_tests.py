# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests inside of FreeCAD are reported by their names, whatever becomes of them and of FreeCAD."""

import re
import subprocess
import sys

from running import ROOT, environment

TESTS = """
import os
import signal

import FreeCAD
import pytest

pytestmark = pytest.mark.freecad


@pytest.mark.parametrize("number", [1, 2])
def test_passes(number):
    assert FreeCAD.newDocument(f"Number{number}").Name == f"Number{number}"


def test_fails():
    assert len(FreeCAD.listDocuments()) == 7


def test_prints_a_traceback():
    FreeCAD.Console.PrintError("Traceback (most recent call last)\\n")


def test_crashes():
    os.kill(os.getpid(), signal.SIGSEGV)


def test_goes_on():
    assert not FreeCAD.GuiUp and not FreeCAD.listDocuments()


@pytest.mark.freecad(home="no native")
def test_without_the_native_module():
    from curveups.base.native import problem
    assert "run tools/setup" in str(problem())


@pytest.mark.freecad(timeout=2)
def test_hangs():
    os.kill(os.getpid(), signal.SIGSTOP)
"""


def test_each_is_reported_by_name(tmp_path):
    ours = (ROOT / "tests" / "workbench" / "conftest.py").read_text("utf-8")
    (tmp_path / "conftest.py").write_text(ours.replace(
        "Path(__file__).resolve().parents[1]", f"Path({str(ROOT / 'tests')!r})"))
    (tmp_path / "test_made.py").write_text(TESTS)
    done = subprocess.run([sys.executable, "-m", "pytest", "-v", "-p", "no:cacheprovider", "-p", "no:xdist",
                           "--rootdir", tmp_path, tmp_path], env=environment(), text=True,
                          capture_output=True, timeout=500)
    found = dict(re.findall(r"(?m)^\S*test_made.py::test_(\S+) (\w+)", done.stdout))
    assert found == {"passes[1]": "PASSED", "passes[2]": "PASSED", "fails": "FAILED",
                     "prints_a_traceback": "FAILED", "crashes": "FAILED", "goes_on": "PASSED",
                     "without_the_native_module": "PASSED", "hangs": "FAILED"}, done.stdout
    assert "assert 0 == 7" in done.stdout and "test_crashes" in done.stdout, done.stdout
    assert "Segmentation fault" in done.stdout and "no answer for 2 s" in done.stdout, done.stdout
