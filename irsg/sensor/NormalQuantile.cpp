#include "irsg/sensor/NormalQuantile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

/// The quotient of two polynomials, whose coefficients begin with that of the highest power.
struct Quotient {
    std::array<double, 8> above, below;

    double at(double x) const {
        double numerator = above[0], denominator = below[0];
        for (std::size_t i = 1; i < above.size(); ++i) {
            numerator = numerator * x + above[i];
            denominator = denominator * x + below[i];
        }
        return numerator / denominator;
    }
};

constexpr Quotient middle{
    {2509.0809287301226727, 33430.575583588128105, 67265.770927008700853, 45921.953931549871457,
     13731.693765509461125, 1971.5909503065514427, 133.14166789178437745, 3.3871328727963666080},
    {5226.4952788528545610, 28729.085735721942674, 39307.895800092710610, 21213.794301586595867,
     5394.1960214247511077, 687.18700749205790830, 42.313330701600911252, 1.0}};
constexpr Quotient tail{{7.74545014278341407640e-4, 2.27238449892691845833e-2,
                         2.41780725177450611770e-1, 1.27045825245236838258, 3.64784832476320460504,
                         5.76949722146069140550, 4.63033784615654529590, 1.42343711074968357734},
                        {1.05075007164441684324e-9, 5.47593808499534494600e-4,
                         1.51986665636164571966e-2, 1.48103976427480074590e-1,
                         6.89767334985100004550e-1, 1.67638483018380384940, 2.05319162663775882187,
                         1.0}};
constexpr Quotient farTail{
    {2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3,
     2.65321895265761230930e-2, 2.96560571828504891230e-1, 1.78482653991729133580,
     5.46378491116411436990, 6.65790464350110377720},
    {2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5,
     7.86869131145613259100e-4, 1.48753612908506148525e-2, 1.36929880922735805310e-1,
     5.99832206555887937690e-1, 1.0}};

/// The probabilities around a half that one quotient serves: this far from it.
constexpr double middleWidth = 0.425;

double inMiddle(double q) {
    return q * middle.at(0.180625 - q * q);
}

double inTail(double q, double probability) {
    const double r = std::sqrt(-portable::log(q < 0.0 ? probability : 1.0 - probability));
    const double value = r <= 5.0 ? tail.at(r - 1.6) : farTail.at(r - 5.0);
    return q < 0.0 ? -value : value;
}

} // namespace

double normalQuantile(double probability) {
    const double q = probability - 0.5;
    return std::abs(q) <= middleWidth ? inMiddle(q) : inTail(q, probability);
}

void normalQuantiles(std::span<double> probabilities) {
    constexpr std::size_t block = 64;
    std::array<double, block> given;
    std::array<std::size_t, block> tails;
    for (std::size_t first = 0; first < probabilities.size(); first += block) {
        const std::size_t count = std::min(block, probabilities.size() - first);
        double* const values = probabilities.data() + first;
        std::copy_n(values, count, given.begin());
        // All as if they were in the middle, six of seven are; then the others anew.
        for (std::size_t i = 0; i < count; ++i)
            values[i] = inMiddle(given[i] - 0.5);
        std::size_t ends = 0;
        for (std::size_t i = 0; i < count; ++i) {
            tails[ends] = i;
            ends += !(std::abs(given[i] - 0.5) <= middleWidth);
        }
        for (std::size_t k = 0; k < ends; ++k)
            values[tails[k]] = inTail(given[tails[k]] - 0.5, given[tails[k]]);
    }
}

} // namespace irsg
