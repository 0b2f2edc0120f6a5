#pragma once

#include <optional>
#include <string>

#include <tiffio.h>

namespace irsg {

/// What GDAL adds to a page of a TIFF file, in tags of its own.
struct GdalTags {
    /// The stored value that stands for no value (tag 42113, GDAL_NODATA, a number as text); none
    /// where the tag is missing or is "nan".
    std::optional<double> missing;
    bool hasScale = false; ///< a scale or an offset of values (in tag 42112, GDAL_METADATA)
};

/// Of the present page. What is no number is left out with a remark on `page` of `file`.
GdalTags gdalTagsOf(TIFF* tiff, const std::string& file, const std::string& page);

} // namespace irsg
