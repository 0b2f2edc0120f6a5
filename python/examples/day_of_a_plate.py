"""A day: the signature of a ship whose hull and deck follow local time, as pandas or NumPy has it."""

import pathlib
import sys

import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    table = project.run(analysis="day", step=21600 if quick else 3600).table
    hours = table["time"] / 3600
    warmest = int(np.argmax(table["intensity"]))
    print(f"most intensity at {hours[warmest]:.1f} h: {table['intensity'][warmest]:.4g} W sr-1")
    table.save("day.csv")


if __name__ == "__main__":
    main("--quick" in sys.argv)
