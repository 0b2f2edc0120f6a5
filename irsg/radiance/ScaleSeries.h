#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "irsg/radiometry/Units.h"

namespace irsg {

/// A positive smooth function of a scale s on an interval, as a Chebyshev series of its logarithm
/// over 1 / s: Planck's law is nearly a straight line there.
class ScaleSeries {
  public:
    /// A constant.
    explicit ScaleSeries(double constant = 0.0) : constant_(constant) {}
    /// No value where 65 terms do not reach 1e-11 relative, or the function is not positive.
    template <typename Function>
    static std::optional<ScaleSeries> fitted(double least, double most, const Function& function);

    double at(double scale) const;

  private:
    double constant_ = 0.0;
    double middle_ = 0.0, halfWidth_ = 0.0;
    std::vector<double> terms_;
};

template <typename Function>
std::optional<ScaleSeries> ScaleSeries::fitted(double least, double most,
                                               const Function& function) {
    if (!(most > least))
        return ScaleSeries(function(least));
    ScaleSeries series;
    series.middle_ = 0.5 * (1.0 / least + 1.0 / most);
    series.halfWidth_ = 0.5 * (1.0 / least - 1.0 / most);
    const auto valueAt = [&](double x) {
        return function(1.0 / (series.middle_ + series.halfWidth_ * x));
    };
    for (int count = 9; count <= 65; count = 2 * count - 1) {
        std::vector<double> logs;
        for (int i = 0; i < count; ++i) {
            const double value = valueAt(std::cos(pi * (i + 0.5) / count));
            if (!(value > 0.0) || !std::isfinite(value))
                return std::nullopt;
            logs.push_back(std::log(value));
        }
        series.terms_.assign(static_cast<std::size_t>(count), 0.0);
        for (int j = 0; j < count; ++j) {
            double sum = 0.0;
            for (int i = 0; i < count; ++i)
                sum += logs[static_cast<std::size_t>(i)] * std::cos(pi * j * (i + 0.5) / count);
            series.terms_[static_cast<std::size_t>(j)] = sum * (j == 0 ? 1.0 : 2.0) / count;
        }
        bool isExact = true;
        for (const double x : {-1.0, -0.83, -0.41, 0.07, 0.52, 0.91, 1.0}) {
            const double value = valueAt(x);
            const double found = series.at(1.0 / (series.middle_ + series.halfWidth_ * x));
            isExact = isExact && std::abs(found - value) <= 1e-11 * value;
        }
        if (isExact) {
            while (series.terms_.size() > 2 && std::abs(series.terms_.back()) < 1e-14)
                series.terms_.pop_back();
            return series;
        }
    }
    return std::nullopt;
}

inline double ScaleSeries::at(double scale) const {
    if (terms_.empty())
        return constant_;
    // Clenshaw's recurrence.
    const double x = (1.0 / scale - middle_) / halfWidth_;
    double next = 0.0, afterNext = 0.0;
    for (std::size_t j = terms_.size() - 1; j > 0; --j) {
        const double here = terms_[j] + 2.0 * x * next - afterNext;
        afterNext = next;
        next = here;
    }
    return std::exp(terms_[0] + x * next - afterNext);
}

} // namespace irsg
