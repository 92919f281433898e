# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid motions that fit points."""

from __future__ import annotations

import numpy as np


def rigid_motion(source: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """R, t with the least sum of squares of R x + t - y over pairs of points, n x 3 (Kabsch, Acta
    Cryst. A 32, 1976)."""
    a, b = source.mean(0), target.mean(0)
    u, _, vt = np.linalg.svd((target - b).T @ (source - a))
    R = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    return R, b - R @ a
