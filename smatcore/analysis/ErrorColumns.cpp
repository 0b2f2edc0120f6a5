#include "smatcore/analysis/ErrorColumns.h"

#include <limits>
#include <string>

#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

ErrorColumns errorColumnsOf(const Settings& settings) {
    const std::string& word = settings[key::renderErrors];
    return word == "off"      ? ErrorColumns::none
           : word == "causes" ? ErrorColumns::causes
                              : ErrorColumns::sum;
}

std::vector<const char*> errorPrefixes(ErrorColumns columns) {
    switch (columns) {
    case ErrorColumns::none:
        return {};
    case ErrorColumns::sum:
        return {"error_"};
    case ErrorColumns::causes:
        break;
    }
    return {"error_", "error_sampling_", "error_air_", "error_background_", "error_exchange_"};
}

irsg::ErrorParts unknownError() {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown, unknown};
}

void appendError(std::vector<double>& row, const irsg::ErrorParts& error, ErrorColumns columns) {
    if (columns == ErrorColumns::none)
        return;
    row.push_back(error.sum());
    if (columns == ErrorColumns::causes)
        row.insert(row.end(), {error.sampling, error.air, error.background, error.exchange});
}

void appendErrors(std::vector<double>& row, const std::optional<irsg::RadiometryErrors>& errors,
                  ErrorColumns columns) {
    const irsg::ErrorParts none = unknownError();
    const auto own = errors.value_or(irsg::RadiometryErrors{none, none, none});
    for (const irsg::ErrorParts& error :
         {own.intensity_W_sr, own.contrastIntensity_W_sr, own.irradiance_W_m2})
        appendError(row, error, columns);
}

void describeErrors(const irsg::RadiometryErrors& errors, irsg::RadianceImage& image) {
    const auto add = [&](const irsg::ErrorParts& error, irsg::Quantity quantity,
                         const std::string& unit) {
        const std::string key = std::string(irsg::info(quantity).key) + "_" + unit;
        const auto set = [&](const char* prefix, double value) {
            image.attributes[prefix + key] = irsg::roundedText(value, 9);
        };
        set("error_", error.sum());
        set("error_sampling_", error.sampling);
        set("error_air_", error.air);
        set("error_background_", error.background);
        set("error_exchange_", error.exchange);
    };
    add(errors.intensity_W_sr, irsg::Quantity::intensity, "W_sr");
    add(errors.contrastIntensity_W_sr, irsg::Quantity::contrastIntensity, "W_sr");
    add(errors.irradiance_W_m2, irsg::Quantity::irradiance, "W_m2");
}

} // namespace smat
