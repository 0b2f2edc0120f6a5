#pragma once

#include <cstddef>

namespace irsg {

/// Goes on by a stretch in a uniform gas, at many strengths of absorption: what passes and what is
/// emitted. `emission`: of the gas as a black body.
void addStretch(const double* absorption_per_m, const double* emission, double length_m,
                std::size_t count, double* passes, double* emits);

/// sums[k] += values[i] * map[i * columns + k].
void addMapped(const double* values, std::size_t count, const double* map, std::size_t columns,
               double* sums);

} // namespace irsg
