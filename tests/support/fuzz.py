# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutations of good inputs, fed to every reader: `python fuzz.py SECONDS [--seed N] [--only KIND,...]`.

A reader refuses an input with an error of ours, or what it gives holds what fuzz_kinds asks for. Crashes,
other errors, warnings of libraries and inputs that take more than LIMIT seconds or MEMORY bytes are failures:
they are kept in build/fuzz. So are CAD files without an end that have lost a part, and more than SHARE of all
others: FreeCAD works on some for minutes, until the time limit of the command ends it.

Input number i of a kind follows from seed, kind and i alone (but for the dates that FreeCAD writes into STEP
and IGES files). Readers run in a process of their own, begun anew after a crash."""

import argparse
import os
import queue
import random
import resource
import subprocess
import sys
import threading
import time
import traceback
import warnings
from pathlib import Path

from mutations import mutated
from running import ROOT, environment

LIMIT = 30.0       # seconds; sound inputs take a hundredth of one, CAD files with FreeCAD's start some
LEAST = 20         # inputs of a kind, whatever they take
SHARE = 0.1        # of inputs on which FreeCAD may work without an end; FEW may always
FEW = 2
MEMORY = 8 << 30   # address space, which libraries reserve a lot of


def input_of(kind, seed, number, samples):
    chance = random.Random(f"{seed} {kind} {number}")
    return mutated(chance.choice(samples), chance)


def work(kind, seed, first):
    """In the child: a line for every input, `NUMBER` or `NUMBER what went wrong`."""
    from fuzz_kinds import BROKEN, ENDLESS, KINDS, Endless

    from curveups.base.errors import CurveUpsError
    from curveups.base.native import native

    warnings.simplefilter("error")
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    ending, make_samples, check, _ = {**KINDS, **BROKEN}[kind]
    samples = make_samples()
    path = Path(f"input{ending}")
    number = first
    print("ready", flush=True)
    while True:
        data, lossy = input_of(kind, seed, number, samples)
        path.write_bytes(data)
        said = ""
        try:
            check(path, number, lossy)
        except (CurveUpsError, native.Error) as error:
            # `translated` gives a library's errors this word, for whoever meets one.
            said = "" if str(error) and "unexpected failure" not in str(error) else f" {error!r}"
        except Endless:
            said = f" {ENDLESS}, of a file that lost a part" if lossy else f" {ENDLESS}"
        except UnicodeDecodeError:
            said = "" if ending == ".json" else " no text"  # whoever opens the file says so
        except ValueError as error:
            # Of json alone: the file is read by whoever calls the reader.
            said = "" if kind == "parameters" and "JSON" in type(error).__name__ else " " + repr(error)
        except Exception as error:
            traceback.print_exc()
            said = " " + " ".join(repr(error).split())[:300]
        if said:
            keep(path.parent, seed, number)
        print(f"{number}{said}", flush=True)
        number += 1


def keep(folder, seed, number):
    for path in folder.glob("input.*"):
        path.rename(folder / f"failed-{seed}-{number}{path.suffix}")


class Child:
    """A process that works on one kind, from input `first` on."""

    def __init__(self, kind, seed, first, folder):
        self._log = open(folder / "said", "ab")
        self._process = subprocess.Popen(
            [sys.executable, __file__, "--work", kind, str(seed), str(first)], cwd=folder, text=True,
            env=environment(CURVEUPS_THREADS="1"), stdout=subprocess.PIPE, stderr=self._log)
        self._lines = queue.Queue()
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self):
        for line in self._process.stdout:
            self._lines.put(line.strip())
        self._lines.put(None)

    def next(self, seconds):
        """The next line, None where the process ended; queue.Empty where none comes."""
        return self._lines.get(timeout=seconds)

    def end(self):
        self._process.kill()
        self._log.close()
        return self._process.wait()


def fuzz_kind(kind, seconds, seed, folder, limit=LIMIT, least=LEAST):
    """(number of inputs, failures as (number, what), number of inputs without an end that are borne)."""
    from fuzz_kinds import ENDLESS

    folder.mkdir(parents=True, exist_ok=True)
    failures, number = [], 0
    child = Child(kind, seed, number, folder)
    end = None  # the time runs from the first child's being ready
    try:
        while end is None or number < least or time.monotonic() < end:
            try:
                line = child.next(limit)
            except queue.Empty:
                line, what = None, f"no end within {limit:.0f} s"
            else:
                what = "" if line is not None else "crashed"
            if line == "ready":
                end = end or time.monotonic() + seconds
                continue
            if line is not None:
                word, _, what = line.partition(" ")
                number = int(word)
            if what:
                failures.append((number, what))
            number += 1
            if line is None:
                child.end()
                keep(folder, seed, number - 1)
                if end is None:
                    raise RuntimeError(f"{kind} does not begin: see {folder / 'said'}")
                child = Child(kind, seed, number, folder)
    finally:
        child.end()
    endless = sum(what == ENDLESS for _, what in failures)
    if endless > max(FEW, SHARE * number):
        return number, failures, 0
    return number, [one for one in failures if one[1] != ENDLESS], endless


def fuzz(seconds, seed, kinds, folder):
    """Prints what was found; whether nothing was."""
    from fuzz_kinds import BROKEN, KINDS

    known = {**KINDS, **BROKEN}
    whole = sum(known[kind][3] for kind in kinds)
    total, failed = 0, 0
    print(f"fuzz: seed {seed}", flush=True)
    for kind in kinds:
        count, failures, endless = fuzz_kind(kind, seconds * known[kind][3] / whole, seed, folder / kind)
        borne = f", {endless} without an end in FreeCAD (borne: {SHARE:.0%})" if endless else ""
        print(f"fuzz: {kind}: {count} inputs, {len(failures)} failures{borne}", flush=True)
        for number, what in failures:
            print(f"fuzz:   {kind} {number}: {what} ({folder / kind}/failed-{seed}-{number}*)", flush=True)
        total, failed = total + count, failed + len(failures)
    print(f"{total} inputs fuzzed in {seconds:g} s with seed {seed}, {failed} failures", flush=True)
    return failed == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("seconds", type=float)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--only", default="")
    parser.add_argument("--folder", type=Path, default=ROOT / "build" / "fuzz")
    given = parser.parse_args()
    from fuzz_kinds import KINDS

    seed = given.seed if given.seed is not None else int.from_bytes(os.urandom(4), "little")
    kinds = given.only.split(",") if given.only else list(KINDS)
    return 0 if fuzz(given.seconds, seed, kinds, given.folder.resolve()) else 1


if __name__ == "__main__":
    if sys.argv[1:2] == ["--work"]:
        work(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    sys.exit(main())
