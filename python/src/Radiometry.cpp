#include <limits>
#include <optional>
#include <string>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Spectrum.h"
#include "python/src/Bindings.h"

namespace smat::python {

namespace {

using irsg::Band;
using irsg::Spectrum;

double orNan(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

Spectrum spectrumOf(const Numbers& wavelengths_um, const Numbers& values,
                    const std::string& outside) {
    if (outside != "hold" && outside != "zero")
        throw badArgument("outside", outside, "'hold' or 'zero'");
    return Spectrum(vectorOf(wavelengths_um, "wavelengths_um"), vectorOf(values, "values"),
                    outside == "hold" ? Spectrum::Outside::hold : Spectrum::Outside::zero);
}

const char* outsideOf(const Spectrum& spectrum) {
    return spectrum.outside() == Spectrum::Outside::hold ? "hold" : "zero";
}

void addSpectrum(py::module_& module) {
    py::class_<Spectrum>(module, "Spectrum", R"(A function of wavelength, linear between its nodes.

Parameters
----------
wavelengths_um : array_like, shape (n,)
    Nodes, um; at least two, positive and ascending.
values : array_like, shape (n,)
    Finite values at the nodes.
outside : {'hold', 'zero'}
    Beyond the nodes: the value of the nearest end, or 0.

Raises
------
InputError
    For nodes that do not ascend, values that are not finite, lengths that differ.
)")
        .def(py::init(&spectrumOf), py::arg("wavelengths_um"), py::arg("values"),
             py::arg("outside") = "hold")
        .def_static("constant", &Spectrum::constant, py::arg("value"),
                    "A spectrum of one value at every wavelength.")
        .def_property_readonly("is_constant", &Spectrum::isConstant,
                               "Whether it has one value and no nodes.")
        .def_property_readonly(
            "wavelengths_um",
            [](const py::object& self) {
                return viewOf(self.cast<const Spectrum&>().wavelengths_um(), self);
            },
            "Nodes, um, shape (n,); empty for a constant spectrum. Read-only, not a copy.")
        .def_property_readonly(
            "values",
            [](const py::object& self) {
                return viewOf(self.cast<const Spectrum&>().values(), self);
            },
            "Values at the nodes, shape (n,); one for a constant spectrum. Read-only, not a copy.")
        .def_property_readonly("outside", &outsideOf,
                               "'hold' or 'zero': the value beyond the nodes.")
        .def("__call__", py::vectorize(&Spectrum::at), py::arg("wavelength_um"),
             "Values at wavelengths, um: a number for a number, an array of the same shape for an "
             "array.")
        .def("__len__", &Spectrum::size)
        .def("__eq__", [](const Spectrum& a, const Spectrum& b) { return a == b; })
        .def("__eq__", [](const Spectrum&, const py::object&) { return false; })
        .def("__repr__",
             [](const Spectrum& spectrum) {
                 if (spectrum.isConstant())
                     return "Spectrum.constant(" + irsg::numberText(spectrum.values()[0]) + ")";
                 return "Spectrum of " + std::to_string(spectrum.size()) + " nodes from " +
                        irsg::numberText(spectrum.wavelengths_um().front()) + " to " +
                        irsg::numberText(spectrum.wavelengths_um().back()) + " um";
             })
        .def(py::pickle(
            [](const Spectrum& spectrum) {
                return py::make_tuple(arrayOf(spectrum.wavelengths_um()),
                                      arrayOf(spectrum.values()), outsideOf(spectrum));
            },
            [](const py::tuple& state) {
                const auto values = state[1].cast<Numbers>();
                if (values.size() == 1)
                    return Spectrum::constant(values.at(0));
                return spectrumOf(state[0].cast<Numbers>(), values, state[2].cast<std::string>());
            }))
        .attr("__hash__") = py::none();
}

void addBand(py::module_& module) {
    py::class_<Band>(module, "Band", R"(The spectral response of a sensor between two wavelengths.

Parameters
----------
text : str
    '3-5', in um: a response of 1 from 3 um to 5 um.

Raises
------
InputError
    Unless 0 < minimum < maximum, both finite.
)")
        .def(py::init(&Band::fromText), py::arg("text"))
        .def_static("top_hat", &Band::topHat, py::arg("min_um"), py::arg("max_um"),
                    "A response of 1 from min_um to max_um, um.")
        .def_static("from_response", &Band::fromResponse, py::arg("response"),
                    py::arg("name") = "response",
                    "The response of a Spectrum: values of 0 and more, and 0 outside its nodes.")
        .def_static(
            "load",
            [](const std::filesystem::path& file) {
                return withoutLock([&] { return Band::fromCsv(file); });
            },
            py::arg("file"),
            R"(Read a response from a table of two columns (.csv), or a filter file of MODTRAN (.flt).

Raises
------
InputError
    With file, line and value, for what cannot be a response.
)")
        .def_property_readonly("name", &Band::name, "'3-5 um', or the name of its file.")
        .def_property_readonly(
            "range_um",
            [](const Band& band) {
                return py::make_tuple(band.range().min_um, band.range().max_um);
            },
            "Shortest and longest wavelength, um.")
        .def_property_readonly("is_top_hat", &Band::isTopHat, "Whether its response is 1.")
        .def_property_readonly("area_um", &Band::area_um, "Integral of the response, um.")
        .def("response", py::vectorize(&Band::responseAt), py::arg("wavelength_um"),
             "Response at wavelengths, um; 0 outside the band.")
        .def("radiance", py::vectorize([](const Band* band, double temperature_K) {
                 return irsg::bandRadiance_W_m2_sr(*band, temperature_K);
             }),
             py::arg("temperature_K"), R"(Radiance of a black body in the band, W m-2 sr-1.

The integral of Planck's law times the response, to 1e-9 relative.

Parameters
----------
temperature_K : float or array_like
    Temperatures, K; 0 and less give 0.

Returns
-------
float or numpy.ndarray
    Of the shape of `temperature_K`.
)")
        .def("apparent_temperature", py::vectorize([](const Band* band, double radiance) {
                 return orNan(irsg::apparentTemperature_K(*band, radiance));
             }),
             py::arg("radiance_W_m2_sr"),
             R"(Temperature, K, of the black body with that radiance in the band.

Parameters
----------
radiance_W_m2_sr : float or array_like
    Band radiances, W m-2 sr-1.

Returns
-------
float or numpy.ndarray
    1 K to 1e6 K; nan for a radiance that no such black body has.
)")
        .def("__eq__", [](const Band& a, const Band& b) { return a == b; })
        .def("__eq__", [](const Band&, const py::object&) { return false; })
        .def("__repr__", [](const Band& band) { return "Band(" + band.name() + ")"; })
        .def(py::pickle(
            [](const Band& band) {
                return py::make_tuple(band.isTopHat(), band.range().min_um, band.range().max_um,
                                      band.response(), band.name());
            },
            [](const py::tuple& state) {
                if (state[0].cast<bool>())
                    return Band::topHat(state[1].cast<double>(), state[2].cast<double>());
                return Band::fromResponse(state[3].cast<Spectrum>(), state[4].cast<std::string>());
            }))
        .attr("__hash__") = py::none();
}

} // namespace

void addRadiometry(py::module_& module) {
    addSpectrum(module);
    addBand(module);
    module.def("planck_radiance", py::vectorize(&irsg::planckRadiance_W_m2_sr_um),
               py::arg("wavelength_um"), py::arg("temperature_K"),
               R"(Spectral radiance of a black body, W m-2 sr-1 um-1.

Planck's law per unit wavelength, 2 h c^2 / lambda^5 / (exp(h c / lambda k T) - 1), with the
exact constants of the SI of 2019; relative error below 1e-12.

Parameters
----------
wavelength_um, temperature_K : float or array_like
    Wavelengths, um, and temperatures, K; shapes are broadcast. T <= 0 gives 0.

Returns
-------
float or numpy.ndarray
    Of the broadcast shape.
)");
    module.def("planck_derivative", py::vectorize(&irsg::planckDerivative_W_m2_sr_um_K),
               py::arg("wavelength_um"), py::arg("temperature_K"),
               "Derivative of planck_radiance with respect to temperature, W m-2 sr-1 um-1 K-1.");
    module.def(
        "brightness_temperature", py::vectorize([](double wavelength_um, double radiance) {
            return orNan(irsg::brightnessTemperature_K(wavelength_um, radiance));
        }),
        py::arg("wavelength_um"), py::arg("radiance_W_m2_sr_um"),
        "Temperature, K, of the black body with that spectral radiance, W m-2 sr-1 um-1; nan "
        "for a radiance that is not positive.");
}

} // namespace smat::python
