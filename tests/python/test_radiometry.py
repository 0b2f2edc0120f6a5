"""Planck's law, bands and spectra against closed forms and published numbers."""

import pickle

import numpy as np
import pytest

import smat


def test_radiance_over_all_wavelengths_is_that_of_stefan_and_boltzmann():
    sigma_W_m2_K4 = 5.670374419e-8  # CODATA 2018
    for temperature_K in (200.0, 300.0, 1500.0):
        total = smat.Band.top_hat(0.01, 5e5).radiance(temperature_K)
        assert total == pytest.approx(sigma_W_m2_K4 * temperature_K**4 / np.pi, rel=2e-8)


def test_peak_is_where_wien_has_it():
    wavelengths_um = np.linspace(9.0, 10.5, 15001)
    radiance = smat.planck_radiance(wavelengths_um, 300.0)
    assert wavelengths_um[radiance.argmax()] == pytest.approx(2897.771955 / 300.0, abs=1e-4)


def test_shapes_are_broadcast_and_numbers_stay_numbers():
    assert isinstance(smat.planck_radiance(4.0, 300.0), float)
    assert smat.planck_radiance(np.ones((3, 1)), np.full(4, 300.0)).shape == (3, 4)
    assert smat.Band("3-5").radiance([300.0, 310.0]).shape == (2,)


def test_temperatures_are_inverses():
    band = smat.Band("8-12")
    temperatures_K = np.array([200.0, 288.15, 900.0])
    np.testing.assert_allclose(
        band.apparent_temperature(band.radiance(temperatures_K)), temperatures_K, rtol=1e-8
    )
    assert smat.brightness_temperature(4.0, smat.planck_radiance(4.0, 321.0)) == pytest.approx(321.0)
    assert np.isnan(band.apparent_temperature(-1.0))
    assert np.isnan(smat.brightness_temperature(4.0, 0.0))


def test_derivative_is_the_slope():
    slope = (smat.planck_radiance(4.0, 300.001) - smat.planck_radiance(4.0, 299.999)) / 0.002
    assert smat.planck_derivative(4.0, 300.0) == pytest.approx(slope, rel=1e-8)


def test_spectrum_is_linear_between_its_nodes_and_its_arrays_are_no_copies():
    spectrum = smat.Spectrum([3.0, 4.0, 5.0], [0.0, 1.0, 0.0], "zero")
    np.testing.assert_allclose(spectrum([2.0, 3.5, 4.5, 6.0]), [0.0, 0.5, 0.5, 0.0])
    assert len(spectrum) == 3 and spectrum.outside == "zero" and not spectrum.is_constant
    assert spectrum.values.ctypes.data == spectrum.values.ctypes.data
    with pytest.raises(ValueError, match="read-only"):
        spectrum.values[0] = 1.0
    assert smat.Spectrum.constant(0.5)(7.0) == 0.5


def test_band_of_a_response(tmp_path):
    triangle = smat.Band.from_response(smat.Spectrum([3, 4, 5], [0, 1, 0]), "triangle")
    assert triangle.area_um == pytest.approx(1.0)
    assert (triangle.name, triangle.range_um, triangle.is_top_hat) == ("triangle", (3, 5), False)
    assert triangle.response(3.25) == pytest.approx(0.25)
    (tmp_path / "filter.csv").write_text("wavelength [um],response\n3,0\n4,1\n5,0\n")
    assert smat.Band.load(tmp_path / "filter.csv").area_um == pytest.approx(1.0)


@pytest.mark.parametrize(
    "make, value",
    [
        (lambda: smat.Band("5-3"), "5-3"),
        (lambda: smat.Band.top_hat(0.0, 3.0), "0"),
        (lambda: smat.Spectrum([3.0, 3.0], [1.0, 1.0]), "3"),
        (lambda: smat.Spectrum([3.0, 4.0], [1.0, np.nan]), "nan"),
        (lambda: smat.Spectrum([3.0, 4.0], [1.0, 1.0], "mirror"), "mirror"),
        (lambda: smat.Spectrum([[3.0, 4.0]], [1.0, 1.0]), "2 dimensions"),
        (lambda: smat.Band.from_response(smat.Spectrum([3.0, 4.0], [-1.0, 1.0])), "-1"),
    ],
)
def test_bad_values_are_input_errors(make, value):
    with pytest.raises(smat.InputError) as caught:
        make()
    assert value in str(caught.value)
    assert caught.value.diagnostics[0].expected


@pytest.mark.parametrize(
    "value",
    [
        smat.Band("3-5"),
        smat.Band.from_response(smat.Spectrum([3, 4, 5], [0, 1, 0]), "triangle"),
        smat.Spectrum([3, 4], [1, 2], "zero"),
        smat.Spectrum.constant(0.3),
    ],
)
def test_values_are_pickled(value):
    assert pickle.loads(pickle.dumps(value)) == value
    assert value != 3
