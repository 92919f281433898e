# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares a scanned piece with its design: a mesh, a cloud of points, or markers of tiles. Deviations are
distances of scanned points from the design's actuated front faces."""

from __future__ import annotations

import json
import re
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..base.errors import CurveUpsError, tile_name
from ..base.native import native
from ..base.output import Folder
from ..report import html
from ..report.data import to_text
from ..stages.stage import Job, Picture
from ..targets.target_files import read_target

FORMAT, VERSION = "curveups-compare", 1
POINTS = (".xyz", ".txt", ".csv")
LEAST = 12        # points or markers that a registration needs
MOST = 1_000_000  # points
PER_TILE = 3      # points of a tile, for a figure of its own
SAMPLED = 20      # points of a tile that a coarse mesh gives
SCANNED = ("mean_mm", "rms_mm", "p95_mm", "max_mm", "hausdorff_mm")
FILES = ("compare.json", "compare.html", "deviation.csv")


@dataclass(frozen=True)
class Scan:
    """points: n x 3, mm. tiles: row of F of each marker; empty if the points are no markers."""

    points: np.ndarray
    tiles: np.ndarray


def read_scan(path: Path, tile_count: int) -> Scan:
    """Reads corners of a mesh, and points on the faces of a coarse one, or a text with a point a line, "x y
    z". With a tile's name before it, "T00012 x y z", a point is a marker on the middle of that tile's
    front."""
    if path.suffix.lower() not in POINTS:
        if not path.exists():  # a target's reader would offer built-ins
            raise CurveUpsError("the scan can't be read: there is no such file", str(path), "check its name")
        read = read_target(path, 0.1)
        points, tiles = read.V[np.unique(read.F)], np.zeros(0, int)
        if len(points) < SAMPLED * tile_count:
            points = np.concatenate([points, _samples(read.V, read.F, SAMPLED * tile_count)])
    else:
        points, tiles = _read_points(path, tile_count)
    if len(points) < LEAST or np.linalg.matrix_rank(points - points.mean(0), tol=1e-3) < 2:
        raise CurveUpsError(f"{len(points)} points can't be laid onto a surface", str(path),
                            f"give {LEAST} or more that are not on a line")
    if len(points) > MOST:
        raise CurveUpsError(f"the scan has more than {MOST} points", str(path), "thin it out")
    return Scan(points, tiles)


def _samples(V: np.ndarray, F: np.ndarray, count: int) -> np.ndarray:
    """Points spread evenly over the faces of a mesh."""
    corners = V[F]
    out = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.cumsum(np.linalg.norm(out, axis=1))
    picked = np.searchsorted(area, (np.arange(count) + 0.5) / count * area[-1])
    s, t = np.random.default_rng(0).random((2, count))
    s, t = np.where(s + t > 1, (1 - s, 1 - t), (s, t))
    a, b, c = corners[np.minimum(picked, len(F) - 1)].transpose(1, 0, 2)
    return np.asarray(a + s[:, None] * (b - a) + t[:, None] * (c - a))


def _read_points(path: Path, tile_count: int) -> tuple[np.ndarray, np.ndarray]:
    try:
        text = path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise CurveUpsError(f"the scan can't be read: {error.strerror}", str(path),
                            "check its name and permissions") from None
    except ValueError:
        raise CurveUpsError("the scan is no text", str(path), "give points, one a line") from None
    rows = {tile_name(row): row for row in range(tile_count)}
    points, tiles = [], []
    for number, line in enumerate(text.splitlines(), 1):
        words = re.split(r"[\s,;]+", line.split("#")[0].strip())
        if words == [""]:
            continue
        marker = words[0].startswith("T")
        try:
            if marker:
                tiles.append(rows[words[0]])
            point = [float(word) for word in words[marker:][:3]]
            if len(point) < 3 or not np.isfinite(point).all():
                raise ValueError
        except (KeyError, ValueError):
            raise CurveUpsError(f"'{line[:60]}' is no point of a scan", f"{path}, line {number}",
                                "give x y z in mm, of markers with the tile's name before it") from None
        points.append(point)
    if tiles and len(tiles) < len(points):
        raise CurveUpsError("some points have a tile's name and others have none", str(path),
                            "name the tiles of all markers, or of none")
    return np.array(points, float).reshape(-1, 3), np.array(tiles, int)


def compare(design: Any, scan: Scan, job: Job) -> dict[str, Any]:
    """compare.json; "points" in it, for the other files: x, y, z and the deviation, mm."""
    from scipy.spatial import cKDTree  # which other commands would pay

    V, F = np.asarray(design.V), np.asarray(design.F)
    markers = len(scan.tiles) > 0
    if markers:
        targets = V[F].mean(1)[scan.tiles]
        laid = native.register_markers(scan.points, targets)
    else:
        laid = native.register_scan(scan.points, V, F, native.mean_edge_length(V, F), job)
    points = scan.points @ laid.R.T + laid.t
    if markers:
        owners, away = scan.tiles, np.linalg.norm(points - targets, axis=1)
    else:
        owners, away = native.closest_points(points, V, F)[1], native.distances(points, V, F)
    corners = V[F[owners]]
    out = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    signed = np.copysign(away, ((points - corners[:, 0]) * out).sum(1))
    back = cKDTree(points).query(V[F].mean(1))[0]
    counts = np.bincount(owners, minlength=len(F))
    turn_fixed = not laid.other_turns
    comparison = {
        "format": FORMAT, "version": VERSION, "name": design.name,
        "by": "markers" if markers else "surface", "points_given": len(points),
        "transform": np.vstack([np.c_[laid.R, laid.t], [0, 0, 0, 1]]).tolist(),
        "pose": {"noise_mm": laid.noise, "loss_mm": laid.loss_scale,
                 "rotation_sd_deg": np.degrees(laid.rotation_deviation).tolist(),
                 "translation_sd_mm": laid.translation_deviation.tolist()},
        "turn_fixed": turn_fixed, "other_turns": laid.other_turns,
        "deviation": {"mean_mm": float(away.mean()), "signed_mean_mm": float(signed.mean()),
                      "rms_mm": float(np.sqrt((away ** 2).mean())),
                      **{f"p{share}_mm": float(np.percentile(away, share)) for share in (50, 90, 95, 99)},
                      "max_mm": float(away.max()), "hausdorff_mm": float(max(away.max(), back.max()))},
        "covered": float((counts > 0).mean()), "points": np.c_[points, signed]}
    if turn_fixed:
        of_tile = np.split(signed[np.argsort(owners, kind="stable")], np.cumsum(counts)[:-1])
        comparison["tiles"] = [{"tile": tile_name(row), "median_mm": float(np.median(of_tile[row])),
                                "points": int(counts[row])}
                               for row in np.flatnonzero(counts >= (1 if markers else PER_TILE))]
    return comparison


def predictions(path: Path, tiles: int) -> dict[str, Any]:
    """Deviation and open contacts that files beside a design (design.json) predict: by settled forces
    (report.json), and as it is built, after shaking (actuation.json); without those that are damaged or not
    of this design."""
    size, blocks = path.stat().st_size, {}
    report, path_from_flat = (_read(path.parent / name) for name in ("report.json", "actuation.json"))
    with suppress(LookupError, TypeError, ValueError, OverflowError, AttributeError):
        if report.get("print", {}).get("files", {}).get(path.name, size) == size:
            blocks["predicted"] = _prediction(report["settled"]["scan"], report["settled"]["open_contacts"])
    with suppress(LookupError, TypeError, ValueError, OverflowError):
        shaken = path_from_flat["actuation"]["shaken"]
        if path_from_flat["tiles"] == tiles:
            blocks["built"] = _prediction({name: shaken[name] for name in SCANNED}, shaken["open_contacts"])
    return blocks


def _read(path: Path) -> dict[str, Any]:
    try:
        return dict(json.loads(path.read_text("utf-8")))
    except (OSError, ValueError, TypeError, RecursionError):
        return {}


def _prediction(deviation: dict[str, Any], contacts: list[list[int]]) -> dict[str, Any]:
    values = {name: float(deviation[name]) for name in SCANNED}
    if not np.isfinite([*values.values()]).all():
        raise ValueError
    return {"deviation": values, "open": [[int(a), int(b)] for a, b in contacts]}


def write_comparison(design: Any, comparison: dict[str, Any], path: Path) -> None:
    """compare.json comes last."""
    rows = comparison.pop("points")
    with Folder(path) as folder:
        folder.remove(*FILES)
        folder.write_text("deviation.csv", "x,y,z,deviation_mm\n" + "".join(
            "%.4f,%.4f,%.4f,%.4f\n" % tuple(row) for row in rows.tolist()))
        folder.write_text("compare.html", _page(design, comparison))
        folder.write_text("compare.json", to_text(comparison))


def summary(comparison: dict[str, Any]) -> list[str]:
    """Lines for a terminal and the page."""
    block = comparison["deviation"]
    lines = [f"mean {block['mean_mm']:.3f} mm, RMS {block['rms_mm']:.3f} mm, 95 % below "
             f"{block['p95_mm']:.3f} mm, largest {block['max_mm']:.3f} mm, Hausdorff "
             f"{block['hausdorff_mm']:.3f} mm",
             f"{comparison['points_given']} points cover {100 * comparison['covered']:.0f} % of the tiles"]
    pose = comparison["pose"]
    lines.append(f"the pose is certain to {max(pose['translation_sd_mm']):.2g} mm and "
                 f"{max(pose['rotation_sd_deg']):.2g} deg (standard deviations, for independent noise of "
                 f"{pose['noise_mm']:.2g} mm)")
    for name, by in (("predicted", "settled forces predict"), ("built", "the shape after shaking predicts")):
        if name in comparison:
            block = comparison[name]
            lines.append(f"{by}: mean {block['deviation']['mean_mm']:.3f} mm, largest "
                         f"{block['deviation']['max_mm']:.3f} mm, open contacts: {_pairs(block['open'])}")
    if not comparison["turn_fixed"]:
        lines.append("the shape does not fix how the scan is turned: "
                     f"{comparison['other_turns']} other turns or more fit as well, so there is nothing to "
                     "say of single tiles; mark some tiles, and give the markers")
    return lines


def _pairs(rows: list[list[int]]) -> str:
    names = ["-".join(map(tile_name, row)) for row in rows[:8]]
    return ", ".join(names + [f"and {len(rows) - 8} more"] * (len(rows) > 8)) or "none"


def _page(design: Any, comparison: dict[str, Any]) -> str:
    expected = [comparison.get(name, {}).get("deviation", {}) for name in ("predicted", "built")]
    picture = None
    if comparison["turn_fixed"]:
        values = np.full(len(design.F), np.nan)
        for tile in comparison["tiles"]:
            values[int(tile["tile"][1:]) - 1] = tile["median_mm"]
        picture = Picture("", "Median deviation of each tile, on the flat layout. Tiles without colour have "
                          "no points.", "pictures.flat_layout",
                          {"design": design, "values": values, "label": "median deviation, mm"})
    rows = [(html.words(name[:-3]) + ", mm", f"{value:.4f}", *(block.get(name) for block in expected))
            for name, value in comparison["deviation"].items()]
    return html.render("compare.html", title=f"{design.name}: scan beside the design",
                       lines=summary(comparison), rows=rows, picture=picture)
