#pragma once

#include <optional>
#include <string>
#include <vector>

#include "irsg/core/JsonReader.h"
#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// What files of ours that people may write have in common, as JsonWriting writes it: what is wrong
/// is collected in the reader.

/// A file with a `version`. Throws InputError for text that is not JSON, for a root that is no
/// object and for a version that is missing or newer, as by the same keys a newer file may mean
/// other things. `kind` says what the file should be ("a project file (JSON)"), `parts` what is in
/// it. A `program`, which wrote the file, counts as known.
irsg::JsonReader readVersioned(const std::string& text, const std::string& file, const char* kind,
                               int newest, const char* parts);

/// Three numbers in m, each up to 1e9; no value where they are missing.
std::optional<irsg::Vec3> readPoint(const irsg::JsonReader& json);
/// `yaw_deg`, `pitch_deg` and `roll_deg` of an object.
irsg::Attitude readAttitude(const irsg::JsonReader& json);
/// The index of an entry; no value where it is missing.
std::optional<int> readEntryIndex(const irsg::JsonReader& json);
/// How a model is read, of an object: `upAxis`, `noseAxis`, `unit_m`, `origin`, `twoSided` and
/// `cutTextureAlpha`.
irsg::ModelOptions readModelOptions(const irsg::JsonReader& json);
/// The settings in the sections of an object; of others than `isAllowed` none.
Settings readSettings(const irsg::JsonReader& json,
                      bool (*isAllowed)(const SettingInfo& setting) = nullptr);

/// True for what can be the name of a file in any folder: no separators, no line breaks, no dot in
/// front.
bool isFileName(const std::string& name);

/// "file", "centre" and "base", in the order of irsg::ModelOrigin::At.
const std::vector<std::string>& modelOriginNames();

} // namespace smat
