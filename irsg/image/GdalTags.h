#pragma once

#include <cstddef>
#include <string>

#include <tiffio.h>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Takes what GDAL adds to a page of a TIFF file in tags of its own. Stored values that stand for
/// none (tag 42113, GDAL_NODATA, a number as text) become NaN in all planes from `firstPlane` on,
/// those of the present page. That is remarked on `page` of `file`, as are a scale and an offset
/// (in tag 42112, GDAL_METADATA), which are left out, and a GDAL_NODATA that is no number.
void takeGdalTags(TIFF* tiff, RadianceImage& image, std::size_t firstPlane, const std::string& file,
                  const std::string& page);

} // namespace irsg
