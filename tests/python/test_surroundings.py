# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the program is started from and what it is connected to: closed and full streams, odd folders,
a checkout that can't be written."""

import os
import shutil
import subprocess
import sys

import pytest
from running import ROOT, command, environment

DESIGN = ("design", "disc", "-o", "out", "--no-solids", "--set", "verify=off")


def run(folder, redirection, *arguments, **more):
    """Status and standard error of a command with its streams as a shell redirects them."""
    line = f'"$@" {redirection}'
    done = subprocess.run(["bash", "-c", line, "bash", *command(*arguments)], cwd=folder,
                          env=environment(**more), capture_output=True, text=True)
    return done.returncode, done.stderr


@pytest.mark.parametrize("redirection", [">/dev/full", ">&-", "2>/dev/full", "2>&-", "<&- >&- 2>&-"])
def test_a_design_needs_no_stream(tmp_path, redirection):
    status, _ = run(tmp_path, redirection, *DESIGN)
    assert status == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"design.json", "report.json",
                                                                    "report.html"}


@pytest.mark.parametrize("redirection", [">/dev/full", ">&-"])
@pytest.mark.parametrize("asked", ["targets", "parameters"])
def test_an_answer_that_goes_nowhere_is_an_error(tmp_path, redirection, asked):
    status, said = run(tmp_path, redirection, asked)
    assert status == 4 and said.count("\n") == 1, said
    assert said.startswith("curveups: error: the answer can't be written: ")
    assert "(standard output)" in said


@pytest.mark.parametrize("redirection", ["2>/dev/full", "2>&-", "<&- >&- 2>&-"])
def test_statuses_stay_where_nothing_can_be_said(tmp_path, redirection):
    assert run(tmp_path, redirection, "design", "no-such", "-o", "out")[0] == 2
    assert run(tmp_path, redirection, "--help")[0] == 0


@pytest.mark.parametrize("program", ["tools/curveups", "packaging/debian/curveups"])
def test_a_module_in_the_current_folder_is_not_run(tmp_path, program):
    """The installed command, too, which finds its modules elsewhere."""
    (tmp_path / "numpy.py").write_text("raise SystemExit('executed')\n")
    done = subprocess.run([ROOT / program, *DESIGN], cwd=tmp_path, capture_output=True, text=True,
                          env=environment())
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "design.json").exists()


def test_from_a_link_with_a_search_path_for_folders(tmp_path):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "curveups").symlink_to(ROOT / "tools" / "curveups")
    done = subprocess.run([tmp_path / "bin" / "curveups", "targets"], cwd=ROOT, capture_output=True,
                          text=True, env={**os.environ, "CDPATH": f"{ROOT}:/"})
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr
    done = subprocess.run(["tools/curveups", "targets"], cwd=ROOT, capture_output=True, text=True,
                          env={**os.environ, "CDPATH": f"{ROOT}:/"})
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr


@pytest.mark.skipif(os.geteuid() != 0 or not shutil.which("setpriv"), reason="another user is needed")
def test_a_checkout_of_another_user(tmp_path):
    """Nothing is missing, so nothing is written there."""
    os.chmod(tmp_path, 0o777)
    done = subprocess.run(["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
                           ROOT / "tools" / "curveups", *DESIGN], cwd=tmp_path, capture_output=True,
                          text=True, env={**os.environ, "HOME": str(tmp_path)})
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "design.json").exists()


@pytest.mark.parametrize("name", ["", b"out-\xff"])
def test_folders_without_a_usable_name(tmp_path, name):
    done = subprocess.run([*command("design", "disc", "--no-solids", "-o"), name], cwd=tmp_path,
                          env=environment(), capture_output=True, text=True)
    assert done.returncode == 2, done.stderr
    assert "folder" in done.stderr and "name" in done.stderr and done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_little_memory_is_said(tmp_path):
    """Never a hang: a line and status 2, or it fits. What is too little for the loader of libraries, which
    crashes then, is passed over."""
    status, said = run(tmp_path, "", "design", "half-sphere", "-o", "out", "--no-solids")
    assert status == 0, said

    def within(kilobytes, *arguments):
        line = f'ulimit -v {kilobytes}; exec "$@"'
        return subprocess.run(["bash", "-c", line, "bash", *arguments], cwd=tmp_path, env=environment(),
                              capture_output=True, text=True, timeout=120)

    loads = (sys.executable, "-c", "import os; os.environ['OPENBLAS_NUM_THREADS'] = '1'\n"
                                   "import curveups.cli.commands\n"
                                   "from curveups.base.native import problem; assert problem() is None")
    limits = [kilobytes for kilobytes in (300_000, 350_000, 450_000, 600_000)
              if within(kilobytes, *loads).returncode == 0]
    assert len(limits) > 1
    for kilobytes in limits:
        done = within(kilobytes, *command(*DESIGN))
        assert done.returncode in (0, 2), (kilobytes, done.returncode, done.stderr)
        if done.returncode == 2:
            assert "memory" in done.stderr.splitlines()[-1], done.stderr
