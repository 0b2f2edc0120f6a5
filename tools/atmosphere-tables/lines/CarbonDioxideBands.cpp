#include "tools/atmosphere-tables/lines/CarbonDioxideBands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "irsg/core/CsvTable.h"

namespace irsg::lbl {

namespace {

constexpr int levelsBeyondKnown = 16;

/// 16O12C16O, 16O13C16O, 18O12C18O: half of their levels do not exist.
bool isSymmetric(int isotopologue) {
    return isotopologue == 1 || isotopologue == 2 || isotopologue == 7;
}

int angularMomentum(const std::string& state) {
    return state[2] - '0';
}

/// Whether the level exists: any where the two oxygens differ; else e levels of even J where l + v3
/// is even and of odd J where it is odd, f levels the other way round.
bool exists(int isotopologue, const std::string& state, char symmetry, int J) {
    const int l = angularMomentum(state);
    if (J < l || (l == 0 && symmetry == 'f'))
        return false;
    return !isSymmetric(isotopologue) ||
           (J + l + (state[3] - '0') + (symmetry == 'f' ? 1 : 0)) % 2 == 0;
}

} // namespace

double hoenlLondonFactor(int branch, int J, int lowerL, int upperL) {
    const double j = J, l = lowerL;
    const int change = upperL - lowerL;
    if (J < lowerL || J + branch < upperL || J + branch < 0 || (branch == 0 && J == 0))
        return 0.0;
    if (change == 0)
        return branch > 0   ? (j + 1.0 + l) * (j + 1.0 - l) / (j + 1.0)
               : branch < 0 ? (j + l) * (j - l) / j
                            : (2.0 * j + 1.0) * l * l / (j * (j + 1.0));
    if (std::abs(change) > 1)
        return branch > 0 ? j + 1.0 : branch < 0 ? j : 2.0 * j + 1.0;
    const double s = change; // both signs in one: l counts along the change
    return branch > 0   ? (j + 2.0 + s * l) * (j + 1.0 + s * l) / (j + 1.0)
           : branch < 0 ? (j - 1.0 - s * l) * (j - s * l) / j
                        : (j + 1.0 + s * l) * (j - s * l) * (2.0 * j + 1.0) / (j * (j + 1.0));
}

std::vector<CarbonDioxideBand> readCarbonDioxideBands(const std::vector<std::string>& lines,
                                                      const std::string& file) {
    std::map<std::string, std::size_t> places;
    std::vector<CarbonDioxideBand> bands;
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < lines.size() && diagnostics.size() < 10; ++i) {
        std::istringstream words(lines[i]);
        std::string name, strength;
        words >> name >> strength;
        if (name.empty())
            continue;
        const std::string code = name.substr(0, 11), half = name.substr(code.size());
        const auto value = parseNumber(strength);
        if (code.size() != 11 || (!half.empty() && half != "I" && half != "II") || !value ||
            *value < 0.0 ||
            !std::ranges::all_of(code, [](char c) { return c >= '0' && c <= '9'; })) {
            diagnostics.push_back({file, "line " + std::to_string(i + 1), "'" + lines[i] + "'",
                                   "isotopologue and two states of five digits, strength"});
            continue;
        }
        const auto [place, isNew] = places.try_emplace(code, bands.size());
        if (isNew)
            bands.push_back(
                {code[0] == '0' ? 10 : code[0] - '0', code.substr(1, 5), code.substr(6, 5), 0.0});
        bands[place->second].strength += *value;
    }
    if (bands.empty() && diagnostics.empty())
        diagnostics.push_back({file, "", "no band", "bands of CO2"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    return bands;
}

std::vector<Line> bandLines(const CarbonDioxideBand& band, const CarbonDioxideLevels& levels) {
    const int lowerL = angularMomentum(band.lower), upperL = angularMomentum(band.upper);
    std::vector<Line> lines;
    double sum = 0.0;
    for (const char symmetry : {'e', 'f'}) {
        const RotationalTerm* lower = levels.term(band.isotopologue, band.lower, symmetry);
        if (!lower)
            continue;
        for (const int branch : {-1, 0, 1}) {
            const char upperSymmetry = branch == 0 ? (symmetry == 'e' ? 'f' : 'e') : symmetry;
            const RotationalTerm* upper = levels.term(band.isotopologue, band.upper, upperSymmetry);
            if (!upper)
                continue;
            const int highest =
                std::min(lower->highestJ(), upper->highestJ() - branch) + levelsBeyondKnown;
            for (int J = lowerL; J <= highest; ++J) {
                if (!exists(band.isotopologue, band.lower, symmetry, J) ||
                    !exists(band.isotopologue, band.upper, upperSymmetry, J + branch))
                    continue;
                Line line;
                line.lowerEnergy_per_cm = lower->energy_per_cm(J);
                line.wavenumber_per_cm = upper->energy_per_cm(J + branch) - line.lowerEnergy_per_cm;
                if (line.wavenumber_per_cm <= 0.0)
                    continue;
                const double c = secondRadiationConstant_cm_K / referenceTemperature_K;
                line.intensity = line.wavenumber_per_cm *
                                 hoenlLondonFactor(branch, J, lowerL, upperL) *
                                 std::exp(-c * line.lowerEnergy_per_cm) *
                                 -std::expm1(-c * line.wavenumber_per_cm);
                levels.widths(branch > 0 ? J + 1 : J).applyTo(line);
                line.isotopologue = band.isotopologue;
                sum += line.intensity;
                lines.push_back(line);
            }
        }
    }
    for (Line& line : lines)
        line.intensity *= band.strength / sum;
    return lines;
}

} // namespace irsg::lbl
