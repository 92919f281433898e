# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets that need cuts: a closed sphere, a deep vase, a closed body with limbs, a ring."""

import itertools
import math

import numpy as np


def sphere(radius=40.0, spacing=2.0):
    """V and F of a closed sphere, normals outward."""
    return implicit_surface(lambda p: np.linalg.norm(p, axis=-1) - radius,
                            (-radius, -radius, -radius), (radius, radius, radius), spacing)


def ring(large=34.0, small=14.0, spacing=2.0):
    """A closed torus: one handle."""
    def distance(p):
        return np.hypot(np.hypot(p[..., 0], p[..., 1]) - large, p[..., 2]) - small

    reach = large + small
    return implicit_surface(distance, (-reach, -reach, -small), (reach, reach, small), spacing)


def vase(spacing=2.0):
    """A vase 130 mm deep, open at the top: a surface of revolution with a round bottom."""
    # Polar angles of the bottom, then the wall's radius by height: belly, neck and lip.
    bottom = [(24 * math.sin(t), 24 - 24 * math.cos(t)) for t in np.linspace(0, math.pi / 2, 24)]
    heights = np.linspace(24, 130, 70)[1:]
    wall = [(24 + 11 * math.sin(math.pi * (h - 24) / 70) ** 2 * (h < 94)
             - 0.5 * (1 - math.cos(math.pi * max(0.0, h - 94) / 36)) * -6.0, h) for h in heights]
    return revolved(np.array(bottom + wall), round(2 * math.pi * 30 / spacing))


def revolved(profile, around):
    """The profile (radius, height) turned about z, its first point on the axis; normals away from
    the axis."""
    angles = 2 * math.pi * np.arange(around) / around
    V = [[0.0, 0.0, profile[0][1]]]
    for r, h in profile[1:]:
        V += [[r * math.cos(t), r * math.sin(t), h] for t in angles]

    def at(row, k):
        return 0 if row == 0 else 1 + (row - 1) * around + k % around

    F = [[0, at(1, k + 1), at(1, k)] for k in range(around)]
    for row in range(1, len(profile) - 1):
        for k in range(around):
            F += [[at(row, k), at(row, k + 1), at(row + 1, k + 1)],
                  [at(row, k), at(row + 1, k + 1), at(row + 1, k)]]
    return np.array(V), np.array(F, np.int32)


def implicit_surface(distance, low, high, spacing):
    """V and F of the surface distance(points) = 0, negative inside: marching tetrahedra on a cubic grid of
    about `spacing`, closed if the surface lies inside the box."""
    low, high = np.array(low, float) - 2.1 * spacing, np.array(high, float) + 2.1 * spacing
    count = np.ceil((high - low) / spacing).astype(int) + 1
    grid = np.stack(np.meshgrid(*(low[k] + spacing * np.arange(count[k]) for k in range(3)),
                                indexing="ij"), axis=-1).reshape(-1, 3)
    value = np.asarray(distance(grid))
    value = np.where(value == 0, 1e-12, value)  # no vertex of the grid lies on the surface
    # Six tetrahedra around the diagonal of each cube, the same in all: faces match.
    step = np.array([count[1] * count[2], count[2], 1])
    cubes = np.stack(np.meshgrid(*(np.arange(n - 1) for n in count), indexing="ij"),
                     axis=-1).reshape(-1, 3) @ step
    paths = [np.cumsum([0] + [step[k] for k in order])
             for order in itertools.permutations(range(3))]
    tetrahedra = np.concatenate([cubes[:, None] + path for path in paths])
    inside = value[tetrahedra] < 0
    number = inside.sum(1)
    faces, towards = [], []
    for count_inside in (1, 2, 3):
        chosen = tetrahedra[number == count_inside]
        order = np.argsort(~inside[number == count_inside], axis=1, kind="stable")
        corner = np.take_along_axis(chosen, order, axis=1)  # those inside first
        a, b, c, d = corner.T
        if count_inside == 2:
            loops = [((a, c), (a, d), (b, d)), ((a, c), (b, d), (b, c))]
        elif count_inside == 1:
            loops = [((a, b), (a, c), (a, d))]
        else:
            loops = [((a, d), (b, d), (c, d))]
        for loop in loops:
            faces.append(np.stack([np.sort(np.stack(pair, 1), 1) for pair in loop], 1))
            towards.append(grid[corner[:, count_inside:]].mean(1)
                           - grid[corner[:, :count_inside]].mean(1))
    crossed, index = np.unique(np.concatenate(faces).reshape(-1, 2), axis=0, return_inverse=True)
    F = index.reshape(-1, 3)
    t = value[crossed[:, 0]] / (value[crossed[:, 0]] - value[crossed[:, 1]])
    V = grid[crossed[:, 0]] + t[:, None] * (grid[crossed[:, 1]] - grid[crossed[:, 0]])
    normal = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
    backward = np.einsum("fk,fk->f", normal, np.concatenate(towards)) < 0
    F[backward] = F[backward][:, ::-1]
    return V, F.astype(np.int32)


def obj_text(V, F):
    """The surface as an OBJ file."""
    return "".join(f"v {float(x)!r} {float(y)!r} {float(z)!r}\n" for x, y, z in V) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in F)
