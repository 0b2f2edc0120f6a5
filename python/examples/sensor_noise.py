"""A picture as a sensor reads it: its noise, measured in many frames, against what its numbers say."""

import pathlib
import sys

import numpy as np

import smat

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main(quick: bool) -> None:
    sensor = smat.SensorDescription(ROOT / "resources" / "sensors" / "cooled-mwir.smatsensor")
    numbers = sensor.numbers(300.0)
    # A uniform background of 300 K in many frames: what differs from frame to frame is temporal noise.
    level = sensor.band.radiance(300.0)
    frames = 8 if quick else 64
    uniform = np.full(sensor.shape, level)
    pictures = np.stack([sensor.read(uniform, frame=frame)["L"] for frame in range(frames)])
    noise = float(np.sqrt(np.mean(np.var(pictures, axis=0, ddof=1))))
    per_K = (sensor.band.radiance(300.5) - sensor.band.radiance(299.5)) / 1.0
    print(f"{sensor.title}: noise of {frames} frames {1e3 * noise / per_K:.1f} mK, NETD {1e3 * numbers['netd_K']:.1f} mK")

    # The ship through the same sensor, whose size and band become those of the picture.
    project = smat.Project(ROOT / "samples" / "ship" / "ship.smat")
    if quick:
        project = project.with_settings({"render.bounces": 0, "environment.atmospheres": "none"})
    image = project.image(
        sensor=ROOT / "resources" / "sensors" / "cooled-mwir.smatsensor", quantity="counts", sensor_samples=1
    ).image
    assert image is not None
    image.save("counts.exr")
    print(f"{image['counts'].min():.0f} to {image['counts'].max():.0f} counts")


if __name__ == "__main__":
    main("--quick" in sys.argv)
