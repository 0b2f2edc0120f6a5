"""A hyperspectral cube: an image for each of many narrow bands, as one array."""

import pathlib
import sys

import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "heron" / "heron.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 40, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    edges_um = np.linspace(3.0, 5.0, 4 if quick else 41).round(4).tolist()
    images = project.images(band=list(zip(edges_um, edges_um[1:])))
    cube = np.stack([image["L"] for image in images.values()])  # bands, rows, columns
    np.save("cube.npy", cube)
    print(f"{cube.shape[0]} bands of {cube.shape[2]} x {cube.shape[1]} px")


if __name__ == "__main__":
    main("--quick" in sys.argv)
