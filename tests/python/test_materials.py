# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library of materials: what it says of each number, and what choosing one by its name does."""

from __future__ import annotations

import json

import pytest

from curveups.base import profiles
from curveups.base.native import native

DEFAULTS = {"material_membrane": "latex-0.5", "material_glue": "cyanoacrylate", "material_tile": "vero"}
NAMES = [(kind, name) for kind in profiles.MATERIALS for name in profiles.material_names(kind)]


def test_the_library_has_several_of_each_kind_and_the_defaults_among_them():
    common = native.Parameters()
    for kind, default in DEFAULTS.items():
        assert default in profiles.material_names(kind) and len(profiles.material_names(kind)) > 1
        for name, value in profiles.of_material(kind, default, "").items():
            assert common.get(name) == value, name


@pytest.mark.parametrize("kind, name", NAMES)
def test_each_number_has_a_source_or_says_that_it_is_assumed(kind, name):
    path = profiles.material_path(name)
    values, sources = profiles.of_material(kind, name, ""), json.loads(path.read_text("utf-8"))["sources"]
    assert profiles.about(path)
    left = set(values)
    for key, source in sources.items():
        names = {one for one in values if one in (key, f"{key}_front", f"{key}_back")}
        left -= names
        said = [values[one] for one in names] or [source["value"]]
        assert all(source["low"] <= value <= source["high"] for value in said), key
        assert source["source"] and bool(source["date"]) != source.get("assumed", False), key
    assert not left, left
    used = native.Parameters()
    for key, value in values.items():
        used.set(key, value)


def test_a_material_is_chosen_by_its_name_and_what_is_set_wins(curveups, cap, tmp_path):
    def used(*settings):
        ran = curveups("design", cap, "-o", tmp_path / "o", "--no-remesh", "--no-solids", "--set",
                       "run_verification=off", *settings)
        assert ran.status == 0, ran.err
        return json.loads((tmp_path / "o" / "design.json").read_text("utf-8"))["parameters"]

    pla = profiles.of_material("material_tile", "pla", "")
    soft = used("material_tile=pla", "material_membrane=latex-0.25", "thickness_back=0.3")
    assert {name: soft[name] for name in pla} == pla
    assert (soft["shear_modulus_front"], soft["thickness_front"], soft["thickness_back"]) == (0.72, 0.25, 0.3)
    # Whatever stands first.
    assert used("friction_coefficient=0.4", "material_tile=pla")["friction_coefficient"] == 0.4
    # The tiles' material says what they weigh, not the printer's.
    assert used("printer=fdm", "material_tile=petg")["density"] == 1.27
    assert used("material_tile=petg", "--profile", "fdm")["density"] == 1.27
    config = tmp_path / "own.json"
    config.write_text(json.dumps({"material_glue": "contact-cement"}), encoding="utf-8")
    assert used("L=9", "--config", config)["glue_strength"] == 0.3


def test_an_unknown_material_is_refused(curveups, cap, tmp_path):
    ran = curveups("design", cap, "-o", tmp_path / "o", "--set", "material_glue=honey")
    assert ran.status == 2 and "material_glue" in ran.err and "contact-cement" in ran.err
    assert not (tmp_path / "o").exists()
