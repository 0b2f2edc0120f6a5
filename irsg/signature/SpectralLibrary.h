#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// A spectrum as a library or an instrument writes it, ascending in wavelength.
struct LibrarySpectrum {
    enum class Quantity { emissivity, reflectivity, transmissivity, refractiveIndex, extinction };
    /// One of its columns, as long as the axis, in the order of `lines`.
    struct Column {
        Quantity quantity = Quantity::reflectivity;
        std::vector<double> wavelengths_um;
        std::vector<double> values; ///< fractions, never percent
        std::vector<int> lines;     ///< of the file, where each value stands
    };

    std::string format; ///< "ECOSTRESS", "USGS", "JCAMP-DX", ...
    std::string title;  ///< "" where the file has none
    std::vector<Column> columns;
};

/// Reads what is told to be of a spectral library by its first lines; no value for other texts.
///   ECOSTRESS and ASTER: lines `Name: ...` with `X Units:` and `Y Units:`, then two columns.
///   USGS (splib06): head lines that name the library, then wavelength in um, reflectance and its
///     deviation; deleted values (-1.23e34) are left out.
///   JCAMP-DX 4.24: `##TITLE=`, XYDATA (X++(Y..Y)) in any of its packed forms, or XYPOINTS;
///     reflectance or transmittance.
///   refractiveindex.info: YAML with `type: tabulated n`, `tabulated k` or `tabulated nk`, in um,
///   or
///     `formula 1` to `formula 9` over its wavelength_range, as nodes that follow it to 1e-5; k is
///     0 where no table of it stands beside the formula.
///   DIRSIG .ems: angular factors, then curves of emissivity between CURVE_BEGIN and CURVE_END over
///     um, or over cm-1 where the numbers are above 100; of several curves the first.
/// What is left out is remarked on. Throws InputError with file, line, value and what was expected,
/// for forms that hold no such spectrum as well (absorbance, axes in files of their own).
std::optional<LibrarySpectrum> readSpectralLibrary(std::string_view text, const std::string& file);

/// The words "ECOSTRESS, ASTER, USGS, JCAMP-DX, refractiveindex.info or DIRSIG .ems".
extern const char* const spectralLibraryNames;

} // namespace irsg
