#include "gui/workbench/FirstScene.h"

#include <algorithm>
#include <filesystem>

#include "gui/start/DataFolder.h"
#include "gui/workbench/OrbitCamera.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

constexpr const char* air = "midlatitude-summer-rural-23km.xml";
constexpr const char *azimuth_deg = "40", *elevation_deg = "12";

/// To three digits: a number that people like.
std::string rounded(double value) {
    return QString::number(value, 'g', 3).toStdString();
}

} // namespace

Settings firstScene(const irsg::BoundingBox& bounds, Settings usual) {
    const double radius_m = 0.5 * irsg::length(bounds.max - bounds.min);
    usual.set(key::cameraAzimuth, azimuth_deg);
    usual.set(key::cameraElevation, elevation_deg);
    const double fov_rad = irsg::radians(usual[key::sensorFov]);
    const double range_m = OrbitCamera::rangeToShow(radius_m, fov_rad);
    usual.set(key::cameraRange, rounded(range_m));
    // What is large stands higher: nothing of it below the ground, and the sensor can look at it
    // from below, where no aircraft would be too high.
    constexpr double highest_m = 10000.0;
    usual.set(key::targetAltitude,
              rounded(std::max({Settings()[key::targetAltitude], 2.0 * radius_m,
                                std::min(1.1 * range_m, highest_m)})));
    const auto folder = dataFolder("resources/atmospheres");
    if (const auto file = folder / air; !folder.empty() && std::filesystem::exists(file))
        usual.set(key::environmentAtmospheres, file.string());
    return usual;
}

} // namespace smat::gui
