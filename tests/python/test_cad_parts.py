# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD as it is drawn: walls, rims, closed bodies, several bodies, gaps between faces."""

import math
from types import SimpleNamespace

import cad
import numpy as np
import pytest

from curveups.targets.cad_files import read_cad
from curveups.targets.cad_parts import Choice
from curveups.targets.cad_walls import find_wall
from curveups.base.errors import CurveUpsError
from curveups.base.native import native


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    return cad.make(tmp_path_factory.mktemp("parts"), *cad.PARTS)


def area(found):
    sides = found.V[found.F][:, 1:] - found.V[found.F][:, :1]
    return np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2


def closed(found):
    clean = native.clean_mesh(found.V, found.F)
    return any(one.kind == "closed" for one in native.check_mesh(clean.V, clean.F, 7.0, False))


@pytest.mark.parametrize("skin, radius", [
    ("outer", 45.0), pytest.param("inner", 42.0, marks=pytest.mark.all),
    pytest.param("middle", 43.5, marks=pytest.mark.all)])
def test_a_thick_bowl_is_one_of_its_skins(parts, skin, radius):
    found = read_cad(parts["bowl"], 0.01, choice=Choice(skin))
    assert np.allclose(np.linalg.norm(found.V, axis=1), radius, atol=0.02)
    assert area(found) == pytest.approx(2 * math.pi * radius * radius, rel=5e-3)
    assert found.wall == pytest.approx(3, abs=1e-6) and not closed(found)
    # The front is where the part ends: tiles lie in its wall.
    corners = found.V[found.F]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outward = (normal * corners.mean(axis=1)).sum(axis=1) > 0
    assert outward.all() if skin != "inner" else not outward.any()
    assert any("3 mm thick" in note and skin in note for note in found.notes)


@pytest.mark.parametrize("name, wall, expected", [
    pytest.param("rounded_bowl", 4.0, 2 * math.pi * 45 * (45 - 2.0), marks=pytest.mark.all),
    ("pipe", 3.0, 2 * math.pi * 20 * 60),
    ("lid", 2.0, None), ("lid_sharp_inside", 2.0, None), ("tee", 2.0, None), ("plate", 3.0, 100 * 80)])
def test_walls_are_found_and_rims_left_out(parts, name, wall, expected):
    found = read_cad(parts[name], 0.02)
    assert found.wall == pytest.approx(wall, abs=0.01) and not closed(found)
    if expected is not None:
        assert area(found) == pytest.approx(expected, rel=1e-2)
    if name.startswith("lid"):  # all of the outside but the bottom, fillets too
        low, high = found.V.min(axis=0), found.V.max(axis=0)
        assert np.allclose([low, high], [[0, 0, 0], [80, 60, 20]], atol=1e-3)
        flat_parts = 2 * (80 + 60) * 20 + 80 * 60
        assert 0.9 * flat_parts < area(found) < flat_parts


def test_a_wall_that_is_not_quite_even_is_one(parts):
    found = read_cad(parts["loft"], 0.05)
    assert 2.2 < found.wall < 2.5 and not closed(found)
    assert found.V[:, 2].min() == pytest.approx(0, abs=1e-6)
    assert found.V[:, 2].max() == pytest.approx(70, abs=1e-6)


def test_closed_bodies_are_opened_where_it_is_said(parts):
    assert closed(read_cad(parts["block"], 0.1, choice=Choice(open="none")))
    found = read_cad(parts["block"], 0.1)
    assert not closed(found) and found.wall is None
    assert area(found) == pytest.approx(2 * (30 * 10 + 20 * 10) + 30 * 20)
    assert found.V[found.F].mean(axis=1)[:, 2].min() > 0  # of two alike the lower one is open
    assert any("left open" in note for note in found.notes)
    side = read_cad(parts["block"], 0.1, choice=Choice(open="x=30"))
    assert area(side) == pytest.approx(2 * (30 * 20 + 30 * 10) + 20 * 10)
    upper = read_cad(parts["block"], 0.1, choice=Choice(open="z>4"))
    assert upper.V[:, 2].min() == pytest.approx(4) and not closed(upper)
    assert area(upper) == pytest.approx(30 * 20 + 2 * (30 + 20) * 6)


def test_balls_have_no_planar_face(parts):
    assert closed(read_cad(parts["ball"], 0.1))
    with pytest.raises(CurveUpsError, match="no planar face"):
        read_cad(parts["ball"], 0.1, choice=Choice(open="largest"))
    half = read_cad(parts["ball"], 0.02, choice=Choice(open="z>0"))
    assert not closed(half) and area(half) == pytest.approx(2 * math.pi * 1600, rel=5e-3)
    hollow = read_cad(parts["hollow"], 0.1)
    assert closed(hollow) and hollow.wall == pytest.approx(3, abs=0.01)
    assert np.linalg.norm(hollow.V, axis=1).min() > 39


def test_faces_by_number(parts):
    found = read_cad(parts["block"], 0.1, choice=Choice(faces="Face1, 3-4"))
    assert len(found.F) == 6
    with pytest.raises(CurveUpsError, match="there is no Face7") as told:
        read_cad(parts["block"], 0.1, choice=Choice(faces="Face7"))
    assert "Face1 to Face6" in told.value.remedy


def test_what_there_is_not_is_refused(parts):
    with pytest.raises(CurveUpsError, match="no inner skin"):
        read_cad(parts["block"], 0.1, choice=Choice("inner"))
    with pytest.raises(CurveUpsError, match="no planar face lies in z = 3"):
        read_cad(parts["block"], 0.1, choice=Choice(open="z=3"))
    with pytest.raises(CurveUpsError, match="nothing of the part has z > 99"):
        read_cad(parts["block"], 0.1, choice=Choice(open="z>99"))


def test_several_bodies_are_named(parts):
    found = read_cad(parts["two_bodies"], 0.1)
    assert any("2 bodies" in note and "30 x 20 x 10 mm" in note for note in found.notes)


def test_gaps_between_faces_are_closed(parts):
    found = read_cad(parts["gaping"], 0.05)
    clean = native.clean_mesh(found.V, found.F)
    assert not [one for one in native.check_mesh(clean.V, clean.F, 7.0, False) if one.kind == "components"]
    assert area(found) == pytest.approx(2 * 40 * 30, rel=1e-3)


def test_sheets_that_nearly_meet_are_refused_by_name(parts):
    with pytest.raises(CurveUpsError) as refused:
        read_cad(parts["apart"], 0.05)
    assert "Face1" in refused.value.what and "Face2" in refused.value.what and "0.2 mm" in refused.value.what
    assert len(read_cad(parts["apart"], 0.05, choice=Choice(faces="Face1")).F)


@pytest.mark.parametrize("ending", ["step", "iges", "brep"])
@pytest.mark.parametrize("name, errors", [("tube", []), ("vase_of_halves", []), ("lemon", []),
                                          ("torus_of_halves", ["closed"])])
def test_closed_faces_have_no_seam(tmp_path, name, errors, ending):
    """IGES has two edges where a surface closes, and none in common between faces."""
    surface = read_cad(cad.make(tmp_path, name, ending=ending)[name], 0.05)
    clean = native.clean_mesh(surface.V, surface.F)
    findings = native.check_mesh(clean.V, clean.F, 7.0, False)
    assert [finding.kind for finding in findings if finding.is_error] == errors


@pytest.mark.filterwarnings("error")
def test_faces_without_triangles_are_no_wall_and_no_warning():
    """Damaged file: the share of such a face was 0 / 0."""
    def solid(*faces):
        return SimpleNamespace(BoundBox=SimpleNamespace(DiagonalLength=17.0), Faces=[
            SimpleNamespace(tessellate=lambda _, face=face: face) for face in faces])

    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    lower = [(x, y, 0) for x, y in square], [(0, 2, 1), (0, 3, 2)]
    upper = [(x, y, 10) for x, y in square], [(0, 1, 2), (0, 2, 3)]
    lost, line = ([(0, 0, 0)], []), ([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])
    assert find_wall(solid(lower, upper, lost, line)) is None  # as thick as it is wide
    assert find_wall(solid(lost, lost)) is None and find_wall(solid(line, line)) is None
