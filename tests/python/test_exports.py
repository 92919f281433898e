# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preference page against the one table, and what an export leaves in its folder."""

import re
import zipfile
from xml.etree import ElementTree

import pytest

from running import ROOT

from curveups.features.properties import property_name
from curveups.base.errors import Stopped
from curveups.base.native import native
from curveups.base.parameters import parameter, table
from curveups.project.project import Project
from curveups.report.exports import Choice, choices, write_export
from curveups.stages.cut_request import CutRequest
from curveups.stages.stage import Job
from curveups.stages.surface import find_source


def test_the_preference_page_has_the_table_s_ranges_and_defaults():
    page = ElementTree.parse(ROOT / "resources" / "ui" / "preferences.ui")
    rows = {property_name(row.name): row for row in table()}
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


@pytest.fixture(scope="module")
def laid_out():
    parameters = native.Parameters()
    parameters.set("L", 20)
    source = find_source("disc")
    project = Project(source.name, parameters, {"source": source, "cut request": CutRequest()})
    return project.run(("layout",))["layout"].design


KINDS = parameter("support").choices


@pytest.mark.parametrize("kind", KINDS)
def test_a_support_kind_is_one_value_that_bodies_and_files_read(laid_out, tmp_path, kind):
    values = native.Parameters(laid_out.parameters)
    values.set("support", kind)
    found = native.support_kind(values)
    assert bool(found.removal) == bool(found.bodies) == bool(found.material) == (kind != "none")
    assert found.soluble == ("soluble" in found.material)
    model = native.make_print_model(laid_out.with_parameters(values))
    assert (model.volumes["support"] > 0) == bool(found.bodies)
    assert all(set(one.wanted) <= set(one.kinds) for one in native.print_formats())
    model.write("3mf", "print", str(tmp_path / "print.3mf"))
    with zipfile.ZipFile(tmp_path / "print.3mf") as archive:
        text = archive.read("3D/3dmodel.model").decode()
    assert found.material in text


ALL = Choice(tuple(choices()))


@pytest.fixture
def exported(laid_out, tmp_path):
    """A project, and a folder with an export of it that is called valid."""
    project = Project.of_design(laid_out)
    write_export(project, tmp_path, ALL, Job())
    text = (tmp_path / "report.json").read_text("utf-8").replace('"valid": null', '"valid": true')
    (tmp_path / "report.json").write_text(text)
    return project, tmp_path


def held(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


class Impatient(Job):
    """Stops when it is asked with these words."""

    words = ""

    def __call__(self, *said):
        self.stopped = self.stopped or bool(said) and self.words in str(said[0])
        return super().__call__(*said)


def test_an_export_that_is_cancelled_leaves_no_report(exported):
    """Or new files stood beside an older report, which calls the design valid."""
    project, folder = exported
    job = Impatient()
    job.words = "writing disc-print.3mf"
    with pytest.raises((Stopped, native.Cancelled)):
        write_export(project, folder, Choice(ALL.files, deviation=0.02), job)
    assert not [name for name in held(folder) if "report" in name or name.startswith(".")]


def test_an_export_without_reports_leaves_none(exported):
    """Old reports would name earlier files."""
    project, folder = exported
    files = write_export(project, folder, Choice((("print", "3mf"),), reports=False), Job()).files
    assert set(files) == {"design.json", "disc-print.3mf"}
    assert not [name for name in held(folder) if "report" in name]
