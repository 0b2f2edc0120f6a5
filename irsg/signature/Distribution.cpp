#include "irsg/signature/Distribution.h"

#include <algorithm>
#include <cmath>

#include "irsg/signature/DistributionLaw.h"
#include "irsg/signature/TruncatedDistribution.h"

namespace irsg {

namespace {

void checkEnds(DistributionKind kind, double min, double max) {
    ParameterCheck validate;
    const int number = static_cast<int>(kind);
    validate.require(number >= 0 && number < distributionKindCount, "distribution", number,
                     "a number from 0 to " + std::to_string(distributionKindCount - 1));
    const auto isUsable = [](double x) { return std::isfinite(x) && std::abs(x) <= 1e150; };
    validate.require(isUsable(min), "min", min, "a number between -1e150 and 1e150");
    validate.require(isUsable(max), "max", max, "a number between -1e150 and 1e150");
    validate.throwOnDiagnostics();
    validate.require(min <= max, "min", min, "at most max, " + numberText(max));
    validate.throwOnDiagnostics();
}

/// What min and max must be for the default parameters to exist.
void checkEndsForDefaults(DistributionKind kind, double min, double max) {
    const auto checkEnds = lawOf(kind).checkEnds;
    if (checkEnds == nullptr || min == max)
        return;
    ParameterCheck validate;
    checkEnds(validate, min, max);
    validate.throwOnDiagnostics();
}

void checkParameters(DistributionKind kind, const std::vector<double>& p) {
    const DistributionInfo& about = info(kind);
    ParameterCheck validate;
    const std::string expected = std::to_string(about.parameters.size()) + " for this distribution";
    validate.require(p.size() == about.parameters.size(), "a number of parameters of",
                     static_cast<double>(p.size()), expected);
    validate.throwOnDiagnostics();
    for (std::size_t i = 0; i < p.size(); ++i)
        validate.require(std::isfinite(p[i]) && std::abs(p[i]) <= 1e150, about.parameters[i], p[i],
                         "a number between -1e150 and 1e150");
    validate.throwOnDiagnostics();
    if (const auto check = lawOf(kind).check)
        check(validate, p);
    validate.throwOnDiagnostics();
}

} // namespace

Distribution::Distribution() : kind_(DistributionKind::uniform), min_(1.0), max_(1.0) {}

Distribution::Distribution(DistributionKind kind, double min, double max)
    : kind_(kind), min_(min), max_(max) {
    checkEnds(kind, min, max);
    checkEndsForDefaults(kind, min, max);
    if (isFixed())
        return;
    parameters_ = lawOf(kind).defaults(min, max);
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
    return isFixed() ? parameters_.empty() : parameters_ == lawOf(kind_).defaults(min_, max_);
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
