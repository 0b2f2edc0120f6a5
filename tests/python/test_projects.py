"""Projects and analyses: equal to the command line, stopped, in threads, pickled."""

import concurrent.futures
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import warnings

import numpy as np
import pytest

import smat

QUICK = {
    "image": ["--width", 40, "--height", 32],
    "spectrum": ["--width", 24, "--height", 24, "--resolution", 200],
    "polar": ["--width", 24, "--height", 24, "--step", 90, "--band", "3-5,8-12"],
    "time": ["--width", 24, "--height", 24, "--to", 10, "--step", 5],
    "range": ["--width", 24, "--height", 24, "--points", 3],
    "condition": ["--width", 24, "--height", 24, "--over", "mach", "--points", 2],
    "table": ["--width", 24, "--height", 24, "--azimuth-step", 120, "--elevation-step", 90],
}


def options_of(arguments):
    """Keyword arguments of options."""
    return {
        option[2:].replace("-", "_"): value for option, value in zip(arguments[::2], arguments[1::2])
    }


def without_command(text):
    return [line for line in text.splitlines() if "command" not in line]


def test_every_kind_of_analysis_is_compared():
    assert set(QUICK) == set(smat.analysis_kinds())


@pytest.mark.parametrize("kind", QUICK)
def test_results_have_the_bytes_of_the_command_line(kind, samples, batch, tmp_path):
    file = samples / "sphere" / "sphere.smat"
    name = tmp_path / ("batch.exr" if kind == "image" else "batch.csv")
    batch(kind, file, *QUICK[kind], "--out", name)
    result = getattr(smat.Project(file), kind)(**options_of(QUICK[kind]))
    assert result.is_complete and result.kind == kind
    result.save(tmp_path / ("python" + name.suffix))
    if kind == "image":
        theirs = smat.Image.load(name)
        assert result.image.planes == theirs.planes
        for plane in theirs.planes:
            assert result.image[plane].tobytes() == theirs[plane].tobytes()
        ours, theirs = result.image.attributes, theirs.attributes
        assert {key for key in ours if ours[key] != theirs.get(key)} <= {"command"}
        assert ours.keys() == theirs.keys()
    else:
        theirs = smat.Table.load(name)
        for key, column in theirs.items():
            assert result.table[key].tobytes() == column.tobytes()
        written = (tmp_path / "python.csv").read_text()
        assert without_command(written) == without_command(name.read_text())


def test_intensity_is_the_closed_form(sphere):
    result = sphere.image()
    expected = 0.9 * smat.Band("3-5").radiance(320.0) * np.pi
    assert result.table["intensity"][0] == pytest.approx(expected, rel=2e-3)
    assert result.image["L"].max() == pytest.approx(0.9 * smat.Band("3-5").radiance(320.0), rel=1e-6)


def test_settings_are_read_and_set(sphere, tmp_path, monkeypatch):
    project = sphere.with_settings({"sensor.band": [(3, 5), (8, 12)], "camera.range": 250})
    assert project["camera.range"] == 250.0
    assert project["sensor.band"] == [(3.0, 5.0), (8.0, 12.0)]
    assert project["sensor.width"] == 48
    assert project["render.sun"] == "off"
    assert sphere["camera.range"] == 100.0
    monkeypatch.chdir(tmp_path)
    project["sensor.response"] = "filter.csv"
    assert project["sensor.response"] in (str(tmp_path / "filter.csv"), [str(tmp_path / "filter.csv")])
    project["sensor.response"] = "none"
    project["camera.azimuth"] = np.float64(30.0)
    project["sensor.band"] = smat.Band("4-5")
    assert project.settings["camera.azimuth"] == 30.0 and project["sensor.band"] == [(4.0, 5.0)]


def test_every_default_is_a_value():
    for info in smat.settings():
        value = smat.project.value_of(info, info.default)
        assert smat.find_setting(info.key).key == info.key
        assert isinstance(value, (bool, int, float, str, list)), info.key
        assert isinstance(value, bool) == (info.kind == "boolean"), info.key
        assert info.expected and info.help and info.label


def test_named_analyses_have_their_settings(samples):
    project = smat.Project(samples / "sphere" / "sphere.smat")
    assert project.analyses["range"] == "range"
    result = project.run(analysis="range", points=2, width=24, height=24)
    np.testing.assert_allclose(result.table["range"], [100.0, 1000.0])
    assert result.name == "range"


def test_several_bands_give_an_image_each(sphere):
    images = sphere.images(band=[(3, 5), (8, 12)])
    assert list(images) == ["image@3-5um", "image@8-12um"]
    with pytest.raises(smat.InputError, match="2 bands"):
        sphere.image(band=[(3, 5), (8, 12)])


@pytest.mark.parametrize(
    "act, words",
    [
        (lambda p: p.run("polr"), "did you mean 'polar'"),
        (lambda p: p.run(analysis="nothing"), "nothing"),
        (lambda p: p.run("polar", analysis="range"), "kind range"),
        (lambda p: p["camera.rnage"], "camera.range"),
        (lambda p: p.with_settings({"camera.range": -5}), "-5"),
        (lambda p: p.with_settings({"camera.range": "far", "sensor.width": 0}), "far"),
        (lambda p: p.polar(step=400), "400"),
        (lambda p: p.image(settings={"sensor.response": "missing.csv"}), "missing.csv"),
        (lambda p: p.database("frigate"), "frigate"),
        (lambda p: smat.Project("missing.smat"), "missing.smat"),
        (lambda p: p.image().save("picture.doc"), "picture.doc"),
    ],
)
def test_what_cannot_be_is_an_input_error(sphere, act, words):
    with pytest.raises(smat.InputError) as caught:
        act(sphere)
    assert words in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.diagnostics == caught.value.diagnostics and str(again) == str(caught.value)


def test_all_diagnostics_come_at_once(sphere):
    with pytest.raises(smat.InputError) as caught:
        sphere.with_settings({"camera.range": "far", "sensor.width": 0})
    assert [one.position for one in caught.value.diagnostics] == ["camera.range", "sensor.width"]
    first = caught.value
    assert (first.file, first.position, first.value) == ("settings", "camera.range", "far")
    assert "number" in first.expected and isinstance(first, ValueError)


def test_unknown_options_are_type_errors(sphere):
    with pytest.raises(TypeError, match="stp"):
        sphere.polar(stp=10)


def test_progress_is_told_and_stops(sphere):
    seen = []
    result = sphere.polar(step=45, progress=lambda progress: seen.append(progress.done))
    assert seen[0] == 0 and seen[-1] == 8 and result.is_complete
    part = sphere.polar(step=45, progress=lambda progress: progress.done < 3)
    assert not part.is_complete and 0 < part.table.rows < 8
    with pytest.raises(RuntimeError, match="enough"):
        sphere.polar(step=45, progress=raise_enough)


def raise_enough(progress):
    raise RuntimeError("enough")


def test_ctrl_c_ends_a_sweep_and_leaves_a_usable_interpreter(sphere):
    def interrupt(progress):
        if progress.done == 2:
            os.kill(os.getpid(), signal.SIGINT)

    done = []
    with pytest.raises(KeyboardInterrupt):
        sphere.polar(step=2, progress=lambda p: (done.append(p.done), interrupt(p)))
    assert done[-1] < 10
    assert sphere.polar(step=120).is_complete


def test_threads_run_at_once_and_give_the_bytes_of_one(sphere):
    alone = [sphere.polar(step=30, azimuth=azimuth).table.to_csv() for azimuth in (0, 40)]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(sphere.polar, step=30, azimuth=azimuth) for azimuth in (0, 40)]
        together = [job.result().table.to_csv() for job in jobs]
    assert together == alone


def test_the_lock_of_the_interpreter_is_released(sphere):
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            stop.wait(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    before = counted[0]
    sphere.image(width=400, height=400)
    during = counted[0] - before
    stop.set()
    counter.join()
    assert during > 5


def test_databases_in_memory_stand_in_for_files(sphere):
    database = sphere.database()
    half = database.replaced({"materials.1.emissivity": 0.45})
    full = sphere.image().table["intensity"][0]
    assert sphere.with_database(half).image().table["intensity"][0] == pytest.approx(0.5 * full)
    assert sphere.database() == database
    assert sphere.with_database(half).database() == half


def test_projects_are_saved_and_pickled(sphere, tmp_path):
    changed = sphere.with_settings({"camera.range": 321})
    changed.save(tmp_path / "copy.smat")
    assert smat.Project(tmp_path / "copy.smat")["camera.range"] == 321.0
    half = changed.with_database(changed.database().replaced({"materials.1.emissivity": 0.45}))
    again = pickle.loads(pickle.dumps(half))
    assert again["camera.range"] == 321.0
    assert again.image().image == half.image().image


def test_results_are_pickled_and_read_back(sphere, tmp_path):
    for result in (sphere.image(), sphere.polar(step=90)):
        again = pickle.loads(pickle.dumps(result))
        assert (again.name, again.kind, again.is_complete) == (result.name, result.kind, True)
        assert again.image == result.image and again.table == result.table
        assert again.summary == result.summary and again.command == result.command
        name = tmp_path / ("result.exr" if result.image else "result.csv")
        again.save(name)
        assert smat.Result.load(name).kind == result.kind


def test_warnings_are_python_warnings(sphere):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = sphere.polar(step=90, fov=0.5)
    assert result.warnings and {one.filename for one in caught} == {__file__}
    assert {str(one.message) for one in caught} >= set(result.warnings)
    assert all(issubclass(one.category, smat.SmatWarning) for one in caught)


def test_processes_send_projects_and_results(sphere):
    script = (
        "import multiprocessing, pickle, sys, smat\n"
        "def polar(project): return project.polar(step=120).table\n"
        "if __name__ == '__main__':\n"
        "    project = pickle.load(open(sys.argv[1], 'rb'))\n"
        "    with multiprocessing.get_context('spawn').Pool(2) as pool:\n"
        "        tables = pool.map(polar, [project, project])\n"
        "    assert tables[0] == tables[1] == polar(project)\n"
    )
    run_script(script, pickle.dumps(sphere))


def run_script(script, state):
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        (place / "script.py").write_text(script)
        (place / "state.pickle").write_bytes(state)
        done = subprocess.run(
            [sys.executable, place / "script.py", place / "state.pickle"],
            capture_output=True,
            text=True,
            timeout=120,
        )
    assert done.returncode == 0, done.stderr
    return done.stdout
