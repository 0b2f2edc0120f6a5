#include "smatcore/settings/SettingAvailability.h"
#include "smatcore/settings/SettingKeys.h"

#include "irsg/scene/scattering/SceneScattering.h"

namespace smat {

std::string whyUnavailable(const SettingInfo& setting) {
    const bool isOfScattering = setting.key == key::renderScattering ||
                                setting.key == key::environmentMtf ||
                                setting.key == key::environmentScatteringCoefficient;
    return isOfScattering ? irsg::whyNoScattering() : std::string();
}

} // namespace smat
