#include "smatcore/project/EnvironmentInput.h"

#include <string>
#include <vector>

#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

void logRemarks(const std::string& whose, const std::vector<std::string>& remarks) {
    for (const std::string& remark : remarks) {
        logInfo(whose + ": " + remark);
    }
}

void add(irsg::Environment& environment, std::shared_ptr<const irsg::Atmosphere> atmosphere) {
    logRemarks(atmosphere->name(), atmosphere->remarks());
    environment.add(std::move(atmosphere));
}

} // namespace

std::optional<irsg::SunPosition> addAir(irsg::Environment& environment,
                                        const std::filesystem::path& input) {
    if (!irsg::isEnvironmentXml(input)) {
        add(environment, openAtmosphere(input));
        return std::nullopt;
    }
    logInfo("reading environment " + input.string());
    const irsg::LoadedEnvironment loaded = irsg::loadEnvironment(input);
    logRemarks(input.filename().string(), loaded.remarks);
    for (const auto& atmosphere : loaded.environment.atmospheres()) {
        add(environment, atmosphere);
    }
    if (!environment.defaultBackground) {
        environment.defaultBackground = loaded.environment.defaultBackground;
    }
    return loaded.environment.sun;
}

} // namespace smat
