#include "irsg/gas/GasStrengths.h"

#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {

IRSG_VECTOR_CLONES void addStretch(const double* absorption_per_m, const double* emission,
                                   double length_m, std::size_t count, double* passes,
                                   double* emits) {
    for (std::size_t i = 0; i < count; ++i) {
        const double stopped = passes[i] * vectorAbsorbed(absorption_per_m[i] * length_m);
        emits[i] += emission[i] * stopped;
        passes[i] -= stopped;
    }
}

IRSG_VECTOR_CLONES void addMapped(const double* values, std::size_t count, const double* map,
                                  std::size_t columns, double* sums) {
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < columns; ++k)
            sums[k] += values[i] * map[i * columns + k];
}

} // namespace irsg
