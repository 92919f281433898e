# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures inside of files, as another library reads them."""

import io
import zipfile
from xml.etree import ElementTree

import numpy as np
from matplotlib.image import imread

from curveups.base.native import native

KIND = "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"
GROUND = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
UP = np.array([[0, 1, 2], [0, 2, 3]])


def pixels(png):
    """256 x 256 colours with alpha, 0 to 255."""
    found = (imread(io.BytesIO(png)) * 255).round().astype(int)
    assert found.shape == (256, 256, 4)
    return found


def colours(png):
    return {tuple(one[:3]) for one in pixels(png)[pixels(png)[..., 3] == 255]}


def test_a_level_square_is_a_parallelogram_of_one_colour():
    found = pixels(native.draw_thumbnail(GROUND, UP))
    turn, tilt = np.radians(20), np.radians(50)
    width = np.cos(turn) + np.sin(turn)  # of the picture's larger side, which is filled to 0.92
    share = 0.92 ** 2 * np.cos(tilt) / width ** 2
    assert abs((found[..., 3] / 255).mean() - share) < 2e-3
    rows, columns = np.nonzero(found[..., 3])
    assert abs(np.ptp(columns) + 1 - 0.92 * 256) <= 1.5
    assert abs(np.ptp(rows) + 1 - 0.92 * 256 * np.cos(tilt)) <= 1.5
    light = np.array([-0.35, -0.45, 0.82])
    shade = 0.35 + 0.65 * light[2] / np.linalg.norm(light)
    (colour,) = {tuple(one[:3]) for one in found[found[..., 3] == 255]}
    assert np.abs(np.array(colour) - shade * np.array(native.COLOURS["tiles"])).max() <= 1


def test_what_lies_above_hides_what_lies_below():
    """Whichever comes first. The upper square hangs over the lower one, as seen."""
    above = GROUND @ np.diag([1, 1, 0]) + [0, -0.2, 1]
    tilted = GROUND @ np.array([[1, 0, 0], [0, 1, 0.5], [0, 0, 0]]) + [0, 0, -1]
    both = [np.vstack([above, tilted]), np.vstack([tilted, above])]
    one, other = (native.draw_thumbnail(V, np.vstack([UP, UP + 4])) for V in both)
    assert one == other and len(colours(one)) == 2


def test_a_surface_of_no_area_has_a_picture_of_nothing():
    assert not pixels(native.draw_thumbnail(GROUND @ np.diag([1, 0, 0]) + np.arange(4)[:, None] * 1e-12,
                                            UP))[..., 3].any()


def test_a_3mf_shows_what_it_prints(printed):
    """The thumbnail is of the package, as the format wants it, and has the colours of three kinds."""
    with zipfile.ZipFile(printed.folder / "small-cap-print.3mf") as archive:
        related = {one.get("Type"): one.get("Target")
                   for one in ElementTree.fromstring(archive.read("_rels/.rels"))}
        png = archive.read(related[KIND].lstrip("/"))
        types = ElementTree.fromstring(archive.read("[Content_Types].xml"))
        assert ("thumbnail", "image/png") in {(one.get("Extension"), one.get("ContentType")) for one in types}
    seen = colours(png)
    assert len(seen) > 20
    for kind in ("tiles", "support", "anchors"):
        hue = np.array(native.COLOURS[kind]) / max(native.COLOURS[kind])
        assert any(np.abs(np.array(one) / max(one) - hue).max() < 0.02 for one in seen), kind
