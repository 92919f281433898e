# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chosen files: their estimate against what is written, and the preference page against the one table."""

import re
from xml.etree import ElementTree

import pytest
from running import ROOT

from curveups.report.export_estimate import estimate
from curveups.report.exports import Choice, choices, write_export
from curveups.features.properties import property_name
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages.cut_request import CutRequest
from curveups.stages.stage import Job
from curveups.stages.surface import find_source


@pytest.fixture(scope="module")
def project():
    parameters = native.Parameters()
    parameters.set("L", 10)
    parameters.set("verify", False)
    source = find_source("half-sphere")
    made = Project(source.name, parameters, {"source": source, "cut request": CutRequest()})
    return Project.of_design(made.run(("design",)).design)


@pytest.mark.parametrize("deviation", [0.005, 0.02])
def test_sizes_are_estimated_within_a_factor_of_two(project, tmp_path, deviation):
    choice = Choice(tuple(choices()), deviation=deviation, reports=False)
    tiles = len(project.latest("design").design.F)
    size, seconds = estimate(tiles, project.parameters, choice)
    folder = write_export(project, tmp_path, choice, Job())
    written = sum(count for name, count in folder.files.items() if not name.endswith(".json"))
    assert 0.5 < size / written < 2, (size, written)
    assert seconds > 0


def test_the_preference_page_has_the_table_s_ranges_and_defaults():
    page = ElementTree.parse(ROOT / "resources" / "ui" / "preferences.ui")
    rows = {property_name(row.name): row for row in native.parameter_table()}
    found = 0
    for widget in page.iter("widget"):
        values = {item.get("name"): (item[0].text or "") for item in widget.findall("property")}
        if not values.get("prefPath", "").endswith("Defaults"):
            continue
        row = rows[values["prefEntry"]]
        assert [float(values[name]) for name in ("minimum", "maximum", "rawValue")] == [
            row.minimum, row.maximum, row.default]
        assert re.fullmatch(row.unit, values["unit"])
        found += 1
    assert found == 3
