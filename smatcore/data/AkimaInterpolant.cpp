#include "smatcore/data/AkimaInterpolant.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace smat {

namespace {

/// A curve with the places of two more intervals on either side, of which slopes are made.
struct Extended {
    std::vector<double> x, y;
};

/// Beyond its ends a curve bends as it does there: the parabola through the last three samples.
void addParabolas(Extended& curve) {
    const auto parabola = [](double x0, double y0, double x1, double y1, double x2, double y2,
                             double x) {
        return y0 * (x - x1) * (x - x2) / ((x0 - x1) * (x0 - x2)) +
               y1 * (x - x0) * (x - x2) / ((x1 - x0) * (x1 - x2)) +
               y2 * (x - x0) * (x - x1) / ((x2 - x0) * (x2 - x1));
    };
    auto& [x, y] = curve;
    const std::vector<double> xs = x, ys = y;
    const std::size_t n = xs.size();
    for (int k = 1; k <= 2; ++k) {
        const double below = xs[0] - k * (xs[1] - xs[0]);
        const double above = xs[n - 1] + k * (xs[n - 1] - xs[n - 2]);
        x.insert(x.begin(), below);
        y.insert(y.begin(), parabola(xs[0], ys[0], xs[1], ys[1], xs[2], ys[2], below));
        x.push_back(above);
        y.push_back(
            parabola(xs[n - 1], ys[n - 1], xs[n - 2], ys[n - 2], xs[n - 3], ys[n - 3], above));
    }
}

} // namespace

bool goesRound(const std::vector<double>& x, double period) {
    if (x.size() < 4 || !(period > 0.0))
        return false;
    double step = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
        step = std::max(step, std::abs(x[i + 1] - x[i]));
    const double span = std::abs(x.back() - x.front());
    return span < period && span + 1.5 * step >= period;
}

AkimaInterpolant::AkimaInterpolant(const std::vector<double>& x, const std::vector<double>& y,
                                   double period)
    : x_(x), y_(y), period_(period) {
    const auto isFinite = [](double value) { return std::isfinite(value); };
    if (x.size() != y.size() || !std::ranges::all_of(x, isFinite) ||
        !std::ranges::all_of(y, isFinite) ||
        std::ranges::adjacent_find(x, std::greater_equal<>()) != x.end() ||
        (period > 0.0 && !x.empty() && x.back() - x.front() >= period))
        throw irsg::LogicError("a curve needs finite samples that ascend");
    const std::size_t own = x.size();
    if (period > 0.0 && own > 0) {
        x_.push_back(x.front() + period);
        y_.push_back(y.front());
    }
    slopes_.assign(x_.size(), 0.0);
    if (x_.size() < 2)
        return;
    if (x_.size() == 2) {
        slopes_.assign(2, (y_[1] - y_[0]) / (x_[1] - x_[0]));
        return;
    }
    Extended all{x_, y_};
    if (period > 0.0) {
        const auto add = [&](std::ptrdiff_t sample, bool isBelow) {
            const auto count = static_cast<std::ptrdiff_t>(own);
            const std::ptrdiff_t turns =
                sample < 0 ? -((count - 1 - sample) / count) : sample / count;
            const auto k = static_cast<std::size_t>(sample - turns * count);
            all.x.insert(isBelow ? all.x.begin() : all.x.end(),
                         x[k] + period * static_cast<double>(turns));
            all.y.insert(isBelow ? all.y.begin() : all.y.end(), y[k]);
        };
        for (std::ptrdiff_t k = 1; k <= 2; ++k) {
            add(-k, true);
            add(static_cast<std::ptrdiff_t>(own) + k, false);
        }
    } else {
        addParabolas(all);
    }
    const auto secant = [&](std::size_t i) { // from extended sample i to the next
        return (all.y[i + 1] - all.y[i]) / (all.x[i + 1] - all.x[i]);
    };
    const auto bend = [&](std::size_t i) { // at extended sample i
        return std::abs((secant(i) - secant(i - 1)) / (all.x[i + 1] - all.x[i - 1]));
    };
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const std::size_t k = i + 2;
        const double before = all.x[k] - all.x[k - 1], after = all.x[k + 1] - all.x[k];
        double left = bend(k + 1) * after, right = bend(k - 1) * before;
        if (!(left + right > 0.0)) {
            left = after;
            right = before;
        }
        slopes_[i] = (left * secant(k - 1) + right * secant(k)) / (left + right);
    }
}

double AkimaInterpolant::between(std::size_t i, double part) const {
    const double step = x_.at(i + 1) - x_[i], rest = 1.0 - part;
    // Hermite's form, about the straight line.
    const double secant = y_[i + 1] - y_[i];
    const double first = slopes_[i] * step - secant, last = slopes_[i + 1] * step - secant;
    return y_[i] + part * secant + part * rest * (rest * first - part * last);
}

double AkimaInterpolant::at(double x) const {
    if (x_.empty())
        return std::numeric_limits<double>::quiet_NaN();
    if (period_ > 0.0)
        x -= period_ * std::floor((x - x_.front()) / period_);
    if (!(x >= x_.front() && x <= x_.back()))
        return std::numeric_limits<double>::quiet_NaN();
    if (x == x_.back())
        return y_.back();
    const irsg::Bracket place = irsg::bracket(x_, x);
    return between(place.below, place.fraction);
}

} // namespace smat
