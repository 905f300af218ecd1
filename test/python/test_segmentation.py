"""Segmentation of images whose phases are known."""

import dsc
import numpy as np
import pytest


def disk(noise=0.1):
    x, y = np.meshgrid(np.arange(50), np.arange(40), indexing="ij")
    image = (np.hypot(x - 24, y - 19) < 10).astype(float)
    return image + noise * np.random.default_rng(1).standard_normal(image.shape)


def test_a_disk():
    image = disk()
    result = dsc.segment(image, 2)
    assert result.converged
    assert result.complex.is_valid()
    assert [phase.label for phase in result.phases] == [0, 1]
    assert result.phases[1].pixels == pytest.approx(np.count_nonzero(image > 0.5), rel=0.02)
    assert result.phases[1].components == 1
    assert result.phases[1].intensities == pytest.approx([1], abs=0.05)
    assert result.noise == pytest.approx([0.1], abs=0.02)
    assert result.boundaries[0].labels == (0, 1)
    assert result.boundaries[0].measure == pytest.approx(20 * np.pi, rel=0.03)
    labels = result.complex.to_image(image.shape, 1, (0, 0))
    assert np.count_nonzero(labels != (image > 0.5)) < 20
    again = dsc.segment(image, 2, threads=2)
    assert again.complex.to_bytes() == result.complex.to_bytes()


def test_units_channels_and_masks():
    image = disk()
    scaled = dsc.segment(image, spacing=0.5, origin=(0.25, 0.25), intensities=[0, 1])
    pixels = np.count_nonzero(image > 0.5)
    assert scaled.complex.volumes[1] == pytest.approx(pixels / 4, rel=0.02)
    assert [phase.intensities for phase in scaled.phases] == [[0], [1]]
    channels = np.stack([image, 3 - image], axis=-1)
    two = dsc.segment(channels, 2, channel_axis=-1)
    assert all(len(phase.intensities) == 2 for phase in two.phases)
    damaged = image.copy()
    damaged[:5] = 100
    masked = dsc.segment(np.ma.masked_greater(damaged, 50), 2)
    assert masked.phases[1].pixels == pytest.approx(pixels, rel=0.02)
    same = dsc.segment(damaged, 2, mask=damaged < 50)
    assert same.complex.to_bytes() == masked.complex.to_bytes()


def test_volumes_and_given_topology():
    x = np.indices((24, 22, 20)) - np.array([11.5, 10.5, 9.5])[:, None, None, None]
    image = (np.linalg.norm(x, axis=0) < 7) + 0.2 * np.random.default_rng(2).standard_normal(x.shape[1:])
    result = dsc.segment(image, 2)
    assert result.phases[1].pixels == pytest.approx(4 / 3 * np.pi * 343, rel=0.05)
    kept = dsc.segment(image, 2, start=result.complex, keep_topology=True)
    assert kept.complex.components == {0: 1, 1: 1}
    assert result.complex.to_bytes() != kept.complex.to_bytes()


def test_refuses_bad_arguments():
    image = disk()
    for bad in image[0], image.astype(complex), image.astype(str):
        with pytest.raises((TypeError, ValueError)):
            dsc.segment(bad)
    for options in (
        {"phases": 1},
        {"phases": 500},
        {"intensities": [1]},
        {"intensities": [1, 1]},
        {"connected": [2]},
        {"connected": [1], "keep_topology": True},
        {"smoothing": 0},
        {"noise": -1},
        {"longest_edge": 0.5},
    ):
        with pytest.raises(dsc.Error):
            dsc.segment(np.round(image), **options)
    with pytest.raises(ValueError):
        dsc.segment(image, mask=image[:-1])
    for options in (
        {"intensities": 5},
        {"intensities": [[1, 2], [3, 4]]},
        {"intensities": [0, 1], "phases": 3},
        {"spacing": (1, 1, 1)},
        {"noise": (1, 1)},
    ):
        with pytest.raises(ValueError):
            dsc.segment(image, **options)
    for options in {"phases": 2.5}, {"mask": "x"}, {"start": "x"}:
        with pytest.raises(TypeError):
            dsc.segment(image, **options)
    elsewhere = dsc.segment(image, origin=(1000, 0)).complex
    with pytest.raises(dsc.Error, match="no cell"):
        dsc.segment(image, start=elsewhere)
    with pytest.raises(dsc.Error, match="too far"):
        dsc.segment(image, origin=(1e17, 0))
    with pytest.raises(dsc.Error):
        dsc.segment(np.where(image > 0.5, np.nan, image))
    with pytest.raises(dsc.Interrupted):
        dsc.segment(image, 2, progress=lambda phase: False)
