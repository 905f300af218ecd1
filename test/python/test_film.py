"""Films: decoded here, independently of the viewer, and compared with the complex; shown by Chromium."""

from __future__ import annotations

import base64
import json
import os
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import dsc
import numpy as np
import pytest
from shapes import ball, disk


def film_of(page: str):
    (text,) = re.findall(r'<script id="film" type="application/json">(.*?)</script>', page, re.S)
    return json.loads(text)


def numbers(film, blob):
    """Returns the integers of a blob."""
    data = zlib.decompress(base64.b64decode(film["blobs"][blob]), -15)
    result, value, shift = [], 0, 0
    for byte in data:
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            result.append(value >> 1 if value % 2 == 0 else -(value >> 1) - 1)
            value = shift = 0
    return np.array(result, dtype=np.int64)


def kept(film, blob):
    return np.cumsum(numbers(film, blob) + 1) - 1 if blob is not None else np.zeros(0, dtype=np.int64)


def decoded(film):
    """Returns points in units of the film, simplices and labels of each frame."""
    d = film["dimension"]
    corners = d + 1 if film["cells"] else d
    sides = 1 if film["cells"] else 2
    labels_of_film = np.array(film["labels"])
    frames, q, simplices, labels = [], np.zeros((0, d)), np.zeros((0, corners)), np.zeros((0, sides))
    for frame in film["frames"]:
        n, m = frame["vertices"], frame["simplices"]
        kept_points = kept(film, frame.get("kept_vertices"))
        kept_simplices = kept(film, frame.get("kept_simplices"))
        stored = numbers(film, frame["positions"]).reshape(d, n)
        new_q = np.zeros((n, d))
        for axis in range(d):
            last = 0
            for i in range(n):
                base = q[kept_points[i], axis] if i < len(kept_points) else last
                last = base + stored[axis, i]
                new_q[i, axis] = last
        place = np.full(len(q), -1)
        place[kept_points] = np.arange(len(kept_points))
        old = place[simplices[kept_simplices].astype(int)] if len(kept_simplices) else np.zeros((0, corners))
        new = np.cumsum(numbers(film, frame["new_simplices"]).reshape(corners, -1), axis=1).T
        new_labels = np.cumsum(numbers(film, frame["labels"]).reshape(sides, -1), axis=1).T
        simplices = np.vstack([old, new])
        labels = np.vstack([labels[kept_simplices], labels_of_film[new_labels]])
        q = new_q
        assert len(simplices) == len(labels) == m
        frames.append((q.astype(np.int64), simplices.astype(int), labels.astype(int)))
    return frames


def shapes(q, simplices, labels):
    """Returns the simplices as a sorted list of sums of coordinates and labels, all integers."""
    sums = q[simplices].sum(axis=1)
    return sorted(map(tuple, np.hstack([sums, labels.reshape(len(labels), -1)]).tolist()))


@pytest.mark.parametrize("make", [disk, ball])
@pytest.mark.parametrize("surface", [False, True])
def test_a_film_contains_the_states(make, surface):
    c = make()
    film = dsc.Film("test", surface=surface)
    states = []
    for i in range(4):
        if i:
            c.offset(0.04)
        film.add(c, i / 2)
        s = c.interface() if surface else c.cells()
        facets = s.facets if surface else s.cells
        labels = s.labels[:, ::-1] if surface else s.labels
        states.append((s.points, facets, labels))
    data = film_of(film.html())
    assert data["dimension"] == c.dimension and data["labels"] == [0, 1] and data["hidden"] == [0]
    assert len(data["colors"]) == 2 and data["colors"][0] != data["colors"][1]
    assert [frame["time"] for frame in data["frames"]] == [0, 0.5, 1, 1.5]
    frames = decoded(data)
    assert len(frames) == len(film) == 4
    for state, frame in zip(states, frames):
        q = np.floor((state[0] - data["origin"]) / data["unit"] + 0.5).astype(np.int64)
        assert shapes(q, *state[1:]) == shapes(*frame)


def test_volumes_are_shown():
    c = ball()
    film = dsc.Film()
    film.add(c)
    series = {s["name"]: s["values"] for s in film_of(film.html())["series"]}
    assert series["volume of label 1"] == [pytest.approx(c.volumes[1])]


def test_fields():
    c = disk()
    film = dsc.Film()
    cells = c.cells()
    film.add(c, 0, fields={"x": cells.points[:, 0], "v": cells.points, "quality of cells": c.qualities})
    data = film_of(film.html())
    fields = {f["name"]: f for f in data["fields"]}
    assert fields["x"]["of"] == fields["v"]["of"] == "vertices" and fields["v"]["components"] == 2
    assert fields["quality of cells"]["of"] == "cells"
    f = fields["x"]
    steps = np.cumsum(numbers(data, data["frames"][0]["fields"]["x"]))
    values = f["minimum"] + steps / f["steps"] * (f["maximum"] - f["minimum"])
    assert np.allclose(values, cells.points[:, 0], atol=1e-3)


def test_events_are_shown():
    from test_complex import one_label, two_disks

    c = one_label(two_disks())
    film = dsc.Film()
    for i in range(10):
        film.add(c, i, c.offset(0.015))
    texts = [event["text"] for event in film_of(film.html())["events"]]
    assert "label 1: components merged" in texts


def test_text_cannot_end_the_script():
    film = dsc.Film("</script><script>alert(1)</script>")
    film.add(disk())
    page = film.html()
    assert "</script><script>alert" not in page
    assert film_of(page)["title"] == "</script><script>alert(1)</script>"


@pytest.mark.parametrize("text", ["<!--<script>", "</title>&quot;'\"", "\u2028\u2029\x1b", "\U0001f600"])
def test_any_text_is_kept(text):
    film = dsc.Film(text)
    c = disk()
    film.add(c, fields={text: np.zeros(c.number_of_vertices)})
    page = film.html()
    assert film_of(page)["title"] == text
    assert "<!--" not in page.split('<script id="film"')[1]


def test_a_file_is_replaced_only_when_whole(tmp_path, monkeypatch):
    film = dsc.Film()
    film.add(disk())
    page = tmp_path / "film.html"
    page.write_text("precious")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", full)
        for target in (film, disk()):
            with pytest.raises(OSError, match="space"):
                target.save(page)
    assert page.read_text() == "precious"
    assert os.listdir(tmp_path) == ["film.html"]
    film.save(page)
    assert page.read_text(encoding="utf-8") == film.html()


@pytest.mark.parametrize("fields", [{"f": [1.0]}, {"f": [[1.0]]}, {"f": "text"}])
def test_wrong_fields(fields):
    with pytest.raises(ValueError):
        dsc.Film().add(disk(), fields=fields)


def test_values_that_are_not_finite():
    c = disk()
    with pytest.raises(ValueError, match="not finite"):
        dsc.Film().add(c, fields={"f": np.full(c.number_of_vertices, np.nan)})


def test_the_first_state_may_be_empty():
    film = dsc.Film(surface=True)
    film.add(dsc.Complex2.from_function(lambda p: np.zeros(len(p), dtype=int), [(-1, -1), (1, 1)], 0.5))
    film.add(disk())
    assert film_of(film.html())["unit"] < 1e-5


@pytest.mark.parametrize("value", [1e200, -1e308])
def test_values_that_are_too_large(value):
    c = disk()
    with pytest.raises(ValueError, match="too large"):
        dsc.Film().add(c, fields={"f": np.full(c.number_of_vertices, value)})


COLLECTION = '<VTKFile type="Collection"><Collection>{}</Collection></VTKFile>'


@pytest.mark.skipif(os.environ.get("DSC_PROGRAM") is None, reason="the program dsc is not built")
@pytest.mark.parametrize(
    "content, message",
    [
        ("", "empty"),
        (COLLECTION.format(""), "no states"),
        (COLLECTION.format('<DataSet timestep="abc" file="a.vtu"/>'), "no finite time"),
        (COLLECTION.format('<DataSet timestep="0" ' + "x" * 3_000_000 + ' file="a.vtu"/>'), "a.vtu"),
        (COLLECTION.format('<DataSet file="a.vtu" timestep="0"/><DataSet file="b.vtu" timestep="1"/>'), "a.vtu"),
    ],
    ids=["empty", "no states", "no time", "a long line", "two on a line"],
)
def test_unusable_collections(tmp_path, content, message):
    (tmp_path / "run.pvd").write_text(content)
    view = [os.environ["DSC_PROGRAM"], "view", "run.pvd", "-o", "run.html"]
    done = subprocess.run(view, cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1 and message in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / "run.html").exists()


def test_a_film_has_one_dimension():
    film = dsc.Film()
    film.add(disk())
    with pytest.raises(ValueError, match="dimension"):
        film.add(ball())


def test_an_empty_film():
    with pytest.raises(ValueError, match="no state"):
        dsc.Film().html()


def test_notebooks():
    html = disk()._repr_html_()
    assert html.startswith("<iframe srcdoc=") and "&lt;!DOCTYPE html&gt;" in html


# In a browser


CHROMIUM = shutil.which("chromium")
PROGRAM = os.environ.get("DSC_PROGRAM")
ALL_CASES = os.environ.get("DSC_ALL_CASES") == "1"  # see test/support/all_cases.h


def dom_of(page: Path) -> str:
    """Opens a page in Chromium with its self-test, and returns its elements."""
    assert CHROMIUM is not None
    command = [CHROMIUM, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
               "--enable-unsafe-swiftshader", "--dump-dom", f"--user-data-dir={page.parent}/profile",
               f"{page.as_uri()}#test"]  # fmt: skip
    return subprocess.run(command, capture_output=True, text=True, timeout=300, check=False).stdout


def verdict(page: Path) -> list[str]:
    """Returns the lines of the verdict of the self-test of a page."""
    dom = dom_of(page)
    found = re.search(r'<pre id="verdict"[^>]*>(.*?)</pre>', dom, re.S)
    assert found, dom[-2000:]
    return [line for line in found[1].splitlines() if line]


def assert_shown(page: Path) -> None:
    lines = verdict(page)
    assert not [line for line in lines if "FAILED" in line], "\n".join(lines)
    assert any(re.match(r"viewer: all \d+ checks passed", line) for line in lines), "\n".join(lines)


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
def test_a_page_that_is_cut_short_says_so(tmp_path):
    film = dsc.Film()
    film.add(disk())
    html = film.html()
    page = tmp_path / "cut.html"
    page.write_text(html[: html.rindex("document.addEventListener")], encoding="utf-8")
    assert re.search(r'<p id="message" role="status">[^<]* is incomplete', dom_of(page))


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
def test_the_session_of_the_manual(tmp_path):
    """The example runs as a program, and its film is shown."""
    example = Path(__file__).with_name("example.py")
    page = tmp_path / "two_balls.html"
    subprocess.run([sys.executable, str(example), str(page)], check=True, timeout=300)
    data = film_of(page.read_text(encoding="utf-8"))
    assert any(event["text"] == "label 1: components merged" for event in data["events"])
    assert_shown(page)


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
@pytest.mark.skipif(PROGRAM is None, reason="the program dsc is not built")
@pytest.mark.parametrize("options", [["--surface"], ["--every", "2", "--without", "0"]] + ([[]] if ALL_CASES else []))
def test_a_run_in_the_plane(tmp_path, options):
    (tmp_path / "disk.wkt").write_text("POLYGON((0 0,4 0,4 4,2 3,0 4,0 0))\n")
    run = [PROGRAM, "mean-curvature", "disk.wkt", "--steps", "4", "--output", "run", "--report", "r.json"]
    subprocess.run(run, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    view = [PROGRAM, "view", "run", "-o", "run.html", "--report", "r.json", *options]
    subprocess.run(view, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    assert_shown(tmp_path / "run.html")


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
@pytest.mark.skipif(PROGRAM is None, reason="the program dsc is not built")
def test_a_fluid(tmp_path):
    run = [PROGRAM, "fluid", "collision", "--steps", "2", "--output", "run", "--report", "r.json"]
    subprocess.run(run, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    view = [PROGRAM, "view", "run", "-o", "run.html", "--report", "r.json"]
    subprocess.run(view, cwd=tmp_path, check=True, capture_output=True, timeout=300)
    assert_shown(tmp_path / "run.html")
