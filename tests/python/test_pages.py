# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each page about an algorithm has a picture and an example that prints what the page says. Lines of all
pages wrap."""

import re
import subprocess
import sys

import pytest
from running import ROOT, environment

PAGES = sorted(page for page in (ROOT / "resources" / "docs").glob("*.md") if page.stem not in (
    "architecture", "bibliography", "conventions", "glossary", "guide", "performance", "results"))


def example(page):
    """The blocks of a page's example: kind and text."""
    _, _, rest = page.read_text(encoding="utf-8").partition("## Example\n")
    return re.findall(r"```(\w+)\n(.*?)```", rest.partition("\n## ")[0], re.S)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_examples_print_what_pages_say(page, tmp_path):
    program = tmp_path / "bin" / "curveups"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m curveups.cli "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    env = environment(HOME=str(tmp_path))
    env["PATH"] = f"{program.parent}:{env['PATH']}"
    *blocks, (kind, printed) = example(page)
    assert kind == "text" and blocks, "an example ends with what it prints"
    out = ""
    for kind, code in blocks:
        command = {"python": [sys.executable, "-c", code], "sh": ["bash", "-ec", code]}[kind]
        done = subprocess.run(command, cwd=tmp_path, env=env, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr
        out += done.stdout
    assert out == printed


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_pages_begin_with_a_picture_of_the_project(page):
    text = page.read_text(encoding="utf-8")
    assert f"(images/page-{page.stem}.png)" in text.partition("## Example\n")[0]


@pytest.mark.parametrize("page", [*(ROOT / "resources" / "docs").glob("*.md"), ROOT / "README.md",
                                  ROOT / "Overview.md", ROOT / "CONTRIBUTING.md"], ids=lambda page: page.name)
def test_lines_wrap(page):
    """At 120 columns, but for tables and code."""
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
    assert not [line for line in text.splitlines() if len(line) > 120 and not line.startswith("|")]
