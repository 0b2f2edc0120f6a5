#include "irsg/signature/LookupTable.h"

#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

std::string nodePlace(std::size_t node) {
    return "node " + std::to_string(node + 1);
}

} // namespace

LookupTable::LookupTable(std::vector<double> x, std::vector<double> y, bool loop,
                         const std::string& name)
    : x_(std::move(x)), y_(std::move(y)), loop_(loop) {
    if (x_.size() != y_.size()) {
        throw InputError(
            {name, "",
             std::to_string(x_.size()) + " axis nodes and " + std::to_string(y_.size()) + " values",
             "as many values as nodes"});
    }
    const std::size_t needed = loop_ ? 2 : 1;
    if (x_.size() < needed) {
        throw InputError({name, "", std::to_string(x_.size()) + " nodes",
                          loop_ ? "at least two nodes in a loop" : "at least one node"});
    }
    for (std::size_t i = 0; i < x_.size(); ++i) {
        if (!std::isfinite(x_[i]) || !std::isfinite(y_[i])) {
            throw InputError({name, nodePlace(i), numberText(x_[i]) + ", " + numberText(y_[i]),
                              "finite numbers"});
        }
        if (i > 0 && x_[i] <= x_[i - 1]) {
            throw InputError({name, nodePlace(i),
                              numberText(x_[i]) + " after " + numberText(x_[i - 1]),
                              "a strictly ascending axis"});
        }
    }
}

double LookupTable::at(double x) const {
    if (empty())
        throw LogicError("an empty lookup table has no value");
    // A loop brings x into [first, last); a time before the first node counts back from the last.
    if (loop_) {
        const double period = x_.back() - x_.front();
        const double phase = std::fmod(x - x_.front(), period);
        x = x_.front() + (phase < 0.0 ? phase + period : phase);
    }

    return interpolate(x_, y_, x);
}

bool LookupTable::isOutside(double x) const {
    return !empty() && !loop_ && (x < x_.front() || x > x_.back());
}

} // namespace irsg
