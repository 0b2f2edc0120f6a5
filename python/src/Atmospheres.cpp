#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Units.h"
#include "python/src/Environments.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/tools/RadiativeOutput.h"
#include "smatcore/tools/TemperatureProfile.h"

namespace smat::python {

namespace {

namespace fs = std::filesystem;

NamedEnvironment environmentOf(const std::vector<fs::path>& inputs, std::optional<int> bins_per_cm,
                               const SunAngles& sun) {
    NamedEnvironment made{.inputs = inputs, .bins_per_cm = bins_per_cm, .sun = sun};
    const std::optional<irsg::SunPosition> ofFile = addAtmosphere(
        made.environment, inputs.empty() ? std::vector<fs::path>{"vacuum"} : inputs, bins_per_cm);
    irsg::SunPosition& place = made.environment.sun;
    place = ofFile.value_or(irsg::SunPosition{irsg::radians(180.0), irsg::radians(45.0)});
    if (sun.azimuth_deg)
        place.azimuth_rad = irsg::radians(*sun.azimuth_deg);
    if (sun.elevation_deg)
        place.elevation_rad = irsg::radians(*sun.elevation_deg);
    return made;
}

void checkSun(const SunAngles& sun) {
    std::vector<irsg::Diagnostic> wrong;
    const auto check = [&](const char* name, const std::optional<double>& value, double least,
                           double most) {
        if (value && !(*value >= least && *value <= most))
            wrong.push_back({name, "", irsg::numberText(*value),
                             "a number from " + irsg::numberText(least) + " to " +
                                 irsg::numberText(most) + " deg"});
    };
    check("sun_azimuth_deg", sun.azimuth_deg, 0.0, 360.0);
    check("sun_elevation_deg", sun.elevation_deg, -90.0, 90.0);
    if (!wrong.empty())
        throw irsg::InputError(std::move(wrong));
}

std::vector<irsg::AtmosphereProperty> propertiesOf(const std::vector<std::string>& words) {
    std::vector<irsg::AtmosphereProperty> properties;
    std::vector<std::string> known;
    for (const RadiativeQuantity& quantity : radiativeQuantities())
        known.emplace_back(quantity.word);
    for (const std::string& word : words) {
        const auto found = std::ranges::find(radiativeQuantities(), word, &RadiativeQuantity::word);
        if (found == radiativeQuantities().end())
            throw badArgument("quantities", word, oneOf(known, word));
        if (std::ranges::find(properties, found->property) == properties.end())
            properties.push_back(found->property);
    }
    return properties;
}

std::shared_ptr<ResultTable> spectraOf(const NamedEnvironment& self,
                                       const std::vector<std::string>& quantities,
                                       const irsg::Band& band, const PathGeometryInput& geometry) {
    RadiativeRequest request;
    request.geometry = geometry;
    request.band = band.range();
    request.leaveOutMissing = quantities.empty();
    if (quantities.empty())
        for (const RadiativeQuantity& known : radiativeQuantities())
            request.quantities.push_back(known.property);
    else
        request.quantities = propertiesOf(quantities);
    RadiativeOutput output =
        withoutLock([&] { return radiativeOutput(self.environment, request); });
    warnOf(output.warnings);
    return std::make_shared<ResultTable>(std::move(output.table));
}

} // namespace

void addAtmospheres(py::module_& module) {
    py::class_<NamedEnvironment>(module, "Environment", R"(The air and the sun around a scene.

Parameters
----------
*atmospheres : str or os.PathLike
    Files, in order: the first that has a quantity in a band provides it. AtmosphereSmart and
    Environment files of KARMA (XML), .smatatm, MODTRAN output, spectra and homogeneous air (CSV);
    'vacuum', which is also what no file means.
bins_per_cm : int, optional
    1, 5 or 15: spectral bins of computed atmospheres, cm-1, in place of their own.
sun_azimuth_deg, sun_elevation_deg : float, optional
    Where the sun stands, east of north and above the horizon, deg; without, as an Environment file
    says, else 180 and 45.

Raises
------
InputError
    For files that cannot be read, each with what is wrong.
)")
        // Behind *args pybind11 converts no arguments, not even whole numbers to double.
        .def(py::init([](const py::args& atmospheres, std::optional<int> bins_per_cm,
                         const py::object& sunAzimuth_deg, const py::object& sunElevation_deg) {
                 const SunAngles sun{sunAzimuth_deg.cast<std::optional<double>>(),
                                     sunElevation_deg.cast<std::optional<double>>()};
                 checkSun(sun);
                 const auto inputs = atmospheres.cast<std::vector<fs::path>>();
                 return withoutLock([&] { return environmentOf(inputs, bins_per_cm, sun); });
             }),
             py::kw_only(), py::arg("bins_per_cm") = py::none(),
             py::arg("sun_azimuth_deg") = py::none(), py::arg("sun_elevation_deg") = py::none())
        .def_property_readonly(
            "names",
            [](const NamedEnvironment& self) {
                std::vector<std::string> names;
                for (const auto& atmosphere : self.environment.atmospheres())
                    names.push_back(atmosphere->name());
                return names;
            },
            "What the atmospheres call themselves, in order.")
        .def(
            "spectra",
            [](const NamedEnvironment& self, const std::vector<std::string>& quantities,
               const irsg::Band& band, std::optional<double> sensorAltitude_m,
               std::optional<double> targetAltitude_m, std::optional<double> range_m,
               std::optional<double> elevation_deg, double azimuth_deg, bool toSpace) {
                return spectraOf(self, quantities, band,
                                 {.sensorAltitude_m = sensorAltitude_m,
                                  .losElevation_deg = elevation_deg,
                                  .losAzimuth_deg = azimuth_deg,
                                  .targetAltitude_m = targetAltitude_m,
                                  .range_m = range_m,
                                  .toSpace = toSpace});
            },
            py::arg("quantities"), py::kw_only(), py::arg("band"),
            py::arg("sensor_altitude_m") = py::none(), py::arg("target_altitude_m") = py::none(),
            py::arg("range_m") = py::none(), py::arg("elevation_deg") = py::none(),
            py::arg("azimuth_deg") = 0.0, py::arg("to_space") = false,
            R"(Spectra of the air along one line of sight.

Parameters
----------
quantities : list of str
    Of 'transmittance', 'path' (radiance), 'background', 'sun' (irradiance), 'up', 'down' (diffuse
    fluxes), 'scattering' (optical depth); empty for all that there are.
band : Band
    The range of wavelengths.
sensor_altitude_m, target_altitude_m : float
    Above the ground, m, 0 and more.
range_m : float
    From sensor to target, m.
elevation_deg, azimuth_deg : float
    Of the line of sight at the sensor, up positive and east of north, deg.
to_space : bool
    A path to 100 km in place of a target.

Returns
-------
Table
    Columns wavenumber (cm-1, ascending), wavelength (um) and one for each quantity, with the
    geometry and the providing atmosphere in the provenance.

Raises
------
InputError
    For a geometry that contradicts itself or says too little for a quantity, and for a quantity
    that no atmosphere has in the band.
)")
        .def(
            "ambient_temperature",
            [](const NamedEnvironment& self, double altitude_m) {
                return withoutLock(
                    [&] { return self.environment.ambientTemperature_K(altitude_m).value; });
            },
            py::arg("altitude_m"), "Temperature of the air at an altitude, m, in K.")
        .def(
            "temperature_profile",
            [](const NamedEnvironment& self, double min_m, double max_m, double step_m) {
                return withoutLock([&] {
                    return std::make_shared<ResultTable>(
                        temperatureProfile(self.environment, {min_m, max_m, step_m}));
                });
            },
            py::arg("min_m") = 0.0, py::arg("max_m") = 30e3, py::arg("step_m") = 100.0,
            R"(Temperature of the air over altitude.

Returns
-------
Table
    Columns altitude (m) and temperature (K).

Raises
------
InputError
    For altitudes that do not ascend, and for air without temperature.
)")
        .def("__repr__",
             [](const py::object& self) {
                 return "Environment of " +
                        py::str(", ").attr("join")(self.attr("names")).cast<std::string>();
             })
        .def(py::pickle(
            [](const NamedEnvironment& self) {
                std::vector<std::string> inputs;
                for (const fs::path& input : self.inputs)
                    inputs.push_back(isNoAtmosphere(input) ? input.string()
                                                           : fs::absolute(input).string());
                return py::make_tuple(inputs, self.bins_per_cm, self.sun.azimuth_deg,
                                      self.sun.elevation_deg);
            },
            [](const py::tuple& state) {
                return environmentOf(state[0].cast<std::vector<fs::path>>(),
                                     state[1].cast<std::optional<int>>(),
                                     {state[2].cast<std::optional<double>>(),
                                      state[3].cast<std::optional<double>>()});
            }));
}

} // namespace smat::python
