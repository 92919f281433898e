# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of Solve, Verify, Repair and Build Solids."""

from __future__ import annotations

from typing import Any

from ..panels.panel import show
from ..panels.solve import SolvePanel
from .command import PanelCommand


class RunCommand(PanelCommand):
    """A command that opens the design's panel and starts a run."""

    panel = SolvePanel

    def work(self, design: Any) -> None:
        show(SolvePanel, design).run(self.which)
