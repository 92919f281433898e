# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders that can't be written and disks that fill up: status 4, whole files or none."""

import json
import os
import signal
import subprocess

import pytest
from running import command, environment


def test_unwritable_folder(curveups, cap, tmp_path):
    if os.geteuid() == 0:
        place = "/proc/curveups-test"  # not even root makes folders there
    else:
        (tmp_path / "locked").mkdir(mode=0o500)
        place = tmp_path / "locked" / "out"
    ran = curveups("design", cap, "-o", place, "--no-remesh", "--no-solids")
    assert ran.status == 4 and len(ran.error_lines) == 1


def test_limit_on_file_sizes_leaves_whole_files_only(cap, designed, tmp_path):
    """design.json fits, the page with pictures does not."""
    import resource

    limit = (designed.folder / "design.json").stat().st_size + 2000
    assert (designed.folder / "report.html").stat().st_size > limit

    def lower():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    done = subprocess.run(command("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids"),
                          env=environment(), capture_output=True, text=True, preexec_fn=lower)
    assert done.returncode == 4, done.stderr
    errors = [x for x in done.stderr.splitlines() if x.startswith("curveups: error: ")]
    assert len(errors) == 1 and "report.html" in errors[0] and "complete are design.json" in errors[0]
    assert [p.name for p in (tmp_path / "out").iterdir()] == ["design.json"]
    assert (tmp_path / "out" / "design.json").read_bytes() == (designed.folder / "design.json").read_bytes()


@pytest.fixture
def small_disk(tmp_path):
    """Mounts a file system of so many bytes; without the right to mount there is no test."""
    place = tmp_path / "disk"
    place.mkdir()
    mounted = []

    def mount(size):
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size},mode=777", "curveups-test",
                               str(place)], capture_output=True, text=True)
        if done.returncode != 0:
            pytest.skip(f"no file system can be mounted: {done.stderr.strip()}")
        mounted.append(place)
        return place

    yield mount
    for folder in mounted:
        subprocess.run(["umount", str(folder)], check=True)


@pytest.fixture(scope="module")
def exported(curveups, printed, tmp_path_factory):
    """The folder of a whole export."""
    folder = tmp_path_factory.mktemp("exported")
    assert curveups("export", printed.folder / "design.json", "-o", folder).status == 0
    return folder


@pytest.mark.parametrize("ending", ["design.json", "-tiles.step", "-print.step", "-tiles.stl",
                                    "-print.3mf", ".FCStd"])
def test_full_disk(curveups, exported, small_disk, ending):
    sizes = json.loads((exported / "report.json").read_text("utf-8"))["print"]["files"]
    failed = next(name for name in sizes if name.endswith(ending))
    require_whole_files(curveups, exported, small_disk, sizes, failed, "export", exported / "design.json")


@pytest.mark.parametrize("failed", ["report.html", "report.json"])
def test_full_disk_at_the_report(curveups, cap, designed, small_disk, failed):
    """A document takes twice its size while it is written. On a disk with room for that the report has
    room, too, so that no document is written here."""
    names = ("design.json", "report.html", "report.json")
    sizes = {name: (designed.folder / name).stat().st_size for name in names}
    require_whole_files(curveups, designed.folder, small_disk, sizes, failed, "design", cap, "--no-remesh",
                        "--no-solids")


def require_whole_files(curveups, complete, small_disk, sizes, failed, *command):
    """The disk has room for what is written before this file, of those in the folder `complete`, and for
    half of it."""
    before = list(sizes)[:list(sizes).index(failed)]
    pages = sum(-(-sizes[name] // 4096) for name in before) + sizes[failed] // 2 // 4096
    disk = small_disk(max(pages, 1) * 4096)
    ran = curveups(*command, "-o", disk)
    assert ran.status == 4, ran.err
    assert len(ran.error_lines) == 1 and failed in ran.error_lines[0], ran.err
    assert {p.name for p in disk.iterdir()} == set(before)
    for name in before:
        assert name in ran.error_lines[0], ran.err
        if not name.endswith((".FCStd", ".html")):  # these two say when and how they were made
            assert (disk / name).read_bytes() == (complete / name).read_bytes(), name
