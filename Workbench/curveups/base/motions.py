# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rigid motions that fit points."""

from __future__ import annotations

import numpy as np


from typing import Optional


def rigid_motion(source: np.ndarray, target: np.ndarray, weight: Optional[np.ndarray] = None
                 ) -> tuple[np.ndarray, np.ndarray]:
    """R, t with the least sum of squares of R x + t - y over pairs of points, n x 3 (Kabsch, Acta
    Cryst. A 32, 1976). weight: of each pair; all alike."""
    w = np.full(len(source), 1.0) if weight is None else weight
    a, b = w @ source / w.sum(), w @ target / w.sum()
    u, _, vt = np.linalg.svd((w[:, None] * (target - b)).T @ (source - a))
    R = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    return R, b - R @ a
