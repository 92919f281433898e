# SPDX-License-Identifier: LGPL-2.1-or-later
"""Some seconds of fuzzing (tools/test --fuzz does it for long), and that it notices what it is for."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
import fuzz_kinds
from curveups.base.errors import CurveUpsError
from curveups.targets import cad_files
from fuzz import LEAST, fuzz, fuzz_kind
from fuzz_kinds import KINDS
from shapes import obj_text

SEED = 20240607


def test_readers_bear_mutations(tmp_path, capfd):
    sound = fuzz(2.0 * len(KINDS), SEED, list(KINDS), tmp_path)
    said = capfd.readouterr().out
    assert sound, said
    counts = dict(re.findall(r"^fuzz: (\w+): (\d+) inputs", said, re.M))
    assert set(counts) == set(KINDS)
    assert all(int(count) >= LEAST for count in counts.values()), said


@pytest.mark.parametrize("kind, word", [("crash", "crashed"), ("hang", "no end"), ("break", "KeyError"),
                                        ("warn", "RuntimeWarning"), ("library", "unexpected failure")])
def test_the_fuzzer_notices(tmp_path, kind, word):
    count, failures, _ = fuzz_kind(kind, 1.0, SEED, tmp_path / kind, limit=5.0)
    assert [number for number, _ in failures] == [3] and word in failures[0][1]
    assert (tmp_path / kind / f"failed-{SEED}-3.txt").exists()
    assert count >= LEAST


def test_the_fuzzer_moves_all_coordinates_together(tmp_path):
    """Into one point, and far away: there a mesh was cleaned for ever."""
    _, failures, _ = fuzz_kind("together", 0.0, SEED, tmp_path / "together", least=600)
    assert any("a size of 0" in what for _, what in failures), failures
    assert any("e+" in what for _, what in failures), failures


@pytest.mark.parametrize("by", [0.0, 1e30])
def test_the_fuzzer_notices_what_can_be_no_target(tmp_path, monkeypatch, by):
    """In one point, or far away: that was cleaned, some of it for ever."""
    monkeypatch.setattr(fuzz_kinds, "native", SimpleNamespace(
        clean_mesh=lambda V, F: SimpleNamespace(V=V, F=F)))
    path = tmp_path / "input.obj"
    path.write_text(obj_text(by * fuzz_kinds.V, fuzz_kinds.F))
    with pytest.raises(AssertionError, match="are taken for clean"):
        fuzz_kinds.check_mesh(path, 1, lossy=False)


def test_the_fuzzer_notices_readers_that_often_do_not_end(tmp_path):
    count, failures, _ = fuzz_kind("endless", 1.0, SEED, tmp_path / "endless")
    assert len(failures) == (count + 2) // 3 and all(what.startswith("no end") for _, what in failures)


def test_the_fuzzer_notices_each_file_that_lost_a_part_and_does_not_end(tmp_path):
    count, failures, _ = fuzz_kind("cut off", 0.0, SEED, tmp_path / "cut off", least=60)
    assert 0 < len(failures) < count / 2, (count, failures)
    assert {what for _, what in failures} == {"no end in FreeCAD, of a file that lost a part"}


def _ratio(*_):
    return np.array([1.0]) / np.array([0.0])


@pytest.mark.parametrize("place, breaks, word", [
    ("creases", lambda *_: {}["a name"], "KeyError"), ("creases", _ratio, "RuntimeWarning: divide"),
    ("choose", lambda *_: None, "AttributeError"),
    ("_FAULTS", (("{}", lambda *_: [][0]),), "IndexError"), ("_FAULTS", (("{}", _ratio),), "RuntimeWarning")])
def test_the_fuzzer_notices_errors_of_ours_that_read_cad_files(tmp_path, monkeypatch, place, breaks, word):
    """The process that reads is another, and what is wrong with it was the file's fault."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "input.brep"
    path.write_bytes(fuzz_kinds.KINDS["brep"][1]()[0])
    fuzz_kinds.check_cad(path, 1, lossy=False)
    monkeypatch.setattr(cad_files, place, breaks)
    with pytest.raises(fuzz_kinds.BrokeDown, match=word):
        fuzz_kinds.check_cad(path, 1, lossy=False)


def test_the_fuzzer_says_how_many_inputs_without_an_end_it_bears(tmp_path, monkeypatch, capfd):
    monkeypatch.setattr("fuzz.fuzz_kind", lambda *_: (50, [], 3))
    assert fuzz(1.0, SEED, ["brep"], tmp_path)
    assert "brep: 50 inputs, 0 failures, 3 without an end in FreeCAD (borne: 10%)" in capfd.readouterr().out


def test_the_fuzzer_notices_what_readers_of_cad_files_let_pass(tmp_path, monkeypatch):
    """Without the checks of a file's sections and of unsound faces FreeCAD waits for ever, or loses shape."""
    monkeypatch.setattr(fuzz_kinds, "CAD_SECONDS", 1.0)
    monkeypatch.setattr(cad_files, "is_whole_brep", lambda data: True)
    monkeypatch.setattr(cad_files, "_FAULTS", ())
    monkeypatch.chdir(tmp_path)
    path, data = tmp_path / "input.brep", fuzz_kinds.KINDS["brep"][1]()[-1]
    lines, said = data.split(b"\n"), []
    uses = [k for k in range(lines.index(b"Curves 5"), len(lines)) if re.match(rb"[23]  \d+ \d", lines[k])]
    for worse in (*(data[:len(data) * k // 10] for k in range(1, 10)),
                  *(b"\n".join(lines[:k] + lines[k + 1:]) for k in uses)):
        path.write_bytes(worse)
        try:
            fuzz_kinds.check_cad(path, 1, lossy=True)
        except fuzz_kinds.Endless:
            said.append(fuzz_kinds.ENDLESS)
        except (CurveUpsError, AssertionError) as error:
            said.append(str(error))
    assert fuzz_kinds.ENDLESS in said and any("mm2 are left" in one for one in said), said
