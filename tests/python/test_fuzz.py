# SPDX-License-Identifier: LGPL-2.1-or-later
"""Some inputs of the fuzzer (tools/test --fuzz does it for long), and that it notices what it is for."""

import sys

import fuzz
import pytest

SEED = 20240607


@pytest.mark.parametrize("kind", fuzz.KINDS)
def test_readers_bear_mutations(tmp_path, kind):
    count, failures = fuzz.fuzz_kind(kind, 1.0, SEED, tmp_path)
    assert count and not failures, failures


@pytest.mark.parametrize("wrong", ["os.abort()", "{}['name']", "signal.alarm(1); time.sleep(9)"])
def test_the_fuzzer_notices(tmp_path, monkeypatch, wrong):
    """A crash, an error that is none of ours, and a hang."""
    script = tmp_path / "broken.py"
    script.write_text("import os, signal, sys, time\nprint(sys.argv[4])\nsys.stdout.flush()\n"
                      f"if sys.argv[4] == '0':\n    {wrong}\n")
    (tmp_path / "input.txt").write_text("as it was")
    monkeypatch.setattr(fuzz, "__file__", str(script))
    monkeypatch.setattr(sys, "argv", ["fuzz"])
    count, failures = fuzz.fuzz_kind("any", 0.0, SEED, tmp_path)
    assert [number for number, _ in failures] == [0] and count == 1
    assert (tmp_path / f"failed-{SEED}-0.txt").read_text("utf-8") == "as it was"
