# SPDX-License-Identifier: LGPL-2.1-or-later
"""What macros can hand to the native module: wrong shapes, indices that are out of range, numbers that are
not finite, designs that no optimiser would make. Every entry answers with one of its own errors (or
Python's), and neither crashes nor hangs."""

import subprocess
import sys

import pytest
from hostile_calls import entries
from running import ROOT, environment

SECONDS = 240  # for all calls of an entry: some 20 on a busy machine


@pytest.mark.parametrize("entry", entries())
def test_hostile_arguments(entry, tmp_path):
    with open(tmp_path / "calls", "w", encoding="utf-8") as calls:
        try:
            ran = subprocess.run([sys.executable, ROOT / "tests" / "support" / "hostile_calls.py", entry],
                                 env=environment(CURVEUPS_THREADS="2"), stdout=calls,
                                 stderr=subprocess.PIPE, text=True, timeout=SECONDS, cwd=tmp_path)
            status, said = ran.returncode, ran.stderr
        except subprocess.TimeoutExpired:
            status, said = "no end", ""
    lines = (tmp_path / "calls").read_text(encoding="utf-8").splitlines()
    wrong = [line for line in lines if line.startswith("WRONG")]
    assert status == 0 and lines[-1] == f"END {entry}", (status, lines[-1:], wrong, said[-2000:])


def test_every_entry_is_called():
    found = entries()
    for known in ("surface_deviation", "remesh", "Design", "PrintModel.write",
                  "Parameters.set"):
        assert known in found
    assert len(found) > 40
