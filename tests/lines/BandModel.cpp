#include "tests/lines/BandModel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/atmosphere-tables/lines/Voigt.h"

namespace irsg::lbl {

namespace {

constexpr double reach_per_cm = 25.0;
constexpr std::size_t points = 50; ///< in a bin
constexpr double step_per_cm = 1.0 / points;
// Shallower lines do not change a bin by 1e-6.
constexpr double shallow_per_cm = 1e-6;

double meanTransmittance(const std::array<double, points>& depth) {
    double sum = 0.0;
    for (const double value : depth) {
        sum += std::exp(-value);
    }
    return sum / points;
}

} // namespace

BandModel::BandModel(const LineList& lines, const PartitionSums& partition, const GasPath& path) {
    const double T = path.temperature_K;
    for (const Line& line : lines.lines) {
        const double nu = line.wavenumber_per_cm;
        const double strength =
            line.intensity * partition.ratioTo296(lines.gas, line.isotopologue, T) *
            std::exp(-secondRadiationConstant_cm_K * line.lowerEnergy_per_cm *
                     (1.0 / T - 1.0 / referenceTemperature_K)) *
            std::expm1(-secondRadiationConstant_cm_K * nu / T) /
            std::expm1(-secondRadiationConstant_cm_K * nu / referenceTemperature_K);
        const double width = static_cast<double>(line.airWidth_cm_atm) * (1.0 - path.fraction) +
                             static_cast<double>(line.selfWidth_cm_atm) * path.fraction;
        lines_.push_back(
            {nu, strength * path.column_per_cm2,
             3.581163e-7 * nu * std::sqrt(T / molarMass_g(lines.gas, line.isotopologue)),
             path.pressure_hPa / 1013.25 * width *
                 std::pow(referenceTemperature_K / T, static_cast<double>(line.widthExponent))});
    }
    std::erase_if(lines_, [](const Strong& line) { return line.depth_per_cm < shallow_per_cm; });
    std::ranges::sort(lines_, {}, &Strong::centre_per_cm);
}

double BandModel::bin(int centre_per_cm) const {
    const double lower_per_cm = centre_per_cm - 0.5, upper_per_cm = centre_per_cm + 0.5;
    auto from = [&](double nu) {
        return std::ranges::lower_bound(lines_, nu, {}, &Strong::centre_per_cm);
    };
    const auto first = from(lower_per_cm), last = from(upper_per_cm);

    std::array<double, points> tails{};
    for (auto line = from(lower_per_cm - reach_per_cm); line != from(upper_per_cm + reach_per_cm);
         ++line) {
        if (line == first && first != last) {
            line = last - 1;
            continue;
        }
        const double own = std::floor(line->centre_per_cm + 0.5);
        const double place =
            own + std::clamp(line->centre_per_cm - own, tail_per_cm - 0.5, 0.5 - tail_per_cm);
        VoigtProfile(line->doppler_per_cm, line->lorentz_per_cm)
            .add(lower_per_cm + 0.5 * step_per_cm - place, step_per_cm, points, line->depth_per_cm,
                 tails.data());
    }
    const double beside = meanTransmittance(tails);
    if (first == last) {
        return beside;
    }

    double depth = 0.0, place = 0.0, doppler = 0.0, lorentz = 0.0, root = 0.0;
    for (auto line = first; line != last; ++line) {
        depth += line->depth_per_cm;
        place += line->depth_per_cm * (line->centre_per_cm - lower_per_cm);
        doppler += line->depth_per_cm * line->doppler_per_cm;
        lorentz += line->depth_per_cm * line->lorentz_per_cm;
        double together = line->depth_per_cm;
        for (auto other = first; other != last; ++other) {
            const bool isStronger = other->depth_per_cm > line->depth_per_cm ||
                                    (other->depth_per_cm == line->depth_per_cm && other < line);
            if (!isStronger) {
                continue;
            }
            const double distance = std::abs(other->centre_per_cm - line->centre_per_cm);
            together += other->depth_per_cm * std::max(0.0, 1.0 - distance / together_per_cm);
        }
        root += line->depth_per_cm / std::sqrt(together);
    }
    const double count = root * root / depth;
    std::array<double, points> one{};
    VoigtProfile(doppler / depth, lorentz / depth)
        .add(0.5 * step_per_cm - std::clamp(place / depth, edge_per_cm, 1.0 - edge_per_cm),
             step_per_cm, points, depth / count, one.data());
    return beside * std::pow(meanTransmittance(one), count);
}

double BandModel::at(int centre_per_cm) const {
    double mean = 0.0;
    for (int i = -9; i <= 9; ++i) {
        mean += (1.0 - std::abs(i) / 10.0) / 10.0 * bin(centre_per_cm + i);
    }
    return mean;
}

} // namespace irsg::lbl
