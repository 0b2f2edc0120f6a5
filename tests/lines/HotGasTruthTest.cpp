// Narrow bands of hot gas, and samples of its coincidence with air, against line by line of the
// same lines.
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/gas/GasSpectrum.h"
#include "irsg/gas/GasThroughAir.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
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

/// What a plume of five layers sends through air of a length.
struct ThroughAir {
    std::vector<double> truth, correlated, product; ///< by cell, W m-2 sr-1
};

/// The largest error of what cells `width_per_cm` wide send, of those that carry more than a part
/// of the band.
double largestError(const std::vector<double>& values, const std::vector<double>& truth,
                    const std::vector<GasSpectrum::Cell>& cells, const SpectralRange& band,
                    double width_per_cm) {
    constexpr double counts = 0.01;
    std::map<long, std::pair<double, double>> wide; // value and truth
    double all = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const double um = 1e4 / cells[c].wavenumber_per_cm;
        if (um < band.min_um || um > band.max_um) {
            continue;
        }
        auto& [value, expected] = wide[std::lround(cells[c].wavenumber_per_cm / width_per_cm)];
        value += values[c];
        expected += truth[c];
        all += truth[c];
    }
    double largest = 0.0;
    for (const auto& [number, of] : wide) {
        if (of.second > counts * all) {
            largest = std::max(largest, std::abs(of.first / of.second - 1.0));
        }
    }
    return largest;
}

TEST_F(HotGasTruth, APlumeOfFiveLayersArrivesAsItsLinesThroughThoseOfTheAir) {
    // A jet cut through: rim, shoulder, core and back.
    const std::vector<GasLayer> plume = {
        layer(350.0, 0.30, 0.005, 0.005), layer(500.0, 0.25, 0.014, 0.014, 5e-4),
        layer(750.0, 0.50, 0.033, 0.033, 1e-3), layer(500.0, 0.25, 0.014, 0.014, 5e-4),
        layer(350.0, 0.30, 0.005, 0.005)};
    const std::vector<SpectralRange> bands = {{3.0, 5.0}, {4.2, 4.5}, {4.4, 4.8}};
    const SpectralRange whole = bands.front();
    const WavenumberGrid grid = gridOf(whole, 0.005);
    const GasRequest request{.layers = plume, .band = whole};
    const GasSpectrum spectrum = gasSpectrum(request);
    const std::size_t cells = spectrum.cells.size();
    std::vector<std::size_t> cellOf(grid.count, cells);
    std::vector<double> points(cells, 0.0);
    for (std::size_t i = 0, c = 0; i < grid.count; ++i) {
        while (c + 1 < cells && grid.at(i) >= spectrum.cells[c].upper_per_cm) {
            ++c;
        }
        cellOf[i] = c;
        points[c] += 1.0;
    }
    const std::vector<LineList> gasesOfAir = completeLineLists(data_);
    const Fine source = lineByLine(plume, grid);
    for (const auto& [name, model] :
         {std::pair("midlatitude summer", 2), std::pair("subarctic winter", 5)}) {
        AtmosphereSmartParameters parameters;
        parameters.atmosphereModel = model;
        parameters.aerosols = 0;
        const auto atmosphere = std::make_shared<const AtmosphereSmart>(parameters);
        Environment environment;
        environment.add(atmosphere);
        constexpr double altitude_m = 20.0;
        const AtmosphericState air = *airOfPath(
            atmosphere.get(),
            {.sensorAltitude_m = altitude_m, .targetAltitude_m = altitude_m, .range_m = 100.0});
        // Lines, wings and continua of the air, m-1.
        std::vector<double> extinction_per_m(grid.count, 0.0);
        for (const LineList& list : gasesOfAir) {
            const std::vector<double> k = crossSection_cm2(
                list, *partition_, grid, air.temperature_K, air.pressure_hPa,
                air.fraction(list.gas), defaultLineShape(list.gas), negligible_cm2(list.gas));
            for (std::size_t i = 0; i < grid.count; ++i) {
                extinction_per_m[i] += k[i] * air.density_per_m3(list.gas) * 1e-4;
            }
        }
        for (std::size_t i = 0; i < grid.count; ++i) {
            extinction_per_m[i] += continuumAbsorption_per_m(air, grid.at(i));
        }
        for (const double range_m : {100.0, 1000.0, 5000.0, 20000.0}) {
            const Spectrum passes = environment
                                        .spectrum({.quantity = AtmosphereProperty::transmittance,
                                                   .path = {.sensorAltitude_m = altitude_m,
                                                            .targetAltitude_m = altitude_m,
                                                            .range_m = range_m}},
                                                  whole)
                                        .value;
            const std::vector<LineCorrelation> correlations =
                lineCorrelations(request, spectrum.cells, air, range_m);
            ThroughAir sent;
            sent.truth.assign(cells, 0.0);
            for (std::size_t i = 0; i < grid.count; ++i) {
                sent.truth[cellOf[i]] += source.radiance[i] *
                                         std::exp(-extinction_per_m[i] * range_m) /
                                         points[cellOf[i]];
            }
            for (std::size_t c = 0; c < cells; ++c) {
                const GasSpectrum::Cell& cell = spectrum.cells[c];
                const SpectralRange range{wavelengthFromWavenumber_um(cell.upper_per_cm),
                                          wavelengthFromWavenumber_um(cell.lower_per_cm)};
                const Spectrum* const factors[] = {&passes};
                sent.truth[c] *= range.width_um();
                sent.product.push_back(cell.radiance_W_m2_sr_um * integrateProduct(factors, range));
                sent.correlated.push_back(sent.product.back() * correlations[c].radiance);
            }
            const double bound = range_m > 1000.0 ? 0.05 : 0.03;
            double inAll = 0.0;
            for (const SpectralRange& band : bands) {
                double truth = 0.0, correlated = 0.0, product = 0.0;
                for (std::size_t c = 0; c < cells; ++c) {
                    const double um = 1e4 / spectrum.cells[c].wavenumber_per_cm;
                    if (um >= band.min_um && um <= band.max_um) {
                        truth += sent.truth[c];
                        correlated += sent.correlated[c];
                        product += sent.product[c];
                    }
                }
                const double spike =
                    largestError(sent.correlated, sent.truth, spectrum.cells, band, 25.0);
                std::cout << name << ", " << band.min_um << "-" << band.max_um << " um, " << range_m
                          << " m: " << truth << " W m-2 sr-1, correlated "
                          << 100.0 * (correlated / truth - 1.0) << " %, product "
                          << 100.0 * (product / truth - 1.0) << " %, spikes of 25 cm-1 within "
                          << 100.0 * spike << " %, of products "
                          << 100.0 *
                                 largestError(sent.product, sent.truth, spectrum.cells, band, 25.0)
                          << " %" << std::endl;
                // The middle of the band of CO2, of which the air leaves next to nothing, is a
                // matter of wings.
                constexpr double counts = 0.02;
                if (&band == &bands.front()) {
                    inAll = truth;
                }
                if (truth > counts * inAll) {
                    EXPECT_NEAR(correlated / truth, 1.0, bound)
                        << name << ", " << band.min_um << " um, " << range_m << " m";
                }
            }
        }
    }
}

} // namespace
