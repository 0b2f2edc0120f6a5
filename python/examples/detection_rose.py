"""From how far a sensor sees a ship, over the aspect: as a point above its noise, and resolved for a task."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import smat

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main(quick: bool) -> None:
    sensor = smat.SensorDescription(ROOT / "resources" / "sensors" / "cooled-mwir.smatsensor")
    project = smat.Project(ROOT / "samples" / "ship" / "ship.smat")
    step_deg = 10.0
    if quick:
        step_deg = 90.0
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    ranges = {
        "seen as a point": project.detection(sensor, snr=5, step=step_deg, farthest_m=1e9).table,
        "recognised": project.detection(
            sensor, criterion="johnson", task="recognition", step=step_deg, background_temperature_K=285
        ).table,
    }
    axes = plt.subplot(projection="polar", theta_zero_location="N", theta_direction=-1)
    for name, table in ranges.items():
        angle = np.radians(np.append(table["angle"], table["angle"][0]))
        range_km = 1e-3 * np.append(table["detection_range"], table["detection_range"][0])
        axes.plot(angle, range_km, label=f"{name} (km)")
        print(f"{name}: {range_km.min():.1f} to {range_km.max():.1f} km")
    axes.set_yscale("log")
    axes.legend(loc="lower center")
    plt.savefig("rose.png", dpi=120)


if __name__ == "__main__":
    main("--quick" in sys.argv)
