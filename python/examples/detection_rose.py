"""A detection rose: the range at which the irradiance of the contrast falls to a threshold, over the aspect."""

import pathlib
import sys

import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
THRESHOLD_W_M2 = 1e-8


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    for azimuth_deg in (0, 180) if quick else range(0, 360, 30):
        table = project.range(
            from_=1000, to=100000, points=4 if quick else 30, log=True,
            azimuth=azimuth_deg,
        ).table
        irradiance, range_m = np.abs(table["irradiance"]), table["range"]
        # Straight lines between logarithms; irradiance falls with range.
        detection_m = np.exp(
            np.interp(-np.log(THRESHOLD_W_M2), -np.log(irradiance), np.log(range_m))
        )
        print(f"{azimuth_deg:4d} deg: {detection_m / 1000:.1f} km")


if __name__ == "__main__":
    main("--quick" in sys.argv)
