#pragma once

#include <functional>
#include <optional>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/Environment.h"

namespace smat {

/// An environment whose computed atmospheres (AtmosphereSmart) have other parameters. `change`
/// changes them and returns whether the atmosphere has what is changed; other atmospheres stay.
/// No value where none has it. Throws InputError for parameters that cannot be.
std::optional<irsg::Environment>
withAir(const irsg::Environment& environment,
        const std::function<bool(irsg::AtmosphereSmartParameters&)>& change);

} // namespace smat
