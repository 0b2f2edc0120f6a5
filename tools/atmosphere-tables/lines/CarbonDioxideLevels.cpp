#include "tools/atmosphere-tables/lines/CarbonDioxideLevels.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/CsvTable.h"

namespace irsg::lbl {

namespace {

constexpr std::size_t fewestLevels = 8;
constexpr std::size_t largestM = 120;

/// Solves the normal equations of a polynomial with `terms` coefficients in x.
std::array<double, 4> polynomial(const std::vector<std::pair<double, double>>& points,
                                 std::size_t terms) {
    std::array<std::array<long double, 5>, 4> a{};
    for (const auto& [x, y] : points) {
        std::array<long double, 4> power{1.0L};
        for (std::size_t i = 1; i < terms; ++i)
            power[i] = power[i - 1] * x;
        for (std::size_t i = 0; i < terms; ++i) {
            for (std::size_t j = 0; j < terms; ++j)
                a[i][j] += power[i] * power[j];
            a[i][4] += power[i] * y;
        }
    }
    for (std::size_t i = 0; i < terms; ++i)
        for (std::size_t k = 0; k < terms; ++k) {
            if (k == i)
                continue;
            const long double factor = a[k][i] / a[i][i]; // positive definite: no pivots needed
            for (std::size_t j = i; j < 5; ++j)
                a[k][j] -= factor * a[i][j];
        }
    std::array<double, 4> solution{};
    for (std::size_t i = 0; i < terms; ++i)
        solution[i] = static_cast<double>(a[i][4] / a[i][i]);
    return solution;
}

/// X = J (J + 1) in units in which the polynomial is well conditioned.
double scaled(int J) {
    return 1e-3 * static_cast<double>(J) * static_cast<double>(J + 1);
}

/// What a record says of its transition.
struct Assignment {
    int isotopologue, J;
    char branch, symmetry;
    std::string upper, lower;
    double wavenumber_per_cm, lowerEnergy_per_cm;
    WidthOfM widths;
};

std::string withoutBlanks(std::string_view text) {
    std::string result;
    std::ranges::copy_if(text, std::back_inserter(result), [](char c) { return c != ' '; });
    return result;
}

std::optional<Assignment> assignmentOf(const std::string& record) {
    if (record.size() < 122)
        return std::nullopt;
    const std::string_view text(record);
    auto number = [&](std::size_t first, std::size_t length) {
        return parseNumber(trimmed(text.substr(first, length)));
    };
    Assignment line{record[2] - '0',
                    0,
                    record[117],
                    record[121],
                    withoutBlanks(text.substr(67, 15)),
                    withoutBlanks(text.substr(82, 15)),
                    0.0,
                    0.0,
                    {}};
    const auto J = number(118, 3), wavenumber = number(3, 12), energy = number(45, 10),
               air = number(35, 5), self = number(40, 5), exponent = number(55, 4),
               shift = number(59, 8);
    if (!J || !wavenumber || !energy || !air || !self || !exponent || !shift ||
        line.upper.size() != 5 || line.lower.size() != 5 || line.isotopologue < 1 ||
        line.isotopologue > 9 || (line.branch != 'P' && line.branch != 'Q' && line.branch != 'R') ||
        (line.symmetry != 'e' && line.symmetry != 'f'))
        return std::nullopt;
    line.J = static_cast<int>(*J);
    line.wavenumber_per_cm = *wavenumber;
    line.lowerEnergy_per_cm = *energy;
    line.widths = {*air, *self, *exponent, *shift};
    return line;
}

} // namespace

void WidthOfM::applyTo(Line& line) const {
    line.airWidth_cm_atm = static_cast<float>(airWidth_cm_atm);
    line.selfWidth_cm_atm = static_cast<float>(selfWidth_cm_atm);
    line.widthExponent = static_cast<float>(widthExponent);
    line.airShift_cm_atm = static_cast<float>(airShift_cm_atm);
}

std::optional<RotationalTerm> RotationalTerm::fit(const std::map<int, double>& energies_per_cm) {
    std::vector<std::pair<double, double>> points;
    for (const auto& [J, energy_per_cm] : energies_per_cm)
        points.emplace_back(scaled(J), energy_per_cm);
    RotationalTerm term;
    for (int round = 0; round < 2; ++round) {
        if (points.size() < fewestLevels)
            return std::nullopt;
        term.coefficients_ = polynomial(points, points.size() < 15 ? 3 : 4);
        term.highestJ_ = energies_per_cm.rbegin()->first;
        auto error_per_cm = [&](const std::pair<double, double>& point) {
            double value = 0.0;
            for (std::size_t i = 4; i-- > 0;)
                value = value * point.first + term.coefficients_[i];
            return std::abs(value - point.second);
        };
        std::vector<double> errors_per_cm;
        double squares = 0.0;
        for (const auto& point : points) {
            errors_per_cm.push_back(error_per_cm(point));
            squares += errors_per_cm.back() * errors_per_cm.back();
        }
        term.residual_per_cm_ = std::sqrt(squares / static_cast<double>(points.size()));
        std::ranges::nth_element(errors_per_cm,
                                 errors_per_cm.begin() +
                                     static_cast<std::ptrdiff_t>(errors_per_cm.size() / 2));
        const double limit_per_cm = std::max(0.05, 6.0 * errors_per_cm[errors_per_cm.size() / 2]);
        if (std::erase_if(points, [&](const auto& p) { return error_per_cm(p) > limit_per_cm; }) ==
            0)
            break;
    }
    return term;
}

double RotationalTerm::energy_per_cm(int J) const {
    const double x = scaled(J);
    double value = 0.0;
    for (std::size_t i = coefficients_.size(); i-- > 0;)
        value = value * x + coefficients_[i];
    return value;
}

CarbonDioxideLevels::CarbonDioxideLevels(const std::vector<std::string>& records,
                                         const std::string& file) {
    std::map<std::tuple<int, std::string, char>, std::map<int, double>> levels;
    std::vector<std::size_t> counts(largestM + 1, 0);
    widths_.resize(largestM + 1);
    std::size_t assigned = 0;
    for (const std::string& record : records) {
        const auto line = assignmentOf(record);
        if (!line)
            continue;
        ++assigned;
        const int step = line->branch == 'P' ? -1 : line->branch == 'R' ? 1 : 0;
        const char other = line->symmetry == 'e' ? 'f' : 'e';
        levels[{line->isotopologue, line->lower, line->symmetry}].try_emplace(
            line->J, line->lowerEnergy_per_cm);
        levels[{line->isotopologue, line->upper, step == 0 ? other : line->symmetry}].try_emplace(
            line->J + step, line->lowerEnergy_per_cm + line->wavenumber_per_cm);

        const auto m = static_cast<std::size_t>(step == 1 ? line->J + 1 : line->J);
        if (m > largestM)
            continue;
        ++counts[m];
        widths_[m].airWidth_cm_atm += line->widths.airWidth_cm_atm;
        widths_[m].selfWidth_cm_atm += line->widths.selfWidth_cm_atm;
        widths_[m].widthExponent += line->widths.widthExponent;
        widths_[m].airShift_cm_atm += line->widths.airShift_cm_atm;
    }
    if (assigned < 100)
        throw InputError(Diagnostic{file, "", std::to_string(assigned) + " assigned lines",
                                    "records with quanta of CO2"});
    for (const auto& [key, energies_per_cm] : levels)
        if (const auto term = RotationalTerm::fit(energies_per_cm))
            terms_.emplace(key, *term);

    // A mean for each |m|; where there is no line, that of the next smaller (of the first, at 0).
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(counts, [](std::size_t c) { return c > 0; }) - counts.begin());
    for (std::size_t m = first; m <= largestM; ++m) {
        if (counts[m] == 0) {
            widths_[m] = widths_[m - 1];
            continue;
        }
        const auto count = static_cast<double>(counts[m]);
        widths_[m].airWidth_cm_atm /= count;
        widths_[m].selfWidth_cm_atm /= count;
        widths_[m].widthExponent /= count;
        widths_[m].airShift_cm_atm /= count;
    }
    for (std::size_t m = 0; m < first; ++m)
        widths_[m] = widths_[first];
}

const RotationalTerm* CarbonDioxideLevels::term(int isotopologue, const std::string& state,
                                                char symmetry) const {
    const auto found = terms_.find({isotopologue, state, symmetry});
    return found == terms_.end() ? nullptr : &found->second;
}

WidthOfM CarbonDioxideLevels::widths(int m) const {
    return widths_[std::min(static_cast<std::size_t>(std::abs(m)), largestM)];
}

} // namespace irsg::lbl
