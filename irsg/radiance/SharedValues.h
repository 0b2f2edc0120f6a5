#pragma once

#include <memory>
#include <vector>

namespace irsg {

/// A quantity at the nodes of a sampling, which many hold and nobody changes.
using SharedValues = std::shared_ptr<const std::vector<double>>;

/// By value; what is the same object is not looked at.
inline bool areEqual(const SharedValues& a, const SharedValues& b) {
    return a == b || (a && b && *a == *b);
}

} // namespace irsg
