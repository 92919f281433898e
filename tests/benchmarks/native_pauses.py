# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long native calls are silent, and how soon they end once they are told to: a line per call.

    python tests/benchmarks/native_pauses.py DESIGN.json [FACETS]

DESIGN.json: of some 2500 tiles, say. FACETS: of the surface that is remeshed and compared, about.
Columns: seconds in all, longest time between two calls of progress, longest time from a stop to the
end (of three, after a fifth, a half and four fifths of the time)."""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Workbench"))

from curveups.base.native import native  # noqa: E402

Call = Callable[[Callable[[str, float], bool]], Any]


class Sink:
    """Progress that times the silence, and stops the work after so many seconds."""

    def __init__(self, stop_after: float = float("inf")):
        self.begun = self.last = time.perf_counter()
        self.stop_after, self.stopped = stop_after, 0.0
        self.longest, self.where, self._said = 0.0, "", "the beginning"

    def __call__(self, what: str, fraction: float) -> bool:
        now = time.perf_counter()
        if now - self.last > self.longest:
            self.longest, self.where = now - self.last, f"{self._said} .. {what}"
        self.last, self._said = now, what
        if now - self.begun > self.stop_after and not self.stopped:
            self.stopped = now
        return not self.stopped


def run(call: Call, sink: Sink) -> float:
    """Seconds from the beginning, or from the wish to stop, to the end."""
    try:
        call(sink)
    except native.Cancelled:
        pass
    sink(" the end", 1.0)
    return time.perf_counter() - (sink.begun + min(sink.stop_after, time.perf_counter() - sink.begun))


def measure(name: str, call: Call) -> None:
    sink = Sink()
    run(call, sink)
    seconds = time.perf_counter() - sink.begun
    late = max(run(call, Sink(share * seconds)) for share in (0.2, 0.5, 0.8))
    print(f"{name:24} {seconds:7.2f} {sink.longest:7.3f} {late:7.3f}   {sink.where}", flush=True)


def main() -> None:
    design = native.read_design(Path(sys.argv[1]).read_text(encoding="utf-8"))
    facets = int(sys.argv[2]) if len(sys.argv) > 2 else 500_000
    V, F, cuts, p = design.V, design.F, design.cuts, design.parameters
    chosen = sys.argv[3:]
    tolerance, surface = 0.05, native.builtin_target("half-sphere", 0.05)
    while len(surface[1]) < facets:
        tolerance /= 2
        surface = native.builtin_target("half-sphere", tolerance)
    folder = tempfile.TemporaryDirectory()
    model = native.make_print_model(design)
    model.build_solids()

    def write(ending: str, kind: str) -> Call:
        return lambda sink: model.write(ending, kind, f"{folder.name}/x.{ending}", sink)

    def solids(sink: Any) -> None:
        native.make_print_model(design, sink).build_solids(sink)

    calls: dict[str, Call] = {
        "solve_layout": lambda sink: native.solve_layout(V, F, cuts, p, sink),
        "smooth_for_pins": lambda sink: native.smooth_for_pins(V, F, cuts, p, sink),
        "suggest_cuts": lambda sink: native.suggest_cuts(V, F, cuts, p, 1, [], sink),
        "verify_design": lambda sink: native.verify_design(design, None, sink),
        "settle_design": lambda sink: native.settle_design(design, None, sink),
        "actuate_design": lambda sink: native.actuate_design(design, None, sink, answers=False),
        "actuate_design, hands": lambda sink: native.actuate_design(design, None, sink),
        "repair_design": lambda sink: native.repair_design(design, None, sink),
        "make_print_model": lambda sink: native.make_print_model(design, sink),
        "build_solids": solids,
        "judge_solids": model.judge_solids,
        "write step": write("step", "print"), "write stl": write("stl", "tiles"),
        "write 3mf": write("3mf", "print"),
        f"remesh {len(surface[1])}": lambda sink: native.remesh(*surface, 4.0, sink),
        f"deviation {len(surface[1])}": lambda sink: native.surface_deviation(*surface, *surface, sink),
    }
    for name, call in calls.items():
        if not chosen or any(word in name for word in chosen):
            measure(name, call)


if __name__ == "__main__":
    main()
