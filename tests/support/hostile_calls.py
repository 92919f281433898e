# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls entries of the native module with hostile arguments: `python hostile_calls.py ENTRY`, in a process
of its own, which may crash or hang. Every call is announced before it is made.

What an entry takes is read from its own signature, what is hostile from HOSTILE by the argument's name: an
entry or a name that joins the module without a row here is an error, not a gap."""

import inspect
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
from running import dome

from curveups.base import freecad_session
from curveups.base.native import native

INT = np.int32
NONE = np.zeros((0, 2), INT)


def _cap():
    lines = [line.split() for line in dome(2).splitlines()]
    return (np.array([line[1:] for line in lines if line[0] == "v"], float),
            np.array([line[1:] for line in lines if line[0] == "f"], INT) - 1)


V, F = _cap()
PARAMETERS = native.Parameters()
FOUND = native.solve_layout(V, F, NONE, PARAMETERS)
DESIGN = native.Design("cap", PARAMETERS, V, F, FOUND.T, FOUND.q, NONE)
SQUARE = np.array([(0, 0), (9, 0), (9, 9), (0, 9)], float)
FOLDER = Path(tempfile.mkdtemp())


def put(array, place, value, kind=None):
    out = np.array(array, kind or array.dtype)
    out[place] = value
    return out


def other_design(**changes):
    given = dict(name="cap", parameters=PARAMETERS, V=V, F=F, T=FOUND.T, q=FOUND.q, cuts=NONE)
    return native.Design(**{**given, **changes})


def asked(**settings):
    parameters = native.Parameters()
    for name, value in settings.items():
        parameters.set(name, value)
    return parameters


class Refuses:
    def __call__(self, *arguments):
        raise KeyError("mine")


class Hurried:
    """A sink that lets a few steps pass: hostile input may make sound work long."""

    def __init__(self, steps=40):
        self.steps = steps

    def __call__(self, *arguments):
        self.steps -= 1
        return self.steps > 0


NO_ARRAYS = [None, 7, "x", [[1, 2], [3]], {}, b"abc", object()]
POINTS = NO_ARRAYS + [
    V[:, :2], np.hstack([V, V]), V.ravel(), V[None], V.astype(complex), V.astype(str),
    np.full(V.shape, None, object),
    *(put(V, (3, 1), x) for x in (np.nan, np.inf, -np.inf, 1e300, -1e9))]
TRIANGLES = NO_ARRAYS + [
    F[:, :2], F.ravel(), F[None], F.astype(float), np.full((4, 3), np.nan), F > 0, F.astype(str), F[:0],
    *(put(F, (2, 1), x, np.int64) for x in (-1, -(2 ** 31), 2 ** 31, 2 ** 32, 2 ** 63 - 1, -(2 ** 63), len(V),
                                            10 ** 6)),
    put(F, (0, 0), 2 ** 64 - 1, np.uint64)]
EDGES = NO_ARRAYS + [F, F[:, 0], np.array([[0.0, 1.0]]), np.array([[np.nan, 1]]),
                     *(np.array([[0, x]], np.int64) for x in (-1, len(V), 2 ** 31, 2 ** 32 + 1, -(2 ** 63)))]
BLOCKS = [7, "x", [[1, 2], [3]], {}, FOUND.T.reshape(-1, 6), FOUND.T[:, :2], FOUND.T[..., :1], FOUND.T[:-1],
          FOUND.T[:0, :, :1], FOUND.T.astype(complex),
          *(put(FOUND.T, (1, 1, 1), x) for x in (np.nan, np.inf, -np.inf))]
INSETS = [7, "x", FOUND.q.reshape(-1, 6), FOUND.T, FOUND.q[:-1], put(FOUND.q, (0, 0, 0), np.nan),
          put(FOUND.q, (0, 1, 2), -np.inf)]
LENGTHS = [None, "x", [], np.nan, np.inf, -np.inf, 0.0, -1.0]
TILES = [None, 7, "x", [-1], [len(F)], [2 ** 31], [-(2 ** 40)], [0.5], [None]]
PAIRS = [None, 7, [0, 1], [[0]], [[0, 1, 2]], [[0, len(F)]], [[-1, 0]], [[0, 2 ** 40]], [[0.5, 1]]]
STILL = np.tile((0.0, 0, 0, 1, 0, 0, 0), (len(F), 1))
POSES = [7, "x", V, STILL[:1], STILL * 0, STILL * 2, put(STILL, (0, 0), np.nan), put(STILL, (0, 1), 1e300)]
TEXTS = [None, 7, b"\xff", "\udcff"]
OBJECTS = [None, 7, "x", {}, object()]
SINKS = [7, "x", Refuses(), lambda: True]

# By argument: what is right, what must be refused, and what may be refused or worked on, but must end.
VALUES = {
    "V": (V, POINTS, [V * 0, V * 1e-3, V * 1e3, V * [1, 1, 0], V + 9e7, -V, np.vstack([V, V]), V.astype("f4"),
                      V.tolist()]),
    "F": (F, TRIANGLES, [F[:1], F[:, ::-1], put(F, 0, 0), put(F, 0, F[1]), put(F, 0, F[0][::-1]),
                         np.vstack([F, F]), np.vstack([F, [[0, 1, 10]]]), np.vstack([F[:2], F[-2:]]),
                         F.astype(np.uint8)]),
    "target_V": (V, POINTS, [V * 0, V * 1e3]),
    "target_F": (F, TRIANGLES, [F[:1], put(F, 0, 0)]),
    "points": (V[:4] + 1, POINTS, [V[:0], V[:1], V * 0, V + 9e7]),
    "cuts": (NONE, EDGES, [[], np.array([[0, 0]]), np.array([[0, len(V) - 1]]), np.array([[0, 1], [1, 0]]),
                           np.array([[0, 1], [0, 2], [0, 3], [0, 4], [0, 5], [0, 6]])]),
    "T": (FOUND.T, BLOCKS, [FOUND.T * 0, FOUND.T * 1e3, FOUND.T[:, ::-1], FOUND.T + 1e12]),
    "q": (FOUND.q, INSETS, [FOUND.q * 0, FOUND.q - 1e5, FOUND.q + 1e5, FOUND.q * 1e6]),
    "target": (None, [7, (V,), (V, V), (put(V, (0, 0), np.nan), F), (V, put(F, (0, 0), len(V)))], [(V, F)]),
    "parameters": (PARAMETERS, OBJECTS, [asked(L=1.0), asked(L=200.0), asked(H_body=20.0), asked(p_max=50.0),
                                         asked(A_pin_min=100.0), asked(tau=5.0), asked(mesh_size=0.05)]),
    "design": (DESIGN, OBJECTS, [
        other_design(q=FOUND.q * 0), other_design(q=FOUND.q - 1e5), other_design(q=FOUND.q + 1e5),
        other_design(T=FOUND.T - FOUND.T.mean(1, keepdims=True)),
        other_design(T=put(FOUND.T, 0, FOUND.T[0] + 1e6)), other_design(T=put(FOUND.T, 0, FOUND.T[0] + 9e7)),
        other_design(F=F[:1], T=FOUND.T[:1], q=FOUND.q[:1]),
        DESIGN.with_parameters(asked(L=1.0)), DESIGN.with_parameters(asked(H_body=20.0)),
        DESIGN.with_parameters(asked(H_pin=20.0))]),
    "start": (None, [7, "x", V], [DESIGN, other_design(q=FOUND.q + 1e5)]),
    "begin": (None, POSES, [STILL]),
    "memory": (None, [np.zeros(0), np.ones(9), np.full(50, np.nan), np.full(50, 1e9)], []),
    "poses": (STILL, POSES, [STILL + [9, 0, 0, 0, 0, 0, 0]]),
    "answers": (False, ["x"], []),
    "kept": (NONE, EDGES, [np.array([[0, 0]]), np.array([[0, 1], [1, 0]])]),
    "features": (NONE, EDGES, [np.array([[0, 0]]), np.array([[0, len(V) - 1]]), np.array([[0, 1], [1, 0]])]),
    "L": (7.0, LENGTHS, [1e-300, 1e-3, 1e9, 1e300]),
    "largest_move": (1.0, [value for value in LENGTHS if value != 0], [0, 1e-300, 1e9, 1e300]),
    "hole_edge": (28.0, [value for value in LENGTHS if value != 0], [0, 1e-300, 1e9, 1e300]),
    "crease_angle": (40.0, [value for value in LENGTHS if value != np.inf], [1e-300, 360.0, 1e300, np.inf]),
    "corner_reach": (3.5, [value for value in LENGTHS if value != 0], [0, 1e-300, 1e9, 1e300]),
    "tolerance": (0.01, LENGTHS + [1e-300, 1e-9, 1e9], []),
    "cuts_given": (False, ["x"], [2.5]),
    "without_crossings": (False, ["x"], [2.5]),
    "weak_is_enough": (False, ["x"], [2.5]),
    "pins": ([0], TILES, [[], [0, 0], list(range(len(F)))]),
    "tiles": ([0], TILES, [[], [0, 0], list(range(len(F)))]),
    "weak": ([(0, 1)], PAIRS, [[], [(0, 0)], [(0, 23)], [(0, 1)] * 1000]),
    "most": (1, [None, "x", 0.5, 2 ** 31, -(2 ** 40)], [0, -1, -(2 ** 31), 2 ** 31 - 1]),
    "max_iterations": (3, [None, "x", 0.5, 2 ** 31], [0, -1, -(2 ** 31), 2 ** 31 - 1]),
    "count": (1, [None, "x", 0.5, 2 ** 31], [0, -1, -(2 ** 31), 2 ** 31 - 1, 1]),
    "store": (None, [7, "x", DESIGN], [native.SolutionStore()]),
    "progress": (None, [], SINKS + [Hurried(1), lambda *_: None, lambda *_: True]),
    "on_iterate": (None, [], SINKS + [Hurried(1)]),
    "on_step": (None, [], SINKS + [Hurried(1)]),
    "name": ("half-sphere", TEXTS, ["", "L", "half-sphere", "\0", "x" * 10 ** 6]),
    "value": (7.5, [None, [], {}, V, np.nan, np.inf], ["x", True, "", 10 ** 400, -1]),
    "text": (native.write_design(DESIGN), TEXTS + ["", "{", "[]", "[" * 10 ** 6, "\0"], []),
    "kind": ("tiles", TEXTS + ["", "x", "TILES", "\0"], []),
    "ending": ("stl", TEXTS + ["", "x", "../stl"], []),
    "path": (str(FOLDER / "x"), TEXTS[:2] + ["", str(FOLDER), str(FOLDER / "no" / "x"), "a\0b"], []),
    "parts": ([(SQUARE, [], [(5.0, 5.0)], [(2.0, 2.0)])],
              [None, "x", [], [()], [(SQUARE[:2], [], [], [])], [(SQUARE, SQUARE[:1], [], [])],
               [(SQUARE, [], [(np.nan, 0.0)], [])], [(put(SQUARE, (0, 0), np.inf), [], [], [])]],
              [[(SQUARE * 0, SQUARE, [(0.0, 0.0)] * 9, [])]]),
    "part_of_tile": ([], [None, "x", [0, 1], [-1] * len(F), [len(F)] * len(F), [2 ** 31] * len(F)],
                     [[0] * len(F), list(range(len(F)))]),
    "opening": (0.0, [None, "x", np.nan, np.inf, -1.0, 1e300], [1e-300, 0.1, 9.9]),
    "region": ([], [None, "x", [(np.nan, 0.0)], [(0.0, 0.0)], [(0.0, 0.0), (1.0, 0.0), (np.inf, 1.0)]],
               [SQUARE, SQUARE * 1000]),
    "places": ({0: [0.0] * 3},
               [None, "x", {}, {0: [0.0, 0.0]}, {9: [0.0] * 3}, {-1: [0.0] * 3}, {0: [np.nan, 0.0, 0.0]},
                {0: [0.0, 0.0, np.inf]}],
               [{0: [1e3, -1e3, 1e9]}]),
    "thickness": (12.0, [None, "x", np.nan, np.inf, 0.0, -1.0, 1e300], [1e-300]),
    "tooth_radius": (2.5, [None, "x", np.nan, np.inf, 0.0, -1.0, 1e300], [1e-300]),
    "tooth_height": (4.5, [None, "x", np.nan, np.inf, 0.0, -1.0, 1e300], [2.5 + 1e-15]),
    "direct": (False, ["x"], [True]),
    "hands": (False, ["x"], [True]),
    "press": ([], TILES, [[0], [0, 0]]),
    "force": (None, ["x", np.nan, np.inf, 0.0, -1.0, 1e300, 1.0], []),
    "release": ("cut", TEXTS + ["", "CUT", "\0"], ["together", "front-first", "back-first"]),
    "arg0": (PARAMETERS, OBJECTS, []),
}
# What methods are called on. Results without methods of their own need no row.
OBJECTS_OF = {
    "Design": DESIGN, "Parameters": native.Parameters(), "SolutionStore": native.SolutionStore(),
    "PrintModel": native.make_print_model(DESIGN), "VerificationReport": native.verify_design(DESIGN)}
# What says no by its result, or takes some of what others must refuse.
LENIENT = {
    **{(entry, name): "for check_mesh to tell of" for entry in ("clean_mesh", "check_mesh", "mend_mesh")
       for name in "VF"},
    ("Parameters.get", "name"): "", ("Design", "name"): "any text is a name",
    ("Design.with_name", "name"): "any text is a name", ("make_ring", "name"): "any text is a name",
}


def entries():
    """Names of the module's functions, of its classes that can be made and of their methods, as
    `function`, `Class` and `Class.method`."""
    found = []
    for name, item in sorted(vars(native._module()).items()):
        if inspect.isclass(item) and not issubclass(item, BaseException):
            if _signatures(item.__init__, "__init__"):
                found.append(name)
            found += [f"{name}.{method}" for method, function in sorted(vars(item).items())
                      if not method.startswith("_") and callable(function)]
        elif callable(item) and not inspect.isclass(item):
            found.append(name)
    return found


def _signatures(function, name):
    """Names of the arguments, for each way of calling it."""
    out = []
    for found in re.finditer(r"^(?:\d+\. )?%s\((.*)\) -> " % name, function.__doc__ or "", re.M):
        if found[1] == "*args, **kwargs":
            continue
        depth, names, word = 0, [], ""
        for letter in found[1] + ",":
            depth += letter in "([{"
            depth -= letter in ")]}"
            if letter == "," and depth == 0:
                names.append(word.split(":")[0].split("=")[0].strip())
                word = ""
            else:
                word += letter
        out.append([n for n in names if n and n != "self"])
    return out


def _callable(entry):
    """The entry to call, and the names of its arguments in each of its ways."""
    owner, _, method = entry.partition(".")
    item = getattr(native, owner)
    if method:
        return getattr(OBJECTS_OF[owner], method), _signatures(getattr(item, method), method)
    if inspect.isclass(item):
        return item, _signatures(item.__init__, "__init__")
    return item, _signatures(item, owner)


def calls(entry):
    """(what is hostile, whether it must be refused, how to call it)."""
    function, ways = _callable(entry)
    if not ways:
        raise LookupError(f"{entry} has no signature to read")
    for names in ways:
        unknown = [name for name in names if name not in VALUES]
        if unknown:
            raise LookupError(f"{entry} takes {unknown}: say in VALUES what is hostile there")
        good = {name: VALUES[name][0] for name in names}
        if "progress" in good:
            good["progress"] = Hurried
        for name in names:
            _, refused, either = VALUES[name]
            for values, must in ((refused, True), (either, False)):
                for number, value in enumerate(values):
                    label = f"{entry}({name}={_short(value)}) [{number}]"
                    yield label, must and (entry, name) not in LENIENT, function, {**good, name: value}


def _short(value):
    return " ".join(repr(value).split())[:60]


TYPED = (native.Error, TypeError, ValueError, KeyError)


def main(entry):
    if entry == "PrintModel.shape":
        freecad_session.load("Part")
    wrong = 0
    for label, must, function, arguments in calls(entry):
        print(label, flush=True)
        if arguments.get("progress") is Hurried:
            arguments["progress"] = Hurried()
        positional = "arg0" in arguments
        try:
            if positional:
                function(*arguments.values())
            else:
                function(**arguments)
        except TYPED as error:
            assert str(error), "an error without a word"
            continue
        if must:
            print("WRONG: accepted", label, flush=True)
            wrong += 1
    print("END", entry, flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
