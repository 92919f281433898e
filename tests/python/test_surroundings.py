# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders that the program starts from, and modules that it loads."""

import json
import os
import subprocess
import sys

import pytest
from running import ROOT, environment


@pytest.mark.parametrize("program", ["tools/curveups", "packaging/debian/curveups"])
def test_a_module_in_the_current_folder_is_not_run(tmp_path, program):
    """The installed command, too, which finds its modules elsewhere."""
    (tmp_path / "numpy.py").write_text("raise SystemExit('executed')\n")
    done = subprocess.run([ROOT / program, "targets"], cwd=tmp_path, capture_output=True, text=True,
                          env=environment())
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr


def test_from_a_link(tmp_path):
    (tmp_path / "curveups").symlink_to(ROOT / "tools" / "curveups")
    done = subprocess.run([tmp_path / "curveups", "targets"], capture_output=True, text=True)
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr


def test_commands_load_what_draws_when_they_draw():
    """FreeCAD takes half a second and 100 MB, and prints about folders."""
    done = subprocess.run([sys.executable, "-c", "import sys\nfrom curveups.cli import commands\n"
                                                 "print(*sys.modules)"],
                          env=environment(), capture_output=True, text=True)
    loaded = set(done.stdout.split())
    assert "curveups.cli.commands" in loaded, done.stderr
    assert not loaded & {"matplotlib", "ezdxf", "jinja2", "scipy", "FreeCAD"}


@pytest.mark.parametrize("package", ["matplotlib", "jinja2"])
def test_a_missing_package_is_named_after_the_files_that_do_without(tmp_path, package):
    done = subprocess.run([sys.executable, "-c", f"import sys\nsys.modules[{package!r}] = None\n"
                                                 "from curveups.cli import main\nsys.exit(main())",
                           "design", "saddle", "--set", "L=14", "--set", "run_settling=off", "--quiet", "-o",
                           str(tmp_path)], env=environment(), capture_output=True, text=True)
    assert done.returncode == 4 and (
        f"report.html could not be written: this needs the Python package {package}" in done.stderr)
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert set(report["print"]["files"]) == {path.name for path in tmp_path.iterdir()} - {"report.json"}
    assert (tmp_path / "saddle-tiles.step").exists() and not (tmp_path / "report.html").exists()


def test_as_many_threads_as_there_are_processors_at_most():
    for asked, count in (("1000000", os.cpu_count()), ("many", os.cpu_count()), ("1", 1)):
        done = subprocess.run([sys.executable, "-c", "from curveups.base.native import native\n"
                                                     "print(native.thread_count())"],
                              env=environment(CURVEUPS_THREADS=asked), capture_output=True, text=True)
        assert done.stdout.split() == [str(count)], (asked, done)
