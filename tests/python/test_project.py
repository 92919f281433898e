# SPDX-License-Identifier: LGPL-2.1-or-later
"""A project runs what is missing and nothing else, and knows what its results were made from."""

import threading

import pytest
from running import dome

from curveups.project import project as projects
from curveups.project import saved_results
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.native import native
from curveups.base.parameters import table
from curveups.project.project import Project
from curveups.stages import STAGES
from curveups.stages.cut_request import CutRequest
from curveups.stages.design import design_digest
from curveups.stages.stage import Job
from curveups.stages.surface import find_source

GOALS = ("figures", "deviation", "verification", "bodies", "suggestions")


def changed(parameters, **values):
    for name, value in values.items():
        parameters.set(name, value)
    return parameters


@pytest.fixture
def project(tmp_path):
    (tmp_path / "cap.obj").write_text(dome(2))
    source = find_source(str(tmp_path / "cap.obj"), remesh=False)
    return Project("cap", native.Parameters(), {"source": source, "cut request": CutRequest()}, "cap")


@pytest.fixture
def ran(monkeypatch):
    """The names of the stages that were run, in order."""
    names = []
    work = projects._Run._work
    monkeypatch.setattr(projects._Run, "_work",
                        lambda self, stage, key: names.append(stage.name) or work(self, stage, key))
    return names


def test_only_what_is_missing_is_run(project, ran):
    project.run(("target",))
    assert ran == ["surface", "target"]
    project.run(("layout",))
    assert ran[2:] == ["target smoothing", "division", "cuts", "pin smoothing", "layout"]
    first = project.run(GOALS)
    del ran[:]
    again = project.run(GOALS)
    assert ran == [] and all(again[name] is first[name] for name in first)


@pytest.mark.parametrize("name, value, kept, run", [
    ("friction_coefficient", 0.6, "layout", "verification"),
    ("orientation", "front-down", "verification", "bodies"),
    ("H_body", 2.5, "target", "layout"),
    ("tau", 2.8, "pin smoothing", "layout"),
    ("d_gap_min", 0.7, "pin smoothing", "layout"),
    ("printer", "resin", "bodies", None),
    ("A_pin_min", 3.5, "target", "layout"),
])
def test_a_change_runs_what_reads_it_and_keeps_the_rest(project, ran, name, value, kept, run):
    project.parameters = changed(project.parameters, support="breakaway")  # for any orientation
    before = project.run(GOALS)
    del ran[:]
    project.parameters = changed(project.parameters, **{name: value})
    names = [stage.name for stage in STAGES]
    assert project.out_of_date(kept) == ()
    if run:
        assert name in project.out_of_date(run)
    after = project.run(GOALS)
    assert all(after[other] is before[other] for other in names[:names.index(kept) + 1]
               if other in before and other not in ran)
    assert not set(ran) & set(names[:names.index(kept) + 1]) or kept in ("verification", "bodies")
    assert kept not in ran and (run is None or run in ran)
    assert all(project.out_of_date(other) == () for other in GOALS)


def test_what_is_out_of_date_says_why_and_comes_back(project, ran):
    assert project.out_of_date("layout") is None
    project.run(("verification",))
    assert project.out_of_date("verification") == ()
    project.parameters = changed(project.parameters, tau=2.5, f_min_ratio=0.05)
    assert set(project.out_of_date("layout")) == {"tau"}
    assert set(project.out_of_date("verification")) == {"tau", "f_min_ratio"}
    assert project.out_of_date("target") == ()
    # Back to the values it was made from: nothing is out of date, nothing runs.
    project.parameters = changed(project.parameters, tau=3.0, f_min_ratio=0.1)
    del ran[:]
    assert project.out_of_date("verification") == ()
    project.run(("verification",))
    assert ran == []


def test_a_layout_that_was_made_anew_takes_its_verification_along(project):
    first = project.run(("verification",))
    project.parameters = changed(project.parameters, d_gap_min=0.7)
    project.run(("layout",))
    assert project.latest("verification") is first["verification"]
    assert set(project.out_of_date("verification")) == {"layout", "d_gap_min"}


def test_values_that_contradict_one_another_change_nothing(project):
    with pytest.raises(CurveUpsError, match="p_min"):
        project.parameters = changed(project.parameters, p_min=5.0)
    assert project.parameters.get("p_min") == 0.6
    assert project.parameters.get("repair") is True
    project.parameters.set("tau", 1.5)  # a copy
    assert project.parameters.get("tau") == 3.0


OTHER = {"number": lambda row, now: now * 0.9 if row.minimum <= now * 0.9 else now * 1.1 + 0.01,
         "switch": lambda row, now: not now,
         "choice": lambda row, now: next(c for c in row.choices if c != now),
         "tiles": lambda row, now: "T00003", "faces": lambda row, now: "Face1",
         "opening": lambda row, now: "none", "pieces": lambda row, now: "2"}


def test_no_stage_reads_a_parameter_that_it_does_not_declare(project):
    """Another value of each parameter leaves every stage that does not name it with what it had."""
    project.parameters = changed(project.parameters, gravity="held")
    made = project.run(("figures", "bodies", "suggestions"))
    stages = {stage.name: stage for stage in STAGES}

    def figures(name, parameters):
        inputs = projects.Inputs(parameters, {other: made[other] for other in stages[name].reads},
                                 "cap")
        found = stages[name].run(inputs, Job())
        if name == "bodies":
            return [tuple(found.model.bbox), dict(found.model.volumes), list(found.model.thinnest)]
        if name == "layout":
            return design_digest(found.design)
        if name == "verification":  # not the one that the layout's verification left
            inputs.results["design"] = projects.FinishedDesign(made["design"].design)
            return found.blocks["contact_forces"], found.blocks["unilateral"]
        return found.content or found.report()

    base = made.parameters
    names = ("surface", "target", "cuts", "pin smoothing", "layout", "figures", "bodies", "suggestions")
    expected = {name: figures(name, base) for name in names}
    for row in table():
        if row.name in ("run_verification", "L"):
            continue
        other = changed(native.Parameters(base), **{row.name: OTHER[row.type](row, base.get(row.name))})
        for name in names:
            if row.name not in stages[name].parameters(made.parameters):
                assert str(figures(name, other)) == str(expected[name]), (row.name, name)


def test_verification_reads_what_it_declares(project):
    made = project.run(("design",))
    stage = next(stage for stage in STAGES if stage.name == "verification")
    given = {"design": projects.FinishedDesign(made.design)}

    def blocks(parameters):
        found = stage.run(projects.Inputs(parameters, given, ""), Job())
        return str(found.report())

    expected = blocks(made.parameters)
    for row in table():
        if row.name in stage.parameters(made.parameters) or row.name == "L":
            continue
        value = OTHER[row.type](row, made.parameters.get(row.name))
        other = changed(native.Parameters(made.parameters), **{row.name: value})
        assert blocks(other) == expected, row.name


def test_one_thread_works_while_another_reads(project):
    seen, done = [], threading.Event()

    def read():
        while not done.is_set():
            seen.append((project.out_of_date("layout"), project.latest("layout"),
                         project.parameters.get("tau")))

    reader = threading.Thread(target=read)
    reader.start()
    results = []
    worker = threading.Thread(target=lambda: results.append(project.run(("verification",))))
    worker.start()
    worker.join()
    done.set()
    reader.join()
    assert results[0].verdict.valid is True
    assert {state for state, _, _ in seen} <= {None, ()} and (None, None, 3.0) in seen


def test_results_are_saved_and_restored(project, ran, tmp_path):
    before = project.run((*GOALS, "solids", "check"))
    text = saved_results.to_text(project.made())
    del ran[:]
    again = Project("cap", project.parameters, {"source": before["source"], "cut request": CutRequest()},
                    "cap", saved_results.from_text(text))
    after = again.run((*GOALS, "solids", "check"))
    assert ran == ["bodies", "solids"]  # native bodies are not saved
    assert after.verdict == before.verdict and after.warnings() == before.warnings()
    assert native.write_design(after.design) == native.write_design(before.design)
    for name, result in before.items():
        if result.lasting:
            assert str(after[name].report()) == str(result.report()).replace("[", "(").replace("]", ")") or \
                after[name].content == result.content
    # What they were made from is known still.
    again.parameters = changed(again.parameters, tau=2.5)
    assert "tau" in again.out_of_date("verification")


HEAD = '{"format": "curveups-results", "version": 1, "results": '
NOTHING = '{"layout": {"key": {}, "seconds": 1, "result": {"value": "Nothing", "fields": {}}}}'


@pytest.mark.parametrize("text", ["", "{}", "[]", HEAD.replace("1", "9") + "{}}",
                                  HEAD + '{"layout": 3}}', HEAD + NOTHING + "}"])
def test_saved_results_that_were_spoiled_are_refused(text):
    with pytest.raises(CurveUpsError, match="saved results"):
        saved_results.from_text(text, "a document")


def test_stopping_means_the_best_so_far_or_nothing(project):
    def stop_at(word):
        return Job(lambda what, fraction: word not in what)

    with pytest.raises(Stopped):
        project.run(GOALS, stop_at("checking the target"))
    assert project.latest("target") is None or project.latest("layout") is None
    results = project.run(GOALS, stop_at("layout"))
    assert results.stopped and results["layout"].stopped and results.verdict.valid is not True
    assert str(results["verification"].note) == "stopped during layout"
    assert "deviation" not in results["deviation"].report(), "it takes seconds, and was measured after a stop"
    assert len(results.design.T) == 24 and not results.rows()[-1].name == "verify"
    # The best so far was kept, not taken for all there is to have.
    results = project.run(GOALS, stop_at("membrane"))
    assert str(results["verification"].note) == "stopped during verification"
    assert project.latest("verification") is None


def test_who_listens_gets_the_iterates_and_the_same_design(project, tmp_path):
    heard = []
    listening = Job(listen=lambda stage, T, q, figure, _: heard.append((stage, T, q, figure)))
    design = project.run(("design",), listening).design
    assert {stage for stage, *_ in heard} == {"layout"}
    assert all(T.shape == (24, 3, 2) and q.shape == (24, 2, 3) for _, T, q, _ in heard)
    assert len(heard) > project.latest("layout").block["iterations"]
    assert heard[-1][3] < heard[0][3]
    again = Project("cap", native.Parameters(), {"source": project.latest("source"),
                                                 "cut request": CutRequest()})
    assert design_digest(again.run(("design",)).design) == design_digest(design)
    stop = Job(listen=lambda *_: setattr(stop, "stopped", True))
    third = Project("cap", native.Parameters(), {"source": project.latest("source"),
                                                 "cut request": CutRequest()})
    assert third.run(("figures",), stop)["layout"].stopped


def test_a_design_that_is_given_has_no_target(project):
    design = project.run(("design",)).design
    given = Project.of_design(design, "design.json")
    assert given.run(("figures", "verification")).verdict.valid is True
    with pytest.raises(CurveUpsError, match="source"):
        given.run(("layout",))
