"""Colours show on light and on dark pages, and are told apart by colour-blind eyes."""

import itertools

import numpy as np
import pytest

from gasbox.scenario import load, shipped
from gasbox.scenario.colors import PALETTE

pytestmark = pytest.mark.small

# Severe protanopia, deuteranopia and tritanopia: G. M. Machado et al., IEEE Trans. Vis. Comput. Graph. 15, 1291 (2009),
# https://doi.org/10.1109/TVCG.2009.113
EYES = {
    "usual": np.eye(3),
    "no red": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "no green": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "no blue": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}
XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
WHITE = np.array([0.9505, 1.0, 1.089])


def linear(color):
    value = np.array([int(color[place : place + 2], 16) for place in (1, 3, 5)]) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def lab(light):
    ratio = XYZ @ np.clip(light, 0, 1) / WHITE
    f = np.where(ratio > 0.008856, np.cbrt(ratio), 7.787 * ratio + 16 / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def contrast(one, other):
    dark, light = sorted((XYZ @ linear(color))[1] for color in (one, other))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("background", ["#ffffff", "#14171c"])
def test_contrast_of_graphics(background):
    # WCAG 2.1, success criterion 1.4.11: at least 3:1 for graphical objects.
    used = {species.color for name in shipped() for species in load(name).species}
    assert all(contrast(color, background) >= 3 for color in {*PALETTE, *used})


@pytest.mark.parametrize("eye", EYES)
def test_colours_differ_for_every_eye(eye):
    # A difference of 2.3 in CIELAB is just noticeable; small moving discs need far more.
    seen = {color: lab(np.array(EYES[eye]) @ linear(color)) for color in PALETTE}
    least = {
        pair: np.linalg.norm(seen[pair[0]] - seen[pair[1]]) for pair in itertools.combinations(PALETTE, 2)
    }
    assert min(least.values()) > 15
    assert min(least[pair] for pair in itertools.combinations(PALETTE[:3], 2)) > 20
