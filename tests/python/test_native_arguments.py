# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong arguments that macros can hand to the native module: one of its own errors, never a crash."""

import numpy as np
import pytest
from fuzz import cap, design

from curveups.base.native import native

NONE = np.zeros((0, 2), np.int32)
V, F = cap()


def put(array, place, value):
    changed = array.copy()
    changed[place] = value
    return changed


@pytest.mark.parametrize("wrong", [
    (None, F), (V[:, :2], F), (V.astype(complex), F), (put(V, (3, 1), np.nan), F), (put(V, (3, 1), 1e300), F),
    (V, F[:, :2]), (V, F.astype(float)), (V, put(F, (2, 1), -1)), (V, put(F, (2, 1), len(V))), (V, F[:0])])
@pytest.mark.parametrize("entry", [
    lambda V, F: native.solve_layout(V, F, NONE, native.Parameters()), lambda V, F: native.remesh(V, F, 8.0),
    lambda V, F: native.surface_deviation(V, F, V, F),
    lambda V, F: native.tile_shapes_at(V, F, NONE, native.Parameters())])
def test_meshes(entry, wrong):
    with pytest.raises((native.Error, TypeError, ValueError)):
        entry(*wrong)


@pytest.mark.parametrize("cuts", [None, F, np.array([[0, -1]]), np.array([[0, len(V)]]),
                                  np.array([[np.nan, 1]])])
def test_cuts(cuts):
    with pytest.raises((native.Error, TypeError, ValueError)):
        native.solve_layout(V, F, cuts, native.Parameters())


def test_designs():
    whole = design()
    given = dict(name="cap", parameters=whole.parameters, V=V, F=F, T=whole.T, q=whole.q, cuts=NONE)
    for wrong in (dict(T=whole.T[:-1]), dict(T=put(whole.T, (1, 1, 1), np.nan)), dict(q=whole.T),
                  dict(q=put(whole.q, (0, 0, 0), np.inf)), dict(F=put(F, (0, 0), 99)), dict(parameters=None)):
        with pytest.raises((native.Error, TypeError, ValueError)):
            native.Design(**{**given, **wrong})
    for entry in (native.verify_design, native.make_print_model, native.settle_design):
        with pytest.raises((native.Error, TypeError)):
            entry(None)
    # Pins that are nowhere near their tiles: refused, or worked on to an end.
    strange = native.Design(**{**given, "q": whole.q - 1e5})
    for entry in (native.verify_design, native.evaluate_design, native.make_print_model):
        try:
            entry(strange)
        except native.Error as error:
            assert str(error)


def test_parameters():
    parameters = native.Parameters()
    for name, value in (("L", np.nan), ("L", None), ("L", "x"), ("no such", 1), ("bumps", 3)):
        with pytest.raises((native.Error, TypeError, ValueError)):
            parameters.set(name, value)
