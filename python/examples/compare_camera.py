"""A computed picture beside that of a camera: gain, offset and what is left.

The camera's picture is made here, so that the program runs anywhere: counts of a 14-bit camera with noise. Put that of
your camera in its place, as `smat.Image.load("camera.tif")`.
"""

import pathlib
import sys

import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 80, "sensor.height": 64, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    computed = project.image().image
    assert computed is not None
    radiance = computed["L"].astype(float)
    noise = np.random.default_rng(1).normal(0.0, 4.0, radiance.shape)
    camera = smat.Image({"counts": np.round(1500.0 + 4000.0 * radiance + noise)}, {"counts": "1"})

    # Least squares: counts = offset + gain L.
    matrix = np.stack([np.ones(radiance.size), radiance.ravel()], axis=1)
    (offset, gain), *_ = np.linalg.lstsq(matrix, camera["counts"].ravel().astype(float), rcond=None)
    difference = (camera["counts"] - offset) / gain - radiance
    smat.Image({"difference": difference}, {"difference": "W m-2 sr-1"}).save("difference.exr")
    print(f"gain {gain:.0f} counts per W m-2 sr-1, offset {offset:.0f}, rms {difference.std():.2e} W m-2 sr-1")


if __name__ == "__main__":
    main("--quick" in sys.argv)
