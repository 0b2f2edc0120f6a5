#include "irsg/atmosphere/lbl/LineAbsorption.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/atmosphere/lbl/Voigt.h"
#include "irsg/radiometry/Errors.h"

namespace irsg::lbl {

namespace {

constexpr double secondRadiationConstant_cm_K = 1.438776877;
constexpr double referenceTemperature_K = 296.0;
constexpr double pressureOfOneAtmosphere_hPa = 1013.25;

/// A line as it is at one temperature and pressure.
struct LineNow {
    double centre_cm, intensity;
    VoigtProfile profile;
    double pedestal;
};

/// Its shape: Voigt, sub-Lorentzian or on a pedestal, nothing beyond the cut.
double shapeAt(const LineNow& line, double distance_cm, const LineShape& shape,
               double temperature_K) {
    const double away_cm = std::abs(distance_cm);
    if (away_cm > shape.cut_cm)
        return 0.0;
    double value = line.profile.at(away_cm);
    if (shape.carbonDioxideWings)
        value *= carbonDioxideChi(away_cm, temperature_K);
    return value - line.pedestal;
}

/// An even polynomial a + b x^2 + c x^4 that takes over from the shape inside a radius, with the
/// shape's value, slope and curvature there.
struct Cap {
    double a = 0.0, b = 0.0, c = 0.0;

    Cap(double radius, double value, double slope, double curvature) {
        const double perRadius = slope / radius; // 2 b + 4 c r^2
        c = (curvature - perRadius) / (8.0 * radius * radius);
        b = 0.5 * perRadius - 2.0 * c * radius * radius;
        a = value - b * radius * radius - c * radius * radius * radius * radius;
    }
    double at(double x) const { return a + x * x * (b + x * x * c); }
};

/// Grids of the spectrum, each four times as coarse as the one before. A line is a sum of smooth
/// functions: on every level what is left of it inside that level's radius once the coarser level's
/// smooth cap is taken away. So a line costs about a hundred points a level, not one a fine point.
class Pyramid {
  public:
    Pyramid(const WavenumberGrid& grid, double reach_cm) : grid_(grid) {
        double step = grid.step_cm;
        for (;;) {
            Level level;
            level.step_cm = step;
            level.radius_cm = capRatio * 4.0 * step;
            const double span = grid.step_cm * static_cast<double>(grid.count - 1);
            level.count = static_cast<std::size_t>(std::ceil(span / step)) + 2 * margin + 2;
            level.sum.assign(level.count, 0.0);
            levels_.push_back(std::move(level));
            if (levels_.back().radius_cm >= reach_cm)
                break;
            step *= 4.0;
        }
        levels_.back().radius_cm = reach_cm;
    }

    void add(const LineNow& line, const LineShape& shape, double temperature_K) {
        for (std::size_t j = 0; j < levels_.size(); ++j) {
            Level& level = levels_[j];
            const double first_cm = grid_.first_cm - margin * level.step_cm;
            const double low = (line.centre_cm - level.radius_cm - first_cm) / level.step_cm;
            const double high = (line.centre_cm + level.radius_cm - first_cm) / level.step_cm;
            if (high < 0.0 || low > static_cast<double>(level.count - 1))
                continue;
            const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil(low)));
            const auto end = static_cast<std::size_t>(
                std::min(static_cast<double>(level.count - 1), std::floor(high)) + 1.0);
            if (begin >= end)
                continue;
            const double from_cm =
                first_cm + level.step_cm * static_cast<double>(begin) - line.centre_cm;
            addLevel(j, line, shape, temperature_K, from_cm, begin, end);
        }
    }

    /// Everything on the fine grid.
    std::vector<double> sum() {
        for (std::size_t j = levels_.size() - 1; j > 0; --j) {
            const std::vector<double>& coarse = levels_[j].sum;
            std::vector<double>& fine = levels_[j - 1].sum;
            // Point i of a level lies (i - margin) steps from the grid's first point.
            for (std::size_t i = 0; i < fine.size(); ++i) {
                const double place = margin + (static_cast<double>(i) - margin) / 4.0;
                const auto k =
                    std::clamp<std::size_t>(static_cast<std::size_t>(place), 1, coarse.size() - 3);
                const double t = place - static_cast<double>(k);
                fine[i] += coarse[k - 1] * (-t * (t - 1.0) * (t - 2.0) / 6.0) +
                           coarse[k] * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
                           coarse[k + 1] * (-(t + 1.0) * t * (t - 2.0) / 2.0) +
                           coarse[k + 2] * ((t + 1.0) * t * (t - 1.0) / 6.0);
            }
        }
        const auto begin = levels_[0].sum.begin() + margin;
        return {begin, begin + static_cast<std::ptrdiff_t>(grid_.count)};
    }

  private:
    static constexpr int margin = 3;
    static constexpr double capRatio = 12.0;

    struct Level {
        double step_cm = 0.0, radius_cm = 0.0;
        std::size_t count = 0;
        std::vector<double> sum;
    };

    Cap capOf(std::size_t level, const LineNow& line, const LineShape& shape,
              double temperature_K) const {
        const double radius = levels_[level].radius_cm, d = 0.02 * radius;
        const double below = shapeAt(line, radius - d, shape, temperature_K);
        const double here = shapeAt(line, radius, shape, temperature_K);
        const double above = shapeAt(line, radius + d, shape, temperature_K);
        return {radius, here, (above - below) / (2.0 * d), (above - 2.0 * here + below) / (d * d)};
    }

    /// On level j: the shape outside the radius of the finer level, its cap inside, less the cap of
    /// this level (there is none on the coarsest).
    void addLevel(std::size_t j, const LineNow& line, const LineShape& shape, double temperature_K,
                  double from_cm, std::size_t begin, std::size_t end) {
        Level& level = levels_[j];
        const std::size_t count = end - begin;
        double* sum = level.sum.data() + begin;
        values_.assign(count, -line.pedestal);
        line.profile.add(from_cm, level.step_cm, count, 1.0, values_.data());
        if (shape.carbonDioxideWings)
            for (std::size_t i = 0; i < count; ++i)
                values_[i] *= carbonDioxideChi(
                    std::abs(from_cm + level.step_cm * static_cast<double>(i)), temperature_K);
        if (j > 0) {
            const Cap inner = capOf(j - 1, line, shape, temperature_K);
            const double radius = levels_[j - 1].radius_cm;
            for (std::size_t i = 0; i < count; ++i) {
                const double x = from_cm + level.step_cm * static_cast<double>(i);
                if (std::abs(x) < radius)
                    values_[i] = inner.at(x);
            }
        }
        if (j + 1 < levels_.size()) {
            const Cap outer = capOf(j, line, shape, temperature_K);
            for (std::size_t i = 0; i < count; ++i)
                values_[i] -= outer.at(from_cm + level.step_cm * static_cast<double>(i));
        }
        for (std::size_t i = 0; i < count; ++i)
            sum[i] += line.intensity * values_[i];
    }

    WavenumberGrid grid_;
    std::vector<Level> levels_;
    std::vector<double> values_;
};

} // namespace

LineShape defaultLineShape(Gas gas) {
    if (gas == Gas::H2O)
        return {25.0, true, false};
    if (gas == Gas::CO2)
        return {300.0, false, true};
    return {25.0, false, false};
}

double negligible_cm2(Gas gas) {
    // 1e-5 / (largest number density, cm-3, times 2e7 cm).
    constexpr std::array<double, lineGasCount> limits = {7e-31, 5e-29, 3e-26, 6e-26,
                                                         1e-25, 1e-26, 1e-31};
    return limits[static_cast<std::size_t>(gas)];
}

double carbonDioxideChi(double distance_cm, double temperature_K) {
    const double x = std::abs(distance_cm);
    if (x <= 3.0)
        return 1.0;
    const double b1 = 0.416 - 0.354 * std::exp(-0.00386 * temperature_K);
    if (x <= 10.0)
        return std::exp(-b1 * (x - 3.0));
    const double b2 = 0.00167 + 0.0421 * std::exp(-0.00248 * temperature_K);
    if (x <= 70.0)
        return std::exp(-7.0 * b1 - b2 * (x - 10.0));
    return std::exp(-7.0 * b1 - 60.0 * b2 - 0.0200 * (x - 70.0));
}

std::vector<double> crossSection_cm2(const LineList& lines, const PartitionSums& partition,
                                     const WavenumberGrid& grid, double temperature_K,
                                     double pressure_hPa, double moleFraction,
                                     const LineShape& shape, double weakest_cm2) {
    if (grid.count == 0 || !(grid.step_cm > 0.0) || !(temperature_K > 0.0) || !(pressure_hPa > 0.0))
        throw LogicError("absorption was asked for without a grid, a temperature or a pressure");
    Pyramid pyramid(grid, shape.cut_cm);
    const double pressure_atm = pressure_hPa / pressureOfOneAtmosphere_hPa;
    const double cooler = 1.0 / temperature_K - 1.0 / referenceTemperature_K;

    for (const Line& line : lines.lines) {
        const double nu = line.wavenumber_cm;
        if (nu < grid.first_cm - shape.cut_cm - 1.0 || nu > grid.last_cm() + shape.cut_cm + 1.0)
            continue;
        const double intensity =
            line.intensity * partition.ratioTo296(lines.gas, line.isotopologue, temperature_K) *
            std::exp(-secondRadiationConstant_cm_K * line.lowerEnergy_cm * cooler) *
            std::expm1(-secondRadiationConstant_cm_K * nu / temperature_K) /
            std::expm1(-secondRadiationConstant_cm_K * nu / referenceTemperature_K);
        const double doppler_cm =
            3.581163e-7 * nu * std::sqrt(temperature_K / molarMass_g(lines.gas, line.isotopologue));
        const double lorentz_cm =
            pressure_atm *
            (static_cast<double>(line.airWidth_cm_atm) * (1.0 - moleFraction) +
             static_cast<double>(line.selfWidth_cm_atm) * moleFraction) *
            std::pow(referenceTemperature_K / temperature_K,
                     static_cast<double>(line.widthExponent));
        LineNow now{nu + pressure_atm * static_cast<double>(line.airShift_cm_atm), intensity,
                    VoigtProfile(doppler_cm, lorentz_cm), 0.0};
        if (weakest_cm2 > 0.0 && intensity * now.profile.at(0.0) < weakest_cm2)
            continue;
        if (shape.removePedestal)
            now.pedestal = now.profile.at(shape.cut_cm);
        pyramid.add(now, shape, temperature_K);
    }
    std::vector<double> cross_cm2 = pyramid.sum();
    for (double& value : cross_cm2)
        value = std::max(value, 0.0);
    return cross_cm2;
}

} // namespace irsg::lbl
