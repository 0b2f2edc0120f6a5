#include "irsg/radiance/PlanckTable.h"

#include "irsg/radiometry/Planck.h"

namespace irsg {

SharedValues PlanckTable::at(double temperature_K) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto known = cache_.find(temperature_K); known != cache_.end())
            return known->second;
    }
    std::vector<double> radiance(wavelengths_um_.size());
    planckRadiances_W_m2_sr_um(wavelengths_um_, temperature_K, radiance);
    const std::lock_guard lock(mutex_);
    if ((cache_.size() + 1) * wavelengths_um_.size() > mostCached)
        cache_.clear();
    return cache_
        .insert_or_assign(temperature_K,
                          std::make_shared<const std::vector<double>>(std::move(radiance)))
        .first->second;
}

} // namespace irsg
