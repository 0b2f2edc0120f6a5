#include "irsg/signature/Distribution.h"

#include <algorithm>
#include <cmath>

#include "irsg/signature/TruncatedDistribution.h"
#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

constexpr double largestShape = 1e4;

/// What is wrong with the numbers of a distribution.
class ParameterCheck {
  public:
    void require(bool holds, std::string_view what, double value, const char* expected) {
        if (!holds)
            diagnostics_.push_back({"", "", std::string(what) + " " + numberText(value), expected});
    }
    void throwOnDiagnostics() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

  private:
    std::vector<Diagnostic> diagnostics_;
};

std::vector<double> defaultParameters(DistributionKind kind, double min, double max) {
    const double width = max - min, middle = 0.5 * (min + max);
    switch (kind) {
    case DistributionKind::uniform:
        return {};
    case DistributionKind::normal:
        return {middle, width / 6.0};
    case DistributionKind::exponential:
        return {min, width / 4.0};
    case DistributionKind::laplace:
    case DistributionKind::cauchy:
        return {middle, width / 8.0};
    case DistributionKind::rayleigh:
        return {min, width / 4.0};
    case DistributionKind::logNormal:
        return {std::sqrt(min * max), portable::log(max / min) / 6.0};
    case DistributionKind::stable:
        return {middle, width / 8.0, 1.5, 0.0};
    case DistributionKind::gamma:
        return {min, width / 8.0, 2.0};
    case DistributionKind::chiSquared:
        return {min, width / 16.0, 4.0};
    case DistributionKind::fisherF:
        return {min, width / 4.0, 5.0, 10.0};
    case DistributionKind::studentT:
        return {middle, width / 8.0, 5.0};
    case DistributionKind::beta:
        return {min, width, 2.0, 2.0};
    case DistributionKind::pareto:
        return {min, 4.0 / portable::log(max / min)};
    case DistributionKind::poisson:
        return {middle};
    }
    throw LogicError("unknown distribution");
}

void checkEnds(DistributionKind kind, double min, double max) {
    ParameterCheck validate;
    const int number = static_cast<int>(kind);
    validate.require(number >= 0 && number < distributionKindCount, "distribution", number,
                     "a number from 0 to 14");
    const auto isUsable = [](double x) { return std::isfinite(x) && std::abs(x) <= 1e150; };
    validate.require(isUsable(min), "min", min, "a number between -1e150 and 1e150");
    validate.require(isUsable(max), "max", max, "a number between -1e150 and 1e150");
    validate.throwOnDiagnostics();
    validate.require(min <= max, "min", min, ("at most max, " + numberText(max)).c_str());
    validate.throwOnDiagnostics();
}

/// What min and max must be for the default parameters to exist.
void checkEndsForDefaults(DistributionKind kind, double min, double max) {
    ParameterCheck validate;
    if (min != max && (kind == DistributionKind::logNormal || kind == DistributionKind::pareto))
        validate.require(min > 0.0, "min", min, "more than 0 for this distribution");
    if (min != max && kind == DistributionKind::poisson)
        validate.require(0.5 * (min + max) > 0.0 && 0.5 * (min + max) <= largestShape, "a mean of",
                         0.5 * (min + max), "min and max around a number above 0 and at most 1e4");
    validate.throwOnDiagnostics();
}

void checkParameters(DistributionKind kind, const std::vector<double>& p) {
    const DistributionInfo& about = info(kind);
    ParameterCheck validate;
    const std::string expected = std::to_string(about.parameters.size()) + " for this distribution";
    validate.require(p.size() == about.parameters.size(), "a number of parameters of",
                     static_cast<double>(p.size()), expected.c_str());
    validate.throwOnDiagnostics();
    for (std::size_t i = 0; i < p.size(); ++i)
        validate.require(std::isfinite(p[i]) && std::abs(p[i]) <= 1e150, about.parameters[i], p[i],
                         "a number between -1e150 and 1e150");
    validate.throwOnDiagnostics();

    const auto positive = [&](std::size_t i) {
        validate.require(p[i] > 0.0, about.parameters[i], p[i], "more than 0");
    };
    const auto shape = [&](std::size_t i) {
        validate.require(p[i] >= 0.05 && p[i] <= largestShape, about.parameters[i], p[i],
                         "a number from 0.05 to 1e4");
    };
    switch (kind) {
    case DistributionKind::uniform:
        break;
    case DistributionKind::normal:
    case DistributionKind::exponential:
    case DistributionKind::laplace:
    case DistributionKind::cauchy:
    case DistributionKind::rayleigh:
        positive(1);
        break;
    case DistributionKind::logNormal:
        positive(0);
        positive(1);
        break;
    case DistributionKind::stable:
        positive(1);
        validate.require(p[2] == 1.0 || (p[2] >= 0.5 && p[2] <= 0.9) ||
                             (p[2] >= 1.1 && p[2] <= 2.0),
                         about.parameters[2], p[2], "0.5 to 0.9, 1, or 1.1 to 2");
        validate.require(p[2] == 1.0 ? p[3] == 0.0 : std::abs(p[3]) <= 1.0, about.parameters[3],
                         p[3], p[2] == 1.0 ? "0 where alpha is 1" : "a number from -1 to 1");
        break;
    case DistributionKind::gamma:
    case DistributionKind::chiSquared:
    case DistributionKind::studentT:
        positive(1);
        shape(2);
        break;
    case DistributionKind::fisherF:
    case DistributionKind::beta:
        positive(1);
        shape(2);
        shape(3);
        break;
    case DistributionKind::pareto:
        positive(0);
        validate.require(p[1] > 0.0 && p[1] <= 1e9, about.parameters[1], p[1],
                         "more than 0 and at most 1e9");
        break;
    case DistributionKind::poisson:
        validate.require(p[0] > 0.0 && p[0] <= largestShape, about.parameters[0], p[0],
                         "more than 0 and at most 1e4");
        break;
    }
    validate.throwOnDiagnostics();
}

} // namespace

const std::vector<DistributionInfo>& distributionTable() {
    using Kind = DistributionKind;
    static const std::vector<DistributionInfo> table{
        {Kind::uniform, "uniform", {}, "every value alike"},
        {Kind::normal,
         "normal",
         {"mean", "standard deviation"},
         "(min + max) / 2, (max - min) / 6"},
        {Kind::exponential, "exponential", {"origin", "mean beyond it"}, "min, (max - min) / 4"},
        {Kind::laplace, "Laplace", {"centre", "scale"}, "(min + max) / 2, (max - min) / 8"},
        {Kind::cauchy,
         "Cauchy",
         {"centre", "half width at half maximum"},
         "(min + max) / 2, (max - min) / 8"},
        {Kind::rayleigh, "Rayleigh", {"origin", "mode beyond it"}, "min, (max - min) / 4"},
        {Kind::logNormal,
         "log-normal",
         {"median", "sigma of ln x"},
         "sqrt(min max), ln(max / min) / 6; min > 0"},
        {Kind::stable,
         "Levy alpha-stable",
         {"centre", "scale", "alpha", "beta"},
         "(min + max) / 2, (max - min) / 8, 1.5, 0"},
        {Kind::gamma, "gamma", {"origin", "scale", "shape"}, "min, (max - min) / 8, 2"},
        {Kind::chiSquared,
         "chi-squared",
         {"origin", "scale", "degrees of freedom"},
         "min, (max - min) / 16, 4"},
        {Kind::fisherF,
         "F",
         {"origin", "scale", "degrees of freedom 1", "degrees of freedom 2"},
         "min, (max - min) / 4, 5, 10"},
        {Kind::studentT,
         "Student's t",
         {"centre", "scale", "degrees of freedom"},
         "(min + max) / 2, (max - min) / 8, 5"},
        {Kind::beta, "beta", {"origin", "width", "a", "b"}, "min, max - min, 2, 2"},
        {Kind::pareto, "Pareto", {"least value", "exponent"}, "min, 4 / ln(max / min); min > 0"},
        {Kind::poisson, "Poisson", {"mean"}, "(min + max) / 2; whole numbers from min to max"}};
    return table;
}

const DistributionInfo& info(DistributionKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    if (number >= distributionTable().size())
        throw LogicError("unknown distribution");
    return distributionTable()[number];
}

Distribution::Distribution() : kind_(DistributionKind::uniform), min_(1.0), max_(1.0) {}

Distribution::Distribution(DistributionKind kind, double min, double max)
    : kind_(kind), min_(min), max_(max) {
    checkEnds(kind, min, max);
    checkEndsForDefaults(kind, min, max);
    if (isFixed())
        return;
    parameters_ = defaultParameters(kind, min, max);
    truncated_ = std::make_shared<const Truncated>(kind, min, max, parameters_);
}

Distribution::Distribution(DistributionKind kind, double min, double max,
                           std::vector<double> parameters)
    : kind_(kind), min_(min), max_(max), parameters_(std::move(parameters)) {
    checkEnds(kind, min, max);
    checkParameters(kind, parameters_);
    if (!isFixed())
        truncated_ = std::make_shared<const Truncated>(kind, min, max, parameters_);
}

Distribution::~Distribution() = default;
Distribution::Distribution(const Distribution& other) = default;
Distribution& Distribution::operator=(const Distribution& other) = default;
Distribution::Distribution(Distribution&&) noexcept = default;
Distribution& Distribution::operator=(Distribution&&) noexcept = default;

bool Distribution::hasDefaultParameters() const {
    return isFixed() ? parameters_.empty() : parameters_ == defaultParameters(kind_, min_, max_);
}

double Distribution::at(double u) const {
    if (isFixed())
        return min_;
    return std::clamp(truncated_->at(std::clamp(u, 0x1p-60, 1.0 - 0x1p-53)), min_, max_);
}

double Distribution::probabilityUpTo(double x) const {
    if (isFixed() || x < min_ || x >= max_)
        return x < min_ ? 0.0 : 1.0;
    return std::clamp(truncated_->probabilityUpTo(x), 0.0, 1.0);
}

bool Distribution::operator==(const Distribution& other) const {
    return kind_ == other.kind_ && min_ == other.min_ && max_ == other.max_ &&
           parameters_ == other.parameters_;
}

} // namespace irsg
