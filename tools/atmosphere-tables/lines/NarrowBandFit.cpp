#include "tools/atmosphere-tables/lines/NarrowBandFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace irsg::lbl {

namespace {

constexpr std::array<double, 7> depths = {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0};

/// Mean transmittances of a band at the depths, line by line.
std::array<double, depths.size()> transmittances(std::span<const double> relative) {
    std::array<double, depths.size()> means{};
    for (std::size_t d = 0; d < depths.size(); ++d) {
        for (const double value : relative)
            means[d] += std::exp(-depths[d] * value);
        means[d] /= static_cast<double>(relative.size());
    }
    return means;
}

FittedBand fitBand(std::span<const double> crossSections_cm2, double centre_per_cm,
                   const NarrowBandTask& task) {
    FittedBand band;
    band.crossSection_cm2 =
        std::accumulate(crossSections_cm2.begin(), crossSections_cm2.end(), 0.0) /
        static_cast<double>(crossSections_cm2.size());
    if (!(band.crossSection_cm2 > 0.0))
        return band;
    std::vector<double> relative(crossSections_cm2.begin(), crossSections_cm2.end());
    for (double& value : relative)
        value /= band.crossSection_cm2;
    const auto wanted = transmittances(relative);
    const auto squares = [&](double lnInverseSpacing) {
        const double inverse = std::exp(lnInverseSpacing);
        double sum = 0.0;
        for (std::size_t d = 0; d < depths.size(); ++d) {
            NarrowBandSum layer;
            layer.add({depths[d], task.collision_per_cm * inverse,
                       task.dopplerPerWavenumber * centre_per_cm * inverse});
            const double difference =
                -std::expm1(-layer.opticalDepth(task.law)) / (1.0 - wanted[d]) - 1.0;
            sum += difference * difference;
        }
        return sum;
    };
    // Golden section: one minimum, since the transmittance falls with the inverse spacing.
    constexpr double golden = 0.6180339887498949;
    double low = std::log(1e-3), high = std::log(1e5);
    for (int i = 0; i < 60; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        if (squares(a) < squares(b))
            high = b;
        else
            low = a;
    }
    band.inverseSpacing_cm = std::exp(0.5 * (low + high));
    band.rmsError = std::sqrt(squares(0.5 * (low + high)) / static_cast<double>(depths.size()));
    return band;
}

} // namespace

std::vector<FittedBand> fitNarrowBands(const LineList& list, const PartitionSums& partition,
                                       const NarrowBandTask& task) {
    constexpr std::size_t bandsAtOnce = 120; // wings of 300 cm-1 reach into a piece
    const auto points = static_cast<std::size_t>(std::lround(task.width_per_cm / task.step_per_cm));
    std::vector<FittedBand> bands;
    for (std::size_t first = 0; first < task.centres_per_cm.size(); first += bandsAtOnce) {
        const std::size_t count = std::min(bandsAtOnce, task.centres_per_cm.size() - first);
        WavenumberGrid grid;
        grid.first_per_cm =
            task.centres_per_cm[first] - 0.5 * task.width_per_cm + 0.5 * task.step_per_cm;
        grid.step_per_cm = task.step_per_cm;
        grid.count = count * points;
        const double reach_per_cm = task.shape.cut_per_cm + 1.0;
        const auto begin = std::ranges::lower_bound(list.lines, grid.first_per_cm - reach_per_cm,
                                                    {}, &Line::wavenumber_per_cm);
        const auto end = std::ranges::upper_bound(list.lines, grid.last_per_cm() + reach_per_cm, {},
                                                  &Line::wavenumber_per_cm);
        const LineList near{list.gas, {begin, end}, {}};
        const std::vector<double> values =
            crossSection_cm2(near, partition, grid, task.temperature_K, task.pressure_hPa, 0.0,
                             task.shape, task.weakest_cm2);
        for (std::size_t b = 0; b < count; ++b)
            bands.push_back(fitBand(std::span(values).subspan(b * points, points),
                                    task.centres_per_cm[first + b], task));
    }
    return bands;
}

} // namespace irsg::lbl
