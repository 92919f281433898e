# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the membranes of an overlay when they are needed."""

from __future__ import annotations

from typing import Any

from ..notice import errors_shown
from ..overlays import overlay_of
from ..qt import translate
from ..run import LIVE, Task
from .scene import membranes_of


def compute(overlay: Any) -> None:
    """Starts the run; the overlay shows what it has made."""
    title = translate("CurveUps_Overlay", "Membranes")
    with errors_shown(title):
        design = overlay.design()
        LIVE.start(overlay.object, Task(title, lambda job: membranes_of(design, job),
                                        lambda obj, membranes: overlay_of(obj).show_membranes(membranes)))
