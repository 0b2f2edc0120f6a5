#include "irsg/signature/DispersionFormula.h"

#include <array>
#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr std::array<std::size_t, dispersionFormulas> most = {17, 17, 17, 17, 11, 11, 6, 4, 6};

/// Coefficients counted from 1, as the formulas count them; zeros behind the last.
struct Coefficients {
    std::span<const double> values;
    double operator()(std::size_t i) const { return i <= values.size() ? values[i - 1] : 0.0; }
};

/// The sum over pairs (a, b) of coefficients from the second on. Pairs whose a is 0 add nothing,
/// whatever their pole.
template <typename Term>
double sumOfPairs(const Coefficients& c, const Term& term) {
    double sum = 0.0;
    for (std::size_t i = 2; i <= c.values.size(); i += 2)
        if (c(i) != 0.0)
            sum += term(c(i), c(i + 1));
    return sum;
}

} // namespace

std::size_t mostCoefficients(int formula) {
    if (formula < 1 || formula > dispersionFormulas)
        throw LogicError("there is no such dispersion formula");
    return most[static_cast<std::size_t>(formula - 1)];
}

double dispersionIndex(int formula, std::span<const double> coefficients, double wavelength_um) {
    if (coefficients.empty() || coefficients.size() > mostCoefficients(formula))
        throw LogicError("a dispersion formula with too few or too many coefficients");
    const Coefficients c{coefficients};
    const double l = wavelength_um, l2 = l * l;
    switch (formula) {
    case 1:
        return std::sqrt(1.0 + c(1) +
                         sumOfPairs(c, [&](double a, double b) { return a * l2 / (l2 - b * b); }));
    case 2:
        return std::sqrt(1.0 + c(1) +
                         sumOfPairs(c, [&](double a, double b) { return a * l2 / (l2 - b); }));
    case 3:
        return std::sqrt(c(1) +
                         sumOfPairs(c, [&](double a, double b) { return a * std::pow(l, b); }));
    case 4: {
        double square = c(1);
        for (const std::size_t i : {2, 6})
            if (c(i) != 0.0)
                square += c(i) * std::pow(l, c(i + 1)) / (l2 - std::pow(c(i + 2), c(i + 3)));
        for (std::size_t i = 10; i <= 16; i += 2)
            if (c(i) != 0.0)
                square += c(i) * std::pow(l, c(i + 1));
        return std::sqrt(square);
    }
    case 5:
        return c(1) + sumOfPairs(c, [&](double a, double b) { return a * std::pow(l, b); });
    case 6:
        return 1.0 + c(1) + sumOfPairs(c, [&](double a, double b) { return a / (b - 1.0 / l2); });
    case 7: {
        const double part = 1.0 / (l2 - 0.028);
        return c(1) + c(2) * part + c(3) * part * part + c(4) * l2 + c(5) * l2 * l2 +
               c(6) * l2 * l2 * l2;
    }
    case 8: {
        // (n^2 - 1) / (n^2 + 2) = y
        const double y = c(1) + (c(2) != 0.0 ? c(2) * l2 / (l2 - c(3)) : 0.0) + c(4) * l2;
        return std::sqrt((1.0 + 2.0 * y) / (1.0 - y));
    }
    default: {
        const double shifted = l - c(5);
        double square = c(1);
        if (c(2) != 0.0)
            square += c(2) / (l2 - c(3));
        if (c(4) != 0.0)
            square += c(4) * shifted / (shifted * shifted + c(6));
        return std::sqrt(square);
    }
    }
}

} // namespace irsg
