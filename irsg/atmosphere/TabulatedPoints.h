#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "irsg/atmosphere/TabulatedAtmosphere.h"

namespace irsg {

/// Tables of the quadrature points that were asked last.
struct TabulatedAtmosphere::OfPoints {
    static constexpr std::size_t most = 8;
    std::mutex mutex;
    std::map<std::vector<std::uint32_t>, std::shared_ptr<const TabulatedAtmosphere>> known;
};

} // namespace irsg
