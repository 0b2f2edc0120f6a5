// The closed form of what a surface adds against the sum over wavelengths that it stands for.
#include "irsg/radiance/ScaledSum.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"

using namespace irsg;

namespace {

struct Row {
    const char* name;
    double temperature_K;  ///< 0: a measured spectrum
    double least, most;    ///< of the scale of the temperature
    double mostEmissivity; ///< scale
    double (*emissivity)(double wavelength_um);
    double (*transmissivity)(double wavelength_um);
};

double none(double) {
    return 0.0;
}
double half(double) {
    return 0.5;
}
double sloped(double wavelength_um) {
    return 0.5 + 0.2 * (wavelength_um - 3.0);
}
/// A line of a gas that reflects nothing: its limits differ by rounding.
double line(double wavelength_um) {
    return std::exp(-8.0 * std::abs(wavelength_um - 4.3));
}
double beside(double wavelength_um) {
    return 1.0 - line(wavelength_um);
}
double stepped(double wavelength_um) {
    return wavelength_um < 3.7 ? 0.6 : wavelength_um < 4.4 ? 0.8 : 0.9;
}

const std::vector<Row> rows{
    {"grey, never all", 300.0, 0.9, 1.1, 1.5, half, none},
    {"grey, all from a scale on", 300.0, 0.9, 1.1, 3.0, half, none},
    {"grey behind a gas", 500.0, 0.8, 1.6, 2.0, half, beside},
    {"in three steps", 700.0, 0.9, 1.2, 2.0, stepped, none},
    {"cut somewhere inside the band", 600.0, 0.7, 1.3, 2.5, sloped, none},
    {"of a temperature that stays", 600.0, 1.0, 1.0, 2.5, sloped, none},
    {"at another temperature that stays", 600.0, 1.1, 1.1, 2.5, sloped, none},
    {"a gas, hot", 900.0, 0.9, 1.1, 1.3, line, beside},
    {"a gas, measured", 0.0, 1.0, 1.0, 1.3, line, beside},
    {"a painted thing, measured", 0.0, 1.0, 1.0, 2.5, sloped, none},
};

constexpr std::size_t before = 5, count = 2000; // nodes of another band, and of this one

} // namespace

TEST(ScaledSum, IsTheSumOverTheBandAtAnyScales) {
    std::vector<double> wavelengths_um(before, 2.0);
    for (std::size_t i = 0; i < count; ++i) {
        wavelengths_um.push_back(3.0 + 2.0 * static_cast<double>(i) / count);
    }
    PlanckTable planck(wavelengths_um);
    for (const Row& row : rows) {
        ScaledSurface surface;
        surface.temperature_K = row.temperature_K;
        for (std::size_t i = 0; i < count; ++i) {
            const double wavelength_um = wavelengths_um[before + i];
            surface.emissivity.push_back(row.emissivity(wavelength_um));
            surface.absorbedAtMost.push_back(1.0 - row.transmissivity(wavelength_um));
            surface.emitted.intensity.push_back(1e-3 * (1.0 + std::sin(9.0 * wavelength_um)));
            surface.emitted.irradiance.push_back(1e-4 * (1.0 + std::cos(7.0 * wavelength_um)));
            surface.reflected.intensity.push_back(1e-3 * std::exp(-wavelength_um));
            surface.reflected.irradiance.push_back(1e-4 * std::exp(-wavelength_um));
        }
        const auto sum =
            ScaledSum::of(surface, planck, before, {row.least, row.most, row.mostEmissivity});
        ASSERT_TRUE(sum.has_value()) << row.name;
        for (int draw = 0; draw < 200; ++draw) {
            const double u = std::fmod(0.7548776662466927 * draw, 1.0);
            const double v = std::fmod(0.5698402909980532 * draw, 1.0);
            const double scaleT = row.least + (row.most - row.least) * u;
            const double scaleE = 0.3 + (row.mostEmissivity - 0.3) * v;
            double intensity = 0.0, irradiance = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const double emissivity =
                    std::min(scaleE * surface.emissivity[i], surface.absorbedAtMost[i]);
                const double reflectivity = surface.absorbedAtMost[i] - emissivity;
                const double emitted =
                    row.temperature_K > 0.0
                        ? emissivity * planckRadiance_W_m2_sr_um(wavelengths_um[before + i],
                                                                 scaleT * row.temperature_K)
                        : scaleE;
                intensity += emitted * surface.emitted.intensity[i] +
                             reflectivity * surface.reflected.intensity[i];
                irradiance += emitted * surface.emitted.irradiance[i] +
                              reflectivity * surface.reflected.irradiance[i];
            }
            const ScaledPair found = sum->at(scaleT, scaleE);
            ASSERT_NEAR(found.intensity / intensity, 1.0, 2e-11) << row.name << " " << scaleE;
            ASSERT_NEAR(found.irradiance / irradiance, 1.0, 2e-11) << row.name << " " << scaleE;
        }
    }
}

TEST(ScaledSum, HasNoValueWhereNoSeriesIsGoodEnough) {
    // Light that is taken away: the logarithm has no series.
    const std::vector<double> wavelengths_um{4.0, 4.1};
    PlanckTable planck(wavelengths_um);
    ScaledSurface surface;
    surface.temperature_K = 300.0;
    surface.emissivity = surface.absorbedAtMost = {0.5, 0.5};
    surface.emitted = {{-1.0, -1.0}, {1.0, 1.0}};
    surface.reflected = {{0.0, 0.0}, {0.0, 0.0}};
    EXPECT_FALSE(ScaledSum::of(surface, planck, 0, {0.9, 1.1, 1.0}).has_value());
}
