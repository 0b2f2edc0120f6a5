"""Workers of Dask: a worker that is killed in the middle of a sweep costs time and changes nothing."""

import os
import pathlib
import signal

import numpy as np
import pytest

import smat

distributed = pytest.importorskip("distributed")


def test_a_killed_worker_changes_nothing(sphere, tmp_path):
    project = sphere.with_settings({"sensor.width": 24, "sensor.height": 24, "environment.atmospheres": "none"})
    elevations_deg = [float(e) for e in range(-50, 51, 10)]
    killed = tmp_path / "killed"

    # Nested, so that workers get the function itself: they cannot import this file.
    def row(one: smat.Project, elevation_deg: float, mark: str) -> np.ndarray:
        smat.set_threads(1)
        result = one.table(
            azimuth_step=90, elevation_from=elevation_deg, elevation_to=elevation_deg, elevation_step=1
        )
        if elevation_deg == 0.0 and not pathlib.Path(mark).exists():
            pathlib.Path(mark).write_text(str(os.getpid()))
            os.kill(os.getpid(), signal.SIGKILL)
        return result.table.to_numpy()

    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, local_directory=str(tmp_path)
    ) as cluster, distributed.Client(cluster) as client:
        before = set(client.run(os.getpid).values())
        jobs = [client.submit(row, project, e, str(killed), pure=False) for e in elevations_deg]
        together = np.concatenate(client.gather(jobs))
    assert int(killed.read_text()) in before
    alone = project.table(
        azimuth_step=90, elevation_from=elevations_deg[0], elevation_to=elevations_deg[-1], elevation_step=10
    ).table.to_numpy()
    assert together.tobytes() == alone.tobytes()
