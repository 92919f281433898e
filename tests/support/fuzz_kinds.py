# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is fuzzed: good inputs of every reader, and what must hold of whatever is read from a mutated one.

A kind answers `samples()` (good files), and `check(path, number, lossy)`, which reads the file and raises
CurveUpsError or one of the native errors where it is refused; anything else that it raises is a failure.
lossy: the file has lost something, and nothing of it was changed.
Sound work is cut short: it is the business of other tests."""

import json
import os
import signal
import struct
import time
import traceback
import warnings
import zipfile
from dataclasses import asdict
from io import BytesIO
from pathlib import Path
from unittest import mock

import numpy as np
from running import dome

from curveups.base import freecad_session
from curveups.base.errors import CurveUpsError
from curveups.project import saved_results
from curveups.targets import cad_files, target_files
from curveups.base.native import native, translated
from curveups.project.project import Project
from curveups.stages.design import FinishedDesign

NONE = np.zeros((0, 2), np.int32)
LARGEST = 1e8      # mm, of a coordinate
CAD_SECONDS = 5.0  # sound ones take a tenth of one
ENDLESS = "no end in FreeCAD"
# What FreeCAD does not raise for a damaged file.
OURS = (AssertionError, AttributeError, LookupError, NameError, Warning, ZeroDivisionError)
_areas = {}  # of the good files, by ending


class Endless(Exception):
    """FreeCAD's reader was ended."""


class BrokeDown(Exception):
    """An error of our own, or a warning, in the process that reads a CAD file: `read_cad` takes the file for
    damaged then."""


def _cap():
    lines = [line.split() for line in dome(2).splitlines()]
    return (np.array([line[1:] for line in lines if line[0] == "v"], float),
            np.array([line[1:] for line in lines if line[0] == "f"], np.int32) - 1)


V, F = _cap()


class Briefly:
    """A progress sink that ends work after a while."""

    def __init__(self, seconds=1.0):
        self._end = time.monotonic() + seconds

    def __call__(self, *_):
        return time.monotonic() < self._end


def check_mesh(path, number, lossy):
    found = target_files.read_target(path, 0.01)
    found_V, found_F = found.V, found.F
    assert found_V.shape[1:] == (3,) and found_F.shape[1:] == (3,) and np.isfinite(found_V).all()
    assert found_F.min() >= 0 and found_F.max() < len(found_V)
    # Without a sink: work without an end that listens to one would pass for a refusal.
    clean = native.clean_mesh(found_V, found_F)
    if len(clean.F):
        size, far = np.ptp(clean.V, axis=0).max(), np.abs(clean.V).max()
        assert 0 < size and far <= LARGEST, f"{size:g} mm at {far:g} mm are taken for clean"
    errors = [one for one in native.check_mesh(clean.V, clean.F, 8.0, True) if one.is_error]
    if not errors and number % 20 == 0:
        made = native.remesh(clean.V, clean.F, 8.0, Briefly())
        assert np.isfinite(made.V).all()


def _forked(path, deflection, choice, answer, go_on, time_limit, where):
    """What cad_files begins a process for, in a fork of this one, which has FreeCAD already: a hundred
    times as many inputs. Raises BrokeDown for what no file is to blame for."""
    wrong = answer.with_suffix(".wrong")
    child = os.fork()
    if child == 0:
        try:
            for stream in (1, 2):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
            warnings.simplefilter("error")
            with mock.patch.object(cad_files, "_read", _frank(cad_files._read)):
                cad_files._main(str(path), repr(deflection), str(answer), json.dumps(asdict(choice)))
        except BaseException:
            wrong.write_text(traceback.format_exc())
            os._exit(1)
        os._exit(0)
    end = time.monotonic() + time_limit
    while not (ended := os.waitpid(child, os.WNOHANG))[0]:
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            raise Endless
        time.sleep(0.001)
    if wrong.exists():
        trace = wrong.read_text()
        raise BrokeDown(trace.strip().splitlines()[-1]) from RuntimeError(trace)
    return os.waitstatus_to_exitcode(ended[1])


def _frank(read):
    """A reader that shows errors of ours which it takes for FreeCAD's."""
    def frankly(*arguments):
        try:
            return read(*arguments)
        except CurveUpsError as error:
            if isinstance(error.__cause__, OURS):
                raise error.__cause__
            raise

    return frankly


def check_cad(path, number, lossy):
    found_V, found_F = _read_cad(path)
    if lossy:
        area = _area(found_V, found_F)
        assert any(abs(area / known - 1) < 0.02 for known in _areas[path.suffix]), f"{area:g} mm2 are left"
    assert len(found_F) and np.isfinite(found_V).all() and found_F.min() >= 0 and found_F.max() < len(found_V)


def _read_cad(path):
    with mock.patch.multiple(cad_files, _run=_forked, _TIME_LIMIT_MOST=CAD_SECONDS):
        found = cad_files.read_cad(path, 0.5)
    return found.V, found.F


def _area(V, F):
    return np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1).sum() / 2


def check_design(path, number, lossy):
    design = native.read_design(path.read_text(encoding="utf-8"))
    assert native.write_design(native.read_design(native.write_design(design))) == native.write_design(design)
    native.tile_shapes(design)
    native.evaluate_design(design)
    if number % 20 == 0:
        native.verify_design(design, None, Briefly())
    if number % 20 == 10:
        native.make_print_model(design, Briefly())


def check_parameters(path, number, lossy):
    values = json.loads(path.read_text(encoding="utf-8"))
    if not isinstance(values, dict):
        return
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    parameters.check()
    native.check_target(V, F, NONE, parameters)
    if number % 10 == 0:
        found = native.solve_layout(V, F, NONE, parameters, Briefly())
        assert np.isfinite(found.T).all() and np.isfinite(found.q).all()


def check_results(path, number, lossy):
    """The results that a document stores as text."""
    for name, one in saved_results.from_text(path.read_text(encoding="utf-8"), path.name).items():
        assert isinstance(name, str) and one.result is not None


def _stl():
    return ("solid cap\n" + "".join(
        "facet normal 0 0 1\nouter loop\n" + "".join("vertex %r %r %r\n" % tuple(V[v].tolist()) for v in face)
        + "endloop\nendfacet\n" for face in F) + "endsolid cap\n").encode()


def _binary_stl():
    return b"cap".ljust(80) + struct.pack("<I", len(F)) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *V[face].ravel(), 0) for face in F)


def _rows():
    return ("".join("%r %r %r\n" % tuple(row) for row in V.tolist())
            + "".join("3 %d %d %d\n" % tuple(face) for face in F.tolist()))


def _ply_header(form):
    return (f"ply\nformat {form} 1.0\nelement vertex {len(V)}\n"
            + "".join(f"property float {axis}\n" for axis in "xyz")
            + f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")


def _binary_ply():
    return (_ply_header("binary_little_endian").encode() + b"".join(struct.pack("<3f", *row) for row in V)
            + b"".join(struct.pack("<B3i", 3, *face) for face in F))


def _3mf():
    model = ('<?xml version="1.0"?>\n<model unit="millimeter" xmlns='
             '"http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n<resources>\n'
             '<object id="1"><mesh><vertices>\n'
             + "".join('<vertex x="%r" y="%r" z="%r"/>\n' % tuple(row) for row in V.tolist())
             + "</vertices><triangles>\n"
             + "".join('<triangle v1="%d" v2="%d" v3="%d"/>\n' % tuple(face) for face in F.tolist())
             + '</triangles></mesh></object>\n<object id="2"><components>\n'
             '<component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 0"/>\n</components></object>\n'
             '</resources>\n<build>\n<item objectid="2"/>\n</build>\n</model>\n')
    out = BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("3D/3dmodel.model", model)
    return out.getvalue()


def _design():
    parameters = native.Parameters()
    found = native.solve_layout(V, F, NONE, parameters)
    return native.Design("cap", parameters, V, F, found.T, found.q, NONE)


def _results():
    """What a document stores of a run that ended before its design was verified."""
    project = Project("cap", native.Parameters(), {"design": FinishedDesign(_design())})
    return saved_results.to_text(project.made()).encode()


def _cad(ending):
    def samples():
        freecad, part = freecad_session.load("Part")
        cap = part.makeSphere(40).common(part.makeBox(60, 60, 60))
        tower = part.makeCylinder(10, 20).fuse(part.makeCone(10, 5, 10, freecad.Vector(0, 0, 20)))
        shapes = [part.makeBox(20, 30, 10).Shells[0], cap.Faces[0],
                  part.Shell(tower.removeSplitter().Faces[:-1])]
        out = []
        for shape in shapes:
            path = Path(f"good.{ending}").resolve()
            getattr(shape, "export" + ending.capitalize())(str(path))
            out.append(path.read_bytes())
            _areas.setdefault(path.suffix, []).append(_area(*_read_cad(path)))
            path.unlink()
        return out

    return samples


def _warn(path, number, lossy):
    if number == 3:
        np.array([1.0]) / np.array([0.0])


def _library(path, number, lossy):
    if number == 3:
        with translated("somewhere"):
            raise RuntimeError("of a library")


def _endless(path, number, lossy):
    if number % 3 == 0:
        raise Endless


def _cut_off(path, number, lossy):
    if lossy:
        raise Endless


def _crash(path, number, lossy):
    if number == 3:
        os.kill(os.getpid(), signal.SIGSEGV)


def _hang(path, number, lossy):
    if number == 3:
        while True:
            time.sleep(1)


def _break(path, number, lossy):
    if number == 3:
        raise KeyError("a name that is not there")


def _together(path, number, lossy):
    """Breaks where all vertices lie in one point, or beyond what single precision resolves."""
    try:
        size = np.ptp(target_files.read_target(path, 0.01).V, axis=0).max()
    except CurveUpsError:
        return
    if size == 0 or size > 1e25:
        raise KeyError(f"a size of {size:g}")


# Name: (ending of its files, samples, check, share of the time).
KINDS = {
    "obj": (".obj", lambda: [dome(2).encode()], check_mesh, 1.0),
    "off": (".off", lambda: [f"OFF\n{len(V)} {len(F)} 0\n{_rows()}".encode()], check_mesh, 1.0),
    "stl": (".stl", lambda: [_stl(), _binary_stl()], check_mesh, 1.0),
    "ply": (".ply", lambda: [(_ply_header("ascii") + _rows()).encode(), _binary_ply()], check_mesh, 1.0),
    "3mf": (".3mf", lambda: [_3mf()], check_mesh, 1.0),
    "step": (".step", _cad("step"), check_cad, 1.0),
    "iges": (".iges", _cad("iges"), check_cad, 1.0),
    "brep": (".brep", _cad("brep"), check_cad, 1.0),
    "design": (".json", lambda: [native.write_design(_design()).encode()], check_design, 2.0),
    "results": (".json", lambda: [_results()], check_results, 1.0),
    "parameters": (".json", lambda: [json.dumps(native.Parameters().to_dict(), indent=1).encode()],
                   check_parameters, 1.0),
}
# What a fuzzer must notice; for its own test.
BROKEN = {"together": (".obj", lambda: [dome(2).encode()], _together, 1.0),
          **{name: (".txt", lambda: [b"1\n2\n"], check, 1.0)
             for name, check in (("crash", _crash), ("hang", _hang), ("break", _break), ("warn", _warn),
                                 ("library", _library), ("endless", _endless), ("cut off", _cut_off))}}
