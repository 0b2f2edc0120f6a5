"""A signature table on workers of Dask, equal byte for byte to one run; a worker that dies costs its rows once more.

On a cluster, give Client the address of its scheduler; nothing else changes.
"""

import pathlib
import sys

import numpy as np
from dask.distributed import Client, LocalCluster
from numpy.typing import NDArray

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def row(project: smat.Project, elevation_deg: float, step_deg: float) -> NDArray[np.float64]:
    """The row of a table at one elevation."""
    smat.set_threads(1)  # each worker is a process on a core of its own
    result = project.table(
        azimuth_step=step_deg, elevation_from=elevation_deg, elevation_to=elevation_deg, elevation_step=1
    )
    return result.table.to_numpy()


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "ship" / "ship.smat")
    step_deg, elevations_deg = (120.0, [0.0, 45.0, 90.0]) if quick else (5.0, list(np.arange(0.0, 91.0, 5.0)))
    if quick:
        project = project.with_settings(
            {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0, "environment.atmospheres": "none"}
        )
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)  # type: ignore[no-untyped-call]
    with cluster, Client(cluster) as client:  # type: ignore[no-untyped-call]
        jobs = client.map(row, [project] * len(elevations_deg), elevations_deg, [step_deg] * len(elevations_deg))
        together = np.concatenate(client.gather(jobs))
    alone = project.table(
        azimuth_step=step_deg,
        elevation_from=elevations_deg[0],
        elevation_to=elevations_deg[-1],
        elevation_step=elevations_deg[1] - elevations_deg[0],
    ).table.to_numpy()
    assert together.tobytes() == alone.tobytes()
    print(f"{len(together)} directions on 2 workers, equal byte for byte to one run")


if __name__ == "__main__":
    main("--quick" in sys.argv)
