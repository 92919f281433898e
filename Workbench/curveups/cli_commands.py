# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each command of the command line does."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

import numpy as np

from . import cuts, pipeline
from .errors import NOT_VALID, STOPPED, VALID, CurveUpsError, Stopped, from_native
from .files import write_obj, write_outcome, write_reports
from .native import native
from .output import Folder, require_folder_name, safe_name
from .progress import Interrupt, Reporter
from .suggestions import describe


@dataclass
class Session:
    """What commands share: where progress goes, what may stop them, where answers are printed."""

    reporter: Reporter
    interrupt: Interrupt
    output: TextIO


def design(options: Any, session: Session) -> int:
    """curveups design"""
    require_folder_name(options.output)
    request = _request(options, session)
    request.remesh, request.solids = not options.no_remesh, not options.no_solids
    request.auto_cuts = options.auto_cuts
    if options.cuts:
        request.cuts = cuts.read_cuts(options.cuts)
    outcome = pipeline.run_design(request, session.reporter)
    write_outcome(outcome, options.output, session.reporter)
    return _finish(outcome, options.output, session)


def remesh(options: Any, session: Session) -> int:
    """curveups remesh"""
    require_folder_name(options.output)
    request = _request(options, session)
    with_cuts = cuts.CutRequest(edges=np.zeros((1, 2), np.int32))  # a closed target can be cut later
    request.cuts = with_cuts
    target = pipeline.prepare_target(request, session.reporter, [], [])
    folder = Folder(options.output)
    write_obj(folder, f"{request.name}-remeshed.obj", target.V, target.F)
    session.reporter.say(f"{len(target.F)} faces, mean edge {target.mean_edge:.3f} mm")
    return VALID


def targets(options: Any, session: Session) -> int:
    """curveups targets"""
    for name, _ in native.builtin_targets():
        print(name, file=session.output)
    return VALID


def parameters(options: Any, session: Session) -> int:
    """curveups parameters"""
    group = None
    for row in native.parameter_table():
        if row.group != group:
            print(f"{'' if group is None else chr(10)}{row.group}", file=session.output)
            group = row.group
        print(f"  {row.name:<22}{_default(row):<22}{_range(row):<29}{row.meaning}",
              file=session.output)
    return VALID


def verify(options: Any, session: Session) -> int:
    """curveups verify"""
    if options.output:
        require_folder_name(options.output)
    found = _read_design(options.design)
    outcome = pipeline.run_verify(found, session.reporter, str(options.design))
    if options.output:
        folder = Folder(options.output)
        write_reports(outcome, folder)
    return _finish(outcome, options.output, session)


def export(options: Any, session: Session) -> int:
    """curveups export"""
    require_folder_name(options.output)
    found = _read_design(options.design)
    values = found.parameters
    before = values.to_dict()
    affects = {row.name: row.affects for row in native.parameter_table()}
    for name, text in _settings(options.settings):
        _set(values, name, text, f"--set {name}")
        if affects[name] not in ("geometry", "files"):
            raise CurveUpsError(f"{name} can't change on export", f"--set {name}",
                                "run 'curveups design' with it")
    found.parameters = values
    after = values.to_dict()
    changed = any(after[name] != before[name] for name in after if affects[name] == "geometry")
    outcome = pipeline.run_export(found, session.reporter, str(options.design), changed)
    write_outcome(outcome, options.output, session.reporter)
    return _finish(outcome, options.output, session)


COMMANDS = {"design": design, "remesh": remesh, "targets": targets, "parameters": parameters,
            "verify": verify, "export": export}


def _finish(outcome: Any, folder: Path | None, session: Session) -> int:
    words = {True: "valid", False: "not valid", None: "not judged"}
    session.reporter.say(f"{outcome.name}: {len(outcome.design.F)} tiles, "
                         f"{words[outcome.verdict.valid]}")
    for reason in outcome.verdict.reasons:
        session.reporter.say(f"  {reason}")
    _tell_of_cuts(outcome, session.reporter)
    if outcome.stopped:  # a signal that came too late to leave anything out stopped nothing
        session.reporter.say("stopped: what there is, is written" if folder else "stopped")
        return STOPPED
    return NOT_VALID if outcome.verdict.valid is False else VALID


def _tell_of_cuts(outcome: Any, reporter: Reporter) -> None:
    """Where cuts are proposed: how to make them."""
    found = outcome.suggestions
    if found.proposed:
        count = len(found.applied) + len(found.proposed)
        if outcome.verdict.valid is not False:  # otherwise they stand among the reasons
            for cut in found.proposed:
                reporter.say(f"  warning: {describe(cut)} would relieve the layout")
        reporter.say(f"  to make them: --cuts with {outcome.name}-cuts.json, or --auto-cuts {count} for as "
                     "many, chosen anew")


def _request(options: Any, session: Session) -> pipeline.Request:
    values = native.Parameters()
    for path in options.config:
        for name, value in cuts.read_json_object(path).items():
            if name != "about":  # a note of the file's author
                _set(values, name, value, str(path))
    for name, text in _settings(options.settings):
        _set(values, name, text, f"--set {name}")
    try:
        values.check()
    except native.Error as error:
        raise from_native(error, "parameters") from None
    if not values.get("verify"):
        values.set("repair", False)
    name = options.target
    # A tenth of what remeshing may move a vertex, in the target's own coordinates: they are scaled later.
    deflection = 0.0005 * values.get("L") / values.get("scale")
    if name in dict(native.builtin_targets()):
        V, F = native.builtin_target(name, min(max(deflection, 1e-4), 1.0))
        return pipeline.Request(safe_name(name), V, F, values, where=name)
    from . import freecad_io

    path = Path(name)
    session.reporter("reading the target", -1.0)
    V, F = freecad_io.read_target(path, deflection)
    session.interrupt.install()
    if session.interrupt.requested:
        raise Stopped
    return pipeline.Request(safe_name(path.stem), V, F, values, where=str(path))


def _read_design(path: Path) -> Any:
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise CurveUpsError(f"the design can't be read: {error.strerror}", str(path),
                            "check its name and permissions") from None
    except ValueError:
        raise CurveUpsError("the design is no text", str(path),
                            "give a design.json of 'curveups design'") from None
    try:
        found = native.read_design(text)
    except native.Error as error:
        raise from_native(error, str(path)) from None
    found.name = safe_name(found.name)  # files are named after it
    return found


def _settings(texts: list[str]):
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals or not name:
            raise CurveUpsError(f"'{text}' is no setting", "--set", "give name=value")
        yield name.strip(), value.strip()


def _set(values: Any, name: str, value: Any, where: str) -> None:
    try:
        values.set(name, value)
    except native.Error as error:
        raise from_native(error, where) from None
    except RuntimeError:  # a number beyond those that the native module takes
        raise CurveUpsError(f"{name} can't have this value", where,
                            "give one within the range that 'curveups parameters' says") from None


def _default(row: Any) -> str:
    value = row.default
    text = ("on" if value else "off") if isinstance(value, bool) else (
        f"{value:g}" if isinstance(value, (int, float)) else value)
    return f"{text} {row.unit}".strip()


def _range(row: Any) -> str:
    if row.type == "switch":
        return "on, off"
    if row.type == "tiles":
        return "tile names"
    if row.choices:
        return ", ".join(row.choices)
    return f"{row.minimum:g} to {row.maximum:g}"
