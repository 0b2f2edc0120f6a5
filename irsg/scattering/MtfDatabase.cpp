#include "irsg/scattering/MtfDatabase.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/MonotoneCubic.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double speedOfLight_m_s = 299792458.0;

template <typename... Numbers>
std::string formatted(const char* format, Numbers... numbers) {
    char text[200];
    std::snprintf(text, sizeof text, format, numbers...);
    return text;
}

std::vector<MtfField> headerFields(const MtfHeader& h) {
    const auto known = [](double value, double shown) {
        return value > 0.0 ? std::optional(shown) : std::nullopt;
    };
    return {
        {"field of view", known(h.fieldOfView_rad, degrees(h.fieldOfView_rad)), "deg"},
        {"field of interest", known(h.fieldOfInterest_rad, degrees(h.fieldOfInterest_rad)), "deg"},
        {"particle diameter", known(h.particleDiameter_m, 1e6 * h.particleDiameter_m), "um"},
        {"wave frequency", known(h.waveFrequency_Hz, 1e-12 * h.waveFrequency_Hz), "THz"},
        {"wavelength", known(h.waveFrequency_Hz, h.wavelength_um()), "um"}};
}

} // namespace

MtfCurve::MtfCurve(std::vector<double> frequencies_per_rad, std::vector<double> values)
    : frequencies_per_rad_(std::move(frequencies_per_rad)), values_(std::move(values)) {
    if (frequencies_per_rad_.size() < 2 || values_.size() != frequencies_per_rad_.size())
        throw LogicError("an MTF has as many values as frequencies, at least two");
}

double MtfCurve::at(double frequency_per_rad) const {
    if (frequency_per_rad <= frequencies_per_rad_.front())
        return values_.front();
    if (frequency_per_rad >= frequencies_per_rad_.back())
        return values_.back();
    return monotoneCubic(
        frequencies_per_rad_, [this](std::size_t i) { return values_[i]; }, frequency_per_rad);
}

double MtfHeader::wavelength_um() const {
    return waveFrequency_Hz > 0.0 ? 1e6 * speedOfLight_m_s / waveFrequency_Hz : 0.0;
}

MtfDatabase::MtfDatabase(MtfHeader header, std::vector<double> frequencies_per_rad,
                         std::vector<double> opticalDepths, std::vector<std::vector<double>> values)
    : header_(header),
      frequencies_per_rad_(std::move(frequencies_per_rad)),
      opticalDepths_(std::move(opticalDepths)),
      values_(std::move(values)) {
    if (values_.size() != opticalDepths_.size() || values_.empty() ||
        std::ranges::any_of(values_, [this](const std::vector<double>& curve) {
            return curve.size() != frequencies_per_rad_.size();
        }))
        throw LogicError("an MTF database has one curve for each optical depth");
}

MtfCurve MtfDatabase::at(double opticalDepth, const std::string& what) const {
    if (!(opticalDepth >= 0.0) || opticalDepth > largestOpticalDepth() * (1.0 + 1e-9))
        throw InputError({what, "", "a scattering optical depth of " + numberText(opticalDepth),
                          "at most the " + numberText(largestOpticalDepth()) +
                              " that the MTF database reaches"});
    // ln MTF between the neighbours; below the first curve that of no scattering, which is 0.
    const double first = opticalDepths_.front();
    const bool isBelow = opticalDepth < first;
    const Bracket place =
        isBelow ? Bracket{0, 0, opticalDepth / first} : bracket(opticalDepths_, opticalDepth);
    std::vector<double> values;
    for (std::size_t i = 0; i < frequencies_per_rad_.size(); ++i) {
        const double low = isBelow ? 0.0 : std::log(values_[place.below][i]);
        values.push_back(std::exp(lerp(low, std::log(values_[place.above][i]), place.fraction)));
    }
    return {frequencies_per_rad_, std::move(values)};
}

std::vector<MtfField> MtfDatabase::fields() const {
    std::vector<MtfField> fields = headerFields(header_);
    fields.insert(fields.end(),
                  {{"frequencies", static_cast<double>(frequencies_per_rad_.size()), ""},
                   {"lowest frequency", frequencies_per_rad_.front(), "cycles/rad"},
                   {"highest frequency", frequencies_per_rad_.back(), "cycles/rad"},
                   {"optical depths", static_cast<double>(opticalDepths_.size()), ""},
                   {"least optical depth", opticalDepths_.front(), ""},
                   {"largest optical depth", opticalDepths_.back(), ""}});
    return fields;
}

std::vector<std::string> MtfDatabase::description() const {
    std::vector<std::string> lines;
    // The axes are told in a line each.
    for (const MtfField& field : headerFields(header_))
        lines.push_back(
            field.name + ": " +
            (field.value ? formatted("%.5g ", *field.value) + field.unit : "not stated"));
    lines.push_back(formatted("frequencies: %zu from %.4g to %.4g cycles/rad",
                              frequencies_per_rad_.size(), frequencies_per_rad_.front(),
                              frequencies_per_rad_.back()));
    lines.push_back(formatted("optical depths: %zu from %.4g to %.4g", opticalDepths_.size(),
                              opticalDepths_.front(), opticalDepths_.back()));
    for (std::size_t i = 0; i < opticalDepths_.size(); ++i)
        lines.push_back(formatted("  %8.4g  MTF(0) %.6g  MTF at the highest frequency %.6g",
                                  opticalDepths_[i], values_[i].front(), values_[i].back()));
    return lines;
}

std::vector<std::string> MtfDatabase::remarks() const {
    std::vector<std::string> remarks;
    if (header_.fieldOfView_rad == 0.0)
        remarks.push_back("no field of view is stated: haze is cut at half a radian");
    if (header_.fieldOfView_rad > pi)
        remarks.push_back("the field of view is more than half of all directions: is it in rad?");
    if (header_.particleDiameter_m > 0.01)
        remarks.push_back("the particles are larger than 1 cm: is the diameter in m?");
    if (header_.waveFrequency_Hz > 0.0 &&
        (header_.wavelength_um() < 0.1 || header_.wavelength_um() > 1000.0))
        remarks.push_back("the wavelength is outside 0.1 to 1000 um: is the wave frequency in Hz?");
    for (std::size_t i = 0; i < opticalDepths_.size(); ++i)
        if (std::abs(values_[i].back() - 1.0) > 0.05)
            remarks.push_back(
                formatted("the MTF of optical depth %.4g ends at %.4g, not at 1: what "
                          "it lacks there is taken for direct light",
                          opticalDepths_[i], values_[i].back()));
    return remarks;
}

} // namespace irsg
