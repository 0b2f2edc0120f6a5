#!/bin/bash
# What one would guess: pyBSM's circular_aperture_OTF_with_defocus, which names Hopkins (1955) as its source,
# is the exact transfer function of a circular pupil out of focus, 1 at frequency 0.
# What it is: in each term of the series the sine takes the difference of the Bessel functions as its argument,
# sin(2 beta (J1 - J3)) in place of sin(2 beta) (J1 - J3), and the factor in front is 2 / (pi a) in place of
# 4 / (pi a). Near frequency 0 both make up for each other; at half a wave it is off by up to 0.17.
# Version: pybsm 0.16.1 (PyPI). Source: H. H. Hopkins, "The frequency response of a defocused optical system",
# Proc. Roy. Soc. A 231, 91 (1955), eq. 12; the autocorrelation of the pupil by its definition, below.
# Why it matters here: transfer functions of sensors are held to the autocorrelation, not to this function.
set -euo pipefail

version='0.16.1'
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" --quiet install "pybsm==$version" >/dev/null
echo "pybsm $version"

"$work/venv/bin/python" - <<'PYTHON'
import numpy as np
import pybsm.otf

diameter_m, focal_m, wavelength_m, waves = 0.1, 0.2, 4e-6, 0.5
# Its w20 is 0.5 / (1 + 4 F^2) times the shift of focus.
shift_m = waves * wavelength_m / (0.5 / (1.0 + 4.0 * (focal_m / diameter_m) ** 2))


def autocorrelation(s):
    """Over a grid: both pupils, s radii apart, and the phase between them."""
    x = (np.arange(3000) + 0.5) / 3000 * 4 - 2
    x, y = np.meshgrid(x, x)
    a2, b2 = (x + s / 2) ** 2 + y**2, (x - s / 2) ** 2 + y**2
    inside = (a2 < 1) & (b2 < 1)
    return np.sum(np.cos(2 * np.pi * waves * (a2 - b2))[inside]) / np.sum(x**2 + y**2 < 1)


print("s (2 is the cutoff)   pyBSM    autocorrelation")
for s in (0.001, 0.05, 0.2, 0.5, 1.0, 1.5):
    u = np.array([s * diameter_m / wavelength_m / 2])
    theirs = pybsm.otf.circular_aperture_OTF_with_defocus(
        u=u, v=np.zeros(1), wavelength=wavelength_m, D=diameter_m, f=focal_m, defocus=shift_m)[0]
    print(f"{s:19.3f}   {theirs:7.4f}   {autocorrelation(s):7.4f}")
PYTHON
