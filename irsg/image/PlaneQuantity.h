#pragma once

#include <string>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// What the numbers of a plane are.
struct PlaneQuantity {
    /// "radiance", "spectral radiance", "irradiance", "intensity", "temperature", "counts"; ""
    /// where nothing states it. An apparent temperature is a temperature.
    std::string name;
    std::string unit; ///< "" where none is known; that of its quantity where only that is stated

    bool operator==(const PlaneQuantity&) const = default;
};

/// By the unit of the plane, or else by its name (T_apparent, counts). Of a plane with neither,
/// such as L or Y of another program, by the attributes of the image: `image.quantity`, which
/// images of ours have, `quantity`, `unit` and `units`. These are of the plane that is shown, the
/// first.
PlaneQuantity quantityOf(const RadianceImage& image, const ImageChannel& plane);

} // namespace irsg
