#pragma once

namespace irsg {

/// Radius of the sphere that every path is laid over, m: that of MODTRAN's models of middle
/// latitudes.
inline constexpr double earthRadius_m = 6371.23e3;

} // namespace irsg
