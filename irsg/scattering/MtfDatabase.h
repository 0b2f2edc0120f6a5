#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace irsg {

/// The modulation transfer function of one scattering path: by spatial frequency, divided by the
/// direct transmission, so that it is the gain of a sinusoidal pattern over its direct light.
class MtfCurve {
  public:
    /// Frequencies ascend from >= 0, cycles per radian; at least two.
    MtfCurve(std::vector<double> frequencies_per_rad, std::vector<double> values);

    const std::vector<double>& frequencies_per_rad() const { return frequencies_per_rad_; }
    const std::vector<double>& values() const { return values_; }
    /// Monotone cubic between the nodes, clamped outside.
    double at(double frequency_per_rad) const;
    /// Gain of the whole energy, MTF(0): (P_S + P_U) / P_U of the report's eq. 9.
    double gain() const { return values_.front(); }
    /// What is left at the highest frequency: the weight of the direct image.
    double direct() const { return values_.back(); }

  private:
    std::vector<double> frequencies_per_rad_, values_;
};

/// What the file says about itself (report table 21). Only the field of view takes part in
/// calculations; 0 where unknown.
struct MtfHeader {
    double fieldOfView_rad = 0.0;     ///< full angle that the curves stand for
    double fieldOfInterest_rad = 0.0; ///< full angle of the light that was followed
    double particleDiameter_m = 0.0;
    double waveFrequency_Hz = 0.0;

    /// Vacuum wavelength of the wave frequency, um; 0 where that is unknown.
    double wavelength_um() const;
    bool operator==(const MtfHeader&) const = default;
};

/// One number that a database is described by; nothing where the file does not know it.
struct MtfField {
    std::string name;
    std::optional<double> value;
    std::string unit; ///< empty for a count or a ratio
};

/// An MTF database (report section 9, F41): curves for several scattering optical depths at shared
/// frequencies. The file is binary and little-endian on every machine: 4 doubles (the header), two
/// int32 (curves M, points n), n doubles (frequencies), then M times a double (optical depth) and n
/// doubles (values): 40 + 8 n + M (8 + 8 n) bytes.
class MtfDatabase {
  public:
    /// LogicError where numbers do not fit each other; what a file must fulfil is checked by
    /// read() and check().
    MtfDatabase(MtfHeader header, std::vector<double> frequencies_per_rad,
                std::vector<double> opticalDepths, std::vector<std::vector<double>> values);

    /// Throws InputError with every diagnostic and its byte offset: a wrong length, big-endian
    /// bytes, numbers that are not finite, axes that do not ascend, values outside exp(-tau) to
    /// exp(tau).
    static MtfDatabase read(const std::filesystem::path& file);
    static MtfDatabase fromBytes(std::string_view bytes, const std::string& file);
    /// Checks, and replaces the file in one step.
    void write(const std::filesystem::path& file) const;
    std::string bytes() const;

    const MtfHeader& header() const { return header_; }
    const std::vector<double>& frequencies_per_rad() const { return frequencies_per_rad_; }
    /// Ascending, > 0.
    const std::vector<double>& opticalDepths() const { return opticalDepths_; }
    const std::vector<double>& values(std::size_t curve) const { return values_[curve]; }

    /// The curve of any scattering optical depth from 0 (which is 1 everywhere) to the largest of
    /// the database: ln MTF is linear in it, as single scattering and the small-angle theory have
    /// it. InputError outside, naming `what` ("the path to 'aircraft'").
    MtfCurve at(double opticalDepth, const std::string& what) const;
    double largestOpticalDepth() const { return opticalDepths_.back(); }

    /// Header and axes as numbers.
    std::vector<MtfField> fields() const;
    /// Lines for a reader: header, axes, gains; what looks odd comes last, as remarks.
    std::vector<std::string> description() const;
    std::vector<std::string> remarks() const;

  private:
    MtfHeader header_;
    std::vector<double> frequencies_per_rad_, opticalDepths_;
    std::vector<std::vector<double>> values_;
};

} // namespace irsg
