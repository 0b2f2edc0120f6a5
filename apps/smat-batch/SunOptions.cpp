#include "apps/smat-batch/SunOptions.h"

#include <cmath>
#include <vector>

#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace smat::batch {

namespace {

/// An angle of a place on the earth; 0 with a diagnostic.
double angle_rad(const char* option, const std::string& text, double most_deg,
                 std::vector<irsg::Diagnostic>& diagnostics) {
    const auto value_deg = irsg::parseNumber(text);
    if (value_deg && std::abs(*value_deg) <= most_deg)
        return irsg::radians(*value_deg);
    diagnostics.push_back({option, "", text,
                           "a number from " + irsg::numberText(-most_deg) + " to " +
                               irsg::numberText(most_deg) + " deg"});
    return 0.0;
}

} // namespace

SunOptions::SunOptions(CLI::App& command) {
    const auto add = [&](const char* option, std::string& text, const char* unit,
                         const char* help) {
        command.add_option(option, text, help)->type_name(unit)->group("Environment");
    };
    add("--date", date_, "YYYY-MM-DD",
        "With --utc, --latitude and --longitude: the sun of a moment and a place, in place of "
        "--sun-azimuth, --sun-elevation and --day-of-year");
    add("--utc", utc_, "HH:MM[:SS]", "Universal time of that day");
    add("--latitude", latitude_, "deg", "North positive");
    add("--longitude", longitude_, "deg", "East positive");
}

std::optional<SunOptions::Sun> SunOptions::sun() const {
    const std::pair<const char*, const std::string*> all[] = {{"--date", &date_},
                                                              {"--utc", &utc_},
                                                              {"--latitude", &latitude_},
                                                              {"--longitude", &longitude_}};
    std::vector<irsg::Diagnostic> diagnostics;
    for (const auto& [option, text] : all)
        if (text->empty())
            diagnostics.push_back({option, "", "nothing",
                                   "a value: --date, --utc, --latitude and --longitude belong "
                                   "together"});
    if (diagnostics.size() == std::size(all))
        return std::nullopt;
    irsg::Geographic place;
    if (!latitude_.empty())
        place.latitude_rad = angle_rad("--latitude", latitude_, 90.0, diagnostics);
    if (!longitude_.empty())
        place.longitude_rad = angle_rad("--longitude", longitude_, 360.0, diagnostics);
    irsg::UniversalTime time;
    if (!date_.empty() && !utc_.empty())
        irsg::collect(
            diagnostics, [&] { time = irsg::UniversalTime::fromText(date_, utc_, ""); },
            [](irsg::Diagnostic& one) {
                one.file = "--" + one.position;
                one.position.clear();
            });
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return Sun{irsg::sunPosition(time, place), time.dayOfYear()};
}

} // namespace smat::batch
