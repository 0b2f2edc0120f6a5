#pragma once

#include <filesystem>

namespace smat {

/// A sea with waves, 12 km a side about the origin, flat: sea.osgb with its picture waves.png,
/// which repeats every 256 m and shows the slope of the waves along the wind: 0.5 is level water, 1
/// the steepest slope. And the same with the wake of the sample corvette about it: wake.osgb, with
/// wake.png for the 256 m that the wake is seen in.
void writeSea(const std::filesystem::path& folder);

} // namespace smat
