#include "tools/atmosphere-tables/lines/CarbonDioxidePolyads.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideBands.h"
#include "tools/atmosphere-tables/lines/SymmetricEigen.h"

namespace irsg::lbl {

namespace {

/// Constants, cm-1, with the quanta counted from the ground state.
struct Constants {
    double w1, w2, w3;
    double x11, x12, x13, x22, x23, x33, xll;
    double fermi;                  ///< <v1 v2| H |v1 - 1 v2 + 2> over sqrt(v1 ((v2 + 2)^2 - l^2))
    double fermi1, fermi2, fermi3; ///< its growth with v1, v2 + 2 and v3
    double B, a1, a2, a3, gll;     ///< B - a1 v1 - a2 v2 - a3 v3 + gll l^2
    double fermiRotation;          ///< of the coupling, per J (J + 1)
};
constexpr std::array<Constants, 2> constants = {{
    {1341.691,  667.1704,    2361.611,     -2.825634,   0.5062688,   -19.63424,  0.1742255,
     -12.55363, -12.46989,   0.02645607,   -26.2203,    0.1957202,   0.1689562,  0.312709,
     0.3902478, 1.267657e-3, -6.964288e-4, 2.958438e-3, 2.066831e-7, 4.032136e-5},
    {1342.57,   648.263,    2296.127,     -2.838341,   1.130367,     -19.09001,  -0.01956651,
     -11.65857, -12.46989,  0.194309,     -24.32376,   0.1923799,    0.2026356,  0.312709,
     0.390267,  1.26857e-3, -6.653668e-4, 2.868082e-3, -6.935949e-7, 2.473163e-5},
}};
/// Of third order, of both isotopologues.
constexpr double y111 = 0.01009756, y112 = 0.2344046, y113 = -0.1429841, y122 = 0.05472587,
                 y123 = -0.5809229, y133 = 0.1088261, y222 = -0.03622588, y223 = 0.1437634,
                 y233 = 0.007046839, y333 = -0.001073064, y1ll = 0.06258132, y2ll = 0.03376991,
                 y3ll = -0.1295501;
constexpr double centrifugal_per_cm = 1.35e-7; ///< D
constexpr double doubling_per_cm = 6.15e-4;    ///< q of l2 = 1, times v2 + 1 over 2

/// By isotopologue: the strength of 00011 from the ground; the dipoles of v1 + 1 and v2 + 2 over
/// that of v3 + 1; and what the square of the latter loses for each of 2 v1 + v2.
constexpr double strengthMain[] = {9.153e-17, 9.278e-19};
constexpr double ratioV1[] = {0.13216, 0.12939}, ratioV2[] = {-0.003301, -0.002708};
constexpr double lossPerQuantum[] = {0.0135, 0.003};

std::size_t place(int isotopologue) {
    if (isotopologue != 1 && isotopologue != 2)
        throw LogicError("polyads of this isotopologue of CO2 have no constants");
    return static_cast<std::size_t>(isotopologue - 1);
}

double harmonic_per_cm(const Constants& c, double v1, double v2, double v3, double l) {
    return c.w1 * v1 + c.w2 * v2 + c.w3 * v3 + c.x11 * v1 * v1 + c.x12 * v1 * v2 + c.x13 * v1 * v3 +
           c.x22 * v2 * v2 + c.x23 * v2 * v3 + c.x33 * v3 * v3 + c.xll * l * l +
           y111 * v1 * v1 * v1 + y112 * v1 * v1 * v2 + y113 * v1 * v1 * v3 + y122 * v1 * v2 * v2 +
           y123 * v1 * v2 * v3 + y133 * v1 * v3 * v3 + y222 * v2 * v2 * v2 + y223 * v2 * v2 * v3 +
           y233 * v2 * v3 * v3 + y333 * v3 * v3 * v3 + l * l * (y1ll * v1 + y2ll * v2 + y3ll * v3);
}

bool levelExists(const PolyadState& state, char symmetry, int J) {
    if (J < state.l2 || (state.l2 == 0 && symmetry == 'f'))
        return false;
    return (J + state.l2 + state.v3 + (symmetry == 'f' ? 1 : 0)) % 2 == 0;
}

} // namespace

double PolyadState::level_per_cm(int J, char symmetry) const {
    const double x = static_cast<double>(J) * (J + 1.0) - static_cast<double>(l2 * l2);
    const double bending = 2.0 * quanta + l2; // of the state with v1 = 0
    const double split =
        l2 == 1 ? 0.5 * doubling_per_cm * 0.5 * (bending + 1.0) * (symmetry == 'f' ? 1.0 : -1.0)
                : 0.0;
    return energy_per_cm + (rotation_per_cm + split) * x - centrifugal_per_cm * x * x;
}

std::vector<PolyadState> carbonDioxidePolyad(int isotopologue, int quanta, int l2, int v3) {
    const Constants& c = constants[place(isotopologue)];
    const auto size = static_cast<std::size_t>(quanta + 1);
    SquareMatrix energy(size), rotation(size);
    for (std::size_t i = 0; i < size; ++i) {
        const auto v1 = static_cast<double>(i);
        const double v2 = 2.0 * (quanta - v1) + l2;
        energy(i, i) = harmonic_per_cm(c, v1, v2, v3, l2);
        rotation(i, i) = c.B - c.a1 * v1 - c.a2 * v2 - c.a3 * v3 + c.gll * l2 * l2;
        if (i == 0)
            continue;
        const double root = std::sqrt(v1 * ((v2 + 2.0) * (v2 + 2.0) - l2 * l2));
        energy(i, i - 1) = energy(i - 1, i) =
            (c.fermi + c.fermi1 * v1 + c.fermi2 * (v2 + 2.0) + c.fermi3 * v3) * root;
        rotation(i, i - 1) = rotation(i - 1, i) = c.fermiRotation * root;
    }
    const EigenSystem system = eigenSystem(energy);
    std::vector<PolyadState> states;
    for (std::size_t s = size; s-- > 0;) {
        PolyadState state{
            quanta, l2, v3, static_cast<int>(size - s), system.values[s], 0.0, system.vectors[s]};
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = 0; j < size; ++j)
                state.rotation_per_cm += state.amplitudes[i] * rotation(i, j) * state.amplitudes[j];
        states.push_back(std::move(state));
    }
    return states;
}

double polyadBandStrength(int isotopologue, const PolyadState& upper, const PolyadState& lower) {
    const std::size_t which = place(isotopologue);
    if (upper.l2 != lower.l2 || upper.v3 != lower.v3 + 1)
        return 0.0;
    const double l2 = lower.l2;
    double dipole = 0.0;
    if (upper.quanta == lower.quanta) {
        for (std::size_t i = 0; i < lower.amplitudes.size(); ++i)
            dipole += lower.amplitudes[i] * upper.amplitudes[i];
        dipole *= std::sqrt(std::max(0.0, 1.0 - lossPerQuantum[which] * (2.0 * lower.quanta + l2)));
    } else if (upper.quanta == lower.quanta + 1) {
        for (std::size_t i = 0; i < lower.amplitudes.size(); ++i) {
            const auto v1 = static_cast<double>(i);
            const double v2 = 2.0 * (lower.quanta - v1) + l2;
            dipole += lower.amplitudes[i] *
                      (ratioV1[which] * upper.amplitudes[i + 1] * std::sqrt(v1 + 1.0) +
                       ratioV2[which] * upper.amplitudes[i] *
                           std::sqrt((v2 + 2.0) * (v2 + 2.0) - l2 * l2));
        }
    } else {
        return 0.0;
    }
    const double origin_per_cm = upper.energy_per_cm - lower.energy_per_cm;
    const double ground_per_cm = carbonDioxidePolyad(isotopologue, 0, 0, 1).front().energy_per_cm;
    return strengthMain[which] * origin_per_cm / ground_per_cm * (lower.v3 + 1.0) * dipole *
           dipole * (lower.l2 > 0 ? 2.0 : 1.0) *
           std::exp(-secondRadiationConstant_cm_K / referenceTemperature_K * lower.energy_per_cm);
}

namespace {

/// Lines of a band whose intensities at a temperature are at least `weakest`.
void addBand(int isotopologue, const PolyadState& upper, const PolyadState& lower,
             const CarbonDioxideLevels& levels, double temperature_K, double weakest,
             std::vector<Line>& lines) {
    constexpr int highestJ = 160;
    const double strength = polyadBandStrength(isotopologue, upper, lower);
    const double cold = secondRadiationConstant_cm_K / referenceTemperature_K;
    const double warming =
        secondRadiationConstant_cm_K * (1.0 / referenceTemperature_K - 1.0 / temperature_K);
    std::vector<Line> band;
    double sum = 0.0;
    for (const char symmetry : {'e', 'f'})
        for (const int branch : {-1, 0, 1})
            for (int J = lower.l2; J <= highestJ; ++J) {
                const char above = branch == 0 ? (symmetry == 'e' ? 'f' : 'e') : symmetry;
                if (!levelExists(lower, symmetry, J) || !levelExists(upper, above, J + branch))
                    continue;
                Line line;
                line.isotopologue = isotopologue;
                line.lowerEnergy_per_cm = lower.level_per_cm(J, symmetry);
                line.wavenumber_per_cm =
                    upper.level_per_cm(J + branch, above) - line.lowerEnergy_per_cm;
                // Counted from the band, so that nothing underflows.
                line.intensity = hoenlLondonFactor(branch, J, lower.l2, upper.l2) *
                                 line.wavenumber_per_cm *
                                 std::exp(-cold * (line.lowerEnergy_per_cm - lower.energy_per_cm));
                levels.widths(branch > 0 ? J + 1 : J).applyTo(line);
                sum += line.intensity;
                band.push_back(line);
            }
    for (Line& line : band) {
        line.intensity *= strength / sum;
        if (line.intensity * std::exp(warming * line.lowerEnergy_per_cm) >= weakest)
            lines.push_back(line);
    }
}

} // namespace

std::vector<Line> hotCarbonDioxide(const CarbonDioxideLevels& levels, double highestEnergy_per_cm,
                                   double temperature_K, double weakest) {
    constexpr int mostQuanta = 9, mostL = 18, mostV3 = 5;
    std::vector<Line> lines;
    for (const int isotopologue : {1, 2})
        for (int l2 = 0; l2 <= mostL; ++l2)
            for (int v3 = 0; v3 <= mostV3; ++v3)
                for (int quanta = 0; quanta <= mostQuanta; ++quanta) {
                    const auto lower = carbonDioxidePolyad(isotopologue, quanta, l2, v3);
                    if (lower.back().energy_per_cm > highestEnergy_per_cm)
                        break;
                    for (const int more : {0, 1})
                        for (const PolyadState& upper :
                             carbonDioxidePolyad(isotopologue, quanta + more, l2, v3 + 1))
                            for (const PolyadState& from : lower)
                                if (from.energy_per_cm <= highestEnergy_per_cm)
                                    addBand(isotopologue, upper, from, levels, temperature_K,
                                            weakest, lines);
                }
    std::ranges::stable_sort(lines, {}, &Line::wavenumber_per_cm);
    return lines;
}

void addMissingLines(LineList& list, const std::vector<Line>& hot) {
    constexpr double near_per_cm = 1.0, nearEnergy_per_cm = 6.0, likeness = 1.4;
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    std::vector<char> taken(list.lines.size(), 0);
    std::vector<Line> missing;
    for (const Line& line : hot) {
        auto best = list.lines.size();
        double bestDistance = near_per_cm;
        auto next = static_cast<std::size_t>(
            std::ranges::lower_bound(list.lines, line.wavenumber_per_cm - near_per_cm, {},
                                     &Line::wavenumber_per_cm) -
            list.lines.begin());
        for (; next < list.lines.size() &&
               list.lines[next].wavenumber_per_cm <= line.wavenumber_per_cm + near_per_cm;
             ++next) {
            const Line& listed = list.lines[next];
            const double distance = std::abs(listed.wavenumber_per_cm - line.wavenumber_per_cm);
            const double ratio = listed.intensity / line.intensity;
            if (!taken[next] && listed.isotopologue == line.isotopologue &&
                distance <= bestDistance && ratio < likeness && ratio > 1.0 / likeness &&
                std::abs(listed.lowerEnergy_per_cm - line.lowerEnergy_per_cm) < nearEnergy_per_cm) {
                best = next;
                bestDistance = distance;
            }
        }
        if (best < list.lines.size())
            taken[best] = 1;
        else
            missing.push_back(line);
    }
    list.lines.insert(list.lines.end(), missing.begin(), missing.end());
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
}

} // namespace irsg::lbl
