#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <tiffio.h>

namespace irsg {

/// More is not taken at once.
inline constexpr tmsize_t mostTiffMemory_B = tmsize_t{1} << 30;

/// A file in memory, in the way libtiff asks for it, with the first thing it had to say.
struct TiffMemory {
    std::string bytes;
    std::size_t position = 0;
    std::string complaint = {};
};

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenTiff = std::unique_ptr<TIFF, CloseTiff>;

/// Opens a file in memory for reading ("rm") or writing ("wm"); empty where it cannot be, which the
/// complaint explains.
OpenTiff openTiff(TiffMemory& memory, const char* mode);

} // namespace irsg
