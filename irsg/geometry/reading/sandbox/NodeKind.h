#pragma once

#include <cstdint>

namespace irsg {

/// The nodes that one process hands to another.
enum class NodeKind : std::uint8_t {
    group,
    geode,
    transform,
    lod,
    switching,
    multiSwitch,
    sequence,
    billboard,
    geometry,
    joint
};

} // namespace irsg
