#include <cmath>

#include <gtest/gtest.h>

#include "tools/atmosphere-tables/lines/NodeTraining.h"

namespace irsg::lbl {
namespace {

constexpr double lower_per_cm = 4000.0, upper_per_cm = 4015.0, step_per_cm = 0.01;

CrossSectionGrid smallGrid() {
    CrossSectionGrid grid;
    grid.pressures_hPa = {1100.0, 300.0, 30.0, 0.1};
    grid.temperatures_K = {180.0, 245.0, 330.0};
    return grid;
}

/// Methane of the same cross section at every pressure and temperature, which wavers by a factor of
/// 50 within half a cm-1.
FineCrossSections wavering(double mean_cm2) {
    FineCrossSections fine;
    fine.grid = {
        lower_per_cm + 0.5 * step_per_cm, step_per_cm,
        static_cast<std::size_t>(std::lround((upper_per_cm - lower_per_cm) / step_per_cm))};
    std::vector<float> values;
    for (std::size_t i = 0; i < fine.grid.count; ++i) {
        values.push_back(static_cast<float>(std::log(mean_cm2) +
                                            2.0 * std::sin(12.0 * fine.grid.at(i)) +
                                            0.3 * std::sin(fine.grid.at(i))));
    }
    fine.lnCrossSection[static_cast<std::size_t>(Gas::CH4)].assign(smallGrid().points(Gas::CH4),
                                                                   values);
    return fine;
}

/// Largest error of the transmittance of bins of 5 cm-1 over columns up to the longest one.
double largestError(const FineCrossSections& fine, const TrainedNodes& trained,
                    double longest_per_cm2) {
    const auto& ln = fine.lnCrossSection[static_cast<std::size_t>(Gas::CH4)].front();
    const BinSet& bins = trained.bins[1];
    double largest = 0.0;
    for (double column = longest_per_cm2; column > 1e-3 * longest_per_cm2; column *= 0.5) {
        for (const SpectralBin& bin : bins.bins) {
            double mean = 0.0, count = 0.0, sum = 0.0;
            for (std::size_t i = 0; i < ln.size(); ++i) {
                if (fine.grid.at(i) > bin.lower_per_cm && fine.grid.at(i) < bin.upper_per_cm) {
                    mean += std::exp(-column * std::exp(static_cast<double>(ln[i])));
                    count += 1.0;
                }
            }
            for (std::uint32_t i = bin.first; i < bin.first + bin.count; ++i) {
                const double nu_per_cm = trained.wavenumbers_per_cm[bins.nodes[i]];
                const auto at = static_cast<std::size_t>(
                    std::lround((nu_per_cm - fine.grid.first_per_cm) / step_per_cm));
                sum += static_cast<double>(bins.weights[i]) *
                       std::exp(-column * std::exp(static_cast<double>(ln[at])));
            }
            largest = std::max(largest, std::abs(sum - mean / count));
        }
    }
    return largest;
}

TEST(NodeTraining, SeesTheFaintAbsorptionThatOnlyALongPathThroughThinAirAddsUp) {
    // 250 km at 11 km altitude hold 3e20 molecules of methane per cm2; a layer of 2 km holds so few
    // that its depth is below 1e-3 nearly everywhere.
    const TrainingPaths training =
        trainingPaths({Profile::model(ModelAtmosphere::subarcticWinter)});
    const std::array<NodeGoals, 3> goals = {
        {{0.0025, 0.03, 6}, {0.0015, 0.015, 12}, {0.0015, 0.015, 16}}};
    for (const double mean_cm2 : {3e-23, 1e-22, 1e-21, 1e-20}) {
        const FineCrossSections fine = wavering(mean_cm2);
        const TrainedNodes trained =
            trainNodes(fine, smallGrid(), training, lower_per_cm, upper_per_cm, 1, goals);
        ASSERT_EQ(trained.bins[1].bins.size(), 3u);
        EXPECT_LT(largestError(fine, trained, 3e20), 0.01) << mean_cm2;
    }
}

TEST(NodeTraining, ErrorsOfNodesThatAreKeptAreThoseOfTheirTraining) {
    const TrainingPaths training =
        trainingPaths({Profile::model(ModelAtmosphere::subarcticWinter)});
    const std::array<NodeGoals, 3> goals = {
        {{0.0025, 0.03, 6}, {0.0015, 0.015, 12}, {0.0015, 0.015, 16}}};
    for (const int width_per_cm : {1, 5}) {
        const FineCrossSections fine = wavering(1e-21);
        const TrainedNodes trained = trainNodes(fine, smallGrid(), training, lower_per_cm,
                                                upper_per_cm, width_per_cm, goals);
        TrainedNodes kept = trained;
        kept.squaredError = kept.largestError = {};
        kept.cases = {};
        measureNodes(kept, fine, smallGrid(), training);
        EXPECT_EQ(kept.cases, trained.cases);
        for (std::size_t r = 0; r < 3; ++r) {
            EXPECT_GT(trained.largestError[r], 0.0);
            // Weights are kept in single precision.
            EXPECT_NEAR(kept.largestError[r], trained.largestError[r], 1e-6) << width_per_cm;
            EXPECT_NEAR(kept.squaredError[r] / trained.squaredError[r], 1.0, 1e-3) << width_per_cm;
        }
    }
}

TEST(NodeTraining, PathsAreLongWhereTheAirIsThin) {
    const TrainingPaths training = trainingPaths({Profile::model(ModelAtmosphere::tropical)});
    double longestAloft_m = 0.0, longestBelow_m = 0.0;
    for (const TrainingPath& path : training.paths) {
        if (path.last != path.first + 1) {
            continue;
        }
        const TrainingLayer& layer = training.layers[path.first];
        double& longest_m = layer.air.pressure_hPa < 400.0 ? longestAloft_m : longestBelow_m;
        longest_m = std::max(longest_m, path.factor * layer.thickness_m);
    }
    EXPECT_NEAR(longestAloft_m, 250e3, 1.0);
    EXPECT_NEAR(longestBelow_m, 80e3, 1.0);
}

} // namespace
} // namespace irsg::lbl
