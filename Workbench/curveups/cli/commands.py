# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the commands of the command line."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Iterator, Sequence

from ..base.errors import NOT_VALID, STOPPED, VALID, CurveUpsError, Stopped
from ..base.findings import Finding, first_of_each_kind
from ..base.language import Language
from ..base.native import native, translated
from ..base.output import Folder, plain_name, safe_name
from ..base.parameters import parameter, table, with_values, without_switches
from ..base.profiles import MATERIALS, NOTES, of_material, profile_path
from ..base.progress import Reporter
from ..features.document_file import write_document
from ..kit import compare as comparing, files as kit_files
from ..project.following import carry_along
from ..project.project import Project, Results
from ..project.size_choice import AUTOMATIC, choose
from ..report import actuation, check as check_report
from ..report.exports import write_spares
from ..report.files import write_check, write_files, write_obj, write_verification
from ..stages import RISEN, stages_of
from ..stages.cut_request import CutRequest, read_cuts, read_json_object
from ..stages.following import Earlier
from ..stages.solids import density_of
from ..stages.stage import Job
from ..stages.surface import find_source


def design(options: Any, reporter: Reporter) -> int:
    """curveups design"""
    earlier = _read_design(options.follow) if options.follow else None
    project = _project(options, replace(_cuts(options), suggested=options.auto_cuts), reporter, earlier)
    job = Job(reporter)
    if earlier:
        carry_along(project, Earlier.of(earlier), job, not options.cuts and not options.auto_cuts)
        reporter.say(str(project.latest("target").tiling))
    if (cuts := project.latest("cut request")).suggested:
        project.give("cut request", cuts.accept(project.run(("cut search",), job)["cut search"]))
    goals = (*stages_of("solve"), *stages_of("settle", *(() if options.no_solids else ("build", "print"))))
    results = project.run(goals, job)
    stopped = write_files(results, options.output, job, write_document)
    return _finish(results, options.output, reporter, stopped)


def check(options: Any, reporter: Reporter) -> int:
    """curveups check"""
    cuts = _cuts(options)
    # Closed surfaces are accepted and reported.
    project = _project(options, replace(cuts, suggested=1), reporter)
    project.give("cut request", cuts)
    job = Job(reporter)
    results = project.run(stages_of("check"), job)
    for line in check_report.table(results):
        _answer(line)
    results = project.run(stages_of("check", "sizes"), job)
    for finding in check_report.advice(results):
        _answer(str(finding))
    if options.output:
        write_check(results, options.output)
    if results.stopped:
        return STOPPED
    return VALID if results["feasibility"].feasible else NOT_VALID


def remesh(options: Any, reporter: Reporter) -> int:
    """curveups remesh"""
    # A closed target may be cut later.
    project = _project(options, CutRequest(suggested=1), reporter)
    target = project.run(("target",), Job(reporter))["target"]
    write_obj(Folder(options.output), f"{project.name}-remeshed.obj", target.V, target.F)
    reporter.say(f"{len(target.F)} faces, mean edge {target.mean_edge:.3f} mm")
    return VALID


def targets(options: Any, reporter: Reporter) -> int:
    """curveups targets"""
    for name, _ in native.builtin_targets():
        _answer(name)
    return VALID


def parameters(options: Any, reporter: Reporter) -> int:
    """curveups parameters"""
    shown = [row for row in table() if row.basic or options.all]
    for before, row in zip((None, *shown), shown):
        if before is None or row.group != before.group:
            _answer(f"\n{row.group}" if before else row.group)
        _answer(f"  {row.name:<28}{_default(row):<22}{_range(row):<29}{row.meaning}")
    if not options.all:
        _answer("\n'curveups parameters --all' lists the others, too")
    return VALID


def verify(options: Any, reporter: Reporter) -> int:
    """curveups verify"""
    design = _read_design(options.design)
    project = Project.of_design(design, str(options.design))
    project.parameters = with_values(project.parameters, {"run_verification": True})
    results = project.run(stages_of("verify"), Job(reporter), strict=True)
    if options.output:
        write_verification(results, design, options.output)
    return _finish(results, options.output, reporter, results.stopped)


def export(options: Any, reporter: Reporter) -> int:
    """curveups export"""
    project, rebuilt = _design_project(options, reporter)
    job = Job(reporter)
    if options.tiles is not None:
        spares = write_spares(project, options.output, options.tiles, job)
        reporter.say(f"written: {', '.join(spares)}")
        return VALID
    note = Finding("unverified.changed" if rebuilt else "unverified.export")
    results = project.run(stages_of("build", "print"), job, strict=True, note=note)
    stopped = write_files(results, options.output, job, write_document)
    return _finish(results, options.output, reporter, stopped)


def kit(options: Any, reporter: Reporter) -> int:
    """curveups kit"""
    order = kit_files.Order(options.quantity, options.names, Language(options.language).name)
    project, _ = _design_project(options, reporter)
    job = Job(reporter)
    results = kit_files.make(project, job)
    if not results["check"].print_block:  # stopped before there was anything to draw
        raise Stopped
    stopped = kit_files.write_kit(results, options.output, job, order)
    return _finish(results, options.output, reporter, stopped)


def compare(options: Any, reporter: Reporter) -> int:
    """curveups compare"""
    design = _read_design(options.design)
    with translated(str(options.scan)):
        scan = comparing.read_scan(options.scan, len(design.F))
        comparison = comparing.compare(design, scan, Job(reporter))
    comparison.update(comparing.predictions(options.design, len(design.F)))
    comparing.write_comparison(design, comparison, options.output)
    for line in comparing.summary(comparison):
        _answer(line)
    return VALID


def actuate(options: Any, reporter: Reporter) -> int:
    """curveups actuate"""
    project, _ = _design_project(options, reporter, ("rebuild", "files", "verify"))
    job = Job(reporter)
    results = project.run(("bodies", *stages_of("actuate")), job, strict=True)
    with translated(str(options.design)):
        stopped = actuation.write_actuation(results, options.output, job)
    for finding in results[RISEN].findings():
        reporter.say(f"{project.name}: {finding}")
    if stopped:
        reporter.say("stopped: the files so far are written")
        return STOPPED
    return VALID if results[RISEN].is_known else NOT_VALID


COMMANDS = {command.__name__: command for command in (design, check, remesh, targets, parameters, verify,
                                                      export, kit, compare, actuate)}


def _design_project(options: Any, reporter: Reporter, effects: tuple[str, ...] = ("rebuild", "files")
                    ) -> tuple[Project, bool]:
    """Project of a design file with settings that have one of these effects, and whether they change its
    geometry."""
    project = Project.of_design(_read_design(options.design), str(options.design))
    values, rebuilt = project.parameters, False
    # The density follows the printer where it is the printer's and no verdict depends on it.
    follows = values.get("density") == density_of(values.get("printer")) and values.get("gravity") == "off"
    given = list(_settings(options))
    for name, value, _ in _of_printer(given) if follows else ():
        values.set(name, value)
    for name, value, where in _with_materials(given):
        before = native.Parameters(values)
        with translated(where):
            values.set(name, value)
        row = parameter(native.parameter_name(name))
        if row.effect not in effects:
            typed = where.removeprefix("--set ")  # possibly a material's
            raise CurveUpsError(f"{typed} can't change on {options.command}", where,
                                "run 'curveups design' with it")
        rebuilt |= row.effect == "rebuild" and values.get(name) != before.get(name)
    project.parameters = values
    return project, rebuilt


def _answer(line: str) -> None:
    """Prints a line on standard output."""
    print(line, flush=True)


def _finish(results: Results, folder: Path | None, reporter: Reporter, stopped: bool) -> int:
    verdict = results.verdict
    settled = results.get("settle")
    needed = settled.friction_needed.get("coefficient") if settled else None
    friction = "" if needed is None else f", needs friction {needed:.2g}"
    reporter.say(f"{results.name}: {len(results['design'].design.F)} tiles, {verdict.word}{friction}")
    for reason in verdict.reasons:
        reporter.say(f"  {reason}")
    for first, others in first_of_each_kind(results.warnings()):  # report.json and the page have all
        reporter.say(f"  warning: {first}" + (f" (and {others} more of this kind)" if others else ""))
    suggestions = results.get("suggestions")
    if suggestions is not None and suggestions.proposed:
        if verdict.valid is not False:  # otherwise they stand among the reasons
            for cut in suggestions.proposed:
                reporter.say(f"  warning: {cut} would relieve the layout")
        reporter.say(f"  to make them: --cuts with {results.name}-cuts.json, or --auto-cuts "
                     f"{len(suggestions.applied) + len(suggestions.proposed)} for as many, chosen anew")
    if stopped:
        reporter.say("stopped: the files so far are written" if folder else "stopped")
        return STOPPED
    return NOT_VALID if verdict.valid is False else VALID


def _cuts(options: Any) -> CutRequest:
    return read_cuts(options.cuts) if options.cuts else CutRequest()


def _project(options: Any, cuts: CutRequest, reporter: Reporter, earlier: Any = None) -> Project:
    """Project of a target; with L=auto or H_body=auto, with the chosen sizes and their design. earlier: the
    design whose parameters are the defaults."""
    values, automatic = without_switches(earlier), set()
    profile = [profile_path(options.profile)] if options.profile else []
    of_profile, given = ([(name, value, str(path)) for path in paths
                          for name, value in read_json_object(path).items() if name not in NOTES]
                         for paths in (profile, options.config))
    given += _settings(options)
    for name, value, where in (*_of_printer([*of_profile, *given]), *of_profile, *_with_materials(given)):
        if name in AUTOMATIC and value == "auto":
            automatic.add(name)
        else:
            automatic.discard(name)
            with translated(where):
                values.set(name, value)
    if earlier and automatic:
        raise CurveUpsError(f"{sorted(automatic)[0]}=auto makes other tiles", "--follow",
                            "leave one of them out")
    if earlier and options.no_remesh:
        raise CurveUpsError("--no-remesh takes other tiles", "--follow", "leave one of them out")
    will_be_cut = (bool(cuts) or bool(earlier and len(earlier.cuts)) or cuts.suggested > 0
                   or values.get("pieces") != "1")
    remesh = not getattr(options, "no_remesh", False)
    source = find_source(options.target, remesh=remesh, will_be_cut=will_be_cut)
    project = Project(safe_name(source.name), values, {"source": source, "cut request": cuts}, options.target)
    if not automatic:
        return project
    choice = choose(project, automatic, Job(reporter))
    for finding in choice.findings():
        reporter.say(str(finding))
    for name, value in choice.values.items():
        reporter.say(f"{name} = {value:g} mm is chosen")
    return choice.project


def _of_printer(given: Sequence[tuple[str, Any, str]]) -> Iterator[tuple[str, Any, str]]:
    """Parameters that depend on a given printer: the density of its material."""
    printer = next((value for name, value, _ in reversed(given) if name == "printer"), None)
    if printer in parameter("printer").choices:
        yield "density", density_of(printer), printer


def _with_materials(given: Sequence[tuple[str, Any, str]]) -> list[tuple[str, Any, str]]:
    """Settings with the parameters of materials in place of their names; other settings win over these."""
    of_materials = [(name, value, where) for kind, material, where in given if kind in MATERIALS
                    for name, value in of_material(kind, material, where).items()]
    return of_materials + [row for row in given if row[0] not in MATERIALS]


def _read_design(path: Path) -> Any:
    try:
        text = path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise CurveUpsError(f"the design can't be read: {error.strerror}", str(path),
                            "check its name and permissions") from None
    except ValueError:
        raise CurveUpsError("the design is no text", str(path),
                            "give a design.json of 'curveups design'") from None
    with translated(str(path)):
        design = native.read_design(text)
    return design.with_name(plain_name(design.name))


def _settings(options: Any) -> Iterator[tuple[str, str, str]]:
    """Names, values and places of --set, and of options that switch a parameter on."""
    for text in options.settings:
        name, equals, value = map(str.strip, text.partition("="))
        if not equals or not name:
            raise CurveUpsError(f"'{text}' is no setting", "--set", "give name=value")
        yield name, value, f"--set {name}"
    for name in ("self_shaping", "check_all"):
        if getattr(options, name, False):
            yield name, "on", f"--{name.replace('_', '-')}"


def _default(row: Any) -> str:
    value = row.default
    text = ("on" if value else "off") if isinstance(value, bool) else (
        f"{value:g}" if isinstance(value, (int, float)) else value)
    return f"{text} {row.unit}".strip()


# Formats of text parameters, by the type of their rows.
TEXTS = {"tiles": "tile names", "faces": "face names", "opening": "auto, largest, none, z=0, ...",
         "pieces": "1 to 24, or auto"}


def _range(row: Any) -> str:
    if row.type == "switch":
        return "on, off"
    if row.type in TEXTS:
        return TEXTS[row.type]
    if row.choices:
        return ", ".join(row.choices)
    return f"{row.minimum:g} to {row.maximum:g}"
