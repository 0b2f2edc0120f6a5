"""Fit an emissivity to a measured radiant intensity by bisection."""

import pathlib
import sys

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "sphere" / "sphere.smat").with_settings({"render.sun": "off"})
    if quick:
        project = project.with_settings({"sensor.width": 48, "sensor.height": 48})
    database = project.database()
    measured_W_sr = 7.0

    def intensity_W_sr(emissivity: float) -> float:
        painted = project.with_database(database.replaced({"materials.1.emissivity": emissivity}))
        return float(painted.image().table["intensity"][0])

    low, high = 0.0, 1.0
    while high - low > 1e-4:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if intensity_W_sr(middle) < measured_W_sr else (low, middle)
    emissivity = 0.5 * (low + high)
    print(f"emissivity {emissivity:.4f} gives {intensity_W_sr(emissivity):.4f} W sr-1")
    # The radiance of a grey body is linear in its emissivity.
    assert abs(emissivity - measured_W_sr / intensity_W_sr(1.0)) < 1e-3


if __name__ == "__main__":
    main("--quick" in sys.argv)
