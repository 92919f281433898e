# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks see what they are for, the benchmark fails where it has to, and what CONTRIBUTING.md shows
works."""

import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys

import pytest
from running import ROOT

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests" / "benchmarks")]

import bench_results  # noqa: E402
import bench_table  # noqa: E402
import check_rooms  # noqa: E402
from curveups.project import project  # noqa: E402
from curveups.base.native import native  # noqa: E402
from curveups.stages import BY_NAME  # noqa: E402


@pytest.mark.parametrize("path, text, said", [
    ("native/curveups/physics/a.cpp", '#include "curveups/fabrication/slab.hpp"', "must not include"),
    ("native/curveups/core/a.hpp", '#include "curveups/geometry/remesh.hpp"', "must not include"),
    ("native/curveups/bindings/a.cpp", "#include <TopoDS_Shape.hxx>", "OpenCASCADE"),
    ("native/curveups/layout/a.cpp", "#include <cholmod.h>", "CHOLMOD"),
    ("native/curveups/cellar/a.cpp", "", "not known"),
    ("Workbench/curveups/stages/a.py", "from ..project.project import Project", "must not import"),
    ("Workbench/curveups/stages/a.py", "def f():\n    from .. import cli", "must not import"),
    ("Workbench/curveups/features/a.py", "import FreeCADGui", "FreeCADGui"),
    ("Workbench/curveups/window/a.py", "from PySide2 import QtCore", "PySide2"),
    ("Workbench/curveups/a.py", "", "not known"),
    ("Workbench/curveups/cellar/a.py", "", "not known"),
    ("Workbench/curveups/stages/a.py", "def f():\n    from ..base import errors", "inside of a function"),
    ("Workbench/curveups/stages/a.py", "from .b import x",
     "import one another: curveups.stages.a, curveups.stages.b"),
    ("native/curveups/refinement/a.cpp", '#include "curveups/core/types.hpp"', ""),
    ("native/curveups/fabrication/a.cpp", '#include "curveups/bodies/outline.hpp"', ""),
    ("Workbench/curveups/cli/a.py", "from ..project.project import Project", ""),
    ("Workbench/curveups/window/qt.py", "from PySide2 import QtCore", ""),
])
def test_the_order_of_rooms(monkeypatch, capsys, tmp_path, path, text, said):
    monkeypatch.setattr(check_rooms, "ROOT", tmp_path)
    (tmp_path / path).parent.mkdir(parents=True)
    (tmp_path / path).write_text(text + "\n")
    if "from .b" in text:
        (tmp_path / path).with_name("b.py").write_text("def f():\n    from . import a\n")
    assert check_rooms.main() == (1 if said else 0)
    assert said in capsys.readouterr().out


def test_the_benchmark_fails_where_a_model_is_not_valid():
    def failed(name, valid, **more):
        return bench_table._failed({"name": name, "valid": valid, "wrong_files": [], **more})

    assert not failed("disc", True)
    assert failed("disc", False) and failed("disc", None) and failed("turtle", False)
    assert not failed("somebody's own", False)
    assert failed("disc", True, wrong_files=["no solids"]) and failed("mine", None, error="no such file")


def test_results_renew_their_models_and_keep_the_others(designed, tmp_path):
    page = tmp_path / "results.md"
    page.write_text(bench_results.RESULTS.read_text(encoding="utf-8"), encoding="utf-8")
    before = page.read_text(encoding="utf-8").splitlines()
    report = json.loads((designed.folder / "report.json").read_text("utf-8"))
    row = {**report, "name": "disc", "paper_seconds": None, "seconds_to_valid": 1.5, "seconds_to_holds": 2.5,
           "seconds_waited": 6.5, "seconds_files": None}
    bench_results.renew([row, {**row, "name": "another"}], page)
    after = page.read_text(encoding="utf-8").splitlines()
    renewed = [line for line in after if line.startswith("| disc | 24 |")]
    assert renewed and " | 1.5 | - | 2.5 | 6.5 | " in renewed[0]
    assert len(after) == len(before) + 1  # the new model's line
    assert [line for line in before if line not in after] == [
        line for line in before if line.startswith("| disc | ")]


def test_the_stage_of_the_contributors_page(designed, monkeypatch):
    page = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    spec = importlib.util.spec_from_loader("curveups.stages.weight", loader=None)
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, spec.name, module)
    exec(re.findall(r"```python\n(.*?)```", page, re.S)[-1], module.__dict__)
    monkeypatch.setitem(BY_NAME, module.STAGE.name, module.STAGE)

    of = project.Project.of_design(native.read_design(json.dumps(designed.json("design.json"))))
    grams = of.run(("weight",))["weight"].block["tiles_g"]
    assert grams == pytest.approx(of.run(("bodies",))["bodies"].model.volumes["tiles"] / 1000 * 1.18)
    values = of.parameters
    values.set("density", 2 * 1.18)
    of.parameters = values
    assert of.out_of_date("weight") == ("density",)
    assert of.run(("weight",))["weight"].block["tiles_g"] == pytest.approx(2 * grams)


@pytest.mark.parametrize("word", ["test_nowhere.py::test_commands", "nowhere/test_nowhere.py::test_commands",
                                  "test_of_nothing"])
def test_a_test_that_there_is_not_is_refused(word):
    ran = subprocess.run([ROOT / "tools" / "test", "--only", word], capture_output=True, text=True)
    assert ran.returncode == 2 and ran.stdout == ""
    assert f"there is no test {word}" in ran.stderr


_RUNNER = """#!/bin/sh
case "$*" in
  *$FAILS*) sleep 1; echo "50% tests passed"; echo "== 1 failed in 1s =="; exit 1 ;;
  *) echo "100% tests passed"; echo "== 1 passed in 1s ==" ;;
esac
"""


@pytest.mark.parametrize("kind, fails", [("none", "nothing"), ("native", "build/test"),
                                         ("python", "tests/python"), ("workbench", "tests/workbench")])
def test_tests_fail_where_one_kind_does(tmp_path, kind, fails):
    """The script runs them side by side."""
    for folder in ("bin", "tools", "build", "tests/python", "tests/workbench"):
        (tmp_path / folder).mkdir(parents=True)
    shutil.copy(ROOT / "tools" / "test", tmp_path / "tools" / "test")
    (tmp_path / "build" / "python.env").write_text(f"CURVEUPS_PYTHON={tmp_path}/bin/python\n")
    for name in ("tests/python/test_a.py", "tests/workbench/test_b.py"):
        (tmp_path / name).touch()
    for name in ("bin/python", "bin/ctest", "tools/setup"):
        (tmp_path / name).write_text(_RUNNER)
        (tmp_path / name).chmod(0o755)
    ran = subprocess.run([tmp_path / "tools" / "test"], capture_output=True, text=True, env={
        **os.environ, "FAILS": fails, "PATH": f"{tmp_path}/bin:{os.environ['PATH']}"})
    assert ran.returncode == (0 if kind == "none" else 1)
    closing = dict(line.split(": ") for line in ran.stdout.splitlines()[-3:])
    failed = {name for name, said in closing.items() if said.startswith(("50%", "1 failed"))}
    assert failed == {kind} - {"none"}
    assert set(closing) == {"native", "python", "workbench"}
