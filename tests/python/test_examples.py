"""Each example runs, quickly, in a folder of its own, and mypy finds nothing in it."""

import ast
import json
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
    "detection_rose": ["rose.png"],
    "plume_points": ["flow.vtu", "points.csv"],
    "sensor_noise": ["counts.exr"],
}
NOTEBOOKS = sorted(EXAMPLES[0].parent.glob("*.ipynb"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda file: file.stem)
def test_example_runs(example, tmp_path):
    for module in ("matplotlib", "dask", "meshio"):
        if f"import {module}" in example.read_text() or f"from {module}" in example.read_text():
            pytest.importorskip(module)
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


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda file: file.stem)
def test_notebook_runs(notebook, monkeypatch):
    monkeypatch.chdir(pathlib.Path(__file__).resolve().parents[2])
    names, shown = {}, []
    for cell in json.loads(notebook.read_text())["cells"]:
        if cell["cell_type"] == "code":
            *lines, last = ast.parse("".join(cell["source"])).body
            exec(compile(ast.Module(lines, []), notebook.name, "exec"), names)
            if isinstance(last, ast.Expr):
                shown.append(eval(compile(ast.Expression(last.value), notebook.name, "eval"), names))
            else:
                exec(compile(ast.Module([last], []), notebook.name, "exec"), names)
    assert shown[0]._repr_png_().startswith(b"\x89PNG")
    assert len(shown) == 3


def test_every_example_is_in_the_readme():
    readme = (EXAMPLES[0].parent / "README.md").read_text()
    for example in EXAMPLES + NOTEBOOKS:
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
