#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/TruthPaths.h"

// The spectral mode, with the table that is shipped, against line by line at 43 levels without any
// table (tests/data/atmosphere/line-by-line.csv.gz, written by `atmosphere-tables truth`).

namespace irsg {
namespace {

using lbl::truthBands;
using lbl::truthBinWidth_per_cm;
using lbl::truthPaths;

struct Truth {
    std::vector<double> transmittance, radiance_W_m2_sr_per_cm;
};

/// By atmosphere, path and band.
const std::map<std::array<int, 3>, Truth>& truth() {
    static const auto all = [] {
        std::map<std::array<int, 3>, Truth> cases;
        const auto file = std::filesystem::path(SMAT_RESOURCES_DIR).parent_path() /
                          "tests/data/atmosphere/line-by-line.csv.gz";
        for (const std::string& line : lbl::readTextLines(file)) {
            int atmosphere = 0, path = 0;
            double lower = 0.0, transmittance = 0.0, radiance = 0.0;
            if (std::sscanf(line.c_str(), "%d,%d,%lf,%lf,%lf", &atmosphere, &path, &lower,
                            &transmittance, &radiance) != 5) {
                continue;
            }
            int band = 0;
            while (lower >= truthBands[static_cast<std::size_t>(band)].upper_per_cm) {
                ++band;
            }
            Truth& own = cases[{atmosphere, path, band}];
            own.transmittance.push_back(transmittance);
            own.radiance_W_m2_sr_per_cm.push_back(radiance);
        }
        return cases;
    }();
    return all;
}

RadiativeTransfer molecularAir(int atmosphere) {
    AtmosphericModel air{Profile::model(static_cast<ModelAtmosphere>(atmosphere)), {}};
    air.scattering = ScatteringMode::single;
    return RadiativeTransfer(air, GasTable::shipped());
}

/// The nodes of exactly the band's bins.
NodeSet nodesOf(const GasTable& gases, const lbl::TruthBand& band) {
    const BinSet& bins = gases.bins(5);
    const auto [first, last] = bins.range(band.lower_per_cm, band.upper_per_cm);
    NodeSet set;
    for (std::size_t b = first; b < last; ++b) {
        for (std::uint32_t i = bins.bins[b].first; i < bins.bins[b].first + bins.bins[b].count;
             ++i) {
            set.nodes.push_back(bins.nodes[i]);
            set.wavenumbers_per_cm.push_back(gases.wavenumber_per_cm(bins.nodes[i]));
        }
    }
    return set;
}

std::vector<double> binMeans(const BinSet& bins, const lbl::TruthBand& band,
                             const std::vector<double>& nodeValues) {
    const auto [first, last] = bins.range(band.lower_per_cm, band.upper_per_cm);
    std::vector<double> means;
    std::size_t at = 0;
    for (std::size_t b = first; b < last; ++b) {
        double mean = 0.0;
        for (std::uint32_t i = 0; i < bins.bins[b].count; ++i) {
            mean += static_cast<double>(bins.weights[bins.bins[b].first + i]) * nodeValues[at++];
        }
        means.push_back(mean);
    }
    return means;
}

class SpectralTruth : public testing::TestWithParam<int> {};

TEST_P(SpectralTruth, IsFollowedOverSixtyPaths) {
    const int bandNumber = GetParam();
    const lbl::TruthBand band = truthBands[static_cast<std::size_t>(bandNumber)];
    const SunPosition night{0.0, -1.0};
    double squares = 0.0, largest = 0.0, largestRadiance = 0.0;
    std::size_t count = 0;
    for (int atmosphere = 1; atmosphere <= 6; ++atmosphere) {
        const RadiativeTransfer transfer = molecularAir(atmosphere);
        const BinSet& bins = transfer.gases().bins(5);
        const NodeSet nodes = nodesOf(transfer.gases(), band);
        for (std::size_t p = 0; p < truthPaths.size(); ++p) {
            const Truth& expected = truth().at({atmosphere, static_cast<int>(p), bandNumber});
            const auto transmittance =
                binMeans(bins, band, transfer.transmittance(nodes, truthPaths[p]));
            const auto radiance =
                binMeans(bins, band, transfer.pathRadiance(nodes, truthPaths[p], night));
            ASSERT_EQ(transmittance.size(), expected.transmittance.size());
            double sum = 0.0, expectedSum = 0.0;
            for (std::size_t b = 0; b < transmittance.size(); ++b) {
                const double error = transmittance[b] - expected.transmittance[b];
                squares += error * error;
                largest = std::max(largest, std::abs(error));
                ++count;
                const double nu =
                    band.lower_per_cm + truthBinWidth_per_cm * (static_cast<double>(b) + 0.5);
                sum += radiance[b] * 1e4 / (nu * nu);
                expectedSum += expected.radiance_W_m2_sr_per_cm[b];
            }
            const double relative = std::abs(sum / expectedSum - 1.0);
            largestRadiance = std::max(largestRadiance, relative);
            EXPECT_LE(relative, 0.02) << "atmosphere " << atmosphere << ", path " << p << ": "
                                      << sum << " against " << expectedSum;
        }
    }
    std::cout << band.lower_per_cm << "-" << band.upper_per_cm
              << " cm-1: transmittance of 5 cm-1, RMS "
              << std::sqrt(squares / static_cast<double>(count)) << ", largest " << largest
              << "; in-band path radiance, largest " << 100.0 * largestRadiance << " %\n";
    EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 0.01);
}

std::string bandName(const testing::TestParamInfo<int>& info) {
    constexpr std::array names = {"EightToTwelve", "ThreeToFive", "OneAndAHalfToTwoAndAHalf"};
    return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Bands, SpectralTruth, testing::Values(0, 1, 2), bandName);

} // namespace
} // namespace irsg
