#include "smatcore/project/AtmosphereInput.h"

#include <system_error>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/Log.h"

namespace smat {

bool isNoAtmosphere(const std::filesystem::path& input) {
    return input == "none" || input == "vacuum";
}

std::shared_ptr<const irsg::Atmosphere> openAtmosphere(const std::filesystem::path& input) {
    if (isNoAtmosphere(input))
        return std::make_shared<irsg::Vacuum>();
    std::error_code failure;
    if (!std::filesystem::is_regular_file(input, failure)) {
        throw irsg::InputError(irsg::Diagnostic{
            .file = input.string(),
            .position = "",
            .value = std::filesystem::is_directory(input, failure) ? "a folder" : "no such file",
            .expected = "none, vacuum or an atmosphere file"});
    }
    logInfo("reading atmosphere " + input.string());
    return irsg::loadAtmosphere(input);
}

} // namespace smat
