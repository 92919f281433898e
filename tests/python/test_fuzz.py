# SPDX-License-Identifier: LGPL-2.1-or-later
"""Some seconds of fuzzing (tools/test --fuzz does it for long), and that it notices what it is for."""

import re

import pytest
from fuzz import fuzz, fuzz_kind
from fuzz_kinds import KINDS

SEED = 20240607
LEAST = {kind: 2 if kind in ("step", "iges", "brep") else 10 for kind in KINDS}  # many CAD files never end


def test_readers_bear_mutations(tmp_path, capfd):
    sound = fuzz(2.0 * len(KINDS), SEED, list(KINDS), tmp_path)
    said = capfd.readouterr().out
    assert sound, said
    counts = dict(re.findall(r"^fuzz: (\w+): (\d+) inputs", said, re.M))
    assert set(counts) == set(KINDS)
    assert all(int(count) >= LEAST[kind] for kind, count in counts.items()), said


@pytest.mark.parametrize("kind, word", [("crash", "crashed"), ("hang", "no end"), ("break", "KeyError")])
def test_the_fuzzer_notices(tmp_path, kind, word):
    count, failures = fuzz_kind(kind, 1.0, SEED, tmp_path / kind, limit=5.0)
    assert [number for number, _ in failures] == [3] and word in failures[0][1]
    assert (tmp_path / kind / f"failed-{SEED}-3.txt").exists()
    assert count >= 4
