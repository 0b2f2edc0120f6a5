#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/scattering/MtfDatabase.h"

namespace irsg {

namespace {

constexpr std::size_t headerBytes = 40;
/// More points or curves than this are damage, not data.
constexpr std::int32_t mostEntries = 1 << 20;
/// Diagnostics that are told of one file.
constexpr std::size_t mostDiagnostics = 20;

/// Little-endian numbers, whatever the machine is.
template <typename Bits>
void put(std::string& bytes, Bits bits) {
    for (std::size_t i = 0; i < sizeof(Bits); ++i)
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(bits >> (8 * i))));
}
void put(std::string& bytes, double value) {
    put(bytes, std::bit_cast<std::uint64_t>(value));
}
template <typename Bits>
Bits take(std::string_view bytes, std::size_t at, bool isBigEndian = false) {
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) {
        const std::size_t place = isBigEndian ? sizeof(Bits) - 1 - i : i;
        bits |= static_cast<Bits>(static_cast<unsigned char>(bytes[at + place])) << (8 * i);
    }
    return bits;
}
double number(std::string_view bytes, std::size_t at) {
    return std::bit_cast<double>(take<std::uint64_t>(bytes, at));
}
std::int32_t count(std::string_view bytes, std::size_t at, bool isBigEndian = false) {
    return static_cast<std::int32_t>(take<std::uint32_t>(bytes, at, isBigEndian));
}
std::uint64_t lengthOf(std::int64_t curves, std::int64_t points) {
    return headerBytes + 8 * static_cast<std::uint64_t>(points) +
           static_cast<std::uint64_t>(curves) * (8 + 8 * static_cast<std::uint64_t>(points));
}
bool isPlausible(std::int32_t curves, std::int32_t points) {
    return curves >= 1 && points >= 2 && curves <= mostEntries && points <= mostEntries;
}

/// Reads a file whose every number is looked at before anything is made of it.
class Reader {
  public:
    Reader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    MtfDatabase read() {
        const auto [curves, points] = counts();
        MtfHeader header;
        double* const fields[] = {&header.fieldOfView_rad, &header.fieldOfInterest_rad,
                                  &header.particleDiameter_m, &header.waveFrequency_Hz};
        const char* const names[] = {"field of view [rad]", "field of interest [rad]",
                                     "particle diameter [m]", "wave frequency [Hz]"};
        for (std::size_t i = 0; i < 4; ++i)
            *fields[i] = checked(8 * i, names[i], "0 (unknown) or a positive number",
                                 [](double value) { return value >= 0.0; });
        std::size_t at = headerBytes;
        const std::vector<double> frequencies = axis(at, points, "frequency [1/rad]", true);
        at += 8 * points;

        std::vector<double> depths;
        std::vector<std::vector<double>> values;
        for (std::size_t m = 0; m < curves; ++m, at += 8 * (points + 1)) {
            depths.push_back(ascending(at, "optical depth", m == 0 ? 0.0 : depths.back(), false));
            values.push_back(curve(at + 8, points, depths.back()));
        }
        if (left_ > 0)
            diagnostics_.push_back(
                {file_, "", std::to_string(left_) + " more values like these", "values as above"});
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return {header, frequencies, std::move(depths), std::move(values)};
    }

  private:
    std::pair<std::size_t, std::size_t> counts() {
        if (bytes_.size() < headerBytes)
            refuse(bytes_.size(), std::to_string(bytes_.size()) + " bytes",
                   "an MTF database: at least 72 bytes");
        const std::int32_t curves = count(bytes_, 32), points = count(bytes_, 36);
        const std::int32_t swappedCurves = count(bytes_, 32, true);
        const std::int32_t swappedPoints = count(bytes_, 36, true);
        if (!isPlausible(curves, points) && isPlausible(swappedCurves, swappedPoints) &&
            lengthOf(swappedCurves, swappedPoints) == bytes_.size())
            refuse(32, "big-endian numbers", "little-endian ones");
        if (curves < 1 || curves > mostEntries)
            refuse(32, std::to_string(curves) + " MTFs", "1 to " + std::to_string(mostEntries));
        if (points < 2 || points > mostEntries)
            refuse(36, std::to_string(points) + " points", "2 to " + std::to_string(mostEntries));
        const std::uint64_t expected = lengthOf(curves, points);
        if (bytes_.size() != expected)
            refuse(std::min<std::uint64_t>(bytes_.size(), expected),
                   "a file of " + std::to_string(bytes_.size()) + " bytes",
                   std::to_string(expected) + " for " + std::to_string(curves) + " MTFs of " +
                       std::to_string(points) + " points");
        return {static_cast<std::size_t>(curves), static_cast<std::size_t>(points)};
    }

    [[noreturn]] void refuse(std::uint64_t at, std::string value, std::string expected) const {
        throw InputError(
            {file_, "byte " + std::to_string(at), std::move(value), std::move(expected)});
    }

    double checked(std::size_t at, const std::string& what, const std::string& expected,
                   const std::function<bool(double)>& isRight) {
        const double value = number(bytes_, at);
        if (std::isfinite(value) && isRight(value))
            return value;
        if (diagnostics_.size() < mostDiagnostics)
            diagnostics_.push_back(
                {file_, "byte " + std::to_string(at), what + " " + numberText(value), expected});
        else
            ++left_;
        return value;
    }

    double ascending(std::size_t at, const char* what, double last, bool isFirstOfAxis) {
        return checked(at, what,
                       isFirstOfAxis ? "0 or a positive number"
                                     : "a number above " + numberText(last),
                       [=](double value) { return isFirstOfAxis ? value >= 0.0 : value > last; });
    }

    std::vector<double> axis(std::size_t at, std::size_t points, const char* what, bool mayBeZero) {
        std::vector<double> values;
        for (std::size_t i = 0; i < points; ++i)
            values.push_back(
                ascending(at + 8 * i, what, i == 0 ? 0.0 : values.back(), mayBeZero && i == 0));
        return values;
    }

    std::vector<double> curve(std::size_t at, std::size_t points, double opticalDepth) {
        // All light gained is exp(tau) of the direct part, and a pattern loses at most that.
        const double most = std::exp(std::min(opticalDepth, 600.0)) * (1.0 + 1e-6);
        const std::string expected =
            "a value from " + numberText(1.0 / most) + " to " + numberText(most);
        std::vector<double> values;
        for (std::size_t i = 0; i < points; ++i)
            values.push_back(checked(at + 8 * i, "MTF", expected, [most](double value) {
                return value >= 1.0 / most && value <= most;
            }));
        return values;
    }

    std::string_view bytes_;
    std::string file_;
    std::vector<Diagnostic> diagnostics_;
    std::size_t left_ = 0;
};

} // namespace

MtfDatabase MtfDatabase::fromBytes(std::string_view bytes, const std::string& file) {
    return Reader(bytes, file).read();
}

MtfDatabase MtfDatabase::read(const std::filesystem::path& file) {
    return fromBytes(readFile(file), file.string());
}

std::string MtfDatabase::bytes() const {
    std::string bytes;
    for (const double value : {header_.fieldOfView_rad, header_.fieldOfInterest_rad,
                               header_.particleDiameter_m, header_.waveFrequency_Hz})
        put(bytes, value);
    put(bytes, static_cast<std::uint32_t>(opticalDepths_.size()));
    put(bytes, static_cast<std::uint32_t>(frequencies_per_rad_.size()));
    for (const double frequency : frequencies_per_rad_)
        put(bytes, frequency);
    for (std::size_t m = 0; m < opticalDepths_.size(); ++m) {
        put(bytes, opticalDepths_[m]);
        for (const double value : values_[m])
            put(bytes, value);
    }
    return bytes;
}

void MtfDatabase::write(const std::filesystem::path& file) const {
    const std::string text = bytes();
    fromBytes(text, file.string());
    writeFileDurably(file, text);
}

} // namespace irsg
