"""First picture: a patrol aircraft in 3-5 um as an image in W m-2 sr-1."""

import pathlib
import sys

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "heron" / "heron.smat")
    if quick:
        project = project.with_settings({"sensor.width": 80, "sensor.height": 64, "render.bounces": 0})
    result = project.image(band=(3, 5))
    image = result.image
    assert image is not None
    image.save("heron.exr")  # values with provenance
    image.save("heron.png")  # to look at
    print(f"{image.width_px} x {image.height_px} px, {image.statistics()['maximum']:.3g} W m-2 sr-1 at most")
    for label, value, unit in result.summary:
        print(f"{label}: {value:.4g} {unit}")


if __name__ == "__main__":
    main("--quick" in sys.argv)
