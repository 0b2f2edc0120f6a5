#include "smatcore/settings/SettingAvailability.h"

#include "irsg/scene/scattering/SceneScattering.h"

namespace smat {

std::string whyUnavailable(const SettingInfo& setting) {
    const bool isOfScattering = setting.key == "render.scattering" ||
                                setting.key == "environment.mtf" ||
                                setting.key == "environment.scatteringCoefficient";
    return isOfScattering ? irsg::whyNoScattering() : std::string();
}

} // namespace smat
