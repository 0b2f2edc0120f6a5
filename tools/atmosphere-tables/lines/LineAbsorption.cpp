#include "tools/atmosphere-tables/lines/LineAbsorption.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/Voigt.h"

namespace irsg::lbl {

namespace {

constexpr double pressureOfOneAtmosphere_hPa = 1013.25;

/// Perrin and Hartmann's chi of CO2 in N2 at one temperature: exponentials that follow one another.
class WingFactor {
  public:
    struct Segment {
        double start_per_cm, value, rate; ///< value exp(-rate (x - start))
        double at(double x_per_cm) const {
            return value * std::exp(-rate * (x_per_cm - start_per_cm));
        }
    };

    explicit WingFactor(double temperature_K) {
        const double b1 = 0.416 - 0.354 * std::exp(-0.00386 * temperature_K);
        const double b2 = 0.00167 + 0.0421 * std::exp(-0.00248 * temperature_K);
        segments_[0] = {0.0, 1.0, 0.0};
        segments_[1] = {3.0, 1.0, b1};
        segments_[2] = {10.0, segments_[1].at(10.0), b2};
        segments_[3] = {70.0, segments_[2].at(70.0), 0.0200};
    }
    const Segment& segment(double x_per_cm) const {
        return segments_[(x_per_cm > 3.0) + (x_per_cm > 10.0) + (x_per_cm > 70.0)];
    }

  private:
    std::array<Segment, 4> segments_;
};

/// A line as it is at one temperature and pressure.
struct LineNow {
    double centre_per_cm, intensity;
    VoigtProfile profile;
    double pedestal;
};

/// A smooth even function that takes over from the shape inside a radius r: the polynomial in
/// u = (x / r)^2 through the shape at five places about the seam, u = 0.9 to 1.1. A wing of 1 / u
/// leaves it by less than 1e-6 there, so that value and derivatives go on across the seam.
struct Cap {
    double perSquare = 0.0; ///< 1 / r^2
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0, e = 0.0;

    /// x / r where the polynomial goes through the shape: the roots of u = 0.9, 0.95, ... 1.1.
    static constexpr std::array<double, 5> places = {0.94868329805051381, 0.97467943448089633, 1.0,
                                                     1.0246950765959599, 1.0488088481701516};
    Cap(double radius, const std::array<double, 5>& v) : perSquare(1.0 / (radius * radius)) {
        // Stirling's formula about the middle place, in powers of u - 1.
        constexpr double h = 0.05;
        const double first = (8.0 * (v[3] - v[1]) - (v[4] - v[0])) / (12.0 * h);
        const double second = (16.0 * (v[3] + v[1]) - (v[4] + v[0]) - 30.0 * v[2]) / (24.0 * h * h);
        const double third = (v[4] - v[0] - 2.0 * (v[3] - v[1])) / (12.0 * h * h * h);
        const double fourth =
            (v[4] + v[0] - 4.0 * (v[3] + v[1]) + 6.0 * v[2]) / (24.0 * h * h * h * h);
        a = v[2];
        b = first;
        c = second;
        d = third;
        e = fourth;
    }
    double at(double x) const {
        const double t = x * x * perSquare - 1.0;
        return a + t * (b + t * (c + t * (d + t * e)));
    }
};

/// Grids of the spectrum, each four times as coarse as the one before. A line is a sum of smooth
/// functions: on every level what is left of it inside that level's radius once the coarser level's
/// smooth cap is taken away. So a line costs about a hundred points a level, not one a fine point.
class Pyramid {
  public:
    Pyramid(const WavenumberGrid& grid, const LineShape& shape, double temperature_K)
        : grid_(grid), shape_(shape), wings_(temperature_K) {
        double step = grid.step_per_cm;
        for (;;) {
            Level level;
            level.step_per_cm = step;
            level.radius_per_cm = capRatio * 4.0 * step;
            const double span = grid.step_per_cm * static_cast<double>(grid.count - 1);
            level.count = static_cast<std::size_t>(std::ceil(span / step)) + 2 * margin + 2;
            level.sum.assign(level.count, 0.0);
            levels_.push_back(std::move(level));
            if (2.5 * levels_.back().radius_per_cm >= shape.cut_per_cm)
                break;
            step *= 4.0;
        }
        levels_.back().radius_per_cm = shape.cut_per_cm;
    }

    void add(const LineNow& line) {
        for (std::size_t j = 0; j < levels_.size(); ++j) {
            const Level& level = levels_[j];
            const double first_per_cm = grid_.first_per_cm - margin * level.step_per_cm;
            const double low =
                (line.centre_per_cm - level.radius_per_cm - first_per_cm) / level.step_per_cm;
            const double high =
                (line.centre_per_cm + level.radius_per_cm - first_per_cm) / level.step_per_cm;
            if (high < 0.0 || low > static_cast<double>(level.count - 1))
                continue;
            const auto begin = static_cast<std::size_t>(std::max(0.0, std::ceil(low)));
            const auto end = static_cast<std::size_t>(
                std::min(static_cast<double>(level.count - 1), std::floor(high)) + 1.0);
            if (begin < end)
                addLevel(j, line, begin, end);
        }
    }

    /// Everything on the fine grid.
    std::vector<double> sum() {
        // Lagrange's weights for 1/4, 1/2 and 3/4 of the way between the third and the fourth of
        // six points.
        constexpr std::array<std::array<double, 6>, 4> weights = {
            {{0.0, 0.0, 1.0, 0.0, 0.0, 0.0},
             {77.0 / 8192.0, -693.0 / 8192.0, 6930.0 / 8192.0, 2310.0 / 8192.0, -495.0 / 8192.0,
              63.0 / 8192.0},
             {3.0 / 256.0, -25.0 / 256.0, 150.0 / 256.0, 150.0 / 256.0, -25.0 / 256.0, 3.0 / 256.0},
             {63.0 / 8192.0, -495.0 / 8192.0, 2310.0 / 8192.0, 6930.0 / 8192.0, -693.0 / 8192.0,
              77.0 / 8192.0}}};
        for (std::size_t j = levels_.size() - 1; j > 0; --j) {
            const std::vector<double>& coarse = levels_[j].sum;
            std::vector<double>& fine = levels_[j - 1].sum;
            // Point i of a level lies (i - margin) steps from the grid's first point; the margin of
            // four steps is one of the coarser level's, so that i / 4 + 3 is the place there.
            for (std::size_t i = 0; i < fine.size(); ++i) {
                const double* const from = coarse.data() + i / 4 + margin - 1 - 2;
                const std::array<double, 6>& weight = weights[i % 4];
                fine[i] += weight[0] * from[0] + weight[1] * from[1] + weight[2] * from[2] +
                           weight[3] * from[3] + weight[4] * from[4] + weight[5] * from[5];
            }
        }
        const auto begin = levels_[0].sum.begin() + margin;
        return {begin, begin + static_cast<std::ptrdiff_t>(grid_.count)};
    }

  private:
    static constexpr std::size_t margin = 4;
    static constexpr double capRatio = 12.0;

    struct Level {
        double step_per_cm = 0.0, radius_per_cm = 0.0;
        std::size_t count = 0;
        std::vector<double> sum;
    };

    Cap capOf(std::size_t level, const LineNow& line) const {
        const double radius = levels_[level].radius_per_cm;
        const WingFactor::Segment& segment = wings_.segment(radius);
        std::array<double, 5> values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double x = radius * Cap::places[i];
            values[i] = line.profile.at(x);
            // A corner of chi close to the seam must not bend the polynomial.
            if (shape_.carbonDioxideWings)
                values[i] *= segment.at(x);
            values[i] -= line.pedestal;
        }
        return {radius, values};
    }

    /// On level j: the shape outside the radius of the finer level, its cap inside, less the cap of
    /// this level (there is none on the coarsest).
    void addLevel(std::size_t j, const LineNow& line, std::size_t begin, std::size_t end) {
        Level& level = levels_[j];
        const double step_per_cm = level.step_per_cm;
        const std::size_t count = end - begin;
        const double from_per_cm =
            grid_.first_per_cm - line.centre_per_cm +
            step_per_cm * (static_cast<double>(begin) - static_cast<double>(margin));
        auto place = [&](std::size_t i) {
            return from_per_cm + step_per_cm * static_cast<double>(i);
        };
        values_.assign(count, -line.pedestal);

        // The finer level's share, i in [innerBegin, innerEnd), is its cap here.
        std::size_t innerBegin = count, innerEnd = count;
        if (j > 0) {
            const double radius = levels_[j - 1].radius_per_cm, most = static_cast<double>(count);
            innerBegin = static_cast<std::size_t>(
                std::clamp(std::ceil((-radius - from_per_cm) / step_per_cm), 0.0, most));
            innerEnd = static_cast<std::size_t>(
                std::clamp(std::floor((radius - from_per_cm) / step_per_cm) + 1.0, 0.0, most));
            innerEnd = std::max(innerBegin, innerEnd);
            const Cap inner = capOf(j - 1, line);
            for (std::size_t i = innerBegin; i < innerEnd; ++i)
                values_[i] = inner.at(place(i));
        }
        auto shapeOn = [&](std::size_t first, std::size_t last) {
            if (first == last)
                return;
            line.profile.add(place(first), step_per_cm, last - first, 1.0, values_.data() + first);
            if (!shape_.carbonDioxideWings)
                return;
            for (std::size_t i = first; i < last; ++i) {
                const double x = std::abs(place(i));
                values_[i] = (values_[i] + line.pedestal) * wings_.segment(x).at(x) - line.pedestal;
            }
        };
        shapeOn(0, innerBegin);
        shapeOn(innerEnd, count);

        double* sum = level.sum.data() + begin;
        if (j + 1 < levels_.size()) {
            const Cap outer = capOf(j, line);
            for (std::size_t i = 0; i < count; ++i)
                sum[i] += line.intensity * (values_[i] - outer.at(place(i)));
        } else {
            for (std::size_t i = 0; i < count; ++i)
                sum[i] += line.intensity * values_[i];
        }
    }

    WavenumberGrid grid_;
    LineShape shape_;
    WingFactor wings_;
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

double carbonDioxideChi(double distance_per_cm, double temperature_K) {
    const double x = std::abs(distance_per_cm);
    return WingFactor(temperature_K).segment(x).at(x);
}

std::vector<double> crossSection_cm2(const LineList& lines, const PartitionSums& partition,
                                     const WavenumberGrid& grid, double temperature_K,
                                     double pressure_hPa, double moleFraction,
                                     const LineShape& shape, double weakest_cm2) {
    if (grid.count == 0 || !(grid.step_per_cm > 0.0) || !(temperature_K > 0.0) ||
        !(pressure_hPa > 0.0))
        throw LogicError("absorption was asked for without a grid, a temperature or a pressure");
    Pyramid pyramid(grid, shape, temperature_K);
    const double pressure_atm = pressure_hPa / pressureOfOneAtmosphere_hPa;
    const double cooler = 1.0 / temperature_K - 1.0 / referenceTemperature_K;

    for (const Line& line : lines.lines) {
        const double nu = line.wavenumber_per_cm;
        if (nu < grid.first_per_cm - shape.cut_per_cm - 1.0 ||
            nu > grid.last_per_cm() + shape.cut_per_cm + 1.0)
            continue;
        const double intensity =
            line.intensity * partition.ratioTo296(lines.gas, line.isotopologue, temperature_K) *
            std::exp(-secondRadiationConstant_cm_K * line.lowerEnergy_per_cm * cooler) *
            std::expm1(-secondRadiationConstant_cm_K * nu / temperature_K) /
            std::expm1(-secondRadiationConstant_cm_K * nu / referenceTemperature_K);
        const double doppler_per_cm =
            3.581163e-7 * nu * std::sqrt(temperature_K / molarMass_g(lines.gas, line.isotopologue));
        const double lorentz_per_cm =
            pressure_atm *
            (static_cast<double>(line.airWidth_cm_atm) * (1.0 - moleFraction) +
             static_cast<double>(line.selfWidth_cm_atm) * moleFraction) *
            std::pow(referenceTemperature_K / temperature_K,
                     static_cast<double>(line.widthExponent));
        LineNow now{nu + pressure_atm * static_cast<double>(line.airShift_cm_atm), intensity,
                    VoigtProfile(doppler_per_cm, lorentz_per_cm), 0.0};
        if (weakest_cm2 > 0.0 && intensity * now.profile.at(0.0) < weakest_cm2)
            continue;
        if (shape.removePedestal)
            now.pedestal = now.profile.at(shape.cut_per_cm);
        pyramid.add(now);
    }
    std::vector<double> cross_cm2 = pyramid.sum();
    for (double& value : cross_cm2)
        value = std::max(value, 0.0);
    return cross_cm2;
}

} // namespace irsg::lbl
