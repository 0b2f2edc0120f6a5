#pragma once

#include <filesystem>

namespace smat {

/// A sky of clouds without a sun: six 16-bit pictures north.png to down.png of 512 texels a side.
/// 0 is clear sky, 1 the thickest cloud; nothing below the horizon.
void writeCloudSkybox(const std::filesystem::path& folder);

/// Hills on both sides of a valley that runs from south to north, 16 km a side and up to 1.3 km
/// high: valley.osgb with its picture ground.png of 16 bits, 0.5 where the ground is as warm as the
/// air takes it to be, brighter on bare rock, darker in the woods.
void writeValleyTerrain(const std::filesystem::path& folder);

} // namespace smat
