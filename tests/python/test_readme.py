# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of README.md work as they stand there; links of all pages lead somewhere."""

import re
import subprocess

import pytest
from running import ROOT


def commands():
    blocks = re.findall(r"```sh\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.S)
    return [line for block in blocks for line in block.splitlines() if line.strip()]


def test_readme_commands():
    assert commands()[0] == "tools/demo" and len(commands()) >= 5
    for line in commands():
        done = subprocess.run(line, shell=True, cwd=ROOT, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=550)
        assert done.returncode == 0, (line, done.stderr[-2000:])
        if line == "tools/demo":
            assert "half-sphere-print.3mf" in done.stdout and "report.html" in done.stdout


def pages():
    return [*ROOT.glob("*.md"), *(ROOT / "resources" / "docs").glob("*.md")]


def anchors(page):
    """What a page's headings are linked by."""
    heads = re.findall(r"(?m)^#+ (.+)$", page.read_text(encoding="utf-8"))
    return {re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.name)
def test_links_and_pictures_exist(page):
    for target in re.findall(r"\]\(([^)]+)\)", page.read_text(encoding="utf-8")):
        name, _, anchor = target.partition("#")
        there = page.parent / name if name else page
        assert there.is_file(), (page.name, target)
        assert not anchor or anchor in anchors(there), (page.name, target)


def test_setup_is_silent_where_nothing_is_missing():
    done = subprocess.run(["tools/setup"], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=550)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
