#include "smatcore/settings/SettingRows.h"

#include <utility>

namespace smat::rows {

namespace {

SettingInfo row(std::string_view key, SettingKind kind, std::string option, std::string label,
                std::string defaultText, std::string help, SettingAudience audience) {
    return {.key = std::string(key),
            .label = std::move(label),
            .kind = kind,
            .defaultText = std::move(defaultText),
            .option = std::move(option),
            .help = std::move(help),
            .audience = audience};
}

SettingInfo withRange(SettingInfo info, std::string unit, double minimum, double maximum) {
    info.unit = std::move(unit);
    info.minimum = minimum;
    info.maximum = maximum;
    return info;
}

} // namespace

SettingInfo number(RealKey key, std::string option, std::string label, std::string unit,
                   double minimum, double maximum, std::string defaultText, std::string help,
                   SettingAudience audience) {
    return withRange(row(key, SettingKind::real, std::move(option), std::move(label),
                         std::move(defaultText), std::move(help), audience),
                     std::move(unit), minimum, maximum);
}

SettingInfo integer(IntegerKey key, std::string option, std::string label, std::string unit,
                    double minimum, double maximum, std::string defaultText, std::string help,
                    SettingAudience audience) {
    return withRange(row(key, SettingKind::integer, std::move(option), std::move(label),
                         std::move(defaultText), std::move(help), audience),
                     std::move(unit), minimum, maximum);
}

SettingInfo flag(BooleanKey key, std::string option, std::string label, bool byDefault,
                 std::string help, SettingAudience audience) {
    return row(key, SettingKind::boolean, std::move(option), std::move(label),
               byDefault ? "true" : "false", std::move(help), audience);
}

SettingInfo choice(TextKey key, std::string option, std::string label,
                   std::vector<std::string> choices, std::string defaultText, std::string help,
                   SettingAudience audience) {
    SettingInfo info = row(key, SettingKind::choice, std::move(option), std::move(label),
                           std::move(defaultText), std::move(help), audience);
    info.choices = std::move(choices);
    return info;
}

SettingInfo choiceOrNumber(OptionalRealKey key, std::string option, std::string label,
                           std::string unit, std::vector<std::string> choices, double minimum,
                           double maximum, std::string defaultText, std::string help,
                           SettingAudience audience) {
    SettingInfo info =
        withRange(row(key, SettingKind::choiceOrReal, std::move(option), std::move(label),
                      std::move(defaultText), std::move(help), audience),
                  std::move(unit), minimum, maximum);
    info.choices = std::move(choices);
    return info;
}

SettingInfo numbers(RealListKey key, std::string option, std::string label, std::string unit,
                    std::vector<std::string> choices, double minimum, double maximum,
                    std::string defaultText, std::string help, SettingAudience audience) {
    SettingInfo info =
        withRange(row(key, SettingKind::realList, std::move(option), std::move(label),
                      std::move(defaultText), std::move(help), audience),
                  std::move(unit), minimum, maximum);
    info.choices = std::move(choices);
    return info;
}

SettingInfo bands(TextKey key, std::string option, std::string label, std::string defaultText,
                  std::string help) {
    SettingInfo info = row(key, SettingKind::band, std::move(option), std::move(label),
                           std::move(defaultText), std::move(help), SettingAudience::basic);
    info.unit = "um";
    return info;
}

SettingInfo file(PathsKey key, std::string option, std::string label, std::string help) {
    return row(key, SettingKind::path, std::move(option), std::move(label), "", std::move(help),
               SettingAudience::basic);
}

SettingInfo files(PathsKey key, std::string option, std::string label, std::string help) {
    return row(key, SettingKind::pathList, std::move(option), std::move(label), "none",
               std::move(help), SettingAudience::basic);
}

namespace {

std::string adaptiveWords(const std::string& how) {
    return "adaptive: more cases where curves bend, " + how +
           ", until straight lines between them are within the target error, or 1 % where there "
           "is none";
}

} // namespace

SettingInfo adaptiveSteps(TextKey key, const std::string& how) {
    return choice(key, "--steps", "Spacing", {"fixed", "adaptive"}, "fixed",
                  "fixed, or " + adaptiveWords(how) + ".");
}

SettingInfo stepsOfPlot(TextKey key, const std::string& step, const std::string& how) {
    return choice(key, "--steps", "Spacing", {"auto", "fixed", "adaptive"}, "auto",
                  adaptiveWords(how) + "; auto: adaptive while " + step +
                      " is auto, with 2 % in place of 1 % and the errors of the numbers, else "
                      "fixed.");
}

SettingInfo formerly(SettingInfo info, FormerNames former) {
    info.former = std::move(former);
    return info;
}

SettingInfo named(SettingInfo info, std::vector<std::string> names) {
    info.names = std::move(names);
    return info;
}

} // namespace smat::rows
