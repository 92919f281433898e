# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every long native call says how it gets on, and ends when it is told to: with the best so far where
there is one, else with Cancelled; what the sink raises comes out."""

import numpy as np
import pytest
from running import dome

from curveups.base.errors import Stopped
from curveups.base.native import native
from curveups.stages.solids import part_solids
from curveups.stages.stage import Job

NONE = np.zeros((0, 2), np.int32)


@pytest.fixture(scope="module")
def design():
    lines = [line.split() for line in dome(6, edge=7.0).splitlines()]
    V = np.array([line[1:] for line in lines if line[0] == "v"], float)
    F = np.array([line[1:] for line in lines if line[0] == "f"], np.int32) - 1
    parameters = native.Parameters()
    found = native.solve_layout(V, F, NONE, parameters)
    return native.Design("dome", parameters, V, F, found.T, found.q, NONE)


@pytest.fixture(scope="module", autouse=True)
def several_threads():
    before = native.thread_count()
    native.set_thread_count(2)
    yield
    native.set_thread_count(before)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("files")


def calls(design, folder):
    V, F, p = design.V, design.F, design.parameters
    model = native.make_print_model(design)

    def repair(sink):
        # Contacts that have to press with more than they do.
        harder = native.Parameters(p)
        harder.set("f_min_ratio", 0.9)
        return native.repair_design(design.with_parameters(harder), sink)

    return {
        "layout": lambda sink: native.solve_layout(V, F, NONE, p, sink),
        "cuts": lambda sink: native.suggest_cuts(V, F, NONE, p, 1, [], sink),
        "verify": lambda sink: native.verify_design(design, sink),
        "settle": lambda sink: native.settle_design(design, sink),
        "actuate": lambda sink: native.actuate_design(design, sink),
        "repair": repair,
        "print model": lambda sink: native.make_print_model(design, sink),
        "solids": lambda sink: part_solids(model.bodies("print"), Job(sink)),
        "judge": lambda sink: native.check_bodies(model.bodies("print"), sink),
        "step": lambda sink: model.write("step", "print", str(folder / "x.step"), sink),
        "stl": lambda sink: model.write("stl", "tiles", str(folder / "x.stl"), sink),
        "3mf": lambda sink: model.write("3mf", "print", str(folder / "x.3mf"), sink),
        "remesh": lambda sink: native.remesh(V, F, 3.0, sink),
        "deviation": lambda sink: native.surface_deviation(V, F, V, F, sink),
    }


LEAST = {"layout": 8, "cuts": 4, "verify": 8, "settle": 8, "actuate": 8, "print model": 3,
         "remesh": 2}
NAMES = ["layout", "cuts", "verify", "settle", "actuate", "repair", "print model", "solids", "judge", "step",
         "stl", "3mf", "remesh", "deviation"]


@pytest.mark.parametrize("name", NAMES)
def test_work_is_told_and_can_be_stopped(design, folder, name):
    work, said = calls(design, folder)[name], []

    def listen(what, fraction):
        assert what and fraction <= 1.0
        said.append(what)
        return True

    if name != "repair":  # which may take its time at this
        whole = work(listen)
        assert len(said) >= LEAST.get(name, 1)
    for path in folder.iterdir():
        path.unlink()

    answered = []

    def stop(what, fraction):
        answered.append(what)
        return False

    try:
        part = work(stop)
    except (native.Cancelled, Stopped):
        part = None
    assert len(answered) == 1, "asked again after it was stopped"
    if name in ("layout", "cuts"):
        assert part.stopped and not whole.stopped
    elif name == "repair":
        assert part.status == "stopped"
    else:
        assert part is None
    assert not list(folder.iterdir()), "a file was left"


def test_what_the_sink_raises_comes_out(design):
    def fail(what, fraction):
        raise ZeroDivisionError(what)

    for work in (native.verify_design, native.make_print_model):
        with pytest.raises(ZeroDivisionError):
            work(design, progress=fail)
