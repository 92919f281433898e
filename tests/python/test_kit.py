# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups kit`: what the print shop and whoever builds the shell get, read by other programs."""

import hashlib
import html
import io
import json
import re
import subprocess
import zipfile
from types import SimpleNamespace

import ezdxf
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.image import imread

from curveups.base import freecad_session
from curveups.base.language import Language
from curveups.base.native import native
from curveups.kit import assembly_sheet, drawing, files, latex, maps, ring_sheet, sheets as sheet_files
from curveups.kit.kit import Kit
from curveups.project.project import Project
from curveups.report import shop
from curveups.report.assembly import glue_asked, steps
from curveups.report.data import build_report
from curveups.report.exports import Choice, file_names
from curveups.report.print_pictures import draw_print
from curveups.report.shop import rules
from curveups.stages.sheets import sheets
from curveups.stages.solids import read_printer
from curveups.stages.stage import Job

LATEX = [f"latex-{side}.{kind}" for side in ("front", "back") for kind in ("pdf", "svg", "dxf")]


def pdf_text(path):
    return subprocess.run(["pdftotext", "-layout", path, "-"], check=True, capture_output=True,
                          encoding="utf-8").stdout


def pages_of(path):
    found = subprocess.run(["pdfinfo", path], check=True, capture_output=True, text=True).stdout
    return int(re.search(r"Pages:\s+(\d+)", found)[1])


def rendered(path, page, folder, dpi=254):
    """A page in pixels of 0.1 mm, 0 is black."""
    subprocess.run(["pdftoppm", "-r", str(dpi), "-gray", "-png", "-singlefile", "-f", str(page), path,
                    folder / "page"], check=True)
    pixels = imread(folder / "page.png")
    return pixels if pixels.ndim == 2 else pixels[:, :, 0]


def test_the_folder_holds_what_kit_json_lists(kit):
    assert kit.json["format"] == "curveups-kit" and kit.json["status"] == "complete"
    assert kit.json["valid"] is True and kit.json["tiles"] == 24
    listed = set(kit.json["files"])
    there = {str(p.relative_to(kit.folder)) for p in kit.folder.rglob("*") if p.is_file()}
    assert there == listed | {"kit.json", "design.json"}
    assert {f"small-cap-{ending}" for ending in ("shop.pdf", "print.3mf", "tiles.stl", *LATEX)} <= listed
    for name, about in kit.json["files"].items():
        data = (kit.folder / name).read_bytes()
        assert about == {"bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}
    design = (kit.folder / "design.json").read_bytes()
    assert kit.json["design_sha256"] == hashlib.sha256(design).hexdigest()


def test_print_files_and_design_are_those_of_the_design_command(kit, printed):
    for name in ("design.json", "small-cap-print.3mf", "small-cap-tiles.stl", "small-cap-print.step"):
        assert (kit.folder / name).read_bytes() == (printed.folder / name).read_bytes()


def test_the_same_design_gives_the_same_bytes(curveups, kit, tmp_path):
    assert curveups("kit", kit.folder / "design.json", "-o", tmp_path).status == 0
    for path in kit.folder.rglob("*.*"):
        assert path.read_bytes() == (tmp_path / path.relative_to(kit.folder)).read_bytes(), path.name


def test_the_shop_sheet_is_one_page_with_rules_before_figures(kit):
    path = kit.folder / "small-cap-shop.pdf"
    assert pages_of(path) == 1
    text = pdf_text(path)
    words = ["Leave the support in", "Do not scale, turn or arrange", "Quantity", "Rigid material ",
             kit.json["files"]["small-cap-print.3mf"]["sha256"], "5 mm high"]
    places = [text.index(one) for one in words]
    assert places == sorted(places)
    x, y, _ = kit.json["print"]["bbox_mm"]
    assert f"{x:.1f} mm" in text and f"{y:.1f} mm" in text


@pytest.mark.parametrize("bed, asked, fits", [
    ((250, 210, 210), "Do not scale, turn or arrange", "the print fits"),
    ((60, 200, 210), "Do not scale, turn or arrange", "the print does not fit"),
    ((1000, 70, 210), "Turn all bodies together by a right angle",
     "the print fits, turned by a right angle")])
def test_the_order_says_how_the_print_fits_the_bed(results, monkeypatch, bed, asked, fits):
    """As it stands, or turned, which is forbidden otherwise."""
    report = build_report(results, [], False, {}, {})
    report["print"] = {**report["print"], "bbox_mm": [68.0, 72.0, 5.0]}
    monkeypatch.setattr(shop, "read_printer", lambda name: {**read_printer(name), "bed_mm": list(bed)})
    assert any(rule.startswith(asked) for rule in rules(report, results.parameters))
    assert dict(shop.quote(report, results.parameters))["Printer compared with"].endswith(f"mm, {fits}")


@pytest.mark.parametrize("bboxes, left_out, files, fits", [
    ([[100.0, 90.0, 5.0]], 3, "small-cap-bed-01.3mf or .step", "the print fits without 3 of its anchors"),
    ([[100.0, 90.0, 5.0]], 0, "small-cap-bed-01.3mf or .step",
     "the print fits as small-cap-bed-01 turns and moves it"),
    ([[100.0, 90.0, 5.0]] * 2, 0, "small-cap-bed-01.3mf to small-cap-bed-02.3mf",
     "the print is divided among 2 beds")])
def test_the_order_says_what_goes_on_beds(results, bboxes, left_out, files, fits):
    report = build_report(results, [], False, {}, {})
    report["beds"] = {"anchors_left_out": left_out,
                      "beds": [{"bbox_mm": bbox, "bodies": 30} for bbox in bboxes]}
    said = dict(shop.quote(report, results.parameters))
    assert said["To be printed"].startswith(files) and said["Printer compared with"].endswith(fits)


def test_files_of_many_beds_follow_the_order(results, tmp_path):
    """The picture keeps its room, and every checksum stands on a page."""
    kit = Kit(results, build_report(results, [], False, {}, {}))
    kit.files = {f"small-cap-bed-{k:02}.3mf": {"bytes": k, "sha256": hashlib.sha256(b"%d" % k).hexdigest()}
                 for k in range(200)}
    path = tmp_path / "shop.pdf"
    path.write_bytes(sheet_files.shop_page(kit))
    first, *others = pdf_text(path).split("\f")
    assert "The pages that follow list the files" in first and "mm high" in first
    said = "".join(others)
    assert all(said.count(one["sha256"]) == 1 for one in kit.files.values()) and pages_of(path) == 4


def test_the_glue_has_to_hold_the_largest_shear(results):
    """Glue of pins and anchors; the parts list names glues of the program that do."""
    report = build_report(results, [], False, {}, {})
    report = {**report, "glue": {"shear_max_mpa": 0.5501}, "anchors": {"glue_shear_mpa": [0.1, 0.2]}}
    assert glue_asked(report) == 0.56
    assert glue_asked({**report, "anchors": {"glue_shear_mpa": [0.1, 0.9]}}) == 0.9
    glued = dict(assembly_sheet.parts(Kit(results, report)))["Glue"]
    assert "holds 0.56 MPa in shear" in glued and "materials: cyanoacrylate)" in glued


@pytest.mark.parametrize("high", [0.8, 0.35])
@pytest.mark.parametrize("size, said", [((60, 200), "490 × 390"), ((60, 450), "390 × 490"),
                                        ((480, 60), "490 × 390"), ((600, 600), "490 × 390")])
def test_words_around_the_picture_of_a_print_keep_apart(size, said, high):
    """And the bed lies as the printer has it, unless the print has to be turned."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * np.array(size) / 2
    model = native.make_ring("plate", [(corners, [], [], [])], 5.0, 2.5, 5.0)
    figure, _ = drawing.sheet(150, 150)
    draw_print(figure.add_axes([0.1, 0.1, 0.8, high]), model, (490, 390, 200))
    figure.canvas = FigureCanvasAgg(figure)
    figure.canvas.draw()
    texts = [text for axes in figure.findobj(Axes) for text in (*axes.texts, axes.title, axes._left_title)
             if text.get_text()]
    assert sum(said in text.get_text() for text in texts) == 1 and len(texts) > 3
    boxes = [text.get_window_extent(figure.canvas.get_renderer()) for text in texts]
    for k, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:k])


@pytest.mark.parametrize("language", ["en", "de"])
def test_words_of_the_section_stay_in_their_parts(results, language):
    """Texts of rings lie within the rings, those of sheets within the window."""
    kit = Kit(results, build_report(results, [], False, {}, {}), say=Language(language))
    found, width = ring_sheet.section(kit), kit.rings["width_mm"]
    for x, _, height, text in found.texts:
        end = x + drawing._width(text, height * drawing.POINT / drawing.CAPITALS)
        assert (end <= width) if x < width else (end <= found.size[0] - 1 - width), text


def test_two_pieces_say_which_of_their_tiles_lie_side_by_side():
    """All pairs across the border, and some that lie far apart, in the step that joins the pieces."""
    V = 40.0 * np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]])
    F = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]
    ball = native.remesh(V, np.array(F, np.int32), 10, crease_angle=30)
    halves = native.divide_surface(ball.V, ball.F, np.zeros((0, 2), np.int32), 2)
    design = SimpleNamespace(V=ball.V, F=ball.F, cuts=np.array(halves.borders))
    found = Kit(SimpleNamespace(design=design), {}).borders
    assert len(found["pairs"]) == len(halves.borders) > 8
    for a, b in found["pairs"]:
        assert halves.piece[a] != halves.piece[b] and len(set(ball.F[a]) & set(ball.F[b])) == 2
    assert len(found["named"]) == 4 and all(pair in found["pairs"] for pair in found["named"])
    middles = np.array([ball.V[ball.F[pair]].mean((0, 1)) for pair in found["named"]])
    apart = np.linalg.norm(middles[:, None] - middles, axis=2)[np.triu_indices(4, 1)]
    assert apart.min() > 30  # of a ball of some 80 mm
    whole = SimpleNamespace(V=ball.V, F=ball.F, cuts=np.zeros((0, 2), np.int32))
    assert Kit(SimpleNamespace(design=whole), {}).borders == {"pairs": [], "named": []}


@pytest.mark.parametrize("settings, shop_says, shop_omits, page_says", [
    (("support=breakaway", "printer=fdm"),
     ("do not break them", "PLA or PETG", "Do not scale, turn", "on the bed alone, and leave these in, too"),
     ("wash it off", "two materials", "Tilt"),
     ("holds, peel the slicer's supports off the back and break the bridges",)),
    (("support=breakaway", "printer=resin"),
     ("Tilt the whole", "peeled off the vat by its whole area",
      "take these supports off, and cure with the bridges on", "tilted as a whole"),
     ("turn or", "as the files stand", "leave these in"),
     ("holds, break the bridges",)),
    (("support=none",), ("Nothing joins the tiles",), ("Leave the", "leave these in"),
     ("turn the ring over, so that you can reach the back. The membrane stays",
      "Leave all where it lies"))])
def test_sheets_fit_support_and_printer(curveups, printed, tmp_path, settings, shop_says, shop_omits,
                                        page_says):
    ran = curveups("kit", printed.folder / "design.json", "-o", tmp_path,
                   *(word for one in settings for word in ("--set", one)))
    assert ran.status in (0, 1), ran.err
    text = " ".join(pdf_text(tmp_path / "small-cap-shop.pdf").split())
    assert all(one in text for one in shop_says) and not any(one in text for one in shop_omits)
    page = html.unescape((tmp_path / "small-cap-assembly.html").read_text("utf-8"))
    assert all(words in page for words in page_says)


def test_the_report_begins_with_what_the_shop_needs(printed):
    page = (printed.folder / "report.html").read_text(encoding="utf-8")
    places = [page.index(one) for one in ("For the print shop", "Leave the support in", "Quantity",
                                          "All that is printed", "<h2>Flat layout")]
    assert places == sorted(places) and page.index("<img") > places[2]


def test_names_of_print_files_have_what_shops_ask_for(curveups, printed, tmp_path):
    ran = curveups("kit", printed.folder / "design.json", "-o", tmp_path, "--quantity", 3, "--names",
                   "{quantity}-{name}-{body}-{material}-{thickness}")
    assert ran.status == 0, ran.err
    assert (tmp_path / "3x-small-cap-tiles-rigid-5mm.stl").exists()
    assert (tmp_path / "3x-small-cap-support-soluble-5mm.stl").exists()
    said = " ".join(pdf_text(tmp_path / "small-cap-shop.pdf").split())
    assert "3, of 35 bodies each (24 tiles)" in said
    assert "3x-small-cap-print-rigid-5mm.3mf or 3x-small-cap-print-rigid-5mm.step: every body" in said
    assert "small-cap-print.3mf or" not in said
    # A kit under other names takes the place of the last, but for files that somebody has changed.
    (tmp_path / "3x-small-cap-tiles-rigid-5mm.stl").write_text("scaled")
    assert curveups("kit", printed.folder / "design.json", "-o", tmp_path).status == 0
    assert [path.name for path in tmp_path.glob("3x-*")] == ["3x-small-cap-tiles-rigid-5mm.stl"]
    refused = curveups("kit", printed.folder / "design.json", "-o", tmp_path / "no", "--names", "{colour}")
    assert refused.status == 2 and "{quantity}" in refused.err and not (tmp_path / "no").exists()
    assert curveups("kit", printed.folder / "design.json", "-o", tmp_path / "no", "--quantity", 0).status == 2
    assert file_names("a", Choice((("tiles", "stl"),))) == {("tiles", "stl"): "a-tiles.stl"}


@pytest.mark.parametrize("name, value, status, title", [
    ("friction_coefficient", 0.01, 1, "NOT VALID small cap"),
    pytest.param("verify", False, 0, "NOT VERIFIED small cap", marks=pytest.mark.all)])
def test_a_kit_says_everywhere_that_it_is_not_valid(curveups, printed, tmp_path, name, value, status, title):
    data = json.loads((printed.folder / "design.json").read_text("utf-8"))
    data["parameters"][name] = value
    (tmp_path / "doubtful.json").write_text(json.dumps(data))
    ran = curveups("kit", tmp_path / "doubtful.json", "-o", tmp_path / "kit")
    assert ran.status == status, ran.err
    folder = tmp_path / "kit"
    for file in ("shop.pdf", "assembly.pdf", "latex-back.pdf"):
        assert title in pdf_text(folder / f"small-cap-{file}")
    assert f"Do not order it as it is: the design is {title[:-10].lower()}." in " ".join(
        pdf_text(folder / "small-cap-shop.pdf").split())
    assert title in (folder / "small-cap-print.step").read_text("utf-8")
    assert title.encode() in (folder / "small-cap-tiles.stl").read_bytes()[:80]
    with zipfile.ZipFile(folder / "small-cap-print.3mf") as archive:
        assert title in archive.read("3D/3dmodel.model").decode("utf-8")
    found = json.loads((folder / "kit.json").read_text("utf-8"))
    assert found["valid"] is (None if status == 0 else False) and found["title"] == "small cap"
    design = (folder / "design.json").read_text("utf-8")
    assert json.loads(design)["name"] == "small cap"
    assert found["design_sha256"] == hashlib.sha256(design.encode("utf-8")).hexdigest()


def test_a_kit_stopped_while_its_print_is_divided_says_so(results, tmp_path, monkeypatch):
    def stopped(*_):
        raise native.Cancelled

    monkeypatch.setattr("curveups.kit.kit.beds", stopped)
    assert files.write_kit(results, tmp_path, Job())
    written = json.loads((tmp_path / "kit.json").read_text("utf-8"))
    assert written["status"] == "stopped" and written["files"] == {}


def test_a_kit_leaves_files_that_it_did_not_write(results, tmp_path):
    (tmp_path / "small-cap-frame.png").write_text("a photo")
    assert not files.write_kit(results, tmp_path, Job())
    assert (tmp_path / "small-cap-frame.png").read_text() == "a photo"


def test_a_layout_can_not_change_in_a_kit(curveups, printed, tmp_path):
    for typed in ("tau", "material_glue"):
        value = "contact-cement" if typed == "material_glue" else "2"
        ran = curveups("kit", printed.folder / "design.json", "-o", tmp_path / "no", "--set",
                       f"{typed}={value}")
        assert ran.status == 2 and f"{typed} can't change on kit (--set {typed})" in ran.err
        assert not (tmp_path / "no").exists()


def test_a_kit_of_another_design_takes_the_place_of_the_last(curveups, printed, tmp_path):
    first = curveups("design", printed.folder.parent / "none.obj", "-o", tmp_path)
    assert first.status == 2
    for name in ("report.json", "small-cap-actuated.step", "small-cap-shop.pdf"):
        (tmp_path / name).write_text("of an earlier run")
    assert curveups("kit", printed.folder / "design.json", "-o", tmp_path).status == 0
    assert not (tmp_path / "report.json").exists() and not (tmp_path / "small-cap-actuated.step").exists()
    assert (tmp_path / "small-cap-shop.pdf").read_bytes().startswith(b"%PDF")


@pytest.fixture(scope="module")
def results(printed):
    design = native.read_design((printed.folder / "design.json").read_text("utf-8"))
    return Project.of_design(design).run(files.goals(), Job(), strict=True)


def test_progress_of_a_kit_names_each_file_and_moves_to_its_end(results, tmp_path):
    said = []
    assert not files.write_kit(results, tmp_path, Job(lambda *step: said.append(step) or True))
    listed = list(json.loads((tmp_path / "kit.json").read_text("utf-8"))["files"])
    writing = [(what, fraction) for what, fraction in said if what.startswith("writing ")]
    assert list(dict.fromkeys(what for what, _ in writing)) == [f"writing {name}" for name in listed]
    fractions = [fraction for _, fraction in writing]
    assert fractions == sorted(fractions) and fractions[0] == 0 and fractions[-1] > 0.95
    assert said[0][0] == "dividing the print among beds"


def test_the_assembly_sheet_has_a_page_a_step_with_its_picture(kit):
    page = (kit.folder / "small-cap-assembly.html").read_text("utf-8")
    titles = [one["title"] for one in kit.json["steps"]]
    assert titles[3] == "Glue the front first" and titles[-1] == "Cut the surplus off"
    assert page.count("<img") == len(titles) + 1 and "src=\"http" not in page
    path = kit.folder / "small-cap-assembly.pdf"
    assert pages_of(path) == len(titles) + 2
    pages = pdf_text(path).split("\f")
    for number, (title, text) in enumerate(zip(titles, pages[1:]), 1):
        assert text.split("\n")[0].strip().startswith(f"{number}. {title[:40]}")
    named = set(re.findall(r"[\w-]+\.(?:svg|pdf|dxf|step|stl)", pdf_text(path)))
    assert len(named) > 8 and not [one for one in named if not list(kit.folder.rglob(one))], named
    block = kit.json["print"]["glue"]
    volume = kit.json["glue"]["volume_cm3"]["front"]
    assert volume == pytest.approx(1e-4 * (block["front_pins_mm2"] + block["front_anchors_mm2"]))
    # What the pins carry is more than the anchors do, and less than what the verdict allows.
    asked = kit.json["glue"]["asked_mpa"]
    assert max(kit.json["anchors"]["glue_shear_mpa"]) < asked <= native.Parameters().get("glue_strength")
    assert f"holds {asked:.2f} MPa in shear" in page
    # Contact cement holds 0.3 MPa.
    does = "cyanoacrylate" if asked > 0.3 else "contact-cement, cyanoacrylate"
    assert f"materials: {does})" in page
    assert "small-cap-former.stl" in page and "-frame.dxf" not in page
    assert f"{volume:.2f} cm³" in page and "stays on its ring while it is washed and dries" in page
    anchors = kit.json["sheets"]["anchors"]
    assert f"24 tiles, {anchors} anchors, slabs: 1." in page
    assert kit.json["print"]["bodies"] == 24 + anchors + 1


def bare(text):
    """Letters and digits: PDFs name neither dashes nor quotation marks."""
    return re.sub(r"\W", "", text)


def test_sheets_are_in_the_language_that_is_asked_for(curveups, printed, tmp_path):
    """No English text of a sheet that could be read is left in the German ones."""
    ran = curveups("kit", printed.folder / "design.json", "-o", tmp_path, "--language", "de")
    assert ran.status == 0, ran.err
    german = Language("de")
    wanted = {"shop": rules, "assembly": lambda *given: [step.text for step in steps(*given)]}
    found = json.loads((tmp_path / "kit.json").read_text("utf-8"))
    parameters = native.read_design((tmp_path / "design.json").read_text("utf-8")).parameters
    said = {path.stem: " ".join(pdf_text(path).split()) for path in tmp_path.rglob("*.pdf")}
    for name, lines in wanted.items():
        for line in lines(found, parameters, german):
            assert bare(line) in bare(said[f"small-cap-{name}"])
    english = {one for one, other in german.translations.items()
               if re.search(r"[a-z]{4} [a-z]", one) and "{" not in one and one not in other}
    assert len(english) > 40
    for name, text in said.items():
        assert not [one for one in english if one in text], name
    assert "Die Folie zieht mit" in said["small-cap-latex-front"]
    page = (tmp_path / "small-cap-assembly.html").read_text("utf-8")
    assert '<html lang="de">' in page and "Zuerst die Vorderseite kleben" in page
    assert found["language"] == "de" and found["steps"][0]["title"] == "Wash and mark the latex"  # as always
    refused = curveups("kit", printed.folder / "design.json", "-o", tmp_path / "no", "--language", "xx")
    assert refused.status == 2 and "there is no language 'xx' (--language): give one of en, de" in refused.err
    assert not (tmp_path / "no").exists()


def test_every_tile_has_its_number_on_the_map_twice(results):
    found = maps.tile_map(Kit(results, build_report(results, [], False, {}, {})))
    numbers = sorted(int(text) for *_, text in found.texts if text.isdigit())
    assert numbers == sorted([*range(1, 25)] * 2)
    lines = [line for layer in found.lines.values() for line in layer]
    assert len(lines) == 48
    areas = [0.5 * (np.cross(line[1] - line[0], line[2] - line[0])) for line in lines]
    assert sorted(np.sign(areas)) == [-1] * 24 + [1] * 24  # the back's are mirrored
    worst = results["verification"].report()["worst_contacts"]
    assert len(found.lines["cut"]) == 2 * len({tile for one in worst for tile in one["tiles"]})


def inside(point, outline):
    (x, y), a, b = point, outline, np.roll(outline, -1, axis=0)
    crossing = (a[:, 1] > y) != (b[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return np.count_nonzero(crossing & (x < at)) % 2 == 1


def test_trim_marks_go_around_all_pins_at_their_distance(kit):
    space = ezdxf.readfile(kit.folder / "small-cap-trim.dxf").modelspace()
    outline, = (np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="cut"]'))
    pins = [np.array([p[:2] for p in line])[:3] for line in space.query('LWPOLYLINE[layer=="grid"]')]
    assert len(pins) == 12 and np.allclose(outline[0], outline[-1])
    corners = np.concatenate(pins)
    assert all(inside(corner, outline[:-1]) for corner in corners)
    ends = outline[:-1]
    along = np.roll(ends, -1, axis=0) - ends
    share = np.einsum("pnk,nk->pn", corners[:, None] - ends, along) / np.einsum("nk,nk->n", along, along)
    distance = np.linalg.norm(corners[:, None] - ends - share.clip(0, 1)[..., None] * along, axis=2).min(1)
    assert distance.min() > 1.499 and np.median(np.sort(distance)[:len(pins)]) < 1.7
    # Anchors lie around that as they are printed.
    anchors = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="control"]')]
    assert len(anchors) == kit.json["sheets"]["anchors"]
    assert not any(inside(corner, ends) for anchor in anchors for corner in anchor)
    slab = np.array(kit.json["print"]["bbox_mm"][:2]) - 2 * native.SUPPORT_MARGIN
    assert np.ptp(np.concatenate(anchors), axis=0) == pytest.approx(slab, abs=0.1)


def test_cuts_end_in_stop_holes(curveups, tmp_path):
    """A slit from the rim to the middle of a disk."""
    cuts = tmp_path / "cuts.json"
    cuts.write_text(json.dumps({"polylines": [[[0, 0, 0], [60, 0, 0]]]}))
    ran = curveups("design", "disc", "-o", tmp_path / "d", "--cuts", cuts, "--set", "L=14", "verify=off",
                   "--no-solids")
    assert ran.status == 0, ran.err
    design = native.read_design((tmp_path / "d" / "design.json").read_text("utf-8"))
    found = maps.marks(Kit(Project.of_design(design).run(("bodies",)), {"valid": True}))
    assert len(found.circles["cut"]) == len(found.lines["cut"]) == 1


def test_spares_are_the_tiles_that_were_named(curveups, printed, tmp_path):
    ran = curveups("export", printed.folder / "design.json", "-o", tmp_path, "--tiles", "T00012, T00003")
    assert ran.status == 0, ran.err
    assert {p.name for p in tmp_path.iterdir()} == {f"small-cap-spares.{e}" for e in ("step", "stl", "3mf")}
    step = (tmp_path / "small-cap-spares.step").read_text("utf-8")
    assert set(re.findall(r"'(T\d{5})'", step)) == {"T00003", "T00012"}
    for name in ("T00025", "12", ""):
        refused = curveups("export", printed.folder / "design.json", "-o", tmp_path / "no", "--tiles", name)
        assert refused.status == 2 and "T00001 to T00024" in refused.err and not (tmp_path / "no").exists()


# Templates.

def sheets_of(box, **values):
    parameters = native.Parameters()
    for name, value in values.items():
        parameters.set(name, value)
    return sheets(box, parameters)


BLOCK = sheets_of((195.4, 194.3), shear_modulus_back=0.36)


def test_the_load_is_the_slope_of_the_sheets_energy():
    """A square of rest side 1 mm has the energy h G / 2 (2 l^2 + l^-4 - 3); half of its slope by l is the
    force on a side, which is l mm long then."""
    def energy(stretch, modulus=0.72, thickness=0.5):
        return 0.5 * modulus * thickness * (2 * stretch ** 2 + stretch ** -4 - 3)

    tension = (energy(3 + 1e-6) - energy(3 - 1e-6)) / 2e-6 / 2 / 3
    assert BLOCK["window_mm"] == [225, 225]
    assert BLOCK["load_n"]["front"] == pytest.approx([225 * tension] * 2, rel=1e-6)
    assert BLOCK["load_n"]["back"] == pytest.approx([112.5 * tension] * 2, rel=1e-6)
    assert BLOCK["load_n"]["front"][0] == pytest.approx(80, rel=0.02)  # N, Half-Sphere


def test_sheets_hold_the_print_its_margin_teeth_and_grip():
    for box, tau in (((195.4, 100.0), 3.0), ((30.0, 31.0), 2.5), ((510.0, 395.0), 1.05)):
        block = sheets_of(box, tau=tau)
        for axis in (0, 1):
            window, pitch = block["window_mm"][axis], block["tooth_pitch_mm"]
            assert box[axis] + 20 <= window < box[axis] + 20 + pitch and window % pitch == 0
            assert block["marked_mm"][axis] * tau == pytest.approx(window + 2 * block["tooth_rows"] * pitch)
            assert 0 <= block["cut_mm"][axis] - block["marked_mm"][axis] - 2 * block["grip_mm"] < 5
            assert block["grid_mm"] * tau == pytest.approx(pitch)


def test_the_template_as_dxf(kit):
    data = (kit.folder / "small-cap-latex-front.dxf").read_text("utf-8")
    document = ezdxf.read(io.StringIO(data))
    assert not document.audit().errors
    assert document.dxfversion == "AC1015" and document.units == ezdxf.units.MM
    space, block = document.modelspace(), kit.json["sheets"]
    cut, = (np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="cut"]'))
    assert np.allclose(np.ptp(cut, axis=0), block["cut_mm"])
    squares = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="control"]')]
    assert len(squares) == 5 and all(np.allclose(np.ptp(one, axis=0), 10) for one in squares)
    grid = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="grid"]')]
    upright = sorted(line[0, 0] for line in grid if line[0, 0] == line[1, 0])
    assert np.allclose(np.diff(upright), block["grid_mm"])
    assert upright[-1] - upright[0] == pytest.approx(block["marked_mm"][0])
    # The first two rows of crossings from each side come to teeth, and no square lies on them.
    teeth = {(round(c.dxf.center.x, 6), round(c.dxf.center.y, 6)) for c in space.query("CIRCLE")}
    columns = len(upright)
    assert len(teeth) == columns ** 2 - (columns - 4) ** 2
    assert all(one.min() > cut.min() + 20 for one in squares)


def test_freecad_reads_each_drawing_at_its_size(kit):
    """All lines and circles, and no other size: mm."""
    freecad, reader = freecad_session.load("Import")
    drawings = sorted(kit.folder.rglob("*.dxf"))
    assert len(drawings) == 5  # latex and ring of both sides, trim
    for path in drawings:
        space = ezdxf.readfile(path).modelspace()
        points = np.array([p[:2] for line in space.query("LWPOLYLINE") for p in line])
        document = freecad.newDocument("Drawing")
        try:
            reader.readDXF(str(path), document.Name)
            boxes = [one.Shape.BoundBox for one in document.Objects if hasattr(one, "Shape")]
            sizes = [max(getattr(box, f"{axis}Max") for box in boxes)
                     - min(getattr(box, f"{axis}Min") for box in boxes) for axis in "XY"]
            assert sizes == pytest.approx(np.ptp(points, axis=0), abs=1e-3), path.name
        finally:
            freecad.closeDocument(document.Name)


def test_the_template_as_svg_has_its_size(kit):
    text = (kit.folder / "small-cap-latex-back.svg").read_text("utf-8")
    cut = kit.json["sheets"]["cut_mm"]
    width, height = (float(re.search(rf'{one}="([\d.]+)pt"', text)[1]) * 25.4 / 72
                     for one in ("width", "height"))
    assert (width, height) == pytest.approx((cut[0] + 16, cut[1] + 16), abs=0.01)
    assert {'id="cut"', 'id="grid"', 'id="control"'} <= set(re.findall(r'id="\w+"', text))
    assert "<dc:date>" not in text


def longest_run(line):
    """The longest run of dark pixels of a row."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], line < 0.6, [0]]).astype(int)))
    return max(edges[1::2] - edges[::2], default=0)


def test_rulers_measure_100_mm_and_squares_their_size_on_paper(kit, tmp_path):
    path = kit.folder / "small-cap-latex-front.pdf"
    text = pdf_text(path)
    assert pages_of(path) == 6  # a cover and a page for each of three papers
    assert text.count("Print at 100 %") == 3 and text.count("100 mm long") == 3
    for page, paper in zip((2, 4, 6), drawing.PAPERS.values()):
        pixels = rendered(path, page, tmp_path)
        assert pixels.shape == pytest.approx((paper[1] * 10, paper[0] * 10), abs=2)
        foot = pixels[-int(10 * (drawing.BORDER + drawing.FOOT)):]
        assert max(map(longest_run, foot)) / 10 == pytest.approx(100, abs=0.3)
        body = pixels[:-int(10 * (drawing.BORDER + drawing.FOOT))]
        assert max(map(longest_run, body)) / 10 == pytest.approx(kit.json["sheets"]["cut_mm"][0], abs=0.3)


@pytest.mark.parametrize("paper", list(drawing.PAPERS))
def test_large_sheets_are_tiled_whole_with_crosses_on_crosses(paper):
    whole = latex.template("large", sheets_of((510, 495), tau=1.2))
    parts = drawing.tiles(whole, paper)
    assert len(parts) > 3
    covered = np.zeros((int(whole.size[1]), int(whole.size[0])), bool)
    for column, row, (x, y, width, height) in parts:
        assert width == drawing.PAPERS[paper][0] - 2 * drawing.BORDER
        covered[max(0, round(y)):round(y + height), max(0, round(x)):round(x + width)] = True
        for other in parts:
            if other[:2] == (column + 1, row):
                assert x + width - other[2][0] == pytest.approx(drawing.OVERLAP)
            if other[:2] == (column, row + 1):
                assert other[2][1] + height - y == pytest.approx(drawing.OVERLAP)
    assert covered.all()


def test_pages_without_a_line_are_left_out():
    whole = drawing.Drawing("two corners", (900, 900))
    whole.box("cut", 0, 0, 20, 20)
    whole.circle("grid", 850, 850, 10)
    found = drawing.tiles(whole, "A4")
    assert len(found) == 2 and found[0][1] == 0 and found[1][0] == 0


def test_the_former_is_one_closed_body(kit):
    _, mesh = freecad_session.load("Mesh")
    found = mesh.Mesh(str(kit.folder / "small-cap-former.stl"))
    assert found.isSolid() and found.countComponents() == 1
    assert found.Volume == pytest.approx(1000 * kit.json["former"]["volume_cm3"], rel=0.02)
