#include "smatcore/project/EnvironmentInput.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/AtmosphereInput.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

/// The atmospheres and default background of one file, and its sun where it has one.
struct LoadedAtmosphere {
    irsg::Environment environment;
    std::optional<irsg::SunPosition> sun;
};

void logRemarks(const std::string& whose, const std::vector<std::string>& remarks) {
    for (const std::string& remark : remarks)
        logInfo(whose + ": " + remark);
}

/// What one file or word adds.
LoadedAtmosphere loadedFrom(const std::filesystem::path& input) {
    LoadedAtmosphere loaded;
    if (!irsg::isEnvironmentXml(input)) {
        loaded.environment.add(openAtmosphere(input));
        return loaded;
    }
    logInfo("reading environment " + input.string());
    irsg::LoadedEnvironment file = irsg::loadEnvironment(input);
    logRemarks(input.filename().string(), file.remarks);
    loaded.environment = std::move(file.environment);
    loaded.sun = loaded.environment.sun;
    return loaded;
}

/// The atmospheres with other bins where they have any. InputError where none has.
std::vector<std::shared_ptr<const irsg::Atmosphere>>
withResolution(const std::vector<std::shared_ptr<const irsg::Atmosphere>>& atmospheres,
               int resolution_per_cm) {
    std::vector<std::shared_ptr<const irsg::Atmosphere>> result;
    std::string others;
    for (const auto& atmosphere : atmospheres) {
        const auto other = atmosphere->withBins(resolution_per_cm);
        result.push_back(other ? other : atmosphere);
        if (!other)
            others += (others.empty() ? "" : ", ") + atmosphere->name();
    }
    if (result == atmospheres) {
        throw irsg::InputError(irsg::Diagnostic{
            .file = others.empty() ? "environment" : others,
            .position = "resolution",
            .value = irsg::numberText(resolution_per_cm) + " cm-1",
            .expected = "none: these spectra have nodes of their own, not bins as those of an "
                        "AtmosphereSmart"});
    }
    if (!others.empty())
        logInfo("the resolution has no effect on " + others);
    return result;
}

} // namespace

std::optional<irsg::SunPosition> addAtmosphere(irsg::Environment& environment,
                                               const std::vector<std::filesystem::path>& inputs,
                                               std::optional<int> resolution_per_cm) {
    std::vector<std::shared_ptr<const irsg::Atmosphere>> atmospheres;
    std::optional<irsg::SunPosition> sun;
    std::vector<irsg::Diagnostic> diagnostics;
    for (const auto& input : inputs) {
        irsg::collect(diagnostics, [&] {
            const LoadedAtmosphere loaded = loadedFrom(input);
            const auto& own = loaded.environment.atmospheres();
            atmospheres.insert(atmospheres.end(), own.begin(), own.end());
            if (!environment.defaultBackground)
                environment.defaultBackground = loaded.environment.defaultBackground;
            sun = sun ? sun : loaded.sun;
        });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    for (const auto& atmosphere :
         resolution_per_cm ? withResolution(atmospheres, *resolution_per_cm) : atmospheres) {
        logRemarks(atmosphere->name(), atmosphere->remarks());
        environment.add(atmosphere);
    }
    return sun;
}

} // namespace smat
