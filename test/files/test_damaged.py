"""Gives damaged and malicious files to `dsc`. See benchmark/damaged_files.py for more of them."""

import gzip
import os
import pathlib
import resource
import struct
import subprocess
import sys
import threading

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "benchmark"))
import damaged_files as damaged

DSC = os.environ["DSC_PROGRAM"]
pytestmark = pytest.mark.skipif(
    not (pathlib.Path(DSC).parent / "dsc-files").exists(), reason="dsc-files is not built: VTK is missing"
)
LARGE = (1000, 1000, 1000)
ZEROS = damaged.zeros(300 * 10**6, "gzip")
SPACES = damaged.zeros(200 * 10**6)


def refusal(path, *command):
    """Returns the only line that `dsc` prints for a file that it refuses, without large memory or time."""
    with open(path.parent / "err", "wb") as err:
        arguments = [DSC, *(command or ("info",)), str(path)]
        child = subprocess.Popen(
            arguments,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=err,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (20, 20)),
        )
        patience = threading.Timer(60, child.kill)
        patience.start()
        _, status, usage = os.wait4(child.pid, 0)
        patience.cancel()
        child.returncode = status
    text = (path.parent / "err").read_text()
    assert os.WIFEXITED(status) and os.WEXITSTATUS(status) == 1, text
    assert usage.ru_maxrss < 2**20, "more than 1 GB"
    assert text.startswith("dsc: ") and text.count("\n") == 1 and len(text) < 2000
    assert not any(ord(c) < 32 or 127 <= ord(c) < 160 for c in text[:-1]), text
    assert "crashes its reader" not in text
    return text


def edited(content, *replacements):
    for before, after in replacements:
        assert before in content
        content = content.replace(before, after, 1)
    return content


TOO_LARGE = "GB of content in"
BOMBS = {
    "labels.png": (damaged.png((60000, 60000), data=SPACES), TOO_LARGE),
    "colors.png": (damaged.png((10000, 10000), colors=2, data=SPACES), TOO_LARGE),
    "large.tif": (damaged.tiff((10**6, 10**6), compression=8), TOO_LARGE),
    "rows.tif": (damaged.tiff((8, 32640), data=damaged.box((8, 8, 1)), rows=8), "truncated"),
    "large.nii": (damaged.nii(LARGE), TOO_LARGE),
    "large.nii.gz": (gzip.compress(damaged.nii(LARGE, b"")) + ZEROS, TOO_LARGE),
    "large.inr.gz": (gzip.compress(damaged.inr(LARGE, b"")) + ZEROS, TOO_LARGE),
    "tail.inr.gz": (gzip.compress(damaged.inr()) + ZEROS, "more bytes than its header announces"),
    "large.mha": (damaged.mha(LARGE, SPACES, extra="CompressedData = True\n"), TOO_LARGE),
    "large.nrrd": (damaged.nrrd(LARGE, ZEROS, "gzip"), TOO_LARGE),
    "large.vti": (damaged.vti("0 999 0 999 0 999", compressed=True), TOO_LARGE),
    "large.vtu": (damaged.vtu(compressed=True, counts=(10**12, 10**12)), TOO_LARGE),
    "large.vtp": (damaged.vtp(10**12, 10**12), TOO_LARGE),
    "large.vtk": (damaged.legacy(10**12, 10**12, binary=True), "is it damaged?"),
    "large.meshb": (damaged.meshb(2 * 10**9), "truncated or damaged"),
    "cycle.meshb": (
        edited(damaged.meshb(), (struct.pack("<ii", 8, 224), struct.pack("<ii", 7, 20))),
        "truncated or damaged",
    ),
    "deep.geojson": (b'{"type":"GeometryCollection","geometries":[' * 10**5 + b"]}" * 10**5, "64 levels deep"),
    # what readers of VTK crash at, or never end
    "sizes.nii": (damaged.nii((0, 5, 5)), "wrong numbers in its NIfTI header"),
    "type.nii": (damaged.nii(bits=64), "wrong numbers in its NIfTI header"),
    "sizes.nrrd": (edited(damaged.nrrd(), (b"sizes:", b"seizes:")), "positive integers"),
    "size.nrrd": (edited(damaged.nrrd(), (b" 4 4\n", b" 4 x\n")), "positive integers"),
    "dimension.mha": (edited(damaged.mha(), (b"NDims = 3", b"NDims = 2147483647")), "another number of sizes"),
    "colon.mha": (edited(damaged.mha(), (b"ElementDataFile =", b"ElementDataFile : x =")), "without '='"),
    "long.mha": (damaged.mha(extra="Comment = " + 256 * "x" + "\n"), "too long for VTK"),
    "key.mhd": (edited(damaged.mha(data="no.raw"), (b"ElementDataFile =", b"ElementDataFile x =")), "cannot be opened"),
    "outside.mhd": (edited(damaged.mha(data="/etc/passwd"), (b"ElementDataFile =", b"ElementDataFile x =")), "outside of its folder"),
    "indent.mhd": (edited(damaged.mha(data="/etc/passwd"), (b"ElementDataFile =", b"  ElementDataFile =")), "outside of its folder"),
    "picture.png": (damaged.png(colors=2).replace(b"IEND", b"IEXD"), "damaged PNG picture"),
    "corner.vtp": (edited(damaged.vtp(), (b"ascii\">0 2 1", b"ascii\">0 2 999")), "unknown vertex"),
    "offsets.vtp": (edited(damaged.vtp(), (b"3 6 9 12", b"3 9 6 12")), "is it damaged?"),
    "block.vtu": (edited(damaged.vtu(compressed=True), (b"\x78\x9c", b"\x78\x9d")), "cannot be read by VTK"),
    "words.csv": (b"x,y,z\n1,2," + damaged.WORD, "instead of a number"),
    "words.mhd": (damaged.mha(data=damaged.WORD.decode(), values=b""), "cannot be opened"),
}


@pytest.mark.parametrize("name", BOMBS)
def test_damaged_files_are_refused(tmp_path, name):
    content, message = BOMBS[name]
    (tmp_path / name).write_bytes(content)
    command = ("reconstruct", "-o", str(tmp_path / "r.off")) if name.endswith("csv") else ()
    assert message in refusal(tmp_path / name, *command)


def test_gray_images_of_a_portable_map_that_ends(tmp_path):
    (tmp_path / "a.pgm").write_bytes(b"P5\n8 8\n\n" + bytes(64))
    assert "positive integers" in refusal(tmp_path / "a.pgm", "segment", "-o", str(tmp_path / "a.wkt"))


@pytest.mark.parametrize("name", ["/etc/passwd", "/dev/zero", "../other.raw", "no.raw", "%03d.raw"])
@pytest.mark.parametrize("format", ["mhd", "nhdr", "pvtu", "vtm"])
def test_headers_name_files_in_their_folder(tmp_path, name, format):
    folder = tmp_path / "folder"
    folder.mkdir()
    (tmp_path / "other.raw").write_bytes(bytes(200))
    path = folder / f"a.{format}"
    path.write_bytes(
        {
            "mhd": damaged.mha(data=name, values=b""),
            "nhdr": damaged.nrrd(values=b"", extra=f"data file: {name}\n"),
            "pvtu": damaged.pvtu(name),
            "vtm": damaged.vtm(name),
        }[format]
    )
    expected = "several files" if "%" in name else "cannot be opened" if name == "no.raw" else "outside of its folder"
    assert expected in refusal(path)


def test_headers_may_name_files_below_their_folder(tmp_path):
    (tmp_path / "below").mkdir()
    (tmp_path / "below/a.raw").write_bytes(damaged.box((5, 5, 5)))
    (tmp_path / "a.mhd").write_bytes(damaged.mha(data="below/a.raw", values=b""))
    assert subprocess.run([DSC, "info", tmp_path / "a.mhd"], capture_output=True).returncode == 0


@pytest.mark.parametrize("name", ["a.off", "a.nii", "a.inr", "a.dsc", "a.png", "a.vtu", "a.3mf"])
@pytest.mark.parametrize("kind", ["device", "pipe"])
def test_other_than_regular_files(tmp_path, name, kind):
    if kind == "pipe":
        os.mkfifo(tmp_path / name)
    else:
        (tmp_path / name).symlink_to("/dev/zero")
    assert "file" in refusal(tmp_path / name)


def test_names_with_control_characters(tmp_path):
    (tmp_path / "a.obj").write_bytes(damaged.obj("\x1b[31mred" + "w" * 100000))
    result = subprocess.run([DSC, "info", tmp_path / "a.obj"], capture_output=True)
    assert result.returncode == 0 and b"\x1b" not in result.stdout + result.stderr
    assert len(result.stdout + result.stderr) < 5000
