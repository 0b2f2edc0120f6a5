#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "irsg/signature/DistributionLaw.h"
#include "irsg/signature/random/PortableMath.h"
#include "irsg/signature/random/StableDistribution.h"

namespace irsg {

namespace {

using Numbers = std::vector<double>;
using Tails = std::function<LogTails(double)>;

constexpr double largestShape = 1e4;
constexpr LogTails nothingBelow{-std::numeric_limits<double>::infinity(), 0.0};
constexpr LogTails nothingAbove{0.0, -std::numeric_limits<double>::infinity()};

constexpr const char* aboutTheMiddle = "(min + max) / 2, (max - min) / 8";

double middle(double min, double max) {
    return 0.5 * (min + max);
}

// What parameters must be.

void positive(ParameterCheck& check, std::string_view what, double value) {
    check.require(value > 0.0, what, value, "more than 0");
}

void shape(ParameterCheck& check, std::string_view what, double value) {
    check.require(value >= 0.05 && value <= largestShape, what, value, "a number from 0.05 to 1e4");
}

/// Of a kind whose second number is a width and whose others are shapes.
template <DistributionKind kind>
void widthAndShapes(ParameterCheck& check, const Numbers& p) {
    const auto& names = info(kind).parameters;
    positive(check, names[1], p[1]);
    for (std::size_t i = 2; i < p.size(); ++i)
        shape(check, names[i], p[i]);
}

void positiveMin(ParameterCheck& check, double min, double) {
    check.require(min > 0.0, "min", min, "more than 0 for this distribution");
}

// Standard forms.

StandardForm originScaleShapes(double, double, const Numbers& p) {
    return {p[0], p[1], p.size() > 2 ? p[2] : 0.0, p.size() > 3 ? p[3] : 0.0};
}

StandardForm scaleAndShape(double, double, const Numbers& p) {
    return {0.0, p[0], p[1], 0.0};
}

// Tails.

/// The tails of |z| on the right of a symmetric distribution, as those of z.
LogTails mirrored(const LogTails& right, double z) {
    return z >= 0.0 ? right : LogTails{right.upper, right.lower};
}

/// Where the upper tail is e^-x.
LogTails exponentialTails(double x) {
    return x > 0.0 ? tailsFromUpper(-x) : nothingBelow;
}

/// x of the same.
double exponentialAt(const TailTarget& target) {
    return -(target.isUpper ? target.log : portable::log1mExp(target.log));
}

LogTails studentTails(double degrees, double z) {
    // P(|T| > t) = I(nu / (nu + t^2); nu / 2, 1 / 2).
    const double square = z * z;
    const double whole = degrees + square;
    const double outside =
        std::isinf(square) ? nothingBelow.lower
                           : betaTails(0.5 * degrees, 0.5, degrees / whole, square / whole).lower;
    return mirrored(tailsFromUpper(outside - std::numbers::ln2), z);
}

LogTails poissonTails(double mean, double k) {
    if (k < 0.0)
        return nothingBelow;
    const LogTails gamma = gammaTails(std::floor(k) + 1.0, mean);
    return {gamma.upper, gamma.lower};
}

/// On 0 to 1 with its mode at `mode`: each tail is a square on its own side of the mode.
LogTails triangularTails(double mode, double z) {
    if (z <= 0.0)
        return nothingBelow;
    if (z >= 1.0)
        return nothingAbove;
    return z < mode ? tailsFromLower(2.0 * portable::log(z) - portable::log(mode))
                    : tailsFromUpper(2.0 * portable::log1p(-z) - portable::log1p(-mode));
}

double triangularAt(double mode, const TailTarget& target) {
    const double lower = target.isUpper ? -portable::expm1(target.log) : portable::exp(target.log);
    const double upper = target.isUpper ? portable::exp(target.log) : -portable::expm1(target.log);
    return lower < mode ? std::sqrt(mode * lower) : 1.0 - std::sqrt((1.0 - mode) * upper);
}

/// On 0 to 1 with sides of this width, 0 to 1/2, and level between them.
LogTails trapezoidalTails(double side, double z) {
    if (z <= 0.0)
        return nothingBelow;
    if (z >= 1.0)
        return nothingAbove;
    const double sides = portable::log(2.0 * side * (1.0 - side));
    if (z < side)
        return tailsFromLower(2.0 * portable::log(z) - sides);
    if (1.0 - z < side)
        return tailsFromUpper(2.0 * portable::log1p(-z) - sides);
    const double level = portable::log1p(-side);
    return {portable::log(z - 0.5 * side) - level, portable::log(1.0 - z - 0.5 * side) - level};
}

double trapezoidalAt(double side, const TailTarget& target) {
    const double lower = target.isUpper ? -portable::expm1(target.log) : portable::exp(target.log);
    const double upper = target.isUpper ? portable::exp(target.log) : -portable::expm1(target.log);
    const double ofSide = 0.5 * side / (1.0 - side);
    if (lower < ofSide)
        return std::sqrt(2.0 * side * (1.0 - side) * lower);
    if (upper < ofSide)
        return 1.0 - std::sqrt(2.0 * side * (1.0 - side) * upper);
    return 0.5 * side + (1.0 - side) * lower;
}

/// The parameters of laws over a width, of which a part is special.
Numbers wholeWidthAndHalf(double min, double max) {
    return {min, max - min, 0.5};
}

void widthAndPart(ParameterCheck& check, const Numbers& p, const char* part) {
    positive(check, "width", p[1]);
    check.require(p[2] >= 0.0 && p[2] <= 1.0, part, p[2], "a part from 0 to 1");
}

/// In the order of their numbers.
const DistributionLaw laws[] = {
    {.info = {DistributionKind::uniform, "uniform", {}, "every value alike"},
     .defaults = [](double, double) -> Numbers { return {}; },
     .standard = [](double min, double max, const Numbers&) -> StandardForm {
         return {min, max - min};
     },
     .tails = [](const StandardForm&) -> Tails {
         return [](double z) {
             return z <= 0.0   ? nothingBelow
                    : z >= 1.0 ? nothingAbove
                               : LogTails{portable::log(z), portable::log1p(-z)};
         };
     },
     .closedForm =
         [](const StandardForm&, const TailTarget& target) {
             return target.isUpper ? -portable::expm1(target.log) : portable::exp(target.log);
         }},
    {.info = {DistributionKind::normal,
              "normal",
              {"mean", "standard deviation"},
              "(min + max) / 2, (max - min) / 6"},
     .defaults = [](double min, double max) -> Numbers {
         return {middle(min, max), (max - min) / 6.0};
     },
     .check = widthAndShapes<DistributionKind::normal>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm&) -> Tails { return normalTails; }},
    {.info = {DistributionKind::exponential,
              "exponential",
              {"origin", "mean beyond it"},
              "min, (max - min) / 4"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, (max - min) / 4.0};
     },
     .check = widthAndShapes<DistributionKind::exponential>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm&) -> Tails { return exponentialTails; },
     .closedForm = [](const StandardForm&,
                      const TailTarget& target) { return exponentialAt(target); }},
    {.info = {DistributionKind::laplace, "Laplace", {"centre", "scale"}, aboutTheMiddle},
     .defaults = [](double min, double max) -> Numbers {
         return {middle(min, max), (max - min) / 8.0};
     },
     .check = widthAndShapes<DistributionKind::laplace>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm&) -> Tails {
         return
             [](double z) { return mirrored(tailsFromUpper(-std::abs(z) - std::numbers::ln2), z); };
     },
     .closedForm =
         [](const StandardForm&, const TailTarget& target) {
             const double beyond = std::min(target.log + std::numbers::ln2, 0.0);
             return target.isUpper ? -beyond : beyond;
         }},
    {.info = {DistributionKind::cauchy,
              "Cauchy",
              {"centre", "half width at half maximum"},
              aboutTheMiddle},
     .defaults = [](double min, double max) -> Numbers {
         return {middle(min, max), (max - min) / 8.0};
     },
     .check = widthAndShapes<DistributionKind::cauchy>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm&) -> Tails {
         return [](double z) {
             static const StableDistribution cauchy(1.0, 0.0);
             return cauchy.tails(z);
         };
     }},
    {.info = {DistributionKind::rayleigh,
              "Rayleigh",
              {"origin", "mode beyond it"},
              "min, (max - min) / 4"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, (max - min) / 4.0};
     },
     .check = widthAndShapes<DistributionKind::rayleigh>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm&) -> Tails {
         return [](double z) { return z > 0.0 ? exponentialTails(0.5 * z * z) : nothingBelow; };
     },
     .closedForm = [](const StandardForm&,
                      const TailTarget& target) { return std::sqrt(2.0 * exponentialAt(target)); }},
    {.info = {DistributionKind::logNormal,
              "log-normal",
              {"median", "sigma of ln x"},
              "sqrt(min max), ln(max / min) / 6; min > 0"},
     .defaults = [](double min, double max) -> Numbers {
         return {std::sqrt(min * max), portable::log(max / min) / 6.0};
     },
     .checkEnds = positiveMin,
     .check =
         [](ParameterCheck& check, const Numbers& p) {
             positive(check, "median", p[0]);
             positive(check, "sigma of ln x", p[1]);
         },
     .standard = scaleAndShape,
     .tails = [](const StandardForm& form) -> Tails {
         return [sigma = form.a](double z) {
             return z > 0.0 ? normalTails(portable::log(z) / sigma) : nothingBelow;
         };
     }},
    {.info = {DistributionKind::stable,
              "Levy alpha-stable",
              {"centre", "scale", "alpha", "beta"},
              "(min + max) / 2, (max - min) / 8, 1.5, 0"},
     .defaults = [](double min, double max) -> Numbers {
         return {middle(min, max), (max - min) / 8.0, 1.5, 0.0};
     },
     .check =
         [](ParameterCheck& check, const Numbers& p) {
             const double alpha = p[2], beta = p[3];
             positive(check, "scale", p[1]);
             check.require(alpha == 1.0 || (alpha >= 0.5 && alpha <= 0.9) ||
                               (alpha >= 1.1 && alpha <= 2.0),
                           "alpha", alpha, "0.5 to 0.9, 1, or 1.1 to 2");
             check.require(alpha == 1.0 ? beta == 0.0 : std::abs(beta) <= 1.0, "beta", beta,
                           alpha == 1.0 ? "0 where alpha is 1" : "a number from -1 to 1");
         },
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [law = std::make_shared<const StableDistribution>(form.a, form.b)](double z) {
             return law->tails(z);
         };
     }},
    {.info = {DistributionKind::gamma,
              "gamma",
              {"origin", "scale", "shape"},
              "min, (max - min) / 8, 2"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, (max - min) / 8.0, 2.0};
     },
     .check = widthAndShapes<DistributionKind::gamma>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [shape = form.a](double z) { return gammaTails(shape, z); };
     }},
    {.info = {DistributionKind::chiSquared,
              "chi-squared",
              {"origin", "scale", "degrees of freedom"},
              "min, (max - min) / 16, 4"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, (max - min) / 16.0, 4.0};
     },
     .check = widthAndShapes<DistributionKind::chiSquared>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [degrees = form.a](double z) { return gammaTails(0.5 * degrees, 0.5 * z); };
     }},
    {.info = {DistributionKind::fisherF,
              "F",
              {"origin", "scale", "degrees of freedom 1", "degrees of freedom 2"},
              "min, (max - min) / 4, 5, 10"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, (max - min) / 4.0, 5.0, 10.0};
     },
     .check = widthAndShapes<DistributionKind::fisherF>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [a = form.a, b = form.b](double z) {
             const double whole = a * z + b;
             return z > 0.0 ? betaTails(0.5 * a, 0.5 * b, a * z / whole, b / whole) : nothingBelow;
         };
     }},
    {.info = {DistributionKind::studentT,
              "Student's t",
              {"centre", "scale", "degrees of freedom"},
              "(min + max) / 2, (max - min) / 8, 5"},
     .defaults = [](double min, double max) -> Numbers {
         return {middle(min, max), (max - min) / 8.0, 5.0};
     },
     .check = widthAndShapes<DistributionKind::studentT>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [degrees = form.a](double z) { return studentTails(degrees, z); };
     }},
    {.info =
         {DistributionKind::beta, "beta", {"origin", "width", "a", "b"}, "min, max - min, 2, 2"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, max - min, 2.0, 2.0};
     },
     .check = widthAndShapes<DistributionKind::beta>,
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [a = form.a, b = form.b](double z) { return betaTails(a, b, z, 1.0 - z); };
     }},
    {.info = {DistributionKind::pareto,
              "Pareto",
              {"least value", "exponent"},
              "min, 4 / ln(max / min); min > 0"},
     .defaults = [](double min, double max) -> Numbers {
         return {min, 4.0 / portable::log(max / min)};
     },
     .checkEnds = positiveMin,
     .check =
         [](ParameterCheck& check, const Numbers& p) {
             positive(check, "least value", p[0]);
             check.require(p[1] > 0.0 && p[1] <= 1e9, "exponent", p[1],
                           "more than 0 and at most 1e9");
         },
     .standard = scaleAndShape,
     .tails = [](const StandardForm& form) -> Tails {
         return [exponent = form.a](double z) {
             return z > 1.0 ? exponentialTails(exponent * portable::log(z)) : nothingBelow;
         };
     },
     .closedForm =
         [](const StandardForm& form, const TailTarget& target) {
             return portable::exp(exponentialAt(target) / form.a);
         }},
    {.info = {DistributionKind::poisson,
              "Poisson",
              {"mean"},
              "(min + max) / 2; whole numbers from min to max"},
     .defaults = [](double min, double max) -> Numbers { return {middle(min, max)}; },
     .checkEnds =
         [](ParameterCheck& check, double min, double max) {
             const double mean = middle(min, max);
             check.require(mean > 0.0 && mean <= largestShape, "a mean of", mean,
                           "min and max around a number above 0 and at most 1e4");
         },
     .check =
         [](ParameterCheck& check, const Numbers& p) {
             check.require(p[0] > 0.0 && p[0] <= largestShape, "mean", p[0],
                           "more than 0 and at most 1e4");
         },
     .standard = [](double, double, const Numbers& p) -> StandardForm {
         return {0.0, 1.0, p[0], 0.0};
     },
     .tails = [](const StandardForm& form) -> Tails {
         return [mean = form.a](double k) { return poissonTails(mean, k); };
     },
     .isDiscrete = true},
    {.info = {DistributionKind::triangular,
              "triangular",
              {"least value", "width", "mode, as a part of the width"},
              "min, max - min, 0.5"},
     .defaults = wholeWidthAndHalf,
     .check = [](ParameterCheck& check, const Numbers& p) { widthAndPart(check, p, "mode"); },
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [mode = form.a](double z) { return triangularTails(mode, z); };
     },
     .closedForm = [](const StandardForm& form,
                      const TailTarget& target) { return triangularAt(form.a, target); }},
    {.info = {DistributionKind::trapezoidal,
              "trapezoidal",
              {"least value", "width", "top, as a part of the width"},
              "min, max - min, 0.5"},
     .defaults = wholeWidthAndHalf,
     .check = [](ParameterCheck& check, const Numbers& p) { widthAndPart(check, p, "top"); },
     .standard = originScaleShapes,
     .tails = [](const StandardForm& form) -> Tails {
         return [side = 0.5 * (1.0 - form.a)](double z) { return trapezoidalTails(side, z); };
     },
     .closedForm =
         [](const StandardForm& form, const TailTarget& target) {
             return trapezoidalAt(0.5 * (1.0 - form.a), target);
         }},
};
static_assert(std::size(laws) == distributionKindCount);

} // namespace

const DistributionLaw& lawOf(DistributionKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    if (number >= std::size(laws))
        throw LogicError("unknown distribution");
    return laws[number];
}

const std::vector<DistributionInfo>& distributionTable() {
    static const std::vector<DistributionInfo> table = [] {
        std::vector<DistributionInfo> all;
        for (const DistributionLaw& law : laws)
            all.push_back(law.info);
        return all;
    }();
    return table;
}

const DistributionInfo& info(DistributionKind kind) {
    return lawOf(kind).info;
}

} // namespace irsg
