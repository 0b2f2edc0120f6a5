#include "smatcore/project/AtmosphereInput.h"

#include <system_error>
#include <utility>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/support/Log.h"

namespace smat {

bool isNoAir(const std::filesystem::path& input) {
    return input == "none" || input == "vacuum";
}

namespace {

std::shared_ptr<const irsg::Atmosphere> opened(const std::filesystem::path& input) {
    if (isNoAir(input)) {
        return std::make_shared<irsg::Vacuum>();
    }
    std::error_code failure;
    if (!std::filesystem::is_regular_file(input, failure)) {
        throw irsg::InputError(irsg::Offence{.file = input.string(),
                                             .position = "",
                                             .value = "no such file",
                                             .expected = "none, vacuum or an atmosphere file"});
    }
    logInfo("reading atmosphere " + input.string());
    return irsg::loadAtmosphere(input);
}

} // namespace

std::shared_ptr<const irsg::Atmosphere> openAtmosphere(const std::filesystem::path& input,
                                                       std::optional<int> resolution_cm) {
    const std::shared_ptr<const irsg::Atmosphere> air = opened(input);
    if (!resolution_cm) {
        return air;
    }
    const auto* smart = dynamic_cast<const irsg::AtmosphereSmart*>(air.get());
    if (smart == nullptr) {
        throw irsg::InputError(irsg::Offence{
            .file = air->name(),
            .position = "resolution",
            .value = irsg::numberText(*resolution_cm) + " cm-1",
            .expected = "none: these spectra have nodes of their own, not bins as those of an "
                        "AtmosphereSmart"});
    }
    irsg::AtmosphereSmartParameters parameters = smart->parameters();
    parameters.resolution_cm = *resolution_cm;
    return std::make_shared<irsg::AtmosphereSmart>(std::move(parameters), smart->name(), input);
}

} // namespace smat
