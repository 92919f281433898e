# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each bed takes: hours and money. PrusaSlicer's hours where it is there and the printer lays filament
of one material; else those of the rates in the printer's file."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Callable, Mapping, Optional

from ..base.language import Text
from ..base.native import native
from ..report.shop import is_tilted, tilted_height
from .kit import Kit
from .prices import price

SLICER, RATES = "prusa-slicer", Text("rates of the printer's file")
# These turn off what takes PrusaSlicer 2.5 most of its time: the search for overhanging walls, full
# resolution, and the search for hidden seams. Hours change by less than a hundredth, filament by up to 2 %.
QUICK = ("--no-overhangs", "--resolution", "0.05", "--seam-position", "rear")
MOST_SECONDS, POLL = 300.0, 0.2
_TIME = re.compile(r"; estimated printing time \(normal mode\) = (?:(\d+)d )?(?:(\d+)h )?(?:(\d+)m )?(\d+)s")
_PERCENT = re.compile(r"^(\d{1,2}|100) => ", re.MULTILINE)
_FILAMENT = re.compile(r"; filament used \[cm3\] = ([0-9.]+)")


def costs(kit: Kit) -> list[dict[str, Any]]:
    """Of each bed, for kit.json. Where the slicer fails on a bed, or takes too long for it, those after it go
    by rates as well. Raises Stopped."""
    printer, soluble = kit.printer, native.support_kind(kit.results.parameters).soluble
    slices = not soluble and printer["slicer"] == SLICER
    found, models = [], kit.prints
    for number, model in enumerate(models):
        kit.go_on(number / len(models))
        volumes = {kind: volume / 1000 for kind, volume in model.volumes.items()}
        soft = volumes["support"] if soluble else 0.0
        rigid = sum(volumes[kind] for kind in ("tiles", "support", "anchors")) - soft
        sliced = (_sliced(kit, model, lambda part: kit.go_on((number + part) / len(models))) if slices
                  else None)
        slices = sliced is not None
        high = tilted_height(model.bbox) if is_tilted(kit.results.parameters) else float(model.bbox[2])
        hours, rigid = sliced or (by_rates(high, rigid + soft, printer["rates"]), rigid)
        found.append({"hours": hours, "hours_by": SLICER if sliced else RATES,
                      "rigid_cm3": rigid, "support_cm3": soft, "currency": printer["prices"]["currency"],
                      "price": price(hours, rigid, soft, printer["prices"])})
    return found


def by_rates(height: float, volume: float, rates: Mapping[str, float]) -> float:
    """Hours for a print so high (mm) of so much material (cm3)."""
    return rates["hours"] + height * rates["hours_per_mm"] + volume * rates["hours_per_cm3"]


def _sliced(kit: Kit, model: Any, go_on: Callable[[float], object]) -> Optional[tuple[float, float]]:
    """Hours and cm3 of filament; None without the slicer, or where it fails. go_on: called with how much is
    done; raises Stopped."""
    if not shutil.which(SLICER):
        return None
    bed, layer = kit.printer["bed_mm"], kit.printer["layer_mm"]
    with tempfile.TemporaryDirectory() as folder:
        code, said = Path(folder) / "a.gcode", Path(folder) / "said"
        (Path(folder) / "a.stl").write_bytes(kit.shell(model))
        try:
            with said.open("wb") as output:
                running = subprocess.Popen(
                    [SLICER, "--datadir", folder, "--export-gcode", "--layer-height", str(layer),
                     "--first-layer-height", str(layer),
                     "--bed-shape", f"0x0,{bed[0]}x0,{bed[0]}x{bed[1]},0x{bed[1]}",
                     "--support-material", "--support-material-buildplate-only", *QUICK,
                     "--output", str(code), "a.stl"], cwd=folder, stdout=output, stderr=subprocess.DEVNULL)
            try:
                _await(running, said, go_on)
            finally:
                running.kill()
                running.wait()
            return read_gcode(code.read_text("utf-8", errors="replace"))
        except OSError:
            return None


def _await(running: subprocess.Popen[bytes], said: Path, go_on: Callable[[float], object]) -> None:
    """Until the slicer ends, at most a while. said: what it prints. Raises Stopped."""
    for _ in range(int(MOST_SECONDS / POLL)):
        go_on(progress_of(said.read_text("utf-8", errors="replace")))
        try:
            running.wait(POLL)
            return
        except subprocess.TimeoutExpired:
            continue


def progress_of(text: str) -> float:
    """How much PrusaSlicer has done, 0 to 1, by the lines that it prints: 20 => Generating perimeters."""
    return max((int(percent) / 100 for percent in _PERCENT.findall(text)), default=0.0)


def read_gcode(text: str) -> Optional[tuple[float, float]]:
    """Hours and cm3 of filament by what PrusaSlicer writes about a print; None where it wrote none."""
    time, filament = _TIME.search(text), _FILAMENT.search(text)
    if not time or not filament:
        return None
    days, hours, minutes, seconds = (float(one or 0) for one in time.groups())
    return 24 * days + hours + minutes / 60 + seconds / 3600, float(filament[1])
