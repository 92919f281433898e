# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preference page against the one table, and what an export leaves in its folder."""

import errno
import json
import os
import re
import zipfile
from xml.etree import ElementTree

import pytest

from running import ROOT

from curveups.features.properties import property_name
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.native import native
from curveups.base.parameters import parameter, table
from curveups.project.project import Project
from curveups.report.exports import Choice, choices, other_report, replaced, write_export
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


@pytest.mark.parametrize("file", ["tiles.step", "tiles.stl", "print.3mf"])
def test_an_export_that_is_cancelled_leaves_the_folder_as_it_was(exported, file):
    """Or new files stood beside an older report, which calls the design valid."""
    project, folder = exported
    before, job = held(folder), Impatient()
    job.words = f"writing disc-{file}"
    with pytest.raises((Stopped, native.Cancelled)):
        write_export(project, folder, Choice(ALL.files, deviation=0.02), job)
    assert held(folder) == before
    with pytest.raises((Stopped, native.Cancelled)):
        write_export(project, folder / "new" / "deeper", ALL, job)
    assert held(folder) == before


@pytest.mark.parametrize("nth", [2, 5])
def test_an_export_for_which_the_disk_is_too_small_leaves_the_folder_as_it_was(exported, monkeypatch, nth):
    project, folder = exported
    before, synced = held(folder), []

    def full(descriptor):
        synced.append(descriptor)
        if len(synced) == nth:
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(CurveUpsError, match="No space left on device") as caught:
        write_export(project, folder, ALL, Job())
    assert caught.value.status == 4 and "no file was made" in caught.value.remedy
    assert held(folder) == before


def test_an_export_that_fails_between_its_files_leaves_no_report(exported, monkeypatch):
    project, folder = exported
    replace = os.replace

    def broken(source, target):
        if str(target).endswith("disc-tiles.stl"):
            raise OSError(errno.EIO, "Input/output error")
        replace(source, target)

    monkeypatch.setattr(os, "replace", broken)
    with pytest.raises(CurveUpsError, match="disc-tiles.stl could not be written") as caught:
        write_export(project, folder, ALL, Job())
    assert "complete are disc-design.json" in caught.value.remedy
    assert not [name for name in held(folder) if "report" in name or name.startswith(".")]


def test_an_export_without_reports_leaves_none_that_it_makes_untrue(exported):
    """Another design's stays while none of the files that are there is replaced."""
    project, folder = exported
    names = {("print", "3mf"): "disc-print.3mf"}
    bare = Choice(tuple(names), reports=False)
    assert replaced(folder, "disc", names, bare) == replaced(folder, "disc", names, ALL) == ""
    files = write_export(project, folder, bare, Job()).files
    assert set(files) == {"disc-design.json", "disc-print.3mf"}
    assert not [name for name in held(folder) if "report" in name]
    (folder / "report.json").write_text(theirs := json.dumps({"name": "other"}))
    assert other_report(folder, "disc") == replaced(folder, "disc", names, bare) == "other"
    new = Choice((("tiles", "stl"),), "{name}_{body}", reports=False)
    (folder / "disc-design.json").unlink()
    assert replaced(folder, "disc", {("tiles", "stl"): "disc_tiles.stl"}, new) == ""
    write_export(project, folder, new, Job())
    assert (folder / "report.json").read_text("utf-8") == theirs
    write_export(project, folder, bare, Job())
    assert not (folder / "report.json").exists()
