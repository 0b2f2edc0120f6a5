"""Polar in two bands: contrast intensity over the aspect angle, from the same drawings."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    table = project.polar(step=60 if quick else 10, band=[(3, 5), (8, 12)]).table

    figure, axes = plt.subplots(subplot_kw={"projection": "polar"})
    for band in ("3-5um", "8-12um"):
        axes.plot(np.radians(table["angle"]), table[f"contrast_intensity@{band}"], label=band)
    axes.set_title("Contrast intensity, W sr$^{-1}$")
    axes.legend()
    figure.savefig("polar.png")
    table.save("polar.csv")
    print(f"{table.rows} angles")


if __name__ == "__main__":
    main("--quick" in sys.argv)
