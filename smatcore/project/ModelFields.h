#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "smatcore/project/Project.h"
#include "smatcore/settings/SettingInfo.h"

namespace smat {

/// A number of a model: where it stands and what it does. The one description of it, from which
/// options, `--set models.NAME.KEY`, fields of the window and checks come.
struct ModelField {
    std::string key;      ///< "east", "timeOffset"
    SettingInfo info;     ///< label, unit, range, option, help; of kind real or choiceOrReal
    std::string ofTarget; ///< the setting that says it of the target; empty where none does
    /// Canonical text of a model that is not the target.
    std::function<std::string(const ProjectModel&)> text;
    std::function<void(ProjectModel&, const std::string& canonical)> set;
};

/// The choice of a state that a model does not have of its own.
inline constexpr const char* asTheTarget = "target";

/// Place (east, north, altitude, heading, yaw, pitch, roll; heading and yaw are one number), then
/// state (power, mach, timeOffset).
const std::vector<ModelField>& modelFields();
/// Null for an unknown key.
const ModelField* findModelField(std::string_view key);

/// Of any model, the target's from the settings of the project. Empty where the target has none.
std::string textOf(const Project& project, std::size_t model, const ModelField& field);
/// Sets it, for the target in the settings of the project. Throws InputError that calls the place
/// of the text `where`, for a text that is no value and for what the target has not.
void setField(Project& project, std::size_t model, const ModelField& field, std::string_view text,
              const std::string& where);

/// The argument of `--set`, "models.NAME.KEY=value", is about a model; NAME as findModel takes it.
bool isModelAssignment(std::string_view argument);
/// Does what it says. Throws InputError; what settings say of the target is refused by their name,
/// since an analysis may have its own.
void assignToModel(Project& project, std::string_view argument);

} // namespace smat
