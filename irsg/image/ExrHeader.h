#pragma once

#include <string>
#include <string_view>

namespace irsg {

/// Walks the header of an OpenEXR file, whose signature has been checked, before the library reads
/// it: the library allocates what a length in the file claims before it looks whether the file has
/// as much. Throws InputError with the byte of the first length that leads out of the file or does
/// not suit its type, and for a header without an end.
void checkExrHeader(std::string_view bytes, const std::string& file);

} // namespace irsg
