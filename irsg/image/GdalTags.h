#pragma once

#include <cstddef>
#include <string>

#include <tiffio.h>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Takes what GDAL adds to a page of a TIFF file in tags of its own, for the planes from
/// `firstPlane` on, the samples of the present page. Stored values that stand for none (tag 42113,
/// GDAL_NODATA, a number as text) become NaN. Then each sample gets the scale and the offset that
/// items of GDAL_METADATA (tag 42112, XML) with these roles state for it, value = scale * stored +
/// offset, and the unit of its `unittype` where it has none. All is remarked on `page` of `file`,
/// and so is what cannot be followed and is left out: a GDAL_NODATA, scale or offset that is no
/// finite number, a scale of 0, a sample that is not there, and XML that is damaged.
void takeGdalTags(TIFF* tiff, RadianceImage& image, std::size_t firstPlane, const std::string& file,
                  const std::string& page);

} // namespace irsg
