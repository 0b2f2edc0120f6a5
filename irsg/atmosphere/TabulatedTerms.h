#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "irsg/atmosphere/TabulatedAtmosphere.h"

namespace irsg {

/// Tables of the terms that were asked last.
struct TabulatedAtmosphere::OfTerms {
    static constexpr std::size_t most = 8;
    std::mutex mutex;
    std::map<std::vector<std::uint32_t>, std::shared_ptr<const TabulatedAtmosphere>> known;
};

} // namespace irsg
