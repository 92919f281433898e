# SPDX-License-Identifier: LGPL-2.1-or-later
"""The print shop's page: rules, what to quote by, files, and a picture of all that is printed."""

from __future__ import annotations

from ..base.language import Text
from ..report.print_pictures import draw_print
from ..report.shop import quote, rules
from .drawing import BORDER, PAPERS, saved, sheet, write
from .kit import Kit

LABELS = 48.0  # mm, width of the column of labels
MOST_REASONS = 3


def make(kit: Kit) -> bytes:
    """A PDF of one page."""
    width, height = PAPERS["A4"]
    figure, page = sheet(width, height)
    parameters, say = kit.results.parameters, kit.say
    top = write(page, BORDER, height - BORDER, [say("{title}: order for a 3D print", title=kit.title)], 15)
    said = (*_doubts(kit), *rules(kit.report, parameters, say))
    top = write(page, BORDER, top - 1, [f"•  {rule}" for rule in said], 9.5) - 1
    for label, value in quote(kit.report, parameters, kit.quantity, say, kit.whole):
        page.plot([BORDER, width - BORDER], [top - 0.4] * 2, color="#cccccc", linewidth=0.4)
        top = min(write(page, BORDER, top, [label], 8, LABELS - 2),
                  write(page, BORDER + LABELS, top, [value], 8))
    notes = [say(text) for ending, text in _FILES.items() if any(name.endswith(ending) for name in kit.files)]
    top = write(page, BORDER, top - 1, [*notes, say("Files, in mm, with bytes and SHA-256:")], 8)
    for name, about in kit.files.items():
        top = write(page, BORDER, top, [f"{name}   {about['bytes']}   {about['sha256']}"], 5.5)
    room = top - BORDER
    axes = figure.add_axes([BORDER / width, BORDER / height, 1 - 2 * BORDER / width, room / height])
    draw_print(axes, *kit.drawn, say)
    return saved(figure, "pdf")


_FILES = {
    "prusa.3mf": Text("For PrusaSlicer there is the same as -prusa.3mf, with an extruder for each material."),
    "-fused.stl": Text("""Where bodies must not overlap, there is the same as one closed shell a piece:
-fused.stl and -fused.3mf.""")}


def _doubts(kit: Kit) -> list[str]:
    """Why nobody should print it; none where the design is valid."""
    if kit.report["valid"]:
        return []
    why = kit.say("Do not order it as it is: the design is not valid.") if kit.report["valid"] is False else \
        kit.say("Do not order it as it is: the design is not verified.")
    reasons = kit.results.verdict.reasons[:MOST_REASONS]
    return [why, *(reason.sentence(kit.say.style) for reason in reasons)]
