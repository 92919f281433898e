# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole built-in models, valid and with all their files: at normal size, and at a large L, so that they are
small enough for every file to be read back as others read it and for OpenCASCADE to measure the
report's figures anew."""

import json
import sys

import pytest
from running import ROOT
from schema import FILES, check_report

sys.path.insert(0, str(ROOT / "tools"))

from read_back import read_back  # noqa: E402

pytestmark = pytest.mark.all

NORMAL = {"half-sphere": ["L=7.5"], "hyperboloid": [], "ellipsoid-cap": [], "cylinder-patch": []}
SMALL = {
    "mask": ["L=22"],  # two holes, which its slab has as well; bumps
    "saddle": ["L=24", "bumps=dimples", "support=breakaway"],
}


def finished(curveups, name, settings, folder):
    """The report of a model that has to end valid."""
    words = [word for setting in settings for word in ("--set", setting)]
    ran = curveups("design", name, "-o", folder, "--quiet", *words)
    assert ran.status == 0, ran.err
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    check_report(report)
    assert report["status"] == "complete"
    assert report["valid"] is True and report["reasons"] == []
    return report


@pytest.mark.parametrize("name", NORMAL)
def test_models_of_normal_size_are_valid_and_have_all_files(curveups, tmp_path, name):
    report = finished(curveups, name, NORMAL[name], tmp_path)
    assert report["tiles"] > 500 and report["contact_forces"]["points_below_f_min"] == 0
    assert report["unilateral"]["feasible_at_bump_tips"] is True
    assert report["solids"]["invalid"] == 0 and report["constraints"]["overlaps"] == 0
    sizes = {path.name: path.stat().st_size for path in tmp_path.iterdir()}
    assert set(sizes) == {file.replace("NAME", name) for file in FILES}
    assert report["print"]["files"] == {n: size for n, size in sizes.items() if n != "report.json"}
    assert read_back(tmp_path, report, solids=False) == []


def test_a_model_that_rests_on_the_ground_is_valid(curveups, tmp_path):
    """The ground only has to push: its points share the weight, far below what tiles press with."""
    ran = curveups("design", "half-sphere", "-o", tmp_path, "--no-solids", "--quiet", "--set",
                   "gravity=resting")
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert ran.status == 0 and report["valid"] is True, report["reasons"]
    assert report["unilateral"]["largest_floor"] > 3 * report["unilateral"]["floor"]


@pytest.mark.parametrize("held", ["", "T00331"])
def test_a_model_that_is_held_is_valid(curveups, tmp_path, held):
    ran = curveups("design", "half-sphere", "-o", tmp_path, "--no-solids", "--quiet", "--set", "L=7.5",
                   "gravity=held", f"held_tiles={held}")
    report = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert ran.status == 0 and report["valid"] is True, report["reasons"]
    assert report["unilateral"]["feasible_at_bump_tips"] is True


@pytest.fixture(scope="module", params=SMALL)
def whole(request, curveups, tmp_path_factory):
    """The folder of a finished model and its report."""
    folder = tmp_path_factory.mktemp(request.param)
    return folder, finished(curveups, request.param, SMALL[request.param], folder)


def test_every_solid_is_sound_and_every_mesh_watertight(whole):
    folder, report = whole
    assert report["solids"]["invalid"] == 0
    assert report["constraints"]["overlaps"] == 0
    assert not any(warning.get("kind") in ("bare_interface", "loose") for warning in report["warnings"])
    # BRepCheck, closed, as many solids as bodies, volumes within 1e-9 of the analytic ones.
    assert read_back(folder, report, check=True) == []


def test_figures_are_those_of_the_solids(whole):
    """Distances of flat neighbours and what actuated ones have in common, from the STEP files."""
    from curveups.base import freecad_session

    folder, report = whole
    _, part = freecad_session.load("Part")
    design = json.loads((folder / "design.json").read_text(encoding="utf-8"))
    parameters, figures = design["parameters"], report["solids"]
    # Recessed walls make up for the bumps on them; dimples are not recessed.
    bump = 0 if parameters["bumps"] == "bumps" else parameters["bump_height"]
    assert figures["min_clearance_flat_mm"] >= parameters["d_gap_min"] - bump - 1e-6
    assert figures["max_overlap_actuated_mm3"] <= 1e-6

    owner, contacts = {}, []
    for i, face in enumerate(design["F"]):
        for edge in zip(face, face[1:] + face[:1]):
            if edge[::-1] in owner:
                contacts.append((owner[edge[::-1]], i))
            owner[edge] = i
    flat = part.read(str(folder / f"{report['name']}-tiles.step")).Solids
    actuated = part.read(str(folder / f"{report['name']}-actuated.step")).Solids
    assert len(flat) == len(actuated) == len(design["F"])
    for a, b in contacts[::6]:
        assert flat[a].distToShape(flat[b])[0] >= figures["min_clearance_flat_mm"] - 1e-6
        assert actuated[a].distToShape(actuated[b])[0] <= 1e-6  # they touch
        assert actuated[a].common(actuated[b]).Volume <= 1e-6
