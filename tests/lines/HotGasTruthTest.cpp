// Narrow bands of hot gas, and samples of its coincidence with air, against line by line of the
// same lines.
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/gas/GasSpectrum.h"
#include "irsg/gas/GasThroughAir.h"
#include "irsg/radiometry/Planck.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CarbonDioxidePolyads.h"
#include "tools/atmosphere-tables/lines/CarbonMonoxideLines.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

using namespace irsg;
using namespace irsg::lbl;

namespace {

constexpr double atmosphere_hPa = 1013.25;

class HotGasTruth : public testing::Test {
  protected:
    void SetUp() override {
        data_ = smat::test::sharedMaterial("data/atmosphere");
        if (data_.empty()) {
            GTEST_SKIP() << "no shared material";
        }
        partition_ = PartitionSums::read(data_ / "lines" / "partition");
    }

    const LineList& lines(HotGas gas) {
        auto [place, isNew] = lists_.try_emplace(gas);
        if (!isNew) {
            return place->second;
        }
        LineList& list = place->second;
        if (gas == HotGas::CO) {
            list = carbonMonoxideLines();
        } else {
            list = completeLineList(gas == HotGas::H2O ? Gas::H2O : Gas::CO2, data_);
        }
        if (gas == HotGas::CO2) {
            const auto file = data_ / "lines" / "CO2.par.gz";
            const CarbonDioxideLevels levels(readTextLines(file), file.string());
            addMissingLines(list, hotCarbonDioxide(levels, 10000.0, 1000.0, 1e-23));
        }
        return list;
    }

    /// Optical depth of a gas of a layer on a fine grid.
    std::vector<double> depths(HotGas gas, const GasLayer& layer, const WavenumberGrid& grid) {
        const LineList& all = lines(gas);
        LineShape shape{25.0, false, false};
        if (gas == HotGas::CO2) {
            shape = {60.0, false, true};
        }
        const auto begin = std::ranges::lower_bound(all.lines, grid.first_per_cm - 61.0, {},
                                                    &Line::wavenumber_per_cm);
        const auto end = std::ranges::upper_bound(all.lines, grid.last_per_cm() + 61.0, {},
                                                  &Line::wavenumber_per_cm);
        std::vector<double> k = crossSection_cm2(
            LineList{all.gas, {begin, end}, {}}, *partition_, grid, layer.temperature_K,
            layer.pressure_atm * atmosphere_hPa, layer.fraction(gas), shape, 1e-26);
        const double column_per_cm2 = layer.fraction(gas) * layer.pressure_atm * 101325.0 /
                                      (1.380649e-23 * layer.temperature_K) * layer.length_m * 1e-4;
        for (double& value : k) {
            value *= column_per_cm2;
        }
        return k;
    }

    /// Radiance and transmittance line by line, point by point.
    struct Fine {
        std::vector<double> radiance, transmittance;
    };
    Fine lineByLine(const std::vector<GasLayer>& layers, const WavenumberGrid& grid) {
        Fine fine{std::vector<double>(grid.count, 0.0), std::vector<double>(grid.count, 1.0)};
        for (const GasLayer& layer : layers) {
            std::vector<double> sum(grid.count, 0.0);
            for (const HotGas gas : {HotGas::CO2, HotGas::H2O, HotGas::CO}) {
                if (layer.fraction(gas) == 0.0) {
                    continue;
                }
                const std::vector<double> own = depths(gas, layer, grid);
                for (std::size_t i = 0; i < sum.size(); ++i) {
                    sum[i] += own[i];
                }
            }
            for (std::size_t i = 0; i < sum.size(); ++i) {
                fine.radiance[i] +=
                    fine.transmittance[i] * -std::expm1(-sum[i]) *
                    planckRadiance_W_m2_sr_um(1e4 / grid.at(i), layer.temperature_K);
                fine.transmittance[i] *= std::exp(-sum[i]);
            }
        }
        return fine;
    }

    static WavenumberGrid gridOf(const SpectralRange& band, double step_per_cm) {
        WavenumberGrid grid;
        grid.first_per_cm = 1e4 / band.max_um + 0.5 * step_per_cm;
        grid.step_per_cm = step_per_cm;
        grid.count =
            static_cast<std::size_t>((1e4 / band.min_um - 1e4 / band.max_um) / step_per_cm);
        return grid;
    }

    static double inBand(const std::vector<double>& values, const WavenumberGrid& grid) {
        double sum = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += values[i] * 1e4 / (grid.at(i) * grid.at(i)) * grid.step_per_cm;
        }
        return sum;
    }

    std::filesystem::path data_;
    std::optional<PartitionSums> partition_;
    std::map<HotGas, LineList> lists_;
};

GasLayer layer(double temperature_K, double length_m, double carbonDioxide, double water,
               double carbonMonoxide = 0.0, double pressure_atm = 1.0) {
    GasLayer made;
    made.temperature_K = temperature_K;
    made.length_m = length_m;
    made.pressure_atm = pressure_atm;
    made.fraction(HotGas::CO2) = carbonDioxide;
    made.fraction(HotGas::H2O) = water;
    made.fraction(HotGas::CO) = carbonMonoxide;
    return made;
}

TEST_F(HotGasTruth, NarrowBandsRadiateAsTheirLines) {
    struct Row {
        const char* name;
        std::vector<GasLayer> layers;
        SpectralRange band;
    };
    const std::vector<Row> rows = {
        {"CO2, 1.65 atm cm", {layer(700.0, 0.5, 0.033, 0.0)}, {4.4, 4.8}},
        {"CO2, 1.65 atm cm", {layer(700.0, 0.5, 0.033, 0.0)}, {4.2, 4.4}},
        {"CO2, 30 atm cm", {layer(1000.0, 3.0, 0.1, 0.0)}, {4.4, 4.8}},
        {"CO, 5 atm cm", {layer(900.0, 1.0, 0.0, 0.0, 0.05)}, {4.4, 4.8}},
        {"CO, 0.5 atm cm", {layer(2000.0, 0.1, 0.0, 0.0, 0.05)}, {4.4, 4.8}},
        {"H2O, 10 atm cm", {layer(700.0, 1.0, 0.0, 0.1)}, {4.5, 5.0}},
        {"H2O, 2 atm cm", {layer(1000.0, 0.2, 0.0, 0.1)}, {2.8, 3.0}},
        {"two layers", {layer(400.0, 0.5, 0.02, 0.02), layer(900.0, 0.5, 0.05, 0.05)}, {4.4, 4.8}},
        {"CO2 at 0.3 atm", {layer(800.0, 2.0, 0.05, 0.0, 0.0, 0.3)}, {4.4, 4.8}},
    };
    for (const auto& [name, layers, band] : rows) {
        const WavenumberGrid grid = gridOf(band, 0.01);
        const double truth = inBand(lineByLine(layers, grid).radiance, grid);
        const GasSpectrum narrow =
            gasSpectrum({.layers = layers, .band = band, .source = GasSource::lines});
        const double value = narrow.bandRadiance_W_m2_sr();
        EXPECT_NEAR(value, truth, 0.05 * truth)
            << name << ", " << band.min_um << "-" << band.max_um << " um";
        EXPECT_LT(std::abs(value - truth), narrow.bandError_W_m2_sr()) << name;
        std::cout << name << " " << band.min_um << "-" << band.max_um << " um: " << value / truth
                  << "\n";
    }
}

TEST_F(HotGasTruth, SamplesCorrelateAsTheirLines) {
    AtmosphericState air;
    air.temperature_K = 294.0;
    air.moleFraction[static_cast<std::size_t>(Gas::H2O)] = 0.0188;
    air.moleFraction[static_cast<std::size_t>(Gas::CO2)] = 4e-4;
    struct Row {
        const char* name;
        GasLayer gas;
        SpectralRange band;
        double range_m;
    };
    const std::vector<Row> rows = {
        {"water", layer(700.0, 1.0, 0.0, 0.05), {1e4 / 2200.0, 5.0}, 1000.0},
        {"water, far", layer(700.0, 1.0, 0.0, 0.05), {1e4 / 2200.0, 5.0}, 5000.0},
        {"carbon dioxide", layer(700.0, 0.5, 0.033, 0.033), {4.4, 4.8}, 1000.0},
        {"hot", layer(1000.0, 0.5, 0.033, 0.033), {4.4, 4.8}, 100.0}};
    for (const auto& [name, gas, band, range_m] : rows) {
        const WavenumberGrid grid = gridOf(band, 0.005);
        // Of the air as of a layer that is cold.
        GasLayer cold = layer(air.temperature_K, range_m, 4e-4, 0.0188);
        const Fine before = lineByLine({cold}, grid), source = lineByLine({gas}, grid);
        const GasRequest request{.layers = {gas}, .band = band};
        const GasSpectrum spectrum = gasSpectrum(request);
        const std::vector<LineCorrelation> correlations =
            lineCorrelations(request, spectrum.cells, air, range_m);
        double truth = 0.0, product = 0.0, sampled = 0.0;
        for (std::size_t c = 0; c < spectrum.cells.size(); ++c) {
            double both = 0.0, a = 0.0, b = 0.0, count = 0.0;
            for (std::size_t i = 0; i < grid.count; ++i) {
                if (grid.at(i) >= spectrum.cells[c].lower_per_cm &&
                    grid.at(i) < spectrum.cells[c].upper_per_cm) {
                    both += before.transmittance[i] * source.radiance[i];
                    a += before.transmittance[i];
                    b += source.radiance[i];
                    count += 1.0;
                }
            }
            truth += both;
            product += a * b / count;
            sampled += a * b / count * correlations[c].radiance;
        }
        std::cout << name << ": line by line over product " << truth / product
                  << ", samples over line by line " << sampled / truth << "\n";
        EXPECT_NEAR(sampled, truth, 0.05 * truth) << name;
        EXPECT_GT(std::abs(product - truth), std::abs(sampled - truth)) << name;
    }
}

} // namespace
