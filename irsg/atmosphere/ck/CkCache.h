#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "irsg/atmosphere/ck/CkNodes.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/CacheStore.h"

namespace irsg {

/// Quadrature points that were trained once, of this user's programs.
inline std::optional<CacheStore> ckStore() {
    return CacheStore::ofUser({"wideband", std::uintmax_t{32} << 20});
}

/// Counts up with every change of what is trained: a part of every key.
inline constexpr double ckTraining = 7;

/// Quadrature points that are kept under a key, if they are those of these nodes, else trained and
/// kept; without a store trained.
inline std::shared_ptr<const SensorCkData>
cachedOrTrained(const std::optional<CacheStore>& store, const CacheKey& key, const CkNodes& nodes,
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
