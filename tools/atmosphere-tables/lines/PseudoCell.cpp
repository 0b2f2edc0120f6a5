#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/atmosphere-tables/lines/PseudoLines.h"
#include "tools/atmosphere-tables/lines/RandomNumbers.h"

namespace irsg::lbl {

namespace {

constexpr std::size_t pointCount = 500;
constexpr int draws = 8, rounds = 40;
constexpr double depths[] = {0.005, 0.015, 0.05, 0.1, 0.2, 0.35, 0.55, 0.8, 1.2, 1.8, 2.8, 4.5};

using Matrix = std::vector<std::vector<double>>;

/// Solves A x = b for a positive definite A (Cholesky).
std::vector<double> solved(Matrix a, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[i][j];
            for (std::size_t k = 0; k < j; ++k)
                sum -= a[i][k] * a[j][k];
            a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / a[j][j];
        }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k)
            b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    return b;
}

/// What the lines of a cell absorb, for one pressure: profile of each line and of all its
/// repetitions, at points over the cell.
struct Profiles {
    std::vector<std::vector<double>> values; ///< [line][point], per cm-1
    std::vector<double> columns, targets;
};

Profiles profilesOf(const std::vector<double>& places_per_cm, const PseudoGas& gas,
                    double pressure_atm, double exponent, double pressureExponent) {
    const LineShape shape = defaultLineShape(gas.gas);
    const double width_per_cm = static_cast<double>(gas.airWidth_cm_atm) * pressure_atm;
    auto lorentz = [&](double x) {
        return width_per_cm / std::numbers::pi / (x * x + width_per_cm * width_per_cm);
    };
    const double pedestal = shape.removePedestal ? lorentz(shape.cut_per_cm) : 0.0;
    const int repetitions =
        static_cast<int>(std::ceil(shape.cut_per_cm / gas.cellWidth_per_cm)) + 1;
    Profiles profiles;
    for (const double place_per_cm : places_per_cm) {
        std::vector<double> values(pointCount, 0.0);
        for (std::size_t i = 0; i < pointCount; ++i)
            for (int k = -repetitions; k <= repetitions; ++k) {
                const double x =
                    gas.cellWidth_per_cm * (static_cast<double>(i) / pointCount + k) - place_per_cm;
                if (std::abs(x) <= shape.cut_per_cm)
                    values[i] += lorentz(x) - pedestal;
            }
        profiles.values.push_back(std::move(values));
    }
    for (const double depth : depths) {
        profiles.columns.push_back(std::pow(depth, 1.0 / exponent) /
                                   std::pow(pressure_atm, pressureExponent));
        profiles.targets.push_back(std::exp(-depth));
    }
    return profiles;
}

/// Sum of the squares of the errors; with `gradient` also the normal equations for changes of ln
/// strength.
double squares(const std::vector<Profiles>& all, const std::vector<double>& logStrengths,
               Matrix* normal, std::vector<double>* gradient) {
    const std::size_t n = logStrengths.size();
    double sum = 0.0;
    for (const Profiles& profiles : all) {
        std::vector<double> absorption(pointCount, 0.0);
        std::vector<std::vector<double>> parts = profiles.values;
        for (std::size_t k = 0; k < n; ++k) {
            const double strength = std::exp(logStrengths[k]);
            for (std::size_t i = 0; i < pointCount; ++i) {
                parts[k][i] *= strength;
                absorption[i] += parts[k][i];
            }
        }
        for (std::size_t j = 0; j < profiles.columns.size(); ++j) {
            const double column = profiles.columns[j];
            std::vector<double> transmittance(pointCount);
            double mean = 0.0;
            for (std::size_t i = 0; i < pointCount; ++i) {
                transmittance[i] = std::exp(-column * absorption[i]) / pointCount;
                mean += transmittance[i];
            }
            const double error = mean - profiles.targets[j];
            sum += error * error;
            if (!normal)
                continue;
            std::vector<double> slope(n, 0.0);
            for (std::size_t k = 0; k < n; ++k) {
                for (std::size_t i = 0; i < pointCount; ++i)
                    slope[k] += parts[k][i] * transmittance[i];
                slope[k] *= -column;
            }
            for (std::size_t k = 0; k < n; ++k) {
                (*gradient)[k] -= slope[k] * error;
                for (std::size_t l = 0; l <= k; ++l)
                    (*normal)[k][l] += slope[k] * slope[l];
            }
        }
    }
    return sum;
}

/// Levenberg and Marquardt's way downhill from the given strengths.
double improve(const std::vector<Profiles>& all, std::vector<double>& logStrengths) {
    const std::size_t n = logStrengths.size();
    double damping = 1e-2, best = squares(all, logStrengths, nullptr, nullptr);
    for (int round = 0; round < rounds && damping < 1e6; ++round) {
        Matrix normal(n, std::vector<double>(n, 0.0));
        std::vector<double> gradient(n, 0.0);
        squares(all, logStrengths, &normal, &gradient);
        for (std::size_t k = 0; k < n; ++k)
            normal[k][k] += damping * (normal[k][k] + 1e-6);
        const std::vector<double> change = solved(std::move(normal), std::move(gradient));
        std::vector<double> tried = logStrengths;
        for (std::size_t k = 0; k < n; ++k)
            tried[k] += std::clamp(change[k], -1.5, 1.5);
        const double value = squares(all, tried, nullptr, nullptr);
        if (value < best) {
            best = value;
            logStrengths = std::move(tried);
            damping *= 0.3;
        } else {
            damping *= 5.0;
        }
    }
    return best;
}

} // namespace

Cell fitCell(double exponent, double pressureExponent, const PseudoGas& gas) {
    const double width_per_cm = static_cast<double>(gas.airWidth_cm_atm);
    RandomNumbers random(gas.seed);
    Cell cell;
    double best = 1e300;
    for (int draw = 0; draw < draws; ++draw) {
        std::vector<double> places_per_cm, logStrengths;
        for (std::size_t k = 0; k < gas.linesInCell; ++k) {
            places_per_cm.push_back(gas.cellWidth_per_cm * random.next());
            // One strong line closes the cell at K u = 1, the others are weaker, down to 1e-3.
            logStrengths.push_back(
                std::log(0.5 * gas.cellWidth_per_cm * gas.cellWidth_per_cm / width_per_cm) -
                6.9 * (static_cast<double>(k) + 0.5) / static_cast<double>(gas.linesInCell));
        }
        std::vector<Profiles> all;
        for (const double pressure_atm : gas.pressures_atm)
            all.push_back(profilesOf(places_per_cm, gas, pressure_atm, exponent, pressureExponent));
        const double value = improve(all, logStrengths);
        if (value >= best)
            continue;
        best = value;
        cell.lines.clear();
        for (std::size_t k = 0; k < gas.linesInCell; ++k)
            cell.lines.push_back({places_per_cm[k], std::exp(logStrengths[k])});
        cell.rmsError =
            std::sqrt(value / static_cast<double>(std::size(depths) * gas.pressures_atm.size()));
    }
    return cell;
}

} // namespace irsg::lbl
