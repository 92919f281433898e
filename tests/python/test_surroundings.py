# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders that the program starts from, and modules that it loads."""

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
    assert not loaded & {"matplotlib", "ezdxf", "scipy", "FreeCAD"}


def test_as_many_threads_as_there_are_processors_at_most():
    for asked, count in (("1000000", os.cpu_count()), ("many", os.cpu_count()), ("1", 1)):
        done = subprocess.run([sys.executable, "-c", "from curveups.base.native import native\n"
                                                     "print(native.thread_count())"],
                              env=environment(CURVEUPS_THREADS=asked), capture_output=True, text=True)
        assert done.stdout.split() == [str(count)], (asked, done)
