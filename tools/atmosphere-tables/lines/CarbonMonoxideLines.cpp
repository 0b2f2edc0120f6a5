#include "tools/atmosphere-tables/lines/CarbonMonoxideLines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/Interpolation.h"

namespace irsg::lbl {

namespace {

/// Y_ij, cm-1: those of vibration of K. P. Huber and G. Herzberg 1979 (Constants of Diatomic
/// Molecules), which hold for all v here, those of rotation fitted.
struct DunhamTerm {
    int i, j;
    double value;
};
constexpr std::array<DunhamTerm, 14> dunham = {{
    {1, 0, 2169.81358},
    {2, 0, -13.28831},
    {3, 0, 0.010511},
    {4, 0, 5.74e-5},
    {0, 1, 1.931290148},
    {1, 1, -0.01751018853},
    {2, 1, 1.307696388e-06},
    {3, 1, 3.71527317e-08},
    {0, 2, -6.126262723e-06},
    {1, 2, 3.536336104e-09},
    {2, 2, -3.542629906e-10},
    {0, 3, 6.564557351e-12},
    {1, 3, -4.543465641e-13},
    {0, 4, -3.954266073e-17},
}};

struct Isotopologue {
    int number;
    double abundance, massRatio;
};
constexpr std::array<Isotopologue, 3> isotopologues = {
    {{1, 0.986544, 1.0}, {2, 0.0110836, 0.977707}, {3, 0.00197822, 0.975842}}};

/// Half widths in air, cm-1 / atm, and their exponents by |m|.
constexpr std::array<double, 8> widthAxis = {1, 2, 5, 10, 20, 30, 40, 60};
constexpr std::array<double, 8> airWidths = {0.0797, 0.0748, 0.0650, 0.0580,
                                             0.0510, 0.0441, 0.0420, 0.0420};
constexpr std::array<double, 8> widthExponents = {0.76, 0.75, 0.74, 0.75, 0.67, 0.67, 0.67, 0.67};

/// Strength of v = 0 at 296 K over nu |m| exp(-c2 E''/T) (1 - exp(-c2 nu/T)), abundance included.
constexpr double strength = 4.322759e-23;

/// The square of the moment over that of v = 0, m = 0.
double squaredMoment(int v, int m) {
    const double x = m;
    return (v + 1.0) * (1.0 - 0.0034 * v) *
           (1.0 + x * (1.95339e-4 - 5.20235e-5 * v + x * (6.32427e-6 - 2.28936e-8 * x)));
}

} // namespace

double carbonMonoxideLevel_per_cm(int v, int J, double massRatio) {
    const double half = v + 0.5, x = J * (J + 1.0);
    double energy = 0.0;
    for (const DunhamTerm& term : dunham)
        energy += term.value * std::pow(massRatio, term.i + 2 * term.j) *
                  (std::pow(half, term.i) * std::pow(x, term.j) -
                   (term.j == 0 ? std::pow(0.5, term.i) : 0.0));
    return energy;
}

LineList carbonMonoxideLines() {
    constexpr int highestV = 14, largestM = 130;
    LineList list{Gas::CO, {}, {}};
    const double cold = secondRadiationConstant_cm_K / referenceTemperature_K;
    for (const auto& [number, abundance, massRatio] : isotopologues)
        for (int v = 0; v <= highestV; ++v)
            for (int m = -largestM; m <= largestM; ++m) {
                if (m == 0)
                    continue;
                const int J = m > 0 ? m - 1 : -m;
                Line line;
                line.isotopologue = number;
                line.lowerEnergy_per_cm = carbonMonoxideLevel_per_cm(v, J, massRatio);
                line.wavenumber_per_cm =
                    carbonMonoxideLevel_per_cm(v + 1, m > 0 ? J + 1 : J - 1, massRatio) -
                    line.lowerEnergy_per_cm;
                // The moment goes with the amplitude of the vibration, 1 / sqrt(reduced mass).
                line.intensity = strength * abundance / isotopologues[0].abundance * massRatio *
                                 massRatio * line.wavenumber_per_cm * std::abs(m) *
                                 squaredMoment(v, m) * std::exp(-cold * line.lowerEnergy_per_cm) *
                                 -std::expm1(-cold * line.wavenumber_per_cm);
                const double distance = std::abs(m);
                line.airWidth_cm_atm =
                    static_cast<float>(interpolate(widthAxis, airWidths, distance));
                line.selfWidth_cm_atm = 1.1f * line.airWidth_cm_atm;
                line.widthExponent =
                    static_cast<float>(interpolate(widthAxis, widthExponents, distance));
                list.lines.push_back(line);
            }
    std::ranges::stable_sort(list.lines, {}, &Line::wavenumber_per_cm);
    list.origins = {"CO at 1700-2400 cm-1: v to v + 1 in closed form, Dunham's constants and "
                    "moments fitted to HITRAN2012 (Rothman et al. 2013, J. Quant. Spectrosc. "
                    "Radiat. Transfer 130, 4); strengths to 2 percent"};
    return list;
}

} // namespace irsg::lbl
