# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths between clicks, on a flat grid of squares with one diagonal each."""

import numpy as np
import pytest

from curveups.window.cut_paths import CutPaths, groups


@pytest.fixture
def grid():
    """5 x 5 vertices, numbered by rows; diagonals from lower left to upper right."""
    n = 5
    V = np.array([[x, y, 0] for y in range(n) for x in range(n)], float)
    F = []
    for y in range(n - 1):
        for x in range(n - 1):
            a, b, c, d = n * y + x, n * y + x + 1, n * y + x + n, n * y + x + n + 1
            F += [[a, b, d], [a, d, c]]
    return CutPaths(V, np.array(F, np.int32))


def test_the_first_click_cuts_its_edge_and_goes_on_from_its_second_vertex(grid):
    assert grid.reach((12, 13)) == ([(12, 13)], 13)
    assert grid.reach((13, 12)) == ([(12, 13)], 12)


def test_the_next_click_goes_on_along_the_shortest_path(grid):
    edges, tip = grid.reach((22, 17), tip=6)  # 6 is (1, 1); 17 (2, 3) is nearer than 22 (2, 4) on the rim
    assert tip == 22
    assert edges[-1] == (17, 22)
    ends = [v for edge in edges for v in edge]
    assert ends.count(6) == 1 and all(ends.count(v) == 2 for v in set(ends) - {6, 22})
    assert grid.length(edges) == pytest.approx(2 + np.sqrt(2))


def test_a_neighbouring_edge_needs_no_path(grid):
    assert grid.reach((13, 12), tip=12) == ([(12, 13)], 13)


def test_edges_of_the_rim_end_a_path_and_are_not_cut(grid):
    edges, tip = grid.reach((1, 2), tip=7)
    assert edges == [(2, 7)] and tip == 2
    assert grid.reach((1, 2)) == ([], 2)


def test_cuts_that_hang_together_are_one(grid):
    assert groups([(3, 2), (7, 8), (2, 1), (8, 9)]) == [[(2, 3), (1, 2)], [(7, 8), (8, 9)]]
    assert groups([]) == []
