#include "tools/atmosphere-tables/lines/PseudoLines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "tools/atmosphere-tables/lines/RandomNumbers.h"

namespace irsg::lbl {

namespace {

constexpr double step_per_cm = LowtranBands::step_per_cm;
constexpr double modelTemperature_K = 273.15;
constexpr double pressureOfOneAtmosphere_hPa = 1013.25;
constexpr double widestPath_per_cm2 = 1e25; ///< more than any path holds of a gas
constexpr double leastDepth = 1e-3;
constexpr int corrections = 4;

/// K at 296 K.
double coefficientAt296(const BandPoint& point) {
    return point.coefficient_cm2 *
           std::pow(modelTemperature_K / referenceTemperature_K, point.temperatureExponent);
}

/// ln K runs straight from point to point; the nearer point alone counts where the other has none.
double coefficientBetween(const std::vector<BandPoint>& points, std::size_t i, double nu_per_cm) {
    const double own = coefficientAt296(points[i]);
    const bool above = nu_per_cm > points[i].wavenumber_per_cm;
    if (above ? i + 1 >= points.size() : i == 0)
        return own;
    const double other = coefficientAt296(points[above ? i + 1 : i - 1]);
    if (other <= 0.0)
        return own;
    const double part = std::abs(nu_per_cm - points[i].wavenumber_per_cm) / step_per_cm;
    return lerpByRatio(own, other, part);
}

/// E'' for which, at 273 K, absorption follows T^-m as the model's W does: the widths, ~ T^-x,
/// bring T^(-x n), the partition sum T^-1.5 and the Boltzmann factor T^(c2 E'' / T).
double lowerEnergy_per_cm(const BandPoint& point, const PseudoGas& gas) {
    const double slope = static_cast<double>(gas.widthExponent) * point.pressureExponent + 1.5 -
                         point.temperatureExponent;
    return std::max(0.0, modelTemperature_K / secondRadiationConstant_cm_K * slope);
}

/// Mean optical depths around every point over 20 cm-1, cut at the ends of what has been sampled.
class SlidingMean {
  public:
    SlidingMean(const WavenumberGrid& grid, std::span<const double> crossSection_cm2)
        : grid_(grid), crossSection_cm2_(crossSection_cm2) {}

    double opticalDepth(double centre_per_cm, double column_per_cm2) const {
        auto index = [&](double nu_per_cm) {
            return static_cast<std::size_t>(
                std::clamp((nu_per_cm - grid_.first_per_cm) / grid_.step_per_cm, 0.0,
                           static_cast<double>(grid_.count)));
        };
        const std::size_t from = index(centre_per_cm - 10.0), to = index(centre_per_cm + 10.0);
        double sum = 0.0;
        for (std::size_t i = from; i < to; ++i)
            sum += std::exp(-column_per_cm2 * crossSection_cm2_[i]);
        return -std::log(std::max(sum / static_cast<double>(to - from), 1e-12));
    }

  private:
    WavenumberGrid grid_;
    std::span<const double> crossSection_cm2_;
};

} // namespace

PseudoGas pseudoGas(Gas gas) {
    switch (gas) {
    case Gas::H2O:
        return {gas, 0.075f, 0.35f, 0.68f, 11, 5.0, 8, {1.0, 1.0, 0.3}};
    case Gas::O3:
        return {gas, 0.072f, 0.095f, 0.76f, 12, 0.625, 8, {1.0, 0.3, 0.1, 0.03}};
    case Gas::CH4:
        return {gas, 0.055f, 0.075f, 0.75f, 13, 2.5, 10, {1.0, 0.3, 0.1}};
    default:
        throw LogicError("pseudo-lines are made of water, ozone and methane only");
    }
}

std::vector<Line> pseudoLines(const std::vector<BandPoint>& points, const PseudoGas& gas,
                              double lower_per_cm, double upper_per_cm) {
    std::map<std::pair<double, double>, Cell> cells;
    LineList list{gas.gas, {}, {}};
    std::vector<std::size_t> cellOf; ///< of each line, the point
    RandomNumbers random(gas.seed * 1000003 + static_cast<std::uint64_t>(lower_per_cm));

    for (std::size_t i = 0; i < points.size(); ++i) {
        const BandPoint& point = points[i];
        if (point.wavenumber_per_cm + 0.5 * step_per_cm < lower_per_cm ||
            point.wavenumber_per_cm - 0.5 * step_per_cm > upper_per_cm ||
            point.opticalDepth(widestPath_per_cm2, pressureOfOneAtmosphere_hPa,
                               referenceTemperature_K) < leastDepth)
            continue;
        const auto [cell, isNew] =
            cells.try_emplace({point.exponent, point.pressureExponent}, Cell{});
        if (isNew)
            cell->second = fitCell(point.exponent, point.pressureExponent, gas);
        for (double begin_per_cm = 0.0; begin_per_cm < step_per_cm;
             begin_per_cm += gas.cellWidth_per_cm) {
            const double turn_per_cm = gas.cellWidth_per_cm * random.next();
            const bool mirrored = random.next() < 0.5;
            for (const CellLine& part : cell->second.lines) {
                const double place_per_cm =
                    mirrored ? gas.cellWidth_per_cm - part.place_per_cm : part.place_per_cm;
                Line line;
                line.wavenumber_per_cm =
                    point.wavenumber_per_cm - 0.5 * step_per_cm + begin_per_cm +
                    std::fmod(place_per_cm + turn_per_cm, gas.cellWidth_per_cm);
                if (line.wavenumber_per_cm < lower_per_cm || line.wavenumber_per_cm > upper_per_cm)
                    continue;
                line.intensity =
                    part.strength * coefficientBetween(points, i, line.wavenumber_per_cm);
                line.lowerEnergy_per_cm = lowerEnergy_per_cm(point, gas);
                line.airWidth_cm_atm = gas.airWidth_cm_atm;
                line.selfWidth_cm_atm = gas.selfWidth_cm_atm;
                line.widthExponent = gas.widthExponent;
                list.lines.push_back(line);
                cellOf.push_back(i);
            }
        }
    }

    const PartitionSums rotor = PartitionSums::rigidRotor();
    const WavenumberGrid grid{lower_per_cm, 0.02,
                              static_cast<std::size_t>((upper_per_cm - lower_per_cm) / 0.02) + 1};
    for (int round = 0; round < corrections && !list.lines.empty(); ++round) {
        const std::vector<double> cross_cm2 =
            crossSection_cm2(list, rotor, grid, referenceTemperature_K, pressureOfOneAtmosphere_hPa,
                             0.0, defaultLineShape(gas.gas));
        const SlidingMean mean(grid, cross_cm2);
        std::vector<double> factors(points.size(), 1.0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const BandPoint& point = points[i];
            if (point.coefficient_cm2 <= 0.0 || point.wavenumber_per_cm < lower_per_cm ||
                point.wavenumber_per_cm > upper_per_cm)
                continue;
            double sum = 0.0;
            for (const double depth : {0.2, 0.6, 1.5}) {
                const double column =
                    std::pow(depth, 1.0 / point.exponent) / coefficientAt296(point);
                sum += std::log(depth / mean.opticalDepth(point.wavenumber_per_cm, column));
            }
            factors[i] = std::exp(std::clamp(0.6 * sum / 3.0 / point.exponent, -0.5, 0.5));
        }
        for (std::size_t k = 0; k < list.lines.size(); ++k)
            list.lines[k].intensity *= factors[cellOf[k]];
    }
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    return list.lines;
}

} // namespace irsg::lbl
