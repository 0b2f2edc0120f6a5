#pragma once

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// An atmosphere that knows what its ground reflects. Ground is level, at altitude 0, and reflects
/// evenly in all directions; the upward flux there is what it emits and reflects where nothing
/// stands over it.
class ReflectingGround {
  public:
    virtual ~ReflectingGround() = default;
    /// 0 to 1, over wavelength.
    virtual Spectrum groundReflectivity() const = 0;
};

} // namespace irsg
