# SPDX-License-Identifier: LGPL-2.1-or-later
"""Base of Solve, Verify, Repair and Build Solids."""

from __future__ import annotations

from typing import Any

from ..panels.solve import open_panel
from ..runs import reason
from ..selection import chosen_design
from .command import DesignCommand


class RunCommand(DesignCommand):
    """A command that opens the design's panel and starts a run."""

    which = ""

    def reason(self) -> str:
        design = chosen_design()
        return super().reason() or reason(self.which, design)

    def work(self, design: Any) -> None:
        open_panel(design).run(self.which)
