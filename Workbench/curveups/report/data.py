# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.json: the format that print shops and scripts read. Blocks of stages not run are absent."""

from __future__ import annotations

import json
import math
import resource
from typing import Any, Sequence

import numpy as np

from .. import __version__
from ..project.project import Results
from ..stages.stage import Row

FORMAT, VERSION = "curveups-report", 1


def build_report(results: Results, rows: Sequence[Row], stopped: bool, files: dict[str, int],
                 software: dict[str, str]) -> dict:
    """The report on the results of a run. files: sizes in bytes of the files written; files that are written
    later and added to it are in the report, too."""
    verdict = results.verdict
    report: dict[str, Any] = {
        "format": FORMAT, "version": VERSION, "name": results.name, "title": results.title,
        "status": "stopped" if stopped else "complete",
        "tiles": 0, "contacts": 0, "cuts": 0, "valid": verdict.valid, "holds": verdict.holds,
        "reasons": list(map(str, verdict.reasons)),
        "causes": [{"kind": reason.group, "tiles": list(reason.tiles)} for reason in verdict.reasons],
        "warnings": [warning.entry() for warning in results.warnings()],
        "front": "the side that the normals of F point to; counter-clockwise seen from there",
    }
    checked = results.get("check")
    if checked is None or not checked.print_block:
        report["not_covered"] = ["soundness of solids, support and anchors: they were not looked at",
                                 "what the printer can make: that is looked at on the solids"]
    for result in results.values():
        for name, block in result.report().items():
            report[name] = {**report[name], **block} if isinstance(report.get(name), dict) else block
    if "print" in report:
        report["print"]["files"] = files
    report["stages"] = [{"name": row.name, "seconds": round(row.seconds, 3),
                         "iterations": int(row.iterations)} for row in rows]
    report["peak_memory_mb"] = round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024, 1)
    report["software"] = {"curveups": __version__, **software}
    return report


def has_solids(results: Results) -> bool:
    """True if there are bodies to be written."""
    return "check" in results and results["bodies"].model is not None


def to_text(report: dict) -> str:
    """JSON without numbers that are no numbers."""
    return json.dumps(_finite(report), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(item) for item in value]
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not math.isfinite(value) else value


def show(value: Any) -> str:
    """A value in few digits."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}" if abs(value) < 1e5 else f"{value:.0f}"
    if isinstance(value, (list, tuple)):
        return ", ".join(show(item) for item in value)
    return str(value)
