#pragma once

#include <filesystem>
#include <string>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// The spectral response of a sensor between two wavelengths. R is dimensionless, 0 to 1 by custom
/// but any finite value >= 0 is accepted; its area must be positive.
class Band {
  public:
    /// Response 1 from min to max. Throws InputError unless 0 < min < max, both finite.
    static Band topHat(double min_um, double max_um);
    /// A sampled response (zero outside its axis). Throws InputError for a negative value or no
    /// area.
    static Band fromResponse(Spectrum response, std::string name = "response");
    /// Reads a table of two columns (CsvTable): the axis, ascending or descending, with a head of
    /// spectralHead(), and the response. Without a head or a unit the axis is what its values tell
    /// (axisOfValues), with a remark. A response is from 0 to 1, under a head with % to 100; down
    /// to -0.005 of the largest is 0 and up to 1.005 is 1, with a remark. Filter files of MODTRAN
    /// are read as well, of several channels the first. Throws InputError naming file, line and
    /// value.
    static Band fromCsv(const std::filesystem::path& file);
    /// "3-5" in um. Throws InputError.
    static Band fromText(const std::string& text);

    const std::string& name() const { return name_; }
    const SpectralRange& range() const { return range_; }
    bool isTopHat() const { return response_.isConstant(); }
    /// R at a wavelength; 0 outside the range.
    double responseAt(double wavelength_um) const;
    /// The response as a spectrum (a constant 1 for a top hat: combine with range()).
    const Spectrum& response() const { return response_; }
    /// Integral of R over the range, um.
    double area_um() const;

    bool operator==(const Band&) const = default;

  private:
    Band(std::string name, SpectralRange range, Spectrum response);

    std::string name_;
    SpectralRange range_;
    Spectrum response_;
};

} // namespace irsg
