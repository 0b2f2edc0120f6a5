"""Images, tables, atmospheres, signatures, models and scenes."""

import copy
import inspect
import json
import os
import pickle
import resource
import subprocess
import sys

import numpy as np
import pytest

import smat


def test_everything_public_has_a_docstring():
    missing = []
    for name in smat.__all__:
        thing = getattr(smat, name)
        if name == "__version__":
            continue
        if not (thing.__doc__ or "").strip():
            missing.append(name)
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_") and not (getattr(value, "__doc__", "") or "").strip():
                    missing.append(f"{name}.{member}")
    assert missing == []


def test_import_opens_no_renderer_and_needs_numpy_alone():
    script = (
        "import sys, smat\n"
        "assert not {'pandas', 'xarray', 'matplotlib'} & set(sys.modules)\n"
        "assert 'swrast' not in open('/proc/self/maps').read()\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True, timeout=60)


def test_images_are_made_read_and_written(tmp_path):
    values = np.arange(12, dtype=np.float32).reshape(3, 4)
    image = smat.Image({"L": values, "alpha": values > 5}, {"L": "W m-2 sr-1"}, {"band": "3-5"})
    assert image.shape == (3, 4) and (image.width_px, image.height_px) == (4, 3)
    assert image.planes == ["L", "alpha"] and image.units["L"] == "W m-2 sr-1"
    assert image.attributes == {"band": "3-5"}
    np.testing.assert_array_equal(np.asarray(image), values)
    assert np.asarray(image).base is not None
    assert np.array(image, dtype=float).dtype == float
    image.save(tmp_path / "image.exr")
    assert smat.Image.load(tmp_path / "image.exr")["L"].tobytes() == values.tobytes()
    assert pickle.loads(pickle.dumps(image)) == image
    assert image.statistics()["mean"] == pytest.approx(5.5)
    assert image.statistics("alpha")["maximum"] == 1.0
    assert image.contrast_intensity() is None
    assert image != smat.Image({"L": values})


def test_arrays_outlive_their_image():
    plane = smat.Image({"L": np.full((400, 500), 7.0)})["L"]
    junk = [np.zeros((400, 500), np.float32) for _ in range(20)]
    assert plane.min() == plane.max() == 7.0 and len(junk) == 20


def test_pictures_are_png_files_that_others_read(tmp_path):
    image = smat.Image({"L": np.linspace(0, 1, 64).reshape(8, 8)})
    plain = image.picture(color_map="black-hot", color_bar=False, limits=(0.0, 1.0))
    assert plain.shape == (8, 8, 3) and plain[0, 0].tolist() == [255] * 3
    data = image._repr_png_()
    pillow = pytest.importorskip("PIL.Image")
    (tmp_path / "picture.png").write_bytes(data)
    with pillow.open(tmp_path / "picture.png") as read:
        np.testing.assert_array_equal(np.asarray(read), image.picture())


def test_a_saved_picture_has_the_colours_that_the_program_exports(tmp_path):
    # A tenth of the picture glows; linear from least to largest leaves one colour for the rest.
    values = np.tile(np.linspace(1.0, 1.1, 64), (64, 1))
    values[:6] = 50.0
    plain = smat.Image({"L": values})
    pillow = pytest.importorskip("PIL.Image")

    def saved(image):
        image.save(tmp_path / "picture.png")
        with pillow.open(tmp_path / "picture.png") as read:
            return np.asarray(read)

    picture = plain.picture(color_bar=False)
    assert len(np.unique(picture[6:].reshape(-1, 3), axis=0)) > 32
    np.testing.assert_array_equal(saved(plain), plain.picture())
    told = smat.Image(
        {"L": values},
        attributes={
            "display.colorMap": "ironbow",
            "display.minimum": "1",
            "display.maximum": "1.2",
            "display.scale": "linear",
        },
    )
    np.testing.assert_array_equal(
        told.picture(), plain.picture(color_map="ironbow", limits=(1.0, 1.2))
    )
    np.testing.assert_array_equal(saved(told), told.picture())


@pytest.mark.parametrize(
    "act, words",
    [
        (lambda: smat.Image({}), "plane"),
        (lambda: smat.Image({"L": np.zeros(3)}), "1 dimensions"),
        (lambda: smat.Image({"L": np.zeros((2, 2)), "M": np.zeros((2, 3))}), "3 x 2"),
        (lambda: smat.Image({"L": np.zeros((2, 2))})["M"], "M"),
        (lambda: smat.Image({"L": np.zeros((2, 2))}).picture(color_map="jet"), "jet"),
        (lambda: smat.Image.load("missing.exr"), "missing.exr"),
        (lambda: smat.Table.load("missing.csv"), "missing.csv"),
        (lambda: smat.Model("missing.flt"), "missing.flt"),
        (lambda: smat.Environment("missing.xml"), "missing.xml"),
        (lambda: smat.Environment(sun_elevation_deg=91), "91"),
        (lambda: smat.SignatureDatabase("{}"), "JSON"),
        (lambda: smat.SignatureDatabase.load("missing.sigdb"), "missing.sigdb"),
        (lambda: smat.Scenario("missing.json"), "missing.json"),
        (lambda: smat.Sensor(width_px=0), "0"),
        (lambda: smat.Scene([], settings={"camera.range": 3}), "camera.range"),
        (lambda: smat.find_setting("sensor.widht"), "sensor.width"),
        (lambda: smat.set_threads(-1), "-1"),
    ],
)
def test_bad_input_is_an_input_error(act, words):
    with pytest.raises(smat.InputError) as caught:
        act()
    assert words in str(caught.value)


def test_tables_are_dicts_of_arrays(sphere, tmp_path):
    table = sphere.polar(step=90).table
    assert table.rows == 4 and len(table) == len(table.keys()) == len(table.values())
    assert list(table) == table.keys() and "angle" in table and "nothing" not in table
    assert table.units["angle"] == "deg"
    with pytest.raises(KeyError):
        table["nothing"]
    with pytest.raises(ValueError, match="read-only"):
        table["angle"][0] = 1.0
    np.testing.assert_array_equal(table.to_numpy(), np.stack(table.values(), axis=1))
    for name in ("table.csv", "table.json"):
        table.save(tmp_path / name)
        assert smat.Table.load(tmp_path / name) == table
    assert dict(table.provenance)["analysis"] == "polar"
    assert json.loads(table.to_json())


def test_tables_go_to_pandas_and_xarray(sphere):
    pytest.importorskip("xarray")
    table = sphere.table(azimuth_step=90, elevation_step=90).table
    data = table.to_xarray()
    assert data["intensity"].dims == ("elevation", "azimuth")
    assert data["intensity"].attrs["units"] == "W sr-1"
    row = int(np.flatnonzero((table["azimuth"] == 180) & (table["elevation"] == 0))[0])
    assert data["intensity"].sel(azimuth=180, elevation=0) == table["intensity"][row]
    assert sphere.polar(step=90).table.to_xarray()["intensity"].dims == ("angle",)
    frame = table.to_pandas()
    assert list(frame) == table.keys() and frame.attrs["units"]["range"] == "m"


def test_homogeneous_air_follows_the_law_of_beer_and_lambert(tmp_path):
    (tmp_path / "haze.csv").write_text("wavelength [um],extinction [km-1]\n2,0.5\n6,0.5\n")
    air = smat.Environment(tmp_path / "haze.csv", sun_elevation_deg=10)
    spectra = air.spectra(
        ["transmittance"], band=smat.Band("3-5"), sensor_altitude_m=0, target_altitude_m=0, range_m=2000
    )
    np.testing.assert_allclose(spectra["transmittance"], np.exp(-1.0), rtol=1e-12)
    assert (np.diff(spectra["wavenumber"]) > 0).all()
    again = pickle.loads(pickle.dumps(air))
    assert again.names == air.names
    with pytest.raises(smat.InputError, match="did you mean 'transmittance'"):
        air.spectra(["transmitance"], band=smat.Band("3-5"), range_m=1, sensor_altitude_m=0)


def test_computed_air_has_a_temperature(samples):
    air = smat.Environment(samples.parent / "resources/atmospheres/temperate-maritime.xml")
    profile = air.temperature_profile(0, 2000, 1000)
    assert profile["altitude"].tolist() == [0.0, 1000.0, 2000.0]
    assert air.ambient_temperature(1000.0) == profile["temperature"][1]
    assert (np.diff(profile["temperature"]) < 0).all()


def test_signature_databases_are_edited_linted_and_saved(samples, tmp_path):
    database = smat.SignatureDatabase.load(samples / "sphere" / "sphere.sigdb")
    assert database.material_names == {1: "grey 0.9"} and database.temperature_names[1] == "sphere"
    assert database.title == "sphere" and database["materials.1.emissivity"] == 0.9
    assert database.lint(smat.Band("3-5"), smat.Model(samples / "sphere" / "sphere.flt")) == []
    painted = database.replaced({"materials.1.emissivity": smat.Spectrum([3, 5], [0.7, 0.8])})
    assert painted["materials.1.emissivity"] == [[3, 0.7], [5, 0.8]] != 0.9
    assert database["materials.1.emissivity"] == 0.9
    for name in ("painted.sigdb", "painted.json"):
        painted.save(tmp_path / name)
        assert smat.SignatureDatabase.load(tmp_path / name) == painted
    assert pickle.loads(pickle.dumps(painted)) == painted
    assert smat.SignatureDatabase(json.dumps(painted.to_dict())) == painted
    assert json.loads(painted.to_json()) == painted.to_dict()


def test_lint_finds_and_repairs(samples, tmp_path):
    database = smat.SignatureDatabase.load(samples / "sphere" / "sphere.sigdb")
    percent = database.replaced({"materials.1.emissivity": 90.0})
    (finding,) = [one for one in percent.lint() if one.severity == "error"]
    assert finding.entry == "materials.1" and "emissivity" in finding.place
    assert finding.value and finding.reason and finding.remedy and finding.is_repairable
    repaired, done = percent.repaired()
    assert repaired == database and done[0].place == finding.place
    with pytest.raises(smat.InputError, match="emissivity"):
        percent.save(tmp_path / "wrong.sigdb")
    for path in ("materials.7.emissivity", "nothing"):
        with pytest.raises(KeyError):
            database[path]
    with pytest.raises(KeyError):
        database.replaced({"materials.7.emissivity": 0.5})
    with pytest.raises(smat.InputError, match="emissivitty"):
        database.replaced({"materials.1.emissivitty": 0.5})


def test_models_show_their_triangles(samples):
    model = smat.Model(samples / "box" / "box.flt")
    assert model.facets == sum(len(part.triangles) for part in model.parts) == 12
    low, high = model.bounds_m
    areas = 0.0
    for part in model.parts:
        corners = part.vertices_m[part.triangles]
        cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert np.linalg.norm(cross, axis=1).sum() / 2 == pytest.approx(part.area_m2, rel=1e-6)
        np.testing.assert_allclose(np.linalg.norm(part.normals, axis=1), 1.0, rtol=1e-5)
        assert (part.vertices_m >= low - 1e-5).all() and (part.vertices_m <= high + 1e-5).all()
        assert part.temperature_index >= 0 and part.material_index >= 0
        areas += part.area_m2
    x, y, z = high - low
    assert areas == pytest.approx(2 * (x * y + y * z + z * x), rel=1e-6)
    assert isinstance(model.remarks, list) and os.fspath(model.file).endswith("box.flt")
    double = smat.Model(samples / "box" / "box.flt", unit_m=2.0 * (high[0] - low[0]) / x)
    assert double.facets == 12 and pickle.loads(pickle.dumps(model)).facets == 12


@pytest.fixture(scope="module")
def scene(samples):
    entity = smat.Entity(
        smat.Model(samples / "sphere" / "sphere.flt"),
        smat.SignatureDatabase.load(samples / "sphere" / "sphere.sigdb"),
        name="ball",
    )
    settings = {"render.sun": "off", "render.ambientReflection": "off"}
    return smat.Scene([entity], settings=settings)


@pytest.fixture(scope="module")
def view():
    return smat.SensorView(
        smat.Sensor(65, 65, 0.004, smat.Band("3-5")),
        smat.Viewpoint.about((0, 0, 0), azimuth_rad=0.524, elevation_rad=0.0, range_m=1000.0),
    )


def test_render_gives_the_closed_form_in_the_renderers_memory(scene, view):
    rendered = smat.render(scene, view, smat.Outputs.image_with_reports(errors=True))
    assert rendered.image["L"][32, 32] == pytest.approx(3.32525, rel=1e-5)
    first, second = rendered.image["L"], rendered.image["L"]
    assert first.ctypes.data == second.ctypes.data and not first.flags.owndata
    report = rendered.reports[0]
    (ball,) = report.objects
    expected = 0.9 * smat.Band("3-5").radiance(320.0) * np.pi
    assert ball.name == "ball" and ball.intensity_W_sr == pytest.approx(expected, rel=2e-3)
    assert report.all.contrast_intensity_W_sr == ball.contrast_intensity_W_sr
    assert ball.irradiance_W_m2 == pytest.approx(ball.intensity_W_sr / 1e6, rel=1e-3)
    assert 0 < ball.error_intensity_W_sr < 0.02 * ball.intensity_W_sr
    assert ball.error_contrast_intensity_W_sr > 0 and ball.range_m == pytest.approx(1000.0)
    assert ball.solid_angle_sr == pytest.approx(np.pi / 1e6, rel=5e-3) and ball.covered_pixels > 100
    assert report.background_W_m2_sr == 0 and report.total_irradiance_W_m2 > 0
    assert report.renderer and report.provided_by and report.warnings == []
    assert rendered.spectrum is None


def test_reports_and_spectra_without_an_image(scene, view):
    bands = [smat.Band("3-5"), smat.Band("8-12")]
    rendered = smat.render(scene, view, smat.Outputs.reports(bands))
    assert rendered.image is None and len(rendered.reports) == 2
    assert rendered.reports[0].all.error_intensity_W_sr is None
    wavenumbers_per_cm = np.array([1000.0, 2000.0, 2500.0])
    spectrum = smat.render(scene, view, smat.Outputs.spectrum(wavenumbers_per_cm)).spectrum
    ratio = spectrum["spectral_intensity"] / smat.planck_radiance(1e4 / wavenumbers_per_cm, 320.0)
    np.testing.assert_allclose(ratio, 0.9 * np.pi, rtol=2e-3)


def test_renderers_check_and_describe(scene, view):
    renderer = smat.Renderer()
    renderer.check(scene, view)
    assert renderer.description(scene)
    assert renderer.render(scene, view).image == smat.render(scene, view, smat.Outputs.image()).image
    assert scene.entities == ["ball"]
    assert view.sensor.width_px == view.sensor.height_px == 65
    assert view.sensor.band == smat.Band("3-5")
    assert view.sensor.horizontal_field_of_view_rad == 0.004
    again = pickle.loads(pickle.dumps(view))
    assert again.sensor == view.sensor and again.viewpoint.position_m == view.viewpoint.position_m
    assert np.dot(again.viewpoint.forward, again.viewpoint.up) == pytest.approx(0.0, abs=1e-12)
    below = smat.SensorView(view.sensor, smat.Viewpoint.look_at((0, 100, -50), (0, 0, 0)))
    with pytest.raises(smat.InputError, match="ground|altitude"):
        renderer.check(scene, below)


def test_reference_point_is_the_centre(samples):
    database = smat.SignatureDatabase.load(samples / "sphere" / "sphere.sigdb")
    entity = smat.Entity(smat.Model(samples / "sphere" / "sphere.flt"), database)
    np.testing.assert_allclose(smat.Renderer().reference_point(entity), 0.0, atol=1e-3)
    assert entity.name == "sphere"


def test_projects_give_their_scene_and_view(sphere):
    scene, view = sphere.view()
    assert smat.render(scene, view).image["L"].tobytes() == sphere.image().image["L"].tobytes()
    assert sphere.model().facets > 100 and copy.copy(sphere).title == sphere.title == "Sphere"
    assert sphere.models == ["sphere"] and sphere.notes and sphere.file.endswith("sphere.smat")


def test_memory_stays_flat_over_renders(scene, view):
    renderer = smat.Renderer()

    def grown_B(renders):
        before = resident_B()
        for _ in range(renders):
            renderer.render(scene, view, smat.Outputs.image_with_reports()).image["L"]
        return resident_B() - before

    grown_B(60)
    assert grown_B(150) < 4e6


def resident_B():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def test_monte_carlo_has_the_numbers_of_the_command_line(samples, batch, tmp_path):
    file = samples / "turboprop4" / "turboprop4.smat"
    quick = {"sensor.width": 24, "sensor.height": 24, "camera.range": 20000, "render.bounces": 0,
             "environment.atmospheres": "none", "range.points": 2, "scaling.seed": 7}
    options = [word for key, value in quick.items() for word in ("--set", f"{key}={value}")]
    batch("montecarlo", file, "--kind", "range", "--samples", 64, "--subpixel-shifts", 1,
          *options, "--out", tmp_path / "batch.csv")
    theirs = smat.Table.load(tmp_path / "batch.csv")
    seen = []
    ours = smat.Project(file).monte_carlo(
        "range", samples=64, subpixel_shifts=1, settings=quick, progress=seen.append
    )
    for key, column in theirs.items():
        assert ours.table[key].tobytes() == column.tobytes(), key
    assert ours.values.shape == (2, 64) and ours.is_complete and ours.seed == 7 and seen
    np.testing.assert_allclose(ours.values.mean(axis=1), ours.table["mean"])
    np.testing.assert_array_equal(ours.abscissae, ours.table["range"])
    assert ours.unit == "W sr-1" and ours.scales and isinstance(ours.warnings, list)
    with pytest.raises(smat.InputError, match="plain"):
        smat.Project(file).monte_carlo("range", sequence="halton")


def test_scenarios_are_simulated_as_from_the_command_line(samples, batch, tmp_path):
    file = samples / "flyby" / "flyby.json"
    scenario = smat.Scenario(file)
    assert scenario.sensors and scenario.entities and scenario.times_s.size > 2
    quick = {"sensor.width": 16, "sensor.height": 12, "render.bounces": 0}
    options = [word for key, value in quick.items() for word in ("--set", f"{key}={value}")]
    name, to_s = scenario.sensors[0], float(scenario.times_s[0])
    batch("simulate", file, "--sensor", name, "--to", to_s, *options, "--out", tmp_path / "batch")
    (ours,) = scenario.simulate(tmp_path / "python", sensors=[name], to_s=to_s, settings=quick)
    assert ours.name == name and ours.frames >= 1 and ours.frames_missing == 0
    assert isinstance(ours.warnings, list) and ours.table.rows == 1
    frames = sorted((tmp_path / "batch" / name).glob("*.exr"))
    assert len(frames) == ours.frames
    for frame in frames:
        same = smat.Image.load(os.path.join(ours.folder, frame.name))
        assert same["L"].tobytes() == smat.Image.load(frame)["L"].tobytes()
    with pytest.raises(smat.InputError, match="camera.range"):
        scenario.simulate(tmp_path / "no", settings={"camera.range": 3})
