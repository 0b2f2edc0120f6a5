#include "irsg/signature/UserSpectrum.h"

#include <algorithm>

namespace irsg {

const SpectrumComponent* UserSpectrum::find(const std::string& component) const {
    const auto found = std::find_if(components.begin(), components.end(),
                                    [&](const auto& each) { return each.name == component; });
    return found == components.end() ? nullptr : &*found;
}

} // namespace irsg
