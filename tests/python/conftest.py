"""What the tests share: the samples, copied into a folder of the test, and smat-batch."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess

import pytest

import smat

SOURCE = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def samples() -> pathlib.Path:
    """The folder of the samples."""
    return SOURCE / "samples"


@pytest.fixture(scope="session")
def sphere(samples: pathlib.Path) -> smat.Project:
    """A grey sphere in vacuum, small enough to be quick."""
    return smat.Project(samples / "sphere" / "sphere.smat").with_settings(
        {"sensor.width": 48, "sensor.height": 48, "render.sun": "off"}
    )


@pytest.fixture(scope="session")
def batch():
    """Runs smat-batch of the same build."""
    program = os.environ.get("SMAT_BATCH") or shutil.which("smat-batch")
    if not program:
        pytest.skip("SMAT_BATCH names no smat-batch")

    def run(*arguments: object) -> str:
        done = subprocess.run(
            [program, *map(str, arguments)], capture_output=True, text=True, timeout=120
        )
        assert done.returncode in (0, 1), done.stderr
        return done.stdout

    return run
