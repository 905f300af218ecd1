"""Labels that are given by their names."""

import copy
import json
import os
import pickle
import subprocess

import dsc
import numpy as np
import pytest
from shapes import CUBE_POINTS, CUBE_TRIANGLES

ODD = {1: '7', 2: 'großer "Ring" <&>', 5: "a, b"}
CUBE = np.asarray(CUBE_POINTS, dtype=float)


def two_cubes(**options):
    small = CUBE.mean(axis=0) + (CUBE - CUBE.mean(axis=0)) / 2
    return dsc.Complex3.from_surfaces(
        {"shell": (CUBE, CUBE_TRIANGLES), "core": (small, CUBE_TRIANGLES)}, edge_per_thickness=0, **options
    )


def two_squares():
    outer = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    return dsc.Complex2.from_polygons({"shell": [outer], "core": [0.25 + outer / 2]}, edge_per_thickness=0)


def test_names_of_surfaces_and_polygons():
    assert two_cubes().label_names == two_squares().label_names == {1: "shell", 2: "core"}
    assert two_cubes(labels=[4, 3]).label_names == {4: "shell", 3: "core"}
    surfaces = [(CUBE, CUBE_TRIANGLES)]
    assert dsc.Complex3.from_surfaces(surfaces, edge_per_thickness=0).label_names == {}


def test_names_are_stored(tmp_path):
    c = two_squares()
    c.label_names = ODD
    c.save(tmp_path / "c.dsc")
    copies = dsc.Complex2.read(tmp_path / "c.dsc"), c.copy(), copy.deepcopy(c), pickle.loads(pickle.dumps(c))
    for other in copies:
        assert other.label_names == ODD
        assert other == c
    c.label_names = {}
    assert dsc.Complex2.from_bytes(c.to_bytes()).label_names == {}
    assert copies[1].label_names == ODD
    with pytest.raises(TypeError):
        c.label_names[1] = "a name"  # would be lost


@pytest.mark.parametrize("names", [{1: ""}, {1: " "}, {1: "a\nb"}, {1: "a", 2: "a"}, {1: 3}, {2**40: "a"}])
def test_wrong_names(names):
    with pytest.raises(ValueError):
        two_squares().label_names = names


def test_names_instead_of_numbers():
    by_name, by_number = two_squares(), two_squares()
    assert by_name.volumes[2] == pytest.approx(1 / 4)
    by_name.mean_curvature(1e-3, density={"core": 3.0}, topology=[("core", "shell"), (0, "shell")])
    by_number.mean_curvature(1e-3, density={2: 3.0}, topology=[(2, 1), (0, 1)])
    assert by_name == by_number
    assert by_name.restore_volumes({"core": 0.2, 1: 0.7})
    assert by_name.volumes == pytest.approx({0: by_name.volumes[0], 1: 0.7, 2: 0.2}, rel=1e-3)


def test_unknown_names_are_named():
    c = two_squares()
    for wrong in (
        lambda: c.restore_volumes({"cor": 1.0}),
        lambda: c.mean_curvature(0, density={"cor": 1.0}),
        lambda: c.offset(0, topology=[("cor", "shell")]),
        lambda: dsc.Fluid(c, {"cor": dsc.Liquid(1.0)}),
        lambda: dsc.Film(hidden=["cor"]).add(c),
        lambda: dsc.GrainGrowth(c, density={"cor": 1.0}),
    ):
        with pytest.raises(ValueError, match="no label has the name 'cor'; the names are: 'shell', 'core'$"):
            wrong()
    with pytest.raises(ValueError, match="twice"):
        c.restore_volumes({"core": 1.0, 2: 1.0})
    c.label_names = {i: f"part {i}" for i in range(2000)}
    with pytest.raises(ValueError, match="'part 4' and 1995 others$"):
        c.restore_volumes({"part": 1.0})


def test_a_text_is_always_a_name():
    c = two_squares()
    with pytest.raises(ValueError):
        c.restore_volumes({"2": 0.2})
    c.label_names = {1: "2"}
    assert dsc.Fluid(c, {"2": dsc.Liquid(1.0)}).balance.volume == pytest.approx(c.volumes[1])


def test_fluids():
    c = two_cubes()
    fluid = dsc.Fluid(
        c, {"shell": dsc.Liquid(1.0), "core": dsc.Liquid(0.5)}, tensions={("shell", "core"): 0.1, (0, "shell"): 0.2}
    )
    same = dsc.Fluid(c, {1: dsc.Liquid(1.0), 2: dsc.Liquid(0.5)}, tensions={(1, 2): 0.1, (0, 1): 0.2})
    assert fluid.balance.surface_energy == same.balance.surface_energy > 0
    fluid.set_velocities(np.ones((c.number_of_vertices, 3)), label="core")
    assert np.count_nonzero(fluid.velocities_of("core")) > 0
    assert not fluid.velocities_of("shell").any()
    assert np.array_equal(fluid.pressures_of("core"), fluid.pressures_of(2))
    assert fluid.complex.label_names == c.label_names


def test_films():
    c = two_squares()
    c.label_names = ODD
    film = dsc.Film(hidden=["7"])
    film.add(c)
    page = film.html()
    assert '"hidden":[1]' in page
    assert '[[1,"7"],[2,"gro' in page
    c.label_names = {1: "</script>", 2: "<!--<script>"}
    film.add(c)
    for markup in "</script", "<script", "<!--":
        assert film.html().count(markup) == page.count(markup)


def test_grids_of_vtk():
    pytest.importorskip("vtk")
    c = two_squares()
    c.label_names = ODD
    data = c.to_vtk().GetFieldData()
    names = data.GetAbstractArray("label_names")
    assert {data.GetArray("named_labels").GetValue(i): names.GetValue(i) for i in range(3)} == ODD
    assert two_squares().copy().to_vtk().GetFieldData().GetNumberOfArrays() == 2


def test_the_program_keeps_names(tmp_path):
    c = two_cubes()
    c.label_names = {1: ODD[1], 2: ODD[2]}
    c.save(tmp_path / "c.dsc")
    program = os.environ["DSC_PROGRAM"]
    info = subprocess.run([program, "info", tmp_path / "c.dsc"], capture_output=True, encoding="utf-8", check=True)
    assert f"label 2 '{ODD[2]}': " in info.stdout
    subprocess.run([program, "convert", tmp_path / "c.dsc", tmp_path / "c.stl"], check=True)
    moved = ["rotate", "c.stl", "--axis", "0,0,1", "--angle", "5", "--steps", "1", "--output", "run"]
    subprocess.run([program, *moved], check=True, capture_output=True, cwd=tmp_path)
    assert dsc.Complex3.read(tmp_path / "run/checkpoint.dsc").label_names == c.label_names


def test_segmentation():
    x = np.linspace(-1, 1, 24)
    image = (np.add.outer(x**2, x**2) < 0.4).astype(float)
    first = dsc.segment(image, 2).complex
    first.label_names = {0: "outside", 1: "disk"}
    again = dsc.segment(image, 2, start=first, connected=["disk"])
    assert again.complex.label_names == first.label_names
    with pytest.raises(ValueError, match="'outside', 'disk'"):
        dsc.segment(image, 2, start=first, connected=["ball"])


def test_segmentation_by_the_program(tmp_path):
    x = np.linspace(-1, 1, 24)
    image = (np.add.outer(x**2, x**2) < 0.4).astype(np.uint8)
    (tmp_path / "a.pgm").write_bytes(b"P5\n24 24\n255\n" + (200 * image).tobytes())
    first = dsc.segment(image.astype(float), 2).complex
    first.label_names = {0: "outside", 1: "disk, round"}
    first.save(tmp_path / "c.dsc")

    def segment(connected):
        command = [os.environ["DSC_PROGRAM"], "segment", "a.pgm", "--start", "c.dsc", "--connected", connected]
        files = ["-o", "d.dsc", "-o", "d.png", "-o", "d.wkt", "--report", "r.json"]
        return subprocess.run([*command, *files], capture_output=True, encoding="utf-8", cwd=tmp_path)

    result = segment("0,disk, round")
    assert result.returncode == 0, result.stderr
    assert "label 1 'disk, round': intensity 196.8" in result.stdout
    assert "d.wkt: the format contains no names of labels (0 'outside', 1 'disk, round')" in result.stderr
    assert json.loads((tmp_path / "r.json").read_text())["phases"][1]["name"] == "disk, round"
    assert dsc.Complex2.read(tmp_path / "d.dsc").label_names == first.label_names
    result = segment("1,ball")
    assert result.returncode == 2
    assert result.stderr == (
        "dsc: --connected: no label has the name 'ball' (0 'outside', 1 'disk, round'); give the number of a label\n"
    )
