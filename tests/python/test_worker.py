# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worker: its status during work, and the ways in which work ends."""

import gc
import threading
import time
import weakref

import numpy as np
import pytest
import running  # noqa: F401

from curveups.base.errors import CurveUpsError
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages.cut_request import CutRequest
from curveups.stages.surface import find_source
from curveups.project.worker import Worker


def project_of(target, **values):
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    source = find_source(target)
    return Project(source.name, parameters, {"source": source, "cut request": CutRequest()}, target)


def finish(worker, seconds=60.0):
    """Polls as a window does."""
    end = time.monotonic() + seconds
    while worker.busy and time.monotonic() < end:
        worker.poll()
        time.sleep(0.01)
    assert not worker.busy


@pytest.fixture
def ended():
    return []


@pytest.fixture
def worker():
    worker = Worker()
    yield worker
    worker.cancel()
    assert worker.wait(60)
    while not worker.idle:
        worker.poll()


def test_a_run_tells_where_it_is_and_hands_its_results_over(worker, ended):
    project = project_of("half-sphere", L=12)
    worker.start(project, ("design", "figures", "verification"), ended.append)
    finish(worker)
    outcome, status = ended[0], worker.status()
    assert outcome.error is None and not outcome.cancelled
    design = outcome.value.design
    assert outcome.value["verification"].judged
    assert status.count > 5
    T, q = status.iterate
    assert T.shape == (len(design.F), 3, 2) and q.shape == (len(design.F), 2, 3)
    assert status.seconds > 0 and status.stage
    assert project.made() == {}, "the run's results are not the project's before somebody takes them"


def test_what_one_stage_says_is_not_said_of_the_next(worker, ended):
    """The bar stood at 97 % while the next stage was at work without a word."""
    said, seen = [threading.Event() for _ in range(2)], [threading.Event() for _ in range(2)]

    def work(job):
        job.stage = "target"
        job("remeshing", 0.97)
        said[0].set()
        assert seen[0].wait(20)
        job.stage = "pin smoothing"
        said[1].set()
        assert seen[1].wait(20)

    worker.start_work(work, ended.append)
    told = []
    for one, other in zip(said, seen):
        assert one.wait(20)
        told.append(worker.status())
        other.set()
    finish(worker)
    assert [(one.stage, one.what, one.fraction) for one in told] == [("target", "remeshing", 0.97),
                                                                     ("pin smoothing", "", -1.0)]


def test_the_last_iterate_of_a_layout_is_its_result(worker, ended):
    worker.start(project_of("half-sphere", L=12), ("layout",), ended.append)
    finish(worker)
    T, q = worker.status().iterate
    # The result is turned and moved besides: distances from the first tile's corner are not.
    distances = [np.linalg.norm(corners - corners[0, 0], axis=2)
                 for corners in (T, ended[0].value["layout"].design.T)]
    assert np.abs(distances[0] - distances[1]).max() < 0.5


def wait_for(worker, stage, iterates=0):
    end = time.monotonic() + 60
    while (worker.status().stage != stage or worker.status().count < iterates) and time.monotonic() < end:
        time.sleep(0.005)
    assert worker.status().stage == stage


def test_stopping_keeps_the_best_so_far(worker, ended):
    worker.start(project_of("tower"), ("design", "figures"), ended.append)
    wait_for(worker, "layout", 2)
    worker.stop()
    assert worker.busy, "it is told by poll alone"
    finish(worker)
    results = ended[0].value
    assert results.stopped and results["layout"].stopped and len(results.design.T)


def test_a_stopped_layout_is_made_anew_when_that_is_asked_for(worker, ended):
    project = project_of("tower", L=12)
    twin = project.copy()
    worker.start_work(lambda job: twin.run(("layout",), job), ended.append)
    wait_for(worker, "layout", 2)
    worker.stop()
    finish(worker)
    assert twin.latest("layout").stopped
    assert twin.run(("layout",))["layout"].stopped, "it counts as there is nothing better"
    twin.forget(["layout"])
    assert not twin.run(("layout",))["layout"].stopped


def test_cancelling_is_told_at_once_and_changes_nothing(worker, ended):
    project = project_of("tower")
    worker.start(project, ("design",), ended.append)
    wait_for(worker, "layout", 1)
    worker.cancel()
    worker.poll()
    assert ended[0].cancelled and ended[0].value is None and not worker.busy
    assert project.made() == {}


def test_cancelling_is_told_before_the_thread_has_ended(worker, ended):
    release = threading.Event()
    worker.start_work(lambda job: release.wait(60), ended.append)
    worker.cancel()
    worker.poll()
    assert ended[0].cancelled and not worker.busy and not worker.wait(0)
    release.set()
    assert worker.wait(60)


def test_work_after_a_cancelled_one_waits_for_its_thread(worker, ended):
    at_once, release = [0], threading.Event()

    def work(job):
        at_once.append(at_once[-1] + 1)
        release.wait(10)
        at_once.append(at_once[-1] - 1)
        return "done"

    worker.start_work(work, ended.append)
    worker.cancel()
    worker.poll()
    worker.start_work(work, ended.append)
    assert len(at_once) <= 2, "it is to wait for the first"
    release.set()
    finish(worker)
    assert ended[1].value == "done" and max(at_once) == 1


def test_one_thing_at_a_time(worker, ended):
    release = threading.Event()
    worker.start_work(lambda job: release.wait(10), ended.append)
    with pytest.raises(CurveUpsError, match="at work already"):
        worker.start_work(lambda job: None, ended.append)
    release.set()
    finish(worker)
    assert len(ended) == 1


def test_errors_arrive_as_what_they_are(worker, ended):
    worker.start(project_of("no-such-file.stl"), ("design",), ended.append)
    finish(worker)
    assert isinstance(ended[0].error, CurveUpsError) and "no such target" in str(ended[0].error)
    worker.start_work(lambda job: 1 / 0, ended.append)
    finish(worker)
    assert isinstance(ended[1].error, ZeroDivisionError)
    worker.start_work(lambda job: native.read_design("{}"), ended.append)
    finish(worker)
    assert isinstance(ended[2].error, CurveUpsError) and ended[2].error.remedy


def test_what_was_made_goes_with_the_last_who_needs_it(worker, monkeypatch):
    """Results are freed at once: collecting those of 2500 tiles stops the window for a second."""
    class Made:
        pass

    def work(job):
        found = Made()
        made.append(weakref.ref(found))
        return found

    made, kept = [], []
    monkeypatch.setattr(gc, "collect", lambda *_: 0)
    worker.start_work(work, lambda outcome: kept.append(outcome.value))
    finish(worker)
    assert made[0]() is kept[0]
    kept.clear()
    assert made[0]() is None


@pytest.mark.parametrize("cancel", [False, True])
def test_garbage_ends_in_the_thread_that_polls(worker, ended, cancel):
    """Widgets must end there. By default Python collects in the worker's thread, which makes more objects."""
    threads, made, going_on = set(), threading.Event(), threading.Event()

    class Widget:
        def __init__(self):
            self.cycle = self

        def __del__(self):
            threads.add(threading.current_thread())

    def work(job):
        for _ in range(100):
            [Widget() for _ in range(100)]
        made.set()
        assert going_on.wait(60)

    worker.start_work(work, ended.append)
    assert made.wait(60) and not threads
    worker.poll()
    assert threads == {threading.current_thread()}
    if cancel:
        worker.cancel()
        worker.poll()
        assert ended[0].cancelled and not worker.idle  # its thread may make garbage still
    going_on.set()
    assert worker.wait(60)
    assert not gc.isenabled()
    for _ in range(2):  # the end, then what comes after it
        worker.poll()
    assert len(ended) == 1 and worker.idle and gc.isenabled()
    assert threads == {threading.current_thread()}
