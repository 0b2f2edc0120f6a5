#include "tools/atmosphere-tables/lines/NitrousOxideLines.h"

#include <cmath>
#include <cstdlib>

namespace irsg::lbl {

namespace {

constexpr double listFrom_per_cm = 2000.0, listTo_per_cm = 2400.0;

// nu3 of 14N2-16O: from its lines in this list, which agree with Toth 1987 in all digits here.
constexpr double mainOrigin_per_cm = 2223.75676;
constexpr double mainRotation_per_cm = 0.4190110;
constexpr double mainUpperRotation_per_cm = 0.4155595;
constexpr double mainAbundance = 0.990333;

constexpr RareIsotopologue rare(int number, double abundance, double origin_per_cm,
                                double rotation_per_cm) {
    return {number,
            abundance / mainAbundance,
            origin_per_cm,
            rotation_per_cm,
            mainOrigin_per_cm,
            mainRotation_per_cm,
            mainUpperRotation_per_cm + mainRotation_per_cm,
            mainUpperRotation_per_cm - mainRotation_per_cm};
}

constexpr RareIsotopologue rarer[] = {rare(2, 3.64093e-3, 2177.6568, 0.4189809), // 14N15N16O
                                      rare(3, 3.64093e-3, 2201.6053, 0.4048571), // 15N14N16O
                                      rare(4, 1.98582e-3, 2216.7112, 0.3955773), // 14N14N18O
                                      rare(5, 3.6928e-4, 2220.0736, 0.4066720)}; // 14N14N17O

/// "0 1 1 0" as v1, v2, l2, v3; false for anything else.
bool readState(const std::string& text, int (&state)[4]) {
    const char* at = text.c_str();
    for (int& number : state) {
        char* end = nullptr;
        number = static_cast<int>(std::strtol(at, &end, 10));
        if (end == at)
            return false;
        at = end;
    }
    return true;
}

} // namespace

Line movedLine(const AssignedLine& of, const RareIsotopologue& to) {
    const double r = to.rotation_per_cm / to.mainRotation_per_cm;
    const double q = r * r * to.mainOrigin_per_cm / to.origin_per_cm;
    const double m = of.m;
    const double rotation = (r - 1.0) * to.mainRotation_per_cm * of.J * (of.J + 1.0);
    Line line = of.line;
    line.isotopologue = to.number;
    line.wavenumber_per_cm += to.origin_per_cm - to.mainOrigin_per_cm +
                              (r - 1.0) * to.mainSum_per_cm * m +
                              (q - 1.0) * to.mainChange_per_cm * m * m;
    line.lowerEnergy_per_cm += rotation;
    line.intensity *= to.abundanceRatio * r *
                      std::exp(-secondRadiationConstant_cm_K * rotation / referenceTemperature_K);
    return line;
}

std::vector<AssignedLine> assignedLines(const std::vector<std::string>& texts, int isotopologue,
                                        double lower_per_cm, double upper_per_cm) {
    std::vector<AssignedLine> lines;
    for (const std::string& text : texts) {
        if (text.size() < 127 || text[2] != static_cast<char>('0' + isotopologue))
            continue;
        const auto number = [&](std::size_t first, std::size_t count) {
            return std::strtod(text.substr(first, count).c_str(), nullptr);
        };
        AssignedLine found;
        found.line.wavenumber_per_cm = number(3, 12);
        if (found.line.wavenumber_per_cm < lower_per_cm ||
            found.line.wavenumber_per_cm >= upper_per_cm)
            continue;
        int upper[4], lower[4];
        const std::size_t branch = text.find_first_of("PQR", 112);
        if (!readState(text.substr(67, 15), upper) || !readState(text.substr(82, 15), lower) ||
            upper[3] != lower[3] + 1 || branch == std::string::npos || branch >= 127)
            continue;
        found.line.intensity = number(15, 10);
        found.line.airWidth_cm_atm = static_cast<float>(number(35, 5));
        found.line.selfWidth_cm_atm = static_cast<float>(number(40, 5));
        found.line.lowerEnergy_per_cm = number(45, 10);
        found.line.widthExponent = static_cast<float>(number(55, 4));
        found.line.airShift_cm_atm = static_cast<float>(number(59, 8));
        found.line.isotopologue = isotopologue;
        found.J = static_cast<int>(std::strtol(text.c_str() + branch + 1, nullptr, 10));
        found.m = text[branch] == 'P' ? -found.J : text[branch] == 'R' ? found.J + 1 : 0;
        lines.push_back(found);
    }
    return lines;
}

std::vector<Line> rareNitrousOxide(const std::vector<std::string>& texts) {
    constexpr double weakest = 1e-25;
    std::vector<Line> lines;
    for (const AssignedLine& line : assignedLines(texts, 1, listFrom_per_cm, listTo_per_cm))
        for (const RareIsotopologue& isotopologue : rarer) {
            const Line moved = movedLine(line, isotopologue);
            if (moved.intensity >= weakest && moved.wavenumber_per_cm >= listFrom_per_cm &&
                moved.wavenumber_per_cm < listTo_per_cm)
                lines.push_back(moved);
        }
    return lines;
}

} // namespace irsg::lbl
