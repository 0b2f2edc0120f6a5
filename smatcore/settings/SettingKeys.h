#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smat {

/// The name of a setting with the type of its value: `settings[key::sensorFov]` is a double. Keys
/// that only their analysis reads stand with its definition. The row of a key stands in
/// SettingTable.cpp, apart from it since most files include this one.
template <typename Value>
struct SettingKey {
    const char* name; ///< "sensor.fov"

    constexpr operator std::string_view() const { return name; }
    operator std::string() const { return name; }
    friend bool operator==(const std::string& text, SettingKey key) { return text == key.name; }
};
using RealKey = SettingKey<double>;
using IntegerKey = SettingKey<int>;
using BooleanKey = SettingKey<bool>;
using TextKey = SettingKey<std::string>;                         ///< a choice or a band
using OptionalRealKey = SettingKey<std::optional<double>>;       ///< a choice or a number
using RealListKey = SettingKey<std::vector<double>>;             ///< a choice or numbers
using PathsKey = SettingKey<std::vector<std::filesystem::path>>; ///< files, none or several

namespace key {

inline constexpr IntegerKey sensorWidth{"sensor.width"};
inline constexpr IntegerKey sensorHeight{"sensor.height"};
inline constexpr RealKey sensorFov{"sensor.fov"};
inline constexpr TextKey sensorBand{"sensor.band"};
inline constexpr PathsKey sensorResponse{"sensor.response"};
inline constexpr TextKey sensorMode{"sensor.mode"};

inline constexpr RealKey cameraRange{"camera.range"};
inline constexpr RealKey cameraAzimuth{"camera.azimuth"};
inline constexpr RealKey cameraElevation{"camera.elevation"};

inline constexpr RealKey targetYaw{"target.yaw"};
inline constexpr RealKey targetPitch{"target.pitch"};
inline constexpr RealKey targetRoll{"target.roll"};
inline constexpr RealKey targetAltitude{"target.altitude"};

inline constexpr RealKey stateTime{"state.time"};
inline constexpr RealKey statePower{"state.power"};
inline constexpr RealKey stateMach{"state.mach"};

inline constexpr BooleanKey scalingUse{"scaling.use"};
inline constexpr IntegerKey scalingSeed{"scaling.seed"};

inline constexpr PathsKey environmentAtmospheres{"environment.atmospheres"};
inline constexpr RealKey environmentSunAzimuth{"environment.sunAzimuth"};
inline constexpr RealKey environmentSunElevation{"environment.sunElevation"};
inline constexpr OptionalRealKey environmentDayOfYear{"environment.dayOfYear"};
inline constexpr RealKey environmentAmbientTemperature{"environment.ambientTemperature"};
inline constexpr TextKey environmentBins{"environment.bins"};
inline constexpr PathsKey environmentMtf{"environment.mtf"};
inline constexpr RealKey environmentScatteringCoefficient{"environment.scatteringCoefficient"};
inline constexpr PathsKey environmentSkybox{"environment.skybox"};
inline constexpr RealKey environmentSkyboxSlope{"environment.skyboxSlope"};
inline constexpr RealKey environmentSkyboxOffset{"environment.skyboxOffset"};
inline constexpr PathsKey environmentTerrain{"environment.terrain"};
inline constexpr RealKey environmentTerrainSlope{"environment.terrainSlope"};
inline constexpr RealKey environmentTerrainOffset{"environment.terrainOffset"};
inline constexpr RealKey environmentTerrainEast{"environment.terrainEast"};
inline constexpr RealKey environmentTerrainNorth{"environment.terrainNorth"};
inline constexpr RealKey environmentTerrainAltitude{"environment.terrainAltitude"};

inline constexpr IntegerKey renderAntialiasing{"render.antialiasing"};
inline constexpr TextKey renderZoom{"render.zoom"};
inline constexpr RealKey renderPointSource{"render.pointSource"};
inline constexpr BooleanKey renderHotSpots{"render.hotSpots"};
inline constexpr TextKey renderSupersampling{"render.supersampling"};
inline constexpr TextKey renderSun{"render.sun"};
inline constexpr TextKey renderAmbientReflection{"render.ambientReflection"};
inline constexpr TextKey renderFluxWeights{"render.fluxWeights"};
inline constexpr TextKey renderReferenceTransmittance{"render.referenceTransmittance"};
inline constexpr OptionalRealKey renderBackground{"render.background"};
inline constexpr IntegerKey renderBackgroundRows{"render.backgroundRows"};
inline constexpr IntegerKey renderBackgroundColumns{"render.backgroundColumns"};
inline constexpr BooleanKey renderSunDisc{"render.sunDisc"};
inline constexpr BooleanKey renderScattering{"render.scattering"};
inline constexpr BooleanKey renderTerrainHides{"render.terrainHides"};
inline constexpr IntegerKey renderLayers{"render.layers"};
inline constexpr TextKey renderEngine{"render.engine"};
inline constexpr TextKey renderShadows{"render.shadows"};
inline constexpr OptionalRealKey renderBounces{"render.bounces"};
inline constexpr RealKey renderLightError{"render.lightError"};
inline constexpr RealKey renderWidebandError{"render.widebandError"};
inline constexpr TextKey renderErrors{"render.errors"};
inline constexpr TextKey renderParts{"render.parts"};
inline constexpr OptionalRealKey renderTargetError{"render.targetError"};

inline constexpr TextKey displayColorMap{"display.colorMap"};
inline constexpr TextKey displayScale{"display.scale"};
inline constexpr BooleanKey displayMarkOutside{"display.markOutside"};
inline constexpr OptionalRealKey displayMinimum{"display.minimum"};
inline constexpr OptionalRealKey displayMaximum{"display.maximum"};

inline constexpr TextKey imageQuantity{"image.quantity"};
inline constexpr BooleanKey imageTruthLayers{"image.truthLayers"};
inline constexpr PathsKey imageSensor{"image.sensor"};
inline constexpr IntegerKey imageSensorSamples{"image.sensorSamples"};
inline constexpr IntegerKey imageNoiseSeed{"image.noiseSeed"};

inline constexpr OptionalRealKey polarStep{"polar.step"};
inline constexpr BooleanKey rangeLog{"range.log"};
inline constexpr BooleanKey conditionLog{"condition.log"};

/// "polar.steps", of the name of a kind of analysis: how its cases stand. Some kinds have no such
/// setting.
inline std::string stepsOf(std::string_view analysis) {
    return std::string(analysis) + ".steps";
}

} // namespace key

} // namespace smat
