# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays for pictures of a design: shapes of tiles, and figures per tile and contact."""


import numpy as np
import pytest
from running import dome

from curveups.base.native import native


@pytest.fixture(scope="module")
def target():
    lines = [line.split() for line in dome(4).splitlines()]
    V = np.array([line[1:] for line in lines if line[0] == "v"], float)
    return V, np.array([line[1:] for line in lines if line[0] == "f"], np.int32) - 1


@pytest.fixture(scope="module")
def design(target):
    V, F = target
    parameters, cuts = native.Parameters(), np.zeros((0, 2), np.int32)
    found = native.solve_layout(V, F, cuts, parameters)
    return native.Design("dome", parameters, V, F, found.T, found.q, cuts)


def test_shapes_of_a_design_have_a_row_per_tile_and_contact(design):
    shapes, tiles = native.tile_shapes(design), len(design.F)
    assert shapes.flat.shape == shapes.actuated.shape == (tiles, 6, 3)
    assert shapes.flat_pins.shape == shapes.actuated_pins.shape == (tiles, 2, 6, 3)
    np.testing.assert_allclose(shapes.actuated[:, :3], design.V[design.F], atol=1e-9)
    np.testing.assert_allclose(shapes.flat[:, :3, :2], design.T, atol=1e-9)
    contacts = len(shapes.contacts)
    assert shapes.contact_sides.shape == (contacts, 2) and contacts > tiles / 2
    pairs, sides = shapes.contacts.T, shapes.contact_sides.T  # the edge that both tiles have
    np.testing.assert_allclose(shapes.actuated[pairs[0], sides[0]],
                               shapes.actuated[pairs[1], (sides[1] + 1) % 3], atol=1e-9)


def test_a_target_without_layout_has_actuated_tiles_alone(target):
    V, F = target
    shapes = native.tile_shapes_at(V, F, np.zeros((0, 2), np.int32), native.Parameters())
    assert len(shapes.actuated) == len(F)
    assert len(shapes.flat) == len(shapes.actuated_pins) == len(shapes.flat_pins) == 0


def test_fields_have_a_value_per_tile_or_contact(design):
    tiles, contacts = len(design.F), len(native.tile_shapes(design).contacts)
    before = native.target_figures(design.V, design.F, design.cuts, design.parameters)
    after = native.evaluate_design(design)
    for values in (before.contacts, before.dihedral, before.dihedral_margin, before.interface_share,
                   after.contacts, after.gap):
        assert len(values) == contacts
    for values in (before.back_scale, before.pin_area, before.membrane_clearance, before.stretch,
                   before.least_stretch, before.most_stretch, after.pin_area):
        assert len(values) == tiles
    assert (before.dihedral > 0).all()  # a dome is convex everywhere
    assert (after.pin_area > 0).all()
