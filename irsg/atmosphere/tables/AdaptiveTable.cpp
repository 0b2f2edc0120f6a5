#include "irsg/atmosphere/tables/AdaptiveTable.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b,
                            double part) {
    std::vector<double> values(a.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = a[i] + part * (b[i] - a[i]);
    return values;
}

} // namespace

AdaptiveTable::AdaptiveTable(double low, double high, double tolerance, Function function,
                             Distance distance)
    : low_(low),
      high_(high),
      tolerance_(tolerance),
      function_(std::move(function)),
      distance_(std::move(distance)) {
    if (!(low < high) || !(tolerance > 0.0))
        throw LogicError("a table was asked for over nothing or without a tolerance");
}

const AdaptiveTable::Values& AdaptiveTable::value(double x) const {
    const auto found = values_.find(x);
    if (found != values_.end())
        return found->second;
    ++evaluations_;
    return values_.emplace(x, function_(x)).first->second;
}

AdaptiveTable::Values AdaptiveTable::at(double x) const {
    if (!(x >= low_ && x <= high_))
        throw LogicError("a table was asked beyond its ends");
    const std::lock_guard lock(mutex_);
    // What was computed is given as it is; a table for a few queries is not worth its cells.
    if (const auto known = values_.find(x); known != values_.end())
        return known->second;
    constexpr int fewQueries = 3, deepest = 30;
    if (queries_ < fewQueries) {
        ++queries_;
        return value(x);
    }
    double a = low_, b = high_;
    for (int depth = 0; depth < deepest; ++depth) {
        const double middle = 0.5 * (a + b);
        const double quarter = 0.5 * (a + middle), threeQuarters = 0.5 * (middle + b);
        Cell& cell = cells_[{a, b}];
        if (!cell.tested) {
            const double error = std::max(distance_(value(quarter), value(a), value(middle)),
                                          distance_(value(threeQuarters), value(middle), value(b)));
            cell.tested = true;
            cell.good = error <= tolerance_;
            if (cell.good)
                largestError_ = std::max(largestError_, error);
        }
        // A good cell is used in its quarters, as their ends are known anyway.
        if (cell.good) {
            const double from = x < middle ? (x < quarter ? a : quarter)
                                           : (x < threeQuarters ? middle : threeQuarters);
            const double to = x < middle ? (x < quarter ? quarter : middle)
                                         : (x < threeQuarters ? threeQuarters : b);
            return between(value(from), value(to), (x - from) / (to - from));
        }
        (x < middle ? b : a) = middle;
    }
    ++evaluations_;
    return function_(x);
}

std::size_t AdaptiveTable::evaluations() const {
    const std::lock_guard lock(mutex_);
    return evaluations_;
}

std::size_t AdaptiveTable::bytes() const {
    const std::lock_guard lock(mutex_);
    std::size_t sum = 0;
    for (const auto& [x, values] : values_)
        sum += values.size() * sizeof(double);
    return sum;
}

double AdaptiveTable::largestError() const {
    const std::lock_guard lock(mutex_);
    return largestError_;
}

AdaptiveTable::Distance halfway(double (*difference)(const std::vector<double>&,
                                                     const std::vector<double>&)) {
    return [difference](const std::vector<double>& found, const std::vector<double>& from,
                        const std::vector<double>& to) {
        return difference(found, between(from, to, 0.5));
    };
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

double relativeDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += std::abs(a[i] - b[i]);
        sum += std::abs(a[i]);
    }
    return difference > 0.0 ? difference / sum : 0.0;
}

} // namespace irsg
