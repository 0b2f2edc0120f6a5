"""Each example runs, quickly, in a folder of its own, and mypy finds nothing in it."""

import pathlib
import subprocess
import sys

import pytest

EXAMPLES = sorted((pathlib.Path(__file__).resolve().parents[2] / "python" / "examples").glob("*.py"))
# What each leaves, besides what it prints.
FILES = {
    "first_picture": ["heron.exr", "heron.png"],
    "polar_two_bands": ["polar.csv", "polar.png"],
    "day_of_a_plate": ["day.csv"],
    "hyperspectral_cube": ["cube.npy"],
    "plume_spectrum": ["plume.png"],
    "compare_camera": ["difference.exr"],
}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_example_runs(example, tmp_path):
    if "import matplotlib" in example.read_text():
        pytest.importorskip("matplotlib")
    done = subprocess.run(
        [sys.executable, example, "--quick"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()
    assert sorted(file.name for file in tmp_path.iterdir()) == FILES.get(example.stem, [])


def test_every_example_is_in_the_readme():
    readme = (EXAMPLES[0].parent / "README.md").read_text()
    for example in EXAMPLES:
        assert f"`{example.name}`" in readme


def test_mypy_is_strict_with_the_examples(tmp_path):
    pytest.importorskip("mypy")
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path, *EXAMPLES],
        capture_output=True,
        text=True,
        timeout=200,
    )
    assert done.returncode == 0, done.stdout
