"""A fleet of paints: one ship whose hull has several emissivities, over range."""

import pathlib
import sys

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
PAINTS = {"bare": 0.3, "low emissivity": 0.6, "navy grey": 0.95}


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    database = project.database()
    hull = min(database.material_names)
    print(f"material {hull}: {database.material_names[hull]}")
    for paint, emissivity in PAINTS.items():
        painted = database.replaced({f"materials.{hull}.emissivity": emissivity})
        errors = [finding for finding in painted.lint() if finding.severity == "error"]
        assert not errors
        result = project.with_database(painted).range(
            from_=1000, to=10000, points=3 if quick else 20, band=(8, 12)
        )
        irradiance = result.table["irradiance"]
        print(f"{paint:>15}: {irradiance[0]:.3e} W m-2 at 1 km, {irradiance[-1]:.3e} at 10 km")


if __name__ == "__main__":
    main("--quick" in sys.argv)
