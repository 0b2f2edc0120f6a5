#include "irsg/core/BinaryFormats.h"

#include <algorithm>
#include <array>

namespace irsg {

namespace {

using namespace std::string_view_literals;

constexpr std::array formats = {
    BinaryFormat{"\x89PNG"sv, "a PNG picture"sv, true},
    BinaryFormat{"\xFF\xD8\xFF"sv, "a JPEG picture"sv, true},
    BinaryFormat{"GIF8"sv, "a GIF picture"sv, true},
    BinaryFormat{"SIMPLE  ="sv, "a FITS file"sv, false},
    BinaryFormat{"SQLite format 3"sv, "a database"sv, false},
    BinaryFormat{"MATLAB 5.0 MAT-file"sv, "a MATLAB file"sv, false},
    BinaryFormat{"MATLAB 7.3 MAT-file"sv, "a MATLAB file"sv, false},
    BinaryFormat{"\x89HDF\r\n\x1a\n"sv, "a netCDF or HDF5 file"sv, false},
    BinaryFormat{"CDF\x01"sv, "a netCDF file"sv, false},
    BinaryFormat{"CDF\x02"sv, "a netCDF file"sv, false},
    BinaryFormat{"CDF\x05"sv, "a netCDF file"sv, false},
    BinaryFormat{"PK\x03\x04"sv, "a ZIP archive (a workbook, say)"sv, false},
    BinaryFormat{"\x1f\x8b"sv, "a file compressed by gzip"sv, false},
    BinaryFormat{"%PDF-"sv, "a PDF document"sv, false}};

} // namespace

const BinaryFormat* binaryFormatOf(std::string_view bytes) {
    const auto found = std::ranges::find_if(
        formats, [&](const BinaryFormat& one) { return bytes.starts_with(one.beginning); });
    return found == formats.end() ? nullptr : &*found;
}

std::string_view foundInPlaceOfText(std::string_view bytes) {
    const BinaryFormat* const format = binaryFormatOf(bytes);
    return format == nullptr ? "a NUL byte"sv : format->words;
}

} // namespace irsg
