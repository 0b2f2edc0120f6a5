#pragma once

#include <filesystem>
#include <string>

#include "irsg/sensor/SensorDescription.h"

namespace irsg {

/// The extension of such files.
inline constexpr const char* sensorExtension = ".smatsensor";

/// Reads a sensor (JSON, docs/sensor.md). Throws InputError with everything that is wrong with it,
/// by key and line: unknown keys and values that cannot be (SensorDescription::check) included.
SensorDescription loadSensor(const std::filesystem::path& file);
SensorDescription sensorFromJson(const std::string& text, const std::string& fileName);

/// Reads back equal. Members with their default are left out.
std::string sensorToJson(const SensorDescription& sensor);
/// Checks and writes it. Throws InputError.
void saveSensor(const SensorDescription& sensor, const std::filesystem::path& file);

} // namespace irsg
