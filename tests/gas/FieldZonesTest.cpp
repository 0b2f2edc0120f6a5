#include "irsg/gas/FieldZones.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/gas/GasSpectrum.h"
#include "tests/gas/PlumeFields.h"

using namespace irsg;
using namespace smat::test;

namespace {

constexpr SpectralRange narrow{4.45, 4.47};

/// What a field sends along parallel lines of sight, summed by nothing but layers of gas.
double intensity_W_sr(const PlumeField& field, const std::array<double, 3>& from_m,
                      const std::array<double, 3>& to_m, std::size_t towards) {
    constexpr int lines = 64, steps = 160;
    const std::size_t u = (towards + 1) % 3, v = (towards + 2) % 3;
    double sum = 0.0;
    const double area_m2 = (to_m[u] - from_m[u]) * (to_m[v] - from_m[v]) / (lines * lines);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < lines; ++j) {
            GasRequest request{.layers = {}, .band = narrow};
            std::array<double, 3> at_m{};
            at_m[u] = std::lerp(from_m[u], to_m[u], (i + 0.5) / lines);
            at_m[v] = std::lerp(from_m[v], to_m[v], (j + 0.5) / lines);
            for (int k = 0; k < steps; ++k) {
                at_m[towards] = std::lerp(to_m[towards], from_m[towards], (k + 0.5) / steps);
                GasLayer gas = field.at(at_m);
                gas.length_m = (to_m[towards] - from_m[towards]) / steps;
                if (gas.fraction(HotGas::CO2) > 4e-6) {
                    request.layers.push_back(gas);
                }
            }
            if (!request.layers.empty()) {
                sum += area_m2 * gasSpectrum(request).bandRadiance_W_m2_sr();
            }
        }
    }
    return sum;
}

double largestOf(const std::vector<PlumeZonesError>& errors) {
    double largest = 0.0;
    for (const PlumeZonesError& error : errors) {
        largest = std::max(largest, std::abs(error.relative()));
    }
    return largest;
}

const PlumeZonesError& viewOf(const std::vector<PlumeZonesError>& errors, const std::string& name) {
    return *std::ranges::find(errors, name, &PlumeZonesError::view);
}

TEST(FieldZones, OfAnAxisSendAsItsTable) {
    const auto along_m = planesFromZero(6.0, 61), across_m = planesAboutZero(1.6, 40);
    const PlumeField field =
        fieldOfPart({along_m, across_m, across_m}, 900.0,
                    [](double x_m, double y_m, double z_m) { return jetPart(x_m, y_m, z_m); });
    std::vector<GasLayer> nodes;
    const auto radii_m = planesFromZero(1.6, 41);
    for (const double x_m : along_m) {
        for (const double r_m : radii_m) {
            GasLayer& gas = nodes.emplace_back();
            const double part = jetPart(x_m, r_m, 0.0);
            gas.temperature_K = 288.0 + 612.0 * part;
            gas.fraction(HotGas::CO2) = gas.fraction(HotGas::H2O) = 0.04 * part;
        }
    }
    const PlumeTable table = PlumeTable::ofNodes(along_m, radii_m, std::move(nodes));
    const auto expected = PlumeIntensities(table, narrow).errorsOf(plumeZones(table, 8));
    const GasByTemperature gas(field.parts());
    const FieldWalls walls(field, gas.coldest_K(), 40000);
    const FieldIntensities intensities(field, walls, PlumeBand(narrow), plumeViews());
    const auto errors = intensities.errorsOf(fieldZones(gas, 12));
    ASSERT_EQ(errors.size(), 5U);
    for (const PlumeZonesError& of : expected) {
        EXPECT_NEAR(viewOf(errors, of.view).table_W_sr / of.table_W_sr, 1.0, 0.015) << of.view;
    }
    EXPECT_NEAR(viewOf(errors, "above").table_W_sr / viewOf(errors, "side").table_W_sr, 1.0, 0.01);
    EXPECT_LT(largestOf(errors), 0.03);
    EXPECT_GT(largestOf(intensities.errorsOf(fieldZones(gas, 1))), 0.2);
}

/// Two jets beside each other that become one.
double twoJets(double x_m, double y_m, double z_m) {
    return std::min(1.0, jetPart(x_m, y_m - 0.35, z_m) + jetPart(x_m, y_m + 0.35, z_m));
}
double ellipticJet(double x_m, double y_m, double z_m) {
    return jetPart(x_m, y_m, z_m, 3.0);
}

struct Unround {
    const char* name;
    double (*partOf)(double, double, double);
};
void PrintTo(const Unround& row, std::ostream* out) {
    *out << row.name;
}
class FieldZonesOf : public testing::TestWithParam<Unround> {};

TEST_P(FieldZonesOf, SendAsADenseIntegration) {
    const std::array<double, 3> from_m{0.0, -1.4, -1.4}, to_m{4.0, 1.4, 1.4};
    const PlumeField field = fieldOfPart(
        {planesFromZero(to_m[0], 61), planesAboutZero(1.4, 40), planesAboutZero(1.4, 40)}, 900.0,
        GetParam().partOf);
    const GasByTemperature gas(field.parts());
    const FieldWalls walls(field, gas.coldest_K(), 40000);
    const FieldIntensities intensities(field, walls, PlumeBand(narrow), plumeViews());
    const auto errors = intensities.errorsOf(fieldZones(gas, 14));
    EXPECT_LT(largestOf(errors), 0.025);
    for (const auto& [view, towards] :
         std::vector<std::pair<const char*, std::size_t>>{{"side", 1}, {"above", 2}}) {
        const double expected = intensity_W_sr(field, from_m, to_m, towards);
        EXPECT_NEAR(viewOf(errors, view).table_W_sr / expected, 1.0, 0.01) << view;
        EXPECT_NEAR(viewOf(errors, view).zones_W_sr / expected, 1.0, 0.03) << view;
    }
    const double ratio = viewOf(errors, "side").table_W_sr / viewOf(errors, "above").table_W_sr;
    EXPECT_GT(std::abs(ratio - 1.0), 0.05) << "it is round";
}

INSTANTIATE_TEST_SUITE_P(Unround, FieldZonesOf,
                         testing::Values(Unround{"TwoJets", twoJets},
                                         Unround{"Ellipse", ellipticJet}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(FieldZones, AreRefusedWhereNothingEmits) {
    const PlumeField air = fieldOfPart({planes(0, 1, 3), planes(0, 1, 3), planes(0, 1, 3)}, 900.0,
                                       [](double, double, double) { return 0.0; });
    EXPECT_THROW(GasByTemperature(air.parts()), InputError);
}

TEST(FieldIntensities, HardlyDependOnTheirLines) {
    const PlumeField field =
        fieldOfPart({planesFromZero(4.0, 41), planesAboutZero(1.2, 30), planesAboutZero(1.2, 30)},
                    900.0, ellipticJet);
    const GasByTemperature gas(field.parts());
    const FieldWalls walls(field, gas.coldest_K(), 30000);
    const auto zones = fieldZones(gas, 6);
    std::vector<PlumeView> views = plumeViews();
    views.resize(3);
    const auto one = FieldIntensities(field, walls, PlumeBand(narrow), views).errorsOf(zones);
    const auto finer = FieldIntensities(field, walls, PlumeBand(narrow), views, 2).errorsOf(zones);
    for (std::size_t view = 0; view < one.size(); ++view) {
        EXPECT_NEAR(one[view].table_W_sr / finer[view].table_W_sr, 1.0, 0.003) << one[view].view;
        EXPECT_NEAR(one[view].zones_W_sr / finer[view].zones_W_sr, 1.0, 0.01) << one[view].view;
    }
}

} // namespace
