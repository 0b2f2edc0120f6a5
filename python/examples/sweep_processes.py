"""A signature table on several processes, equal byte for byte to one run.

Each process has its own renderer. With Dask the same function runs on a cluster:
`dask.distributed.Client().map(row, [project] * len(elevations_deg), elevations_deg)`.
"""

import multiprocessing
import pathlib
import sys

import numpy as np

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def row(project: smat.Project, elevation_deg: float, step_deg: float) -> smat.Table:
    """The row of a table at one elevation."""
    return project.table(
        azimuth_step=step_deg,
        elevation_from=elevation_deg,
        elevation_to=elevation_deg,
        elevation_step=1,
    ).table


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    step_deg = 90.0 if quick else 5.0
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    elevations_deg = np.arange(0.0, 91.0, 45.0 if quick else 2.5)
    jobs = [(project, float(elevation), step_deg) for elevation in elevations_deg]
    # Not by fork: what OpenGL has opened does not survive it.
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        rows = pool.starmap(row, jobs, chunksize=1)
    together = np.concatenate([part.to_numpy() for part in rows])
    alone = np.concatenate([row(*job).to_numpy() for job in jobs[: 2 if quick else None]])
    assert together[: len(alone)].tobytes() == alone.tobytes()
    print(f"{len(together)} directions, equal byte for byte")


if __name__ == "__main__":
    main("--quick" in sys.argv)
