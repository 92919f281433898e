# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands of README.md and CONTRIBUTING.md work as they stand there; links of all pages lead somewhere."""

import os
import re
import subprocess
from pathlib import Path

import pytest
from running import ROOT


OWN = ("tools/test", "tools/check")  # what runs this test, or beside it


def commands(page):
    blocks = re.findall(r"```sh\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.S)
    return [line for block in blocks for line in block.splitlines() if line.strip()]


@pytest.mark.all
@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md"])
def test_commands(page, tmp_path):
    """As on a fresh home, but for what was compiled before."""
    assert len(commands(page)) >= 5
    env = {**os.environ, "HOME": str(tmp_path),
           "CCACHE_DIR": os.environ.get("CCACHE_DIR", str(Path.home() / ".cache" / "ccache"))}
    for line in commands(page):
        if line.startswith(OWN):
            continue
        done = subprocess.run(line, shell=True, cwd=ROOT, env=env, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=550)
        assert done.returncode == 0, (line, done.stdout[-2000:], done.stderr[-2000:])
        if line == "tools/demo":
            assert "half-sphere-print.3mf" in done.stdout and "report.html" in done.stdout
    if page == "README.md":
        found = subprocess.run(["freecadcmd", "-c", "import curveups; print(curveups.__file__)"], env=env,
                               stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=100)
        assert f"{tmp_path}/.local/share/FreeCAD/Mod/CurveUps" in found.stdout, found.stdout


def test_the_first_command_makes_the_demo():
    assert commands("README.md")[0] == "tools/demo"


def pages():
    return [*ROOT.glob("*.md"), *(ROOT / "resources" / "docs").glob("*.md")]


def anchors(page):
    """Anchors of a page's headings."""
    heads = re.findall(r"(?m)^#+ (.+)$", page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.name)
def test_links_and_pictures_exist(page):
    for target in re.findall(r"\]\(([^)]+)\)", page.read_text(encoding="utf-8")):
        name, _, anchor = target.partition("#")
        there = page.parent / name if name else page
        assert there.is_file(), (page.name, target)
        assert not anchor or anchor in anchors(there), (page.name, target)


ROOMS = "core numerics geometry design bodies layout physics contact refinement fabrication bindings".split()


@pytest.mark.parametrize("page", [page for page in pages() if page.name != "CHANGELOG.md"],
                         ids=lambda page: page.name)
def test_files_that_pages_name_exist(page):
    """`room/file`, with or without its ending, and full paths."""
    for name in re.findall(r"`([\w./-]+/[\w.-]*)`", page.read_text(encoding="utf-8")):
        top = name.split("/")[0]
        if top in ROOMS:
            name = f"native/curveups/{name}"
        elif top not in ("native", "Workbench", "resources", "tests", "tools", ".ci"):
            continue
        assert (ROOT / name).exists() or list(ROOT.glob(f"{name}.*")), (page.name, name)


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.name)
def test_tests_that_pages_name_exist(page):
    for name, function in re.findall(r"`(test_\w+\.py)(?:::(\w+))?`", page.read_text(encoding="utf-8")):
        file, = (ROOT / "tests").glob(f"*/{name}")
        assert f"def {function}(" in file.read_text(encoding="utf-8") or not function, (page.name, function)


def test_setup_is_silent_where_nothing_is_missing():
    done = subprocess.run(["tools/setup"], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=550)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
