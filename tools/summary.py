# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists what a finished run made, in a few lines: `tools/summary.py DIR`. Called by tools/demo."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from curveups.project.project import Verdict


def summary(folder: Path) -> str:
    """Verdict, figures and files of the run in `folder`."""
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    verdict = Verdict(report["valid"], holds=report.get("holds"))
    area = report["area"]
    lines = [f"{report['name']}: {report['tiles']} tiles, {report['contacts']} contacts, {verdict.word}"]
    lines += [f"  {reason}" for reason in report["reasons"]]
    lines.append(f"area {area['actuated_cm2']:.1f} cm2 actuated, {area['flat_cm2']:.1f} cm2 flat "
                 f"(ratio {area['ratio']:.2f})")
    if report["warnings"]:
        lines.append(f"{len(report['warnings'])} warnings: see report.html")
    stages = ", ".join(f"{s['name']} {s['seconds']:.2f} s" for s in report["stages"])
    lines += [stages, f"files in {folder}:"]
    for path in sorted(folder.iterdir()):
        lines.append(f"  {path.stat().st_size:>12,}  {path.name}")
    return "\n".join(lines)


if __name__ == "__main__":
    print(summary(Path(sys.argv[1])))
