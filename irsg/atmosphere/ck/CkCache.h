#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "irsg/atmosphere/ck/CkNodes.h"
#include "irsg/atmosphere/ck/CkStore.h"
#include "irsg/atmosphere/ck/SensorCkData.h"

namespace irsg {

/// Counts up with every change of what is trained: a part of every key.
inline constexpr double ckTraining = 7;

/// Quadrature points that are kept under a key, if they are those of these nodes, else trained and
/// kept; without a store trained.
inline std::shared_ptr<const SensorCkData>
cachedOrTrained(const std::optional<CkStore>& store, const CkKey& key, const CkNodes& nodes,
                const Band& band, const std::function<SensorCkData()>& train) {
    if (!store)
        return std::make_shared<const SensorCkData>(train());
    if (const auto text = store->find(key.text()))
        if (auto kept = SensorCkData::fromCached(nodes, band, *text))
            return std::make_shared<const SensorCkData>(std::move(*kept));
    auto made = std::make_shared<const SensorCkData>(train());
    store->keep(key.text(), made->cacheText());
    return made;
}

} // namespace irsg
