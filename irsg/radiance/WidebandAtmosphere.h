#pragma once

#include "irsg/atmosphere/Environment.h"
#include "irsg/radiometry/Band.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// Whether one air has wideband points for a band and is the one that answers everything that the
/// settings ask for there in the spectral mode too, so that both modes ask the same air.
bool hasWidebandAtmosphere(const Environment& environment, const Band& band,
                           const RenderSettings& settings);

} // namespace irsg
