# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutations of good inputs, fed to every reader: `python fuzz.py SECONDS [--seed N] [--only KIND,...]`.

A reader refuses an input with an error of ours, or makes something of it. A crash, another error, or no end
within LIMIT seconds is a failure; its input is kept in build/fuzz. Input number i of a kind follows from
seed, kind and i. Readers run in a process of their own, begun anew after a failure."""

import argparse
import json
import os
import random
import re
import signal
import struct
import subprocess
import sys
import time
import zipfile
from io import BytesIO
from pathlib import Path

from running import ROOT, dome, environment

LIMIT = 60  # seconds for one input; sound inputs take a hundredth of one
TOKENS = [b"nan", b"-inf", b"1e300", b"-1", b"0", b"2147483648", b"99999999999999999999", b"0.5", b"foo", b"",
          b"null", b"\xff\xfe", b"\"", b"[", b"{", b"<", b"\\"]


def mutated(data: bytes, chance: random.Random) -> bytes:
    """Some lines lost, doubled or swapped, numbers replaced, bytes changed, or the end cut off."""
    if data[:2] == b"PK":
        out = BytesIO()
        with zipfile.ZipFile(BytesIO(data)) as source, zipfile.ZipFile(out, "w") as target:
            for entry in source.infolist():
                target.writestr(entry.filename, mutated(source.read(entry), chance))
        return out.getvalue()
    for _ in range(chance.choice((1, 1, 2, 4))):
        lines = data.splitlines(keepends=True) or [b""]
        a, b = chance.randrange(len(lines)), chance.randrange(len(lines))
        numbers = list(re.finditer(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?", data))
        what = chance.randrange(6)
        if what == 0:
            del lines[a]
        elif what == 1:
            lines[a:a] = [lines[b]] * chance.choice((1, 50))
        elif what == 2:
            lines[a], lines[b] = lines[b], lines[a]
        data = b"".join(lines)
        if what == 3 and numbers:
            place = chance.choice(numbers)
            data = data[:place.start()] + chance.choice(TOKENS) + data[place.end():]
        elif what == 4 and data:
            at = chance.randrange(len(data))
            data = data[:at] + bytes([chance.randrange(256)]) + data[at + 1:]
        elif what == 5:
            data = data[:chance.randrange(len(data) + 1)]
    return data


def cap():
    """V and F of a small dome."""
    import numpy as np

    lines = [line.split() for line in dome(2).splitlines()]
    return (np.array([line[1:] for line in lines if line[0] == "v"], float),
            np.array([line[1:] for line in lines if line[0] == "f"], np.int32) - 1)


def design():
    import numpy as np
    from curveups.base.native import native

    (V, F), none, parameters = cap(), np.zeros((0, 2), np.int32), native.Parameters()
    layout = native.solve_layout(V, F, none, parameters)
    return native.Design("cap", parameters, V, F, layout.T, layout.q, none)


def mesh_samples(ending):
    """Bytes of good files of a format of meshes."""
    V, F = cap()
    rows = ("".join("%r %r %r\n" % tuple(row) for row in V.tolist())
            + "".join("3 %d %d %d\n" % tuple(face) for face in F.tolist()))
    header = (f"ply\nformat %s 1.0\nelement vertex {len(V)}\n"
              + "".join(f"property float {axis}\n" for axis in "xyz")
              + f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")
    if ending == "obj":
        return [dome(2).encode()]
    if ending == "off":
        return [f"OFF\n{len(V)} {len(F)} 0\n{rows}".encode()]
    if ending == "stl":
        return [("solid cap\n" + "".join(
            "facet normal 0 0 1\nouter loop\n"
            + "".join("vertex %r %r %r\n" % tuple(V[v].tolist()) for v in face)
            + "endloop\nendfacet\n" for face in F) + "endsolid cap\n").encode(),
            b"cap".ljust(80) + struct.pack("<I", len(F)) + b"".join(
                struct.pack("<12fH", 0, 0, 1, *V[face].ravel(), 0) for face in F)]
    if ending == "ply":
        return [(header % "ascii" + rows).encode(),
                (header % "binary_little_endian").encode() + b"".join(struct.pack("<3f", *row) for row in V)
                + b"".join(struct.pack("<B3i", 3, *face) for face in F)]
    out = BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("3D/3dmodel.model", (
            '<model unit="millimeter"><resources>\n<object id="1"><mesh><vertices>\n'
            + "".join('<vertex x="%r" y="%r" z="%r"/>\n' % tuple(row) for row in V.tolist())
            + "</vertices><triangles>\n"
            + "".join('<triangle v1="%d" v2="%d" v3="%d"/>\n' % tuple(face) for face in F.tolist())
            + '</triangles></mesh></object>\n</resources>\n<build><item objectid="1"/></build></model>'))
    return [out.getvalue()]


def cad_samples(ending):
    from curveups.base import freecad_session

    freecad, part = freecad_session.load("Part")
    tower = part.makeCylinder(10, 20).fuse(part.makeCone(10, 5, 10, freecad.Vector(0, 0, 20)))
    path = Path(f"good.{ending}").resolve()
    getattr(part.Shell(tower.Faces[:-1]), f"export{ending.capitalize()}")(str(path))
    return [path.read_bytes()]


def read_surface(path):
    from curveups.base.native import native
    from curveups.targets import cad_files, target_files

    cad_files._TIME_LIMIT = 5.0  # OpenCASCADE never returns from some files
    read = target_files.read_target(path, 0.5)
    clean = native.clean_mesh(read.V, read.F)
    native.check_mesh(clean.V, clean.F, 8.0, True)


def read_design(path):
    from curveups.base.native import native

    text = native.write_design(native.read_design(path.read_text(encoding="utf-8")))
    assert native.write_design(native.read_design(text)) == text
    native.evaluate_design(native.read_design(text))


def read_results(path):
    """Results that a document stores as text."""
    from curveups.project import saved_results

    saved_results.from_text(path.read_text(encoding="utf-8"), path.name)


def saved():
    from curveups.base.native import native
    from curveups.project import saved_results
    from curveups.project.project import Project
    from curveups.stages.design import FinishedDesign

    project = Project("cap", native.Parameters(), {"design": FinishedDesign(design())})
    return [saved_results.to_text(project.run(("figures",)).made).encode()]


def read_parameters(path):
    from curveups.base.native import native

    parameters = native.Parameters()
    for name, value in dict(json.loads(path.read_text(encoding="utf-8"))).items():
        parameters.set(name, value)
    parameters.check()


def parameter_samples():
    from curveups.base.native import native

    return [json.dumps(native.Parameters().to_dict(), indent=1).encode()]


def design_samples():
    from curveups.base.native import native

    return [native.write_design(design()).encode()]


# Name: (ending of its files, samples, reader).
KINDS = {
    **{ending: (ending, lambda ending=ending: mesh_samples(ending), read_surface)
       for ending in ("obj", "off", "stl", "ply", "3mf")},
    **{ending: (ending, lambda ending=ending: cad_samples(ending), read_surface)
       for ending in ("step", "iges", "brep")},
    "design": ("json", design_samples, read_design), "results": ("json", saved, read_results),
    "parameters": ("json", parameter_samples, read_parameters),
}


def work(kind, seed, first, seconds):
    """In the child: announce and read one input after another."""
    from curveups.base.errors import CurveUpsError
    from curveups.base.native import native

    ending, make_samples, read = KINDS[kind]
    samples, end = make_samples(), time.monotonic() + seconds
    path, number = Path(f"input.{ending}"), first
    while number == first or time.monotonic() < end:
        chance = random.Random(f"{seed} {kind} {number}")
        path.write_bytes(mutated(chance.choice(samples), chance))
        print(number, flush=True)
        signal.alarm(LIMIT)
        try:
            read(path)
        except (CurveUpsError, native.Error) as error:
            if "unexpected failure" in str(error):  # the word of `translated` for a library's errors
                raise
        except (UnicodeDecodeError, json.JSONDecodeError, TypeError, ValueError):
            if ending != "json":  # whoever opens such a file says so
                raise
        number += 1


def fuzz_kind(kind, seconds, seed, folder):
    """Number of inputs, and failures as (number, what)."""
    folder.mkdir(parents=True, exist_ok=True)
    failures, first, end = [], 0, time.monotonic() + seconds
    while first == 0 or time.monotonic() < end:
        left = max(end - time.monotonic(), 0.0)
        done = subprocess.run([sys.executable, __file__, "--work", kind, str(seed), str(first), str(left)],
                              cwd=folder, text=True, capture_output=True,
                              env=environment(CURVEUPS_THREADS="1"))
        if not done.stdout:
            raise RuntimeError(f"{kind} does not begin: {done.stderr}")
        last = int(done.stdout.split()[-1])
        first = last + 1
        if done.returncode:
            for path in folder.glob("input.*"):
                path.rename(folder / f"failed-{seed}-{last}{path.suffix}")
            failures.append((last, done.stderr.strip().splitlines()[-1:] or f"signal {-done.returncode}"))
    return first, failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seconds", type=float)
    parser.add_argument("--seed", type=int, default=int.from_bytes(os.urandom(4), "little"))
    parser.add_argument("--only", default=",".join(KINDS))
    given = parser.parse_args()
    kinds, total, failed = given.only.split(","), 0, 0
    for kind in kinds:
        folder = ROOT / "build" / "fuzz" / kind
        count, failures = fuzz_kind(kind, given.seconds / len(kinds), given.seed, folder)
        print(f"fuzz: {kind}: {count} inputs, {len(failures)} failures", flush=True)
        for number, what in failures:
            print(f"fuzz:   {number}: {what} ({folder}/failed-{given.seed}-{number}*)", flush=True)
        total, failed = total + count, failed + len(failures)
    print(f"{total} inputs fuzzed in {given.seconds:g} s with seed {given.seed}, {failed} failures")
    return 1 if failed else 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["--work"]:
        work(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), float(sys.argv[5]))
    else:
        sys.exit(main())
