#include "smatcore/tools/RadiativeOutput.h"

#include <cmath>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using irsg::AtmosphereProperty;
using irsg::Spectrum;
using testing::HasSubstr;

constexpr irsg::SpectralRange band{3.0, 5.0};
const PathGeometryInput slant = {
    .sensorAltitude_m = 2000.0, .losElevation_deg = -20.0, .range_m = 1000.0};

irsg::Environment haze() {
    irsg::BeerLambertParameters air;
    air.name = "haze";
    air.extinction_per_m = Spectrum({2.0, 4.2, 6.0}, {1e-4, 4e-4, 0.0});
    air.airTemperature_K = 280.0;
    air.groundTemperature_K = 300.0;
    air.solarIrradiance_W_m2_um = irsg::extraterrestrialSolarIrradiance({2.0, 6.0});
    air.downwardFlux_W_m2_um = Spectrum({2.0, 6.0}, {0.1, 0.4});
    air.upwardFlux_W_m2_um = Spectrum::constant(2.0);
    irsg::Environment environment;
    environment.add(std::make_shared<irsg::BeerLambert>(air));
    environment.sun = {irsg::radians(120.0), irsg::radians(30.0)};
    return environment;
}

RadiativeRequest everything() {
    RadiativeRequest request;
    for (const RadiativeQuantity& known : radiativeQuantities()) {
        request.quantities.push_back(known.property);
    }
    request.geometry = slant;
    request.band = band;
    return request;
}

double summaryOf(const RadiativeOutput& output, const std::string& label) {
    for (const SummaryItem& item : output.summary) {
        if (item.label == label) {
            return item.value;
        }
    }
    ADD_FAILURE() << "no " << label;
    return NAN;
}

TEST(RadiativeOutput, TransmittanceAndPathRadianceAreTheirClosedForms) {
    const RadiativeOutput output = radiativeOutput(haze(), everything());
    const auto& axis = output.table.find("wavelength")->values;
    const auto& transmittance = output.table.find("transmittance")->values;
    const auto& radiance = output.table.find("path_radiance")->values;
    for (std::size_t i = 0; i < axis.size(); ++i) {
        const double depth = 1000.0 * (axis[i] < 4.2 ? 1e-4 + 3e-4 * (axis[i] - 2.0) / 2.2
                                                     : 4e-4 * (6.0 - axis[i]) / 1.8);
        EXPECT_NEAR(transmittance[i], std::exp(-depth), 2e-5);
        const double black = irsg::planckRadiance_W_m2_sr_um(axis[i], 280.0);
        EXPECT_NEAR(radiance[i], -std::expm1(-depth) * black, 2e-5 * black);
    }
}

TEST(RadiativeOutput, HasTheColumnsOfTheFormatsPageInAscendingWavenumbers) {
    const ResultTable table = radiativeOutput(haze(), everything()).table;
    std::vector<std::string> headers;
    for (const ResultColumn& column : table.columns()) {
        headers.push_back(column.header());
    }
    EXPECT_THAT(headers,
                testing::ElementsAre("wavenumber [cm-1]", "wavelength [um]", "transmittance",
                                     "path_radiance [W m-2 sr-1 um-1]",
                                     "background_radiance [W m-2 sr-1 um-1]",
                                     "solar_irradiance [W m-2 um-1]", "up_flux [W m-2 um-1]",
                                     "down_flux [W m-2 um-1]", "scattering_optical_depth"));
    const auto& wavenumbers = table.find("wavenumber")->values;
    EXPECT_TRUE(std::ranges::is_sorted(wavenumbers));
    EXPECT_NEAR(wavenumbers.front(), 2000.0, 1e-9);
    EXPECT_NEAR(wavenumbers.back(), 1e4 / 3.0, 1e-9);
}

TEST(RadiativeOutput, SumsTheBandUpInSummaryAndProvenance) {
    const RadiativeOutput output = radiativeOutput(haze(), everything());
    EXPECT_NEAR(summaryOf(output, "in_band_up_flux"), 4.0, 1e-12);
    EXPECT_NEAR(summaryOf(output, "in_band_down_flux"), 0.5, 1e-12);
    EXPECT_EQ(summaryOf(output, "band_mean_scattering_optical_depth"), 0.0);
    EXPECT_EQ(summaryOf(output, "ambient_temperature"), 280.0);
    const double mean = summaryOf(output, "band_mean_transmittance");
    EXPECT_GT(mean, std::exp(-0.4));
    EXPECT_LT(mean, std::exp(-0.2));
    const Provenance& provenance = output.table.provenance;
    EXPECT_EQ(provenance.value("analysis"), "radiative");
    EXPECT_EQ(provenance.value("atmosphere"), "haze");
    EXPECT_EQ(provenance.value("band"), "3-5 um");
    EXPECT_EQ(provenance.value("los_elevation [deg]"), "-20");
    EXPECT_EQ(provenance.value("sun_azimuth [deg]"), "120");
    EXPECT_EQ(provenance.value("in_band_up_flux [W m-2]"), "4");
    EXPECT_EQ(provenance.value("band_mean_transmittance"), irsg::numberText(mean));
    EXPECT_EQ(provenance.value("answered by"), "transmittance: haze");
}

TEST(RadiativeOutput, HoldsWhatMeasuredSpectraHavePassed) {
    const test::TemporaryFolder folder;
    const irsg::Environment environment = haze();
    RadiativeRequest request = everything();
    request.referenceDistances_m = {50.0, 12.5, 50.0, 1e9}; // twice, and beyond the sensor
    const RadiativeOutput output = radiativeOutput(environment, request);
    ASSERT_NE(output.table.find("transmittance_last_50m"), nullptr);
    ASSERT_NE(output.table.find("transmittance_last_12.5m"), nullptr);
    EXPECT_EQ(output.table.columns().size(),
              radiativeOutput(environment, everything()).table.columns().size() + 2);
    output.table.save(folder / "s.csv");
    const irsg::SpectraAtmosphere again = irsg::SpectraAtmosphere::fromCsv(folder / "s.csv");
    const irsg::AtmosphericPath path = *again.parameters().path;
    // Homogeneous air: a part of the path takes its part of the optical depth.
    const auto at4um = [&](double range_m) {
        irsg::AtmosphericPath part = path;
        part.range_m = range_m;
        part.sensorAltitude_m =
            path.targetAltitude_m +
            (path.sensorAltitude_m - path.targetAltitude_m) * range_m / path.range_m;
        return again.spectrum(irsg::AtmosphericQuery::transmittance(part), band).at(4.0);
    };
    const double whole = at4um(path.range_m);
    for (const double distance_m : {50.0, 12.5}) {
        EXPECT_NEAR(std::log(at4um(distance_m)), std::log(whole) * distance_m / path.range_m, 1e-4);
    }
    EXPECT_THROW(at4um(60.0), irsg::InputError);
}

TEST(RadiativeOutput, GivesBackTheSameSpectraWhenReadAsAir) {
    const test::TemporaryFolder folder;
    const irsg::Environment environment = haze();
    radiativeOutput(environment, everything()).table.save(folder / "s.csv");
    irsg::Environment again;
    again.sun = environment.sun;
    again.add(std::make_shared<irsg::SpectraAtmosphere>(
        irsg::SpectraAtmosphere::fromCsv(folder / "s.csv")));
    const RadiativeOutput first = radiativeOutput(environment, everything());
    const RadiativeOutput second = radiativeOutput(again, everything());
    EXPECT_EQ(first.table.columns(), second.table.columns());
    EXPECT_EQ(summaryOf(second, "ambient_temperature"), 280.0);
}

TEST(RadiativeOutput, LeavesOutWithAWarningWhatAPathToSpaceHasNotGot) {
    RadiativeRequest request = everything();
    request.geometry = {.sensorAltitude_m = 2000.0, .losElevation_deg = 20.0, .toSpace = true};
    EXPECT_THROW(radiativeOutput(haze(), request), irsg::InputError);
    request.leaveOutMissing = true;
    const RadiativeOutput output = radiativeOutput(haze(), request);
    EXPECT_TRUE(output.table.find("transmittance"));
    EXPECT_TRUE(output.table.find("background_radiance"));
    EXPECT_FALSE(output.table.find("solar_irradiance"));
    EXPECT_EQ(output.warnings.size(), 3u);
    EXPECT_THAT(output.warnings.front(), HasSubstr("solar irradiance is left out"));
}

TEST(RadiativeOutput, SaysNothingOfATemperatureThatNoAirHas) {
    RadiativeRequest request = everything();
    const RadiativeOutput output = radiativeOutput(irsg::Environment::vacuum(), request);
    EXPECT_EQ(output.table.provenance.value("ambient_temperature [K]"), "");
    EXPECT_EQ(summaryOf(output, "band_mean_transmittance"), 1.0);
}

struct BadRow {
    const char* name;
    RadiativeRequest request;
    std::string named;
};

void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}

class BadRadiativeRequest : public testing::TestWithParam<BadRow> {};

TEST_P(BadRadiativeRequest, IsRefusedByName) {
    try {
        radiativeOutput(haze(), GetParam().request);
        FAIL() << "nothing was refused";
    } catch (const irsg::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(GetParam().named));
    }
}

RadiativeRequest one(AtmosphereProperty property, const PathGeometryInput& geometry,
                     const irsg::SpectralRange& range = band) {
    return {.quantities = {property}, .geometry = geometry, .band = range};
}

INSTANTIATE_TEST_SUITE_P(
    Rows, BadRadiativeRequest,
    testing::Values(
        BadRow{"BandWiderThanTheAir", one(AtmosphereProperty::transmittance, slant, {1.999, 5.0}),
               "haze (holds only 2-6 um)"},
        BadRow{"PathWithoutRange",
               one(AtmosphereProperty::pathRadiance,
                   {.sensorAltitude_m = 10.0, .losElevation_deg = 5.0}),
               "path radiance: found"},
        BadRow{"BackgroundWithoutElevation",
               one(AtmosphereProperty::backgroundRadiance, {.sensorAltitude_m = 10.0}),
               "an elevation of the line of sight"},
        BadRow{"SunWithoutTarget",
               one(AtmosphereProperty::solarIrradiance, {.sensorAltitude_m = 10.0}),
               "a target altitude"},
        BadRow{"IntoTheGround",
               one(AtmosphereProperty::transmittance,
                   {.sensorAltitude_m = 10.0, .losElevation_deg = -45.0, .range_m = 100.0}),
               "meets the ground"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace smat
