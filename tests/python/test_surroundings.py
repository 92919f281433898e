# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the program is started from and what it is connected to: closed and full streams, odd folders,
a checkout that can't be written."""

import os
import shutil
import signal
import subprocess
import sys

import cad
import pytest
from running import ROOT, command, environment

DESIGN = ("design", "disc", "-o", "out", "--no-solids", "--set", "run_verification=off")


def run(folder, redirection, *arguments, **more):
    """Status and standard error of a command with its streams as a shell redirects them."""
    line = f'"$@" {redirection}'
    done = subprocess.run(["bash", "-c", line, "bash", *command(*arguments)], cwd=folder,
                          env=environment(**more), capture_output=True, text=True)
    return done.returncode, done.stderr


@pytest.mark.parametrize("redirection", [">/dev/full", ">&-", "2>/dev/full", "2>&-", "<&- >&- 2>&-"])
def test_a_design_needs_no_stream(tmp_path, redirection):
    status, _ = run(tmp_path, redirection, *DESIGN)
    assert status == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"design.json", "report.json",
                                                                    "report.html"}


@pytest.mark.parametrize("redirection", [">/dev/full", ">&-"])
@pytest.mark.parametrize("asked", ["targets", "parameters"])
def test_an_answer_that_goes_nowhere_is_an_error(tmp_path, redirection, asked):
    status, said = run(tmp_path, redirection, asked)
    assert status == 4 and said.count("\n") == 1, said
    assert said.startswith("curveups: error: the answer can't be written: ")
    assert "(standard output)" in said


@pytest.mark.parametrize("redirection", ["2>/dev/full", "2>&-", "<&- >&- 2>&-"])
def test_statuses_stay_where_nothing_can_be_said(tmp_path, redirection):
    assert run(tmp_path, redirection, "design", "no-such", "-o", "out")[0] == 2
    assert run(tmp_path, redirection, "--help")[0] == 0


@pytest.mark.parametrize("program", ["tools/curveups", "packaging/debian/curveups"])
def test_a_module_in_the_current_folder_is_not_run(tmp_path, program):
    """The installed command, too, which finds its modules elsewhere."""
    (tmp_path / "numpy.py").write_text("raise SystemExit('executed')\n")
    done = subprocess.run([ROOT / program, *DESIGN], cwd=tmp_path, capture_output=True, text=True,
                          env=environment())
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "design.json").exists()


def test_from_a_link_with_a_search_path_for_folders(tmp_path):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "curveups").symlink_to(ROOT / "tools" / "curveups")
    done = subprocess.run([tmp_path / "bin" / "curveups", "targets"], cwd=ROOT, capture_output=True,
                          text=True, env={**os.environ, "CDPATH": f"{ROOT}:/"})
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr
    done = subprocess.run(["tools/curveups", "targets"], cwd=ROOT, capture_output=True, text=True,
                          env={**os.environ, "CDPATH": f"{ROOT}:/"})
    assert done.returncode == 0 and "half-sphere\n" in done.stdout, done.stderr


@pytest.mark.skipif(os.geteuid() != 0 or not shutil.which("setpriv"), reason="another user is needed")
def test_a_checkout_of_another_user(tmp_path):
    """Nothing is missing, so nothing is written there."""
    os.chmod(tmp_path, 0o777)
    done = subprocess.run(["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
                           ROOT / "tools" / "curveups", *DESIGN], cwd=tmp_path, capture_output=True,
                          text=True, env={**os.environ, "HOME": str(tmp_path)})
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "design.json").exists()


@pytest.mark.parametrize("name", ["", b"out-\xff"])
def test_folders_without_a_usable_name(tmp_path, name):
    done = subprocess.run([*command("design", "disc", "--no-solids", "-o"), name], cwd=tmp_path,
                          env=environment(), capture_output=True, text=True)
    assert done.returncode == 2, done.stderr
    assert "folder" in done.stderr and "name" in done.stderr and done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def within(folder, kilobytes, *arguments):
    """A program that may have so much memory. No end is a failure."""
    limited = ["bash", "-c", f'ulimit -v {kilobytes}; exec "$@"', "bash", *arguments]
    return subprocess.run(limited, cwd=folder, env=environment(), capture_output=True, text=True,
                          timeout=240)


@pytest.mark.parametrize("kilobytes", [300_000, 380_000, 460_000, 540_000, 620_000])
def test_a_whole_design_in_little_memory_ends_with_a_word(tmp_path, cap, kilobytes):
    """Qt's threads wait for ever for one that could not begin: FreeCAD's Mesh is asked for nothing then."""
    done = within(tmp_path, kilobytes, *command("design", cap, "-o", "out", "--no-remesh"))
    files = set(path.name for path in (tmp_path / "out").glob("*"))
    if done.returncode == 0:
        assert "small-cap.FCStd" in files and "report.json" in files
        return
    assert "there is not enough memory" in done.stderr.splitlines()[-1], done.stderr
    assert (done.returncode, bool(files)) in ((2, False), (4, True))
    for name in files:
        assert name in done.stderr


@pytest.mark.parametrize("kilobytes", [380_000, 540_000, 620_000])
def test_two_signals_end_a_design_in_little_memory(tmp_path, cap, kilobytes):
    """While files are written, at the latest. The thread that writes them waited in FreeCAD for memory, and
    the signals for that thread."""
    limited = ["bash", "-c", f'ulimit -v {kilobytes}; exec "$@"', "bash",
               *command("design", cap, "-o", "out", "--no-remesh")]
    process = subprocess.Popen(limited, cwd=tmp_path, env=environment(), stderr=subprocess.PIPE, text=True)
    said = ""
    for line in process.stderr:
        said += line
        if "writing" in line:
            process.send_signal(signal.SIGINT)
            process.send_signal(signal.SIGINT)
            break
    _, rest = process.communicate(timeout=240)
    said += rest
    assert process.returncode in (0, 2, 3, 4), said
    files = {path.name for path in (tmp_path / "out").glob("*")}
    assert not [name for name in files if name.startswith(".")]
    if process.returncode in (0, 3) and files:
        assert "report.json" in files
    elif process.returncode != 3:
        assert "there is not enough memory" in said.splitlines()[-1], said


@pytest.mark.parametrize("kilobytes", [300_000, 340_000, 380_000, 420_000])
def test_a_part_in_little_memory_is_not_blamed(tmp_path, kilobytes):
    part = cad.make(tmp_path, "bowl", ending="step")["bowl"]
    done = within(tmp_path, kilobytes, *command("check", part, "--set", "L=20"))
    if done.returncode not in (0, 1):
        assert done.returncode == 2 and "memory" in done.stderr.splitlines()[-1], done.stderr


@pytest.mark.parametrize("name", ["MPLBACKEND", "MPLCONFIGDIR", "HOME"])
def test_the_pages_pictures_need_no_sound_surroundings(tmp_path, name):
    status, said = run(tmp_path, "", *DESIGN, **{name: "/dev/null/nowhere"})
    assert status == 0 and "matplotlib" not in said.lower(), said
    assert "<img" in (tmp_path / "out" / "report.html").read_text("utf-8")


def test_commands_load_what_draws_when_they_draw():
    """It takes half a second and 100 MB, and what it says of folders is no news of a target."""
    done = subprocess.run([sys.executable, "-c", "import sys\nfrom curveups.cli import commands\n"
                                                 "print(*sys.modules)"],
                          env=environment(), capture_output=True, text=True)
    loaded = set(done.stdout.split())
    assert "curveups.cli.commands" in loaded, done.stderr
    assert not loaded & {"matplotlib", "ezdxf", "scipy"}


def test_a_page_without_pictures_is_better_than_none(tmp_path):
    (tmp_path / "matplotlib").mkdir()
    (tmp_path / "matplotlib" / "__init__.py").write_text(
        "raise OSError('no folder that may be written to')\n")
    broken = os.pathsep.join((str(tmp_path), environment()["PYTHONPATH"]))
    status, said = run(tmp_path, "", *DESIGN, PYTHONPATH=broken)
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert status == 0, said
    assert "<img" not in page and "no folder that may be written to" in page and "<h2>Figures" in page
    status, said = run(tmp_path, "", "check", "disc", "-o", "out", PYTHONPATH=broken)
    page = (tmp_path / "out" / "check.html").read_text("utf-8")
    assert status in (0, 1) and "could not be drawn" in page, said


IMPATIENT = """
import os, signal, sys
from importlib.machinery import ExtensionFileLoader

class Impatient:
    def find_spec(self, name, path=None, target=None):
        frame = sys._getframe()
        while frame is not None and not isinstance(frame.f_locals.get("self"), ExtensionFileLoader):
            frame = frame.f_back
        if frame is not None:
            sys.meta_path.remove(self)
            os.kill(os.getpid(), signal.SIGINT)
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Impatient())
"""


def test_two_signals_while_extensions_are_loaded_are_a_stop(tmp_path):
    """numpy makes an ImportError of them, with advice on how to install it."""
    (tmp_path / "sitecustomize.py").write_text(IMPATIENT)
    status, said = run(tmp_path, "", *DESIGN,
                       PYTHONPATH=os.pathsep.join((str(tmp_path), environment()["PYTHONPATH"])))
    assert status == 3 and said.splitlines()[-1] == "curveups: stopped", said
    assert not (tmp_path / "out").exists()


def test_what_a_killed_run_left_goes_with_the_next(tmp_path):
    gone = subprocess.Popen(["true"])
    gone.wait()
    out = tmp_path / "out"
    out.mkdir()
    left = [out / f".{gone.pid}-{name}" for name in ("design.json", "disc-print.3mf", "disc.FCStd",
                                                     "disc-tiles.step.part77", "report.html")]
    others = [out / f".{os.getpid()}-disc.FCStd", out / ".notes-design.json", out / f".{gone.pid}-mine.txt"]
    for path in (*left, *others):
        path.write_text("half")
    status, said = run(tmp_path, "", *DESIGN)
    assert status == 0, said
    assert not [path for path in left if path.exists()] and all(path.exists() for path in others)


@pytest.mark.skipif(not os.access("/proc/kmsg", os.R_OK), reason="the kernel's messages may not be read")
@pytest.mark.parametrize("arguments", [("design", "/proc/kmsg", "-o", "out"), ("verify", "/proc/kmsg"),
                                       ("design", "disc", "-o", "out", "--cuts", "/proc/kmsg"),
                                       ("design", "disc", "-o", "out", "--config", "/proc/kmsg"),
                                       ("design", "log.obj", "-o", "out")])
def test_files_of_the_system_are_not_waited_for(tmp_path, arguments):
    (tmp_path / "log.obj").symlink_to("/proc/kmsg")
    status, said = run(tmp_path, "", *arguments)
    assert status == 2 and said.count("curveups: error: ") == 1, said
    assert "/proc/kmsg" in said or "log.obj" in said


def test_as_many_threads_as_there_are_processors_at_most(tmp_path):
    for asked in ("1000000", "99999999999999999999", "0", "-3", "many"):
        done = subprocess.run([sys.executable, "-c", "from curveups.base.native import native\n"
                                                     "print(native.thread_count())"],
                              env=environment(CURVEUPS_THREADS=asked), capture_output=True, text=True)
        assert done.stdout.split() == [str(os.cpu_count())], (asked, done)


def test_little_memory_is_said(tmp_path):
    """Never a hang: a line and status 2, or it fits. What is too little for the loader of libraries, which
    crashes then, is passed over."""
    status, said = run(tmp_path, "", "design", "half-sphere", "-o", "out", "--no-solids")
    assert status == 0, said
    loads = (sys.executable, "-c", "import os; os.environ['OPENBLAS_NUM_THREADS'] = '1'\n"
                                   "import curveups.cli.commands\n"
                                   "from curveups.base.native import problem; assert problem() is None")
    limits = [kilobytes for kilobytes in (300_000, 350_000, 450_000, 600_000)
              if within(tmp_path, kilobytes, *loads).returncode == 0]
    assert len(limits) > 1
    for kilobytes in limits:
        done = within(tmp_path, kilobytes, *command(*DESIGN))
        assert done.returncode in (0, 2), (kilobytes, done.returncode, done.stderr)
        if done.returncode == 2:
            assert "memory" in done.stderr.splitlines()[-1], done.stderr
