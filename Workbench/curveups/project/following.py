# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of a project that carry the tiles of an earlier design along."""

from __future__ import annotations

from dataclasses import replace

from ..stages.following import Earlier, carried_cuts
from ..stages.stage import Job
from .project import Project


def carry_along(project: Project, earlier: Earlier, job: Job, with_cuts: bool = True) -> None:
    """Make a project's target by carrying tiles along, and give it their cuts. Raises CurveUpsError, and
    Stopped."""
    project.give("source", replace(project.latest("source"), follows=earlier))
    target = project.run(("target",), job)["target"]
    if with_cuts and len(earlier.cuts):
        project.give("cut request", carried_cuts(target.followed, project.where))
