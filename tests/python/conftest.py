# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures that run the command line, and designs that tests share."""

import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from running import Ran, call_main, command, dome, environment  # noqa: E402


def pytest_configure(config):
    config.addinivalue_line("markers", "all: a long test, which `tools/test --all` runs")


@pytest.fixture(scope="session")
def curveups():
    """The command line within this process."""
    return call_main


@pytest.fixture(scope="session")
def curveups_process():
    """The command line as a program of its own, for tests of its environment; `more`: variables."""
    def run(*arguments, cwd=None, **more):
        done = subprocess.run(command(*arguments), cwd=cwd, env=environment(**more), text=True,
                              capture_output=True, timeout=500)
        return Ran(done.returncode, done.stdout, done.stderr)

    return run


@pytest.fixture(scope="session")
def cap(tmp_path_factory):
    """A small dome of 24 tiles as an OBJ file: a sound target for tests of everything else."""
    path = tmp_path_factory.mktemp("targets") / "small cap.obj"
    path.write_text(dome(2))
    return path


@dataclass
class Finished:
    """A folder that a `design` run left, and how it ended."""

    folder: Path
    ran: Ran

    def json(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def designed(curveups, cap, tmp_path_factory):
    """The small cap without solids."""
    folder = tmp_path_factory.mktemp("designed")
    return Finished(folder, curveups("design", cap, "-o", folder, "--no-remesh", "--no-solids"))


@pytest.fixture(scope="session")
def printed(curveups, cap, tmp_path_factory):
    """The small cap with all files."""
    folder = tmp_path_factory.mktemp("printed")
    return Finished(folder, curveups("design", cap, "-o", folder, "--no-remesh"))


@pytest.fixture(scope="session")
def kit(curveups, printed, tmp_path_factory):
    """The fabrication kit of the small cap."""
    folder = tmp_path_factory.mktemp("kit")
    ran = curveups("kit", printed.folder / "design.json", "-o", folder)
    assert ran.status == 0, ran.err
    return SimpleNamespace(folder=folder, json=json.loads((folder / "kit.json").read_text("utf-8")))
