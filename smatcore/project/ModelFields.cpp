#include "smatcore/project/ModelFields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/SceneModels.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/NearestNames.h"

namespace smat {

namespace {

constexpr double farthestPlace_m = 1e7;

/// What a conversion between degrees and radians leaves behind the digits that somebody wrote.
double withoutRounding(double value) {
    return std::round(value * 1e10) / 1e10;
}

std::string plainText(double value) {
    return fmt::format("{}", value == 0.0 ? 0.0 : value);
}

double valueOf(const std::string& canonical) {
    return irsg::parseNumber(canonical).value();
}

/// An angle from -180 to 180.
double turned(double angle_deg) {
    const double rest = std::remainder(angle_deg, 360.0);
    return rest <= -180.0 ? rest + 360.0 : rest;
}

/// Heading, in [0, 360), of a yaw and back.
double headingOf(double yaw_deg) {
    const double heading = std::fmod(-yaw_deg, 360.0);
    return withoutRounding(heading < 0.0 ? heading + 360.0 : heading);
}

ModelField fieldOf(std::string key, std::string option, std::string label, std::string unit,
                   double minimum, double maximum, std::string help, std::string ofTarget) {
    ModelField field;
    field.key = key;
    field.info = {.key = "model." + key,
                  .label = std::move(label),
                  .unit = std::move(unit),
                  .kind = SettingKind::real,
                  .minimum = minimum,
                  .maximum = maximum,
                  .defaultText = "0",
                  .option = std::move(option),
                  .help = std::move(help)};
    field.ofTarget = std::move(ofTarget);
    return field;
}

ModelField coordinate(std::string key, double irsg::Vec3::*along, std::string label, double minimum,
                      double maximum, std::string help, std::string ofTarget) {
    ModelField field = fieldOf(key, "--" + key, std::move(label), "m", minimum, maximum,
                               std::move(help), std::move(ofTarget));
    field.text = [along](const ProjectModel& model) {
        return plainText(model.pose.position_m.*along);
    };
    field.set = [along](ProjectModel& model, const std::string& text) {
        model.pose.position_m.*along = valueOf(text);
    };
    return field;
}

ModelField angle(std::string key, double irsg::Attitude::*of, double limit_deg, std::string label,
                 std::string help, std::string ofTarget) {
    ModelField field = fieldOf(key, "--" + key, std::move(label), "deg", -limit_deg, limit_deg,
                               std::move(help), std::move(ofTarget));
    field.text = [of](const ProjectModel& model) {
        return plainText(withoutRounding(irsg::degrees(model.pose.attitude.*of)));
    };
    field.set = [of](ProjectModel& model, const std::string& text) {
        model.pose.attitude.*of = irsg::radians(valueOf(text));
    };
    return field;
}

ModelField heading() {
    ModelField field =
        fieldOf("heading", "--heading", "Heading", "deg", -360, 360,
                "Where the nose points, clockwise from north: minus the yaw.", key::targetYaw);
    field.text = [](const ProjectModel& model) {
        return plainText(headingOf(irsg::degrees(model.pose.attitude.yaw_rad)));
    };
    field.set = [](ProjectModel& model, const std::string& text) {
        model.pose.attitude.yaw_rad = irsg::radians(turned(-valueOf(text)));
    };
    return field;
}

ModelField ownNumber(std::string key, std::optional<double> StateOverride::*of, RealKey setting,
                     std::string label, std::string help) {
    const SettingInfo& limits = settingInfo(setting);
    ModelField field = fieldOf(key, "--" + key, std::move(label), limits.unit, limits.minimum,
                               limits.maximum, std::move(help), limits.key);
    field.info.kind = SettingKind::choiceOrReal;
    field.info.choices = {asTheTarget};
    field.info.defaultText = asTheTarget;
    field.text = [of](const ProjectModel& model) {
        const auto& value = model.own.*of;
        return value ? plainText(*value) : std::string(asTheTarget);
    };
    field.set = [of](ProjectModel& model, const std::string& text) {
        model.own.*of = irsg::parseNumber(text);
    };
    return field;
}

std::vector<ModelField> makeFields() {
    std::vector<ModelField> fields;
    fields.push_back(coordinate("east", &irsg::Vec3::x, "East", -farthestPlace_m, farthestPlace_m,
                                "Where its origin stands, east of the target's origin.", ""));
    fields.push_back(coordinate("north", &irsg::Vec3::y, "North", -farthestPlace_m, farthestPlace_m,
                                "The same, north of the target's origin.", ""));
    fields.push_back(coordinate(
        "altitude", &irsg::Vec3::z, "Altitude", 0, 1e6,
        "Altitude of its origin above the ground; the air it is in follows.", key::targetAltitude));
    fields.push_back(heading());
    fields.push_back(angle("yaw", &irsg::Attitude::yaw_rad, 360, "Yaw",
                           "Turns it counter-clockwise seen from above: minus the heading.",
                           key::targetYaw));
    fields.push_back(angle("pitch", &irsg::Attitude::pitch_rad, 90, "Pitch", "Nose up is positive.",
                           key::targetPitch));
    fields.push_back(angle("roll", &irsg::Attitude::roll_rad, 180, "Roll",
                           "Starboard down is positive.", key::targetRoll));
    fields.push_back(ownNumber("power", &StateOverride::power, key::statePower, "Engine power",
                               "Power setting of its own; target: what state.power and sweeps of "
                               "it say."));
    fields.push_back(ownNumber("mach", &StateOverride::mach, key::stateMach, "Mach number",
                               "Speed of its own for aerodynamic heating; target: what state.mach "
                               "and sweeps of it say."));
    const SettingInfo& time = settingInfo(key::stateTime);
    ModelField offset =
        fieldOf("timeOffset", "--time-offset", "Time offset", "s", time.minimum, time.maximum,
                "Added to the time of the scene on the axis of its time tables.", "");
    offset.text = [](const ProjectModel& model) { return plainText(model.own.timeOffset_s); };
    offset.set = [](ProjectModel& model, const std::string& text) {
        model.own.timeOffset_s = valueOf(text);
    };
    fields.push_back(std::move(offset));
    return fields;
}

[[noreturn]] void refusePlace(const std::string& where, std::string_view text,
                              std::string expected) {
    throw irsg::InputError({.file = where,
                            .position = "",
                            .value = text.empty() ? "nothing" : std::string(text),
                            .expected = std::move(expected)});
}

constexpr std::string_view modelPrefix = "models.";

std::vector<std::string> modelFieldKeys() {
    std::vector<std::string> keys;
    for (const ModelField& field : modelFields())
        keys.push_back(field.key);
    return keys;
}

} // namespace

const std::vector<ModelField>& modelFields() {
    static const std::vector<ModelField> fields = makeFields();
    return fields;
}

const ModelField* findModelField(std::string_view key) {
    const auto found = std::ranges::find(modelFields(), key, &ModelField::key);
    return found == modelFields().end() ? nullptr : &*found;
}

std::string textOf(const Project& project, std::size_t model, const ModelField& field) {
    if (model > 0)
        return field.text(project.models.at(model));
    if (field.ofTarget.empty())
        return "";
    return field.key == "heading" ? plainText(headingOf(project.settings[key::targetYaw]))
                                  : project.settings.text(field.ofTarget);
}

void setField(Project& project, std::size_t model, const ModelField& field, std::string_view text,
              const std::string& where) {
    if (model == 0 && field.ofTarget.empty()) {
        refusePlace(where, text,
                    field.key == "timeOffset"
                        ? "none for the target: state.time is its time"
                        : "nothing for the target, whose origin is that of east and north");
    }
    const auto canonical = canonicalText(field.info, text);
    if (!canonical)
        refusePlace(where, text, field.info.expectedInsteadOf(text));
    if (model > 0)
        field.set(project.models.at(model), *canonical);
    else if (field.key == "heading")
        project.settings.set(field.ofTarget, turned(-valueOf(*canonical)));
    else if (*canonical == asTheTarget)
        refusePlace(where, text, settingInfo(field.ofTarget).expected());
    else
        project.settings.set(field.ofTarget, *canonical, where);
}

bool isModelAssignment(std::string_view argument) {
    return irsg::trimmed(argument).starts_with(modelPrefix);
}

void assignToModel(Project& project, std::string_view argument) {
    const std::size_t equals = argument.find('=');
    const std::string_view place = irsg::trimmed(argument.substr(0, equals));
    const std::string_view path = place.substr(modelPrefix.size());
    const std::size_t dot = path.rfind('.');
    if (equals == std::string_view::npos || dot == std::string_view::npos)
        refusePlace("--set", argument,
                    "models.NAME.KEY=value, where KEY is " + oneOf(modelFieldKeys(), ""));
    const ModelField* field = findModelField(path.substr(dot + 1));
    if (field == nullptr)
        refusePlace(std::string(place), path.substr(dot + 1),
                    oneOf(modelFieldKeys(), path.substr(dot + 1)));
    const std::size_t model = findModel(project, path.substr(0, dot), std::string(place));
    if (model == 0 && !field->ofTarget.empty())
        refusePlace(std::string(place), path.substr(0, dot),
                    "a model that is not the target; " + field->ofTarget +
                        " says it of the target");
    setField(project, model, *field, argument.substr(equals + 1), std::string(place));
}

} // namespace smat
