#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace irsg {

/// How colours follow values between the limits of a display. With every scale they rise with the
/// value, from the first colour at the lower limit to the last one at the upper.
enum class ColorScale {
    automatic, ///< of the next three the first that leaves colours for what does not glow
    linear,
    squareRoot,
    logarithmic, ///< ln(1 + 10,000 x) of the part x of the way: four decades, whatever the limits
    equalized    ///< every colour for as many of the values shown
};

/// As settings and files name them: "auto", "linear", "square-root", "logarithmic", "equalized".
std::vector<std::string> colorScaleNames();
std::string nameOf(ColorScale scale);
/// Throws InputError that lists the names.
ColorScale colorScaleNamed(const std::string& name);

/// The values between which a picture's colours run, low < high, and how.
struct DisplayLimits {
    double low = 0.0;
    double high = 1.0;
    ColorScale scale = ColorScale::linear;
    /// Of an equalized scale: values at equal steps of colour, ascending from `low` to `high`. None
    /// is linear.
    std::shared_ptr<const std::vector<double>> levels{};
    /// What is outside of the limits has colours of its own; else it saturates: it has those of the
    /// ends.
    bool marksOutside = false;

    bool operator==(const DisplayLimits& other) const;

    /// Which part of the colours a value has, 0 at `low` to 1 at `high`; what is outside of the
    /// limits has that of the nearer one.
    double position(double value) const;
    /// The value at a part of the colours, 0 to 1.
    double value(double position) const;
    /// The same limits with another scale; an automatic or equalized one is found from the values
    /// that are shown of one plane or of several. There a value that occurs many times, as a
    /// uniform background does, counts once.
    DisplayLimits with(ColorScale scale, const std::vector<std::span<const float>>& shown) const;
};

} // namespace irsg
