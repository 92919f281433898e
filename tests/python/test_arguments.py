# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands, usage errors and parameters."""

import json
import re

import pytest

ERROR = re.compile(r"^curveups: error: .+ \(.+\): .+$")


def test_help_everywhere(curveups):
    for words in ((), ("design",), ("remesh",), ("targets",), ("verify",), ("export",), ("parameters",)):
        ran = curveups(*words, "--help")
        assert ran.status == 0 and ran.out.startswith("usage: curveups") and ran.err == ""


def test_targets_are_listed_one_a_line(curveups):
    ran = curveups("targets")
    assert ran.status == 0
    assert set(ran.out.split("\n")[:-1]) == {
        "half-sphere", "hyperboloid", "saddle", "ellipsoid-cap", "tower", "mask", "cap", "disc",
        "cylinder-patch"}


def test_every_parameter_has_unit_default_range_and_meaning(curveups):
    from curveups.base.parameters import table

    ran = curveups("parameters", "--all")
    assert ran.status == 0
    for row in table():
        line = next(x for x in ran.out.splitlines() if x.startswith(f"  {row.name} "))
        assert row.meaning in line
        if row.unit:
            assert f" {row.unit} " in line
        if row.type == "number":
            assert f"{row.minimum:g} to {row.maximum:g}" in line


def test_basic_parameters_are_listed_first(curveups):
    from curveups.base.parameters import table

    ran = curveups("parameters")
    listed = {line.split()[0] for line in ran.out.splitlines() if line.startswith("  ")}
    assert listed == {row.name for row in table() if row.basic} and 15 < len(listed) <= 25
    assert "--all" in ran.out


def test_only_what_is_like_a_name_is_taken_for_it():
    from curveups.base.native import native

    def remedy(name):
        with pytest.raises(native.InvalidInput) as caught:
            native.Parameters().set(name, 3.0)
        return caught.value.remedy

    for name, like in {"H_bodi": "H_body", "hbody": "H_body", "pmin": "p_min", "l": "L",
                       "anchor_raduis": "anchor_radius"}.items():
        assert remedy(name) == f"did you mean '{like}'?"
    for name in ("x", "k", "to", "foo", "frob", "", "gravity_north", "H"):
        assert remedy(name) == "list them with 'curveups parameters'"


@pytest.mark.parametrize("arguments", [
    (), ("frobnicate",), ("design",), ("design", "disc"), ("design", "disc", "-o"),
    ("design", "disc", "-o", "x", "--frob"), ("design", "disc", "-o", "x", "--set", "L"),
    ("design", "disc", "-o", "x", "--set", "=3"), ("design", "disc", "-o", "x", "--set", "L=seven"),
    ("design", "disc", "-o", "x", "--set", "L=-1"), ("design", "disc", "-o", "x", "--set", "L=nan"),
    ("design", "disc", "-o", "x", "--set", "L=1e9"), ("design", "disc", "-o", "x", "--set", "l=7"),
    ("design", "disc", "-o", "x", "--set", "bumps=maybe"),
    ("design", "disc", "-o", "x", "--set", "run_verification=perhaps"),
    ("design", "disc", "-o", "x", "--set", "p_min=4"),
    ("design", "no-such-target", "-o", "x"), ("design", "disc", "-o", "x", "--config", "none.json"),
    ("design", "disc", "-o", "x", "--cuts", "none.json"), ("verify", "none.json"),
    ("export", "none.json", "-o", "x"), ("remesh", "disc"),
])
def test_bad_usage_is_one_line_and_status_2(curveups, tmp_path, arguments):
    ran = curveups(*arguments, cwd=tmp_path)
    assert ran.status == 2
    assert ran.out == ""
    errors = [line for line in ran.err.splitlines() if not line.startswith("curveups: reading")]
    assert len(errors) == 1 and ERROR.match(errors[0]), ran.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("settings", [
    ("--set", "tau=2.9", "d_gap_min=0.7"), ("--set=tau=2.9", "d_gap_min=0.7"),
    ("--set", "tau=2.9", "--set", "d_gap_min=0.7")])
def test_several_settings_at_once(curveups, cap, tmp_path, settings):
    """Before the target or behind it."""
    for number, words in enumerate(([cap, *settings], [*settings, cap])):
        folder = tmp_path / str(number)
        ran = curveups("design", *words, "-o", folder, "--no-remesh", "--no-solids", "--set", "verify=off")
        assert ran.status == 0, ran.err
        values = json.loads((folder / "design.json").read_text("utf-8"))["parameters"]
        assert values["tau"] == 2.9 and values["d_gap_min"] == 0.7 and values["run_verification"] is False


@pytest.mark.parametrize("text", [
    "", "[]", "{", '{"L": "\\ud800"}',
    '{"L": 1e999}', '{"L": NaN}', '{"L": [7]}', '{"L": null}', '{"frob": 1}',
    '{"L": "seven"}', '{"verify": 3}',
])
def test_broken_config(curveups, tmp_path, text):
    config = tmp_path / "config.json"
    config.write_text(text)
    ran = curveups("design", "disc", "-o", tmp_path / "out", "--config", config)
    assert ran.status == 2 and len(ran.error_lines) == 1
    assert str(config) in ran.error_lines[0] and ERROR.match(ran.error_lines[0])
    assert not (tmp_path / "out").exists()


def test_a_config_with_a_byte_order_mark(curveups, cap, tmp_path):
    config = tmp_path / "config.json"
    config.write_text('{"tau": 2.9, "verify": "off"}', encoding="utf-8-sig")
    ran = curveups("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids", "--config", config)
    assert ran.status == 0, ran.err
    assert json.loads((tmp_path / "out" / "design.json").read_text("utf-8"))["parameters"]["tau"] == 2.9
