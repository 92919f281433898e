# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of the membranes' stretch says what the membranes do."""

import io

import numpy as np
import pytest

from curveups.base.native import native
from curveups.project.project import Project
from curveups.report import html, pictures
from curveups.report.data import build_report
from curveups.stages import verification
from matplotlib.colors import to_rgb
from matplotlib.image import imread
from PIL import Image


def strip(stretch, tension):
    """A row of squares of 10 mm, each of two triangles."""
    flat = np.array([[10.0 * k, y] for k in range(len(stretch) + 1) for y in (0.0, 10.0)])
    triangles = [t for k in range(len(stretch)) for t in
                 ([2 * k, 2 * k + 2, 2 * k + 1], [2 * k + 1, 2 * k + 2, 2 * k + 3])]
    larger = np.repeat(stretch, 2)
    return {"flat": flat, "triangles": np.array(triangles),
            "stretch": np.column_stack([larger, 0.5 * larger]), "tension": np.repeat(tension, 2)}


def share(image, colour):
    """The share of pixels of a colour."""
    return float((np.abs(image[..., :3] - np.array(to_rgb(colour))).max(axis=2) < 0.02).mean())


@pytest.fixture(scope="module")
def image():
    def draw(*sides):
        return imread(io.BytesIO(pictures.stretch_view(sides)))

    return draw


def test_stretch_becomes_colour_and_slack_is_marked(image):
    taut = strip([2.0, 2.0, 3.0, 3.0], [0, 0, 0, 0])
    low, high = "#440154", "#fde725"  # the ends of the colours' scale
    even = image(taut, taut)
    assert share(even, low) > 0.05 and share(even, high) > 0.05
    assert share(even, low) == pytest.approx(share(even, high), rel=0.15)
    assert share(even, pictures.LOOSE) < 1e-3
    # The slack half takes no part in the scale, and all colours shown are those of the other half.
    slack = image(strip([2.0, 3.0, 1.0, 0.5], [0, 0, 2, 2]), taut)
    assert share(slack, pictures.LOOSE) > 0.05
    wrinkled = image(strip([2.0, 2.0, 3.0, 3.0], [1, 0, 0, 0]), taut)
    tinted = 0.5 * (np.array(to_rgb(low)) + np.array(to_rgb(pictures.WRINKLE)))
    assert share(wrinkled, tinted) > 0.02 > 10 * share(even, tinted)


def test_a_membrane_that_is_slack_all_over_is_drawn(image):
    grey = strip([0.9, 0.8], [2, 2])
    assert share(image(grey, grey), pictures.LOOSE) > 0.1


def test_the_page_shows_both_membranes_where_they_were_computed(designed):
    design = native.read_design((designed.folder / "design.json").read_text("utf-8"))
    results = Project.of_design(design).run(("figures", "verification"))
    found = results["verification"]
    page = html.build_html(results, {**build_report(results, [], False, {}, {}), "warnings": []})
    assert "<h2>Membranes</h2>" in page and "data:image/png;base64," in page
    assert f"stretched by {found.blocks['physics']['stretch_99']:.4g} at most" in page
    assert [p.heading for p in found.pictures()] == ["Contact forces", "", "Membranes"]
    assert verification.Verification(note="verification was off").pictures() == ()
    assert "<h2>Membranes</h2>" in (designed.folder / "report.html").read_text(encoding="utf-8")


def test_colours_that_stand_for_values_are_kept(designed):
    """A palette put steps and a wrong stripe into scales of colours."""
    design = native.read_design((designed.folder / "design.json").read_text("utf-8"))
    scaled, plain = (Image.open(io.BytesIO(pictures.flat_layout(design, values)))
                     for values in (np.linspace(0, 1, len(design.T)), None))
    assert (scaled.mode, plain.mode) == ("RGB", "P")
    ends = [to_rgb(colour) for colour in ("#440154", "#fde725")]  # of viridis
    for one, colours, within in ((scaled, ends, 2), (plain, [to_rgb(pictures.BODY)], 10)):
        drawn = np.array([colour for _, colour in one.convert("RGB").getcolors(1 << 24)])
        for colour in colours:
            assert np.abs(drawn - 255 * np.array(colour)).max(axis=1).min() < within
