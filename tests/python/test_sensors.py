"""Sensors: numbers of the command line, pictures in counts, ranges of detection."""

import json
import pickle
import shlex

import numpy as np
import pytest

import smat


@pytest.fixture
def file(samples):
    return samples.parent / "resources" / "sensors" / "cooled-mwir.smatsensor"


@pytest.fixture
def sensor(file):
    return smat.SensorDescription(file)


def test_numbers_are_those_of_the_command_line(sensor, file, batch):
    theirs = json.loads(batch("sensor", "info", file, "--background-temperature", 290, "--json"))
    assert sensor.numbers(290.0) == theirs
    assert sensor.title == theirs["title"] and sensor.source == theirs["source"]
    assert sensor.shape == (512, 640)
    assert 1e6 * sensor.pixel_angle_rad == pytest.approx(theirs["pixel_angle_urad"], rel=1e-12)
    assert "snr_area" in sensor.numbers(290.0, temperature_difference_K=1.0)
    assert sensor.band.range_um == pytest.approx((3.7, 4.8))


def test_tables_are_those_of_the_command_line(sensor, file, batch, tmp_path):
    batch("sensor", "mtf", file, "--frequencies", "0,500,2000", "--direction", "vertical", "--out", tmp_path / "m.csv")
    batch("sensor", "mrtd", file, "--frequencies", "0,500,20000", "--eye-time", 0.1, "--out", tmp_path / "r.csv")
    theirs = smat.Table.load(tmp_path / "m.csv")
    ours = sensor.transfer([0, 500, 2000], direction="vertical")
    assert ours.keys() == theirs.keys() and np.array_equal(ours.to_numpy(), theirs.to_numpy())
    theirs = smat.Table.load(tmp_path / "r.csv")
    ours = sensor.resolvable_temperature([0, 500, 20000], eye_time_s=0.1)
    assert ours.keys() == theirs.keys() and np.array_equal(ours.to_numpy(), theirs.to_numpy(), equal_nan=True)
    assert ours["mrtd"][0] == 0 and np.isnan(ours["mrtd"][-1])
    batch("sensor", "range", file, "--extinctions", "0.2,1", "--target-size", 3, "--out", tmp_path / "n.csv")
    theirs = smat.Table.load(tmp_path / "n.csv")
    ours = sensor.nominal_ranges([0.2, 1], target_size_m=3)
    assert ours.keys() == theirs.keys() and np.array_equal(ours.to_numpy(), theirs.to_numpy())
    with pytest.raises(smat.InputError, match="horizontal"):
        sensor.transfer([0], direction="diagonal")


def test_a_uniform_picture_is_read_with_the_noise_of_the_numbers(sensor):
    level = sensor.band.radiance(300.0)
    read = sensor.read(np.full(sensor.shape, level), seed=3)
    again = sensor.read(np.full((1024, 1280), level), seed=3)
    assert read["counts"].shape == again["counts"].shape == (512, 640)
    numbers = sensor.numbers(300.0)
    per_K = sensor.band.radiance(300.5) - sensor.band.radiance(299.5)
    differences_K = (read["L"].astype(float) - level) / per_K
    alive = np.abs(differences_K) < 10 * numbers["netd_total_K"]  # bad pixels are 0 or full
    assert 0.99 < alive.mean() <= 1.0
    assert differences_K[alive].mean() == pytest.approx(0.0, abs=0.2 * numbers["netd_total_K"])
    assert differences_K[alive].std() == pytest.approx(numbers["netd_total_K"], rel=0.05)
    with pytest.raises(smat.InputError, match="512 x 640"):
        sensor.read(np.zeros((10, 10)))
    with pytest.raises(smat.InputError, match="512 x 640"):
        sensor.read(np.zeros(5))


def test_ranges_are_those_of_the_command_line(sensor, file, samples, batch, tmp_path):
    project = samples / "sphere" / "sphere.smat"
    batch("detection", project, "--sensor", file, "--step", 120, "--snr", 8, "--farthest", 1e7, "--out", tmp_path / "d.csv")
    theirs = smat.Table.load(tmp_path / "d.csv")
    asked = []
    result = smat.Project(project).detection(sensor, snr=8, step=120, farthest_m=1e7, progress=lambda now: asked.append(now.done))
    assert result.kind == "detection" and result.is_complete and asked[0] == 0
    assert np.array_equal(result.table.to_numpy(), theirs.to_numpy())
    assert dict(result.table.provenance)["analysis"] == "detection"
    again = pickle.loads(pickle.dumps(sensor))
    near = smat.Project(project).detection(
        again, criterion="johnson", cycles=2, probability=0.9, step=180, background_temperature_K=290
    )
    assert np.all(near.table["detection_range"] < result.table["detection_range"][0])
    assert near.table["probability"] == pytest.approx(0.9, abs=1e-4)
    batch(
        "detection", project, "--sensor", file, "--step", 180, "--false-alarms", 1e-5, "--probability", 90, "--farthest", 1e7,
        "--background-temperature", 290, "--clutter", 0.2, "--out", tmp_path / "p.csv",
    )
    likely = smat.Project(project).detection(
        sensor, false_alarms=1e-5, probability=0.9, clutter_K=0.2, step=180, farthest_m=1e7, background_temperature_K=290
    )
    assert np.array_equal(likely.table.to_numpy(), smat.Table.load(tmp_path / "p.csv").to_numpy())
    shown = smat.Project(project).detection(
        sensor, criterion="ttp", task="recognition", scene_contrast_K=20, step=180, background_temperature_K=290
    )
    assert shown.table["cycles"] == pytest.approx(14.5, abs=0.01)


def test_probabilities_and_sensitivities_are_those_of_the_command_line(sensor, file, samples, batch, tmp_path):
    project = samples / "sphere" / "sphere.smat"
    plain = {"step": 180, "background_temperature_K": 290}
    words = ("detection", project, "--sensor", file, "--step", 180, "--background-temperature", 290)
    batch(*words, "--ranges", "200000,900000", "--out", tmp_path / "p.csv")
    ours = smat.Project(project).detection(sensor, ranges_m=[2e5, 9e5], **plain)
    assert np.array_equal(ours.table.to_numpy(), smat.Table.load(tmp_path / "p.csv").to_numpy())
    assert ours.table["probability"][0] > ours.table["probability"][1]
    batch(*words, "--sensitivity", "--clutter", "auto", "--farthest", 1e7, "--range", 20000, "--out", tmp_path / "s.csv")
    ours = smat.Project(project).detection(sensor, sensitivity=True, clutter_K="auto", farthest_m=1e7, range=20000, **plain)
    assert np.array_equal(ours.table.to_numpy(), smat.Table.load(tmp_path / "s.csv").to_numpy())
    assert ours.table["sensitivity_threshold"] == pytest.approx(-0.5, abs=1e-3)


def test_directions_and_comparisons_are_those_of_the_command_line(sensor, file, samples, batch, tmp_path):
    box = samples / "box" / "box.smat"
    words = ("detection", box, "--sensor", file, "--background-temperature", 290)
    batch(*words, "--cases", "directions", "--set", "table.azimuthStep=90", "--set", "table.elevationStep=90",
          "--set", "table.elevationFrom=0", "--out", tmp_path / "t.csv")
    ours = smat.Project(box).detection(
        sensor, cases="directions", azimuth_step=90, elevation_step=90, elevation_from=0, background_temperature_K=290
    )
    assert np.array_equal(ours.table.to_numpy(), smat.Table.load(tmp_path / "t.csv").to_numpy())
    assert list(ours.table.keys())[:3] == ["azimuth", "elevation", "detection_range"]
    batch(*words, "--step", 180, "--against", "paint", "--paint", "black", "--values", "0.5,1", "--out", tmp_path / "a.csv")
    ours = smat.Project(box).detection(
        sensor, against="paint", paint="black", values=[0.5, 1], step=180, background_temperature_K=290
    )
    assert np.array_equal(ours.table.to_numpy(), smat.Table.load(tmp_path / "a.csv").to_numpy())
    assert ours.table["detection_range"][0] < ours.table["detection_range"][1]


def test_what_a_sensor_gives_is_refused_beside_it(file, samples):
    project = smat.Project(samples / "sphere" / "sphere.smat")
    with pytest.raises(smat.InputError, match="--band"):
        project.image(sensor=file, band="8-12")
    with pytest.raises(smat.InputError, match="--noise-seed"):
        project.image(noise_seed=3)


def test_the_command_of_a_detection_leaves_out_what_does_nothing_for_it(sensor, file, samples, batch, tmp_path):
    project = smat.Project(samples / "sphere" / "sphere.smat").with_settings(
        {"render.errors": "sum", "camera.range": 77, "sensor.band": "8-12", "polar.step": 180}
    )
    ours = project.detection(sensor, background_temperature_K=290)
    command = dict(ours.table.provenance)["command"]
    assert "--step" in command and not any(word in command for word in ("--errors", "--range ", "--band"))
    words = shlex.split(command.removeprefix("smat-batch "))
    batch(*words[:-1], tmp_path / "d.csv")
    assert np.array_equal(ours.table.to_numpy(), smat.Table.load(tmp_path / "d.csv").to_numpy())


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_a_radiance_that_is_no_number_is_refused_by_its_place(sensor, wrong):
    radiance = np.full(sensor.shape, 1.16)
    radiance[1, 3] = wrong
    with pytest.raises(smat.InputError, match="row 1, column 3"):
        sensor.read(radiance)


@pytest.mark.parametrize(
    "wrong, named",
    [({"snr": 0}, "snr"), ({"criterion": "luck"}, "johnson"), ({"point": "side"}, "corner"), ({"false_alarms": 0.5}, "false alarm"),
     ({"task": "guess", "criterion": "johnson"}, "recognition"), ({"probability": 1.0, "criterion": "johnson"}, "probability"),
     ({"nearest_m": 10, "farthest_m": 5}, "range"), ({"background_temperature_K": -1}, "background_temperature_K"),
     ({"cases": "all"}, "directions"), ({"values": [1]}, "values"), ({"against": "tide", "values": [1]}, "wind"),
     ({"against": "wind", "values": [5]}, "AtmosphereSmart"), ({"against": "paint", "values": [0.5]}, "paint"),
     ({"against": "hour", "values": [5], "sun_of": "today"}, "sun_of"), ({"against": "hour"}, "values"),
     ({"clutter_K": "much"}, "auto"), ({"draws": 3}, "ranges_m"), ({"ranges_m": [0.0]}, "ranges_m"),
     ({"ranges_m": [np.inf]}, "ranges_m"), ({"clutter_K": np.inf}, "clutter_K"), ({"draws": -1, "ranges_m": [1.0]}, "draws"),
     ({"criterion": "johnson", "clutter_K": 5.0}, "clutter_K"), ({"criterion": "johnson", "clutter_K": "auto"}, "clutter_K"),
     ({"criterion": "johnson", "snr": 5}, "snr"), ({"criterion": "johnson", "false_alarms": 1e-6}, "false_alarms"),
     ({"criterion": "johnson", "point": "corner"}, "point"), ({"criterion": "johnson", "scene_contrast_K": 5}, "scene_contrast_K"),
     ({"criterion": "johnson", "task": "recognition", "cycles": 3}, "task"),
     ({"task": "recognition"}, "task"), ({"cycles": 3}, "cycles"), ({"leave_out": ["black"]}, "leave_out"),
     ({"scene_contrast_K": 5}, "scene_contrast_K"), ({"snr": 5, "false_alarms": 1e-6}, "false_alarms"),
     ({"ranges_m": [1.0], "nearest_m": 10}, "nearest_m"), ({"ranges_m": [1.0], "probability": 0.9}, "probability"),
     ({"band": "8-12"}, "band"), ({"range": 77}, "range"), ({"settings": {"render.errors": "sum"}}, "errors")],
)
def test_wrong_questions_are_refused_by_name(sensor, samples, wrong, named):
    with pytest.raises(smat.InputError, match=named):
        smat.Project(samples / "sphere" / "sphere.smat").detection(sensor, step=180, **wrong)
