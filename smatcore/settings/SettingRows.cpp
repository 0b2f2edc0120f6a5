#include "smatcore/settings/SettingRows.h"

#include <utility>

namespace smat::rows {

SettingInfo number(std::string key, std::string option, std::string label, std::string unit,
                   double minimum, double maximum, std::string defaultText, std::string help,
                   SettingAudience audience) {
    return {.key = std::move(key),
            .label = std::move(label),
            .unit = std::move(unit),
            .kind = SettingKind::real,
            .minimum = minimum,
            .maximum = maximum,
            .defaultText = std::move(defaultText),
            .option = std::move(option),
            .help = std::move(help),
            .audience = audience};
}

SettingInfo integer(std::string key, std::string option, std::string label, std::string unit,
                    double minimum, double maximum, std::string defaultText, std::string help,
                    SettingAudience audience) {
    SettingInfo info = number(std::move(key), std::move(option), std::move(label), std::move(unit),
                              minimum, maximum, std::move(defaultText), std::move(help), audience);
    info.kind = SettingKind::integer;
    return info;
}

SettingInfo choice(std::string key, std::string option, std::string label,
                   std::vector<std::string> choices, std::string defaultText, std::string help,
                   SettingAudience audience) {
    return {.key = std::move(key),
            .label = std::move(label),
            .kind = SettingKind::choice,
            .choices = std::move(choices),
            .defaultText = std::move(defaultText),
            .option = std::move(option),
            .help = std::move(help),
            .audience = audience};
}

SettingInfo named(SettingInfo info, std::vector<std::string> names) {
    info.names = std::move(names);
    return info;
}

SettingInfo choiceOrNumber(std::string key, std::string option, std::string label, std::string unit,
                           std::vector<std::string> choices, double minimum, double maximum,
                           std::string defaultText, std::string help, SettingAudience audience) {
    SettingInfo info = number(std::move(key), std::move(option), std::move(label), std::move(unit),
                              minimum, maximum, std::move(defaultText), std::move(help), audience);
    info.kind = SettingKind::choiceOrReal;
    info.choices = std::move(choices);
    return info;
}

SettingInfo text(std::string key, std::string option, std::string label, std::string unit,
                 SettingKind kind, std::string defaultText, std::string help,
                 SettingAudience audience) {
    return {.key = std::move(key),
            .label = std::move(label),
            .unit = std::move(unit),
            .kind = kind,
            .defaultText = std::move(defaultText),
            .option = std::move(option),
            .help = std::move(help),
            .audience = audience};
}

} // namespace smat::rows
