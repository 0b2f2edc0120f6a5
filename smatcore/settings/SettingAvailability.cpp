#include "smatcore/settings/SettingAvailability.h"
#include "smatcore/settings/SettingKeys.h"

#include "irsg/render/rays/RaysBuilt.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace smat {

std::string whyUnavailable(const SettingInfo& setting) {
    const bool isOfScattering = setting.key == key::renderScattering ||
                                setting.key == key::environmentMtf ||
                                setting.key == key::environmentScatteringCoefficient;
    if (isOfScattering)
        return irsg::whyNoScattering();
    const bool isOfRays = setting.key == key::renderShadows || setting.key == key::renderBounces ||
                          setting.key == key::renderLightError;
    return isOfRays ? irsg::whyNoRays() : std::string();
}

} // namespace smat
