#pragma once

#include <memory>

#include "irsg/radiance/exchange/LightExchange.h"
#include "irsg/radiance/exchange/SceneLight.h"

namespace irsg {

/// What the surfaces of a scene see of each other and what light that brings them. Both are null
/// where it is not asked for, and where it changes nothing.
struct InterReflected {
    std::shared_ptr<const LightExchange> exchange;
    std::shared_ptr<SceneLight> light; ///< in the outputs of an evaluation
};

} // namespace irsg
