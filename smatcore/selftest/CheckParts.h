#pragma once

#include "irsg/radiometry/Planck.h"
#include "irsg/reference/PlanckReference.h"
#include "irsg/reference/Scenes.h"

namespace smat::selftest {

/// What rooms look at: the band of 3 to 5 um, of equal response.
inline const irsg::Band band = irsg::Band::topHat(3.0, 5.0);
/// The codes of what has one material and one state.
inline constexpr irsg::IrCodes one{1, 1};

/// Planck's law in long double, from what is published, W m-2 sr-1 um-1.
inline double truePlanck(double wavelength_um, double temperature_K) {
    return static_cast<double>(irsg::reference::planck(wavelength_um, temperature_K));
}
/// What a grey surface of emissivity 0.9 and 320 K sends in the band, W m-2 sr-1.
inline double grey_W_m2_sr() {
    return 0.9 * irsg::bandRadiance_W_m2_sr(band, 320.0);
}

} // namespace smat::selftest
