"""One view has one number by every way: the benchmark's two objects below a pixel, one far off the axis."""

from __future__ import annotations

import importlib.util
import os
import pathlib
import shutil

import pytest

import smat

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def benchmark():
    specification = importlib.util.spec_from_file_location("every_way", SOURCE / "benchmarks/every_way.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_objects_below_a_pixel_have_one_number_by_every_way(tmp_path, monkeypatch):
    # What surfaces see of each other is the same for all ways.
    monkeypatch.setenv("SMAT_CACHE", str(tmp_path))
    program = os.environ.get("SMAT_BATCH") or shutil.which("smat-batch")
    if not program:
        pytest.skip("SMAT_BATCH names no smat-batch")
    ways = benchmark()
    case = ways.CASES["off-axis"]
    module = pathlib.Path(smat.__file__).parent.parent
    found = {
        way: (worst, stated)
        for way, worst, stated in ways.compare(program, "off-axis", case, case["bands"][0], "default", module)
    }
    assert set(found) == {
        "polar", "table", "table, ranges", "range", "time", "condition", "spectrum", "montecarlo", "simulate",
        "library",
    }
    assert {way: values for way, values in found.items() if not ways.is_good(way, "default", *values)} == {}


def test_differences_are_seen():
    ways = benchmark()
    truth = {("all", "intensity"): 10.0, ("all", "contrast_intensity"): 2.0, ("all", "irradiance"): 0.2}
    near = {**truth, ("all", "contrast_intensity"): 2.01, ("all", "error_contrast_intensity"): 0.02}
    worst, stated = ways.differences(truth, near)
    assert worst == pytest.approx({"intensity": 0.0, "contrast_intensity": 1e-3, "irradiance": 0.0})
    assert stated == pytest.approx(0.5)
    assert ways.is_good("range", "default", worst, stated)
    assert not ways.is_good("polar", "default", worst, stated)
    with_nan = {**truth, ("all", "irradiance"): float("nan")}
    assert not ways.is_good("polar", "default", *ways.differences(truth, with_nan))
