#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "irsg/image/ImageStatistics.h"

namespace irsg {

/// A colour of a picture, sRGB.
struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;

    bool operator==(const Rgb&) const = default;
};

/// The byte of a channel for linear light, 0 to 1, what is outside of that clamped (IEC 61966-2-1).
std::uint8_t byteOfLight(double linear);
/// Back: the linear light of a byte.
double lightOfByte(std::uint8_t byte);

/// Lightness L* of CIE 1976 (D65), 0 black to 100 white.
double lightness(Rgb color);

/// A map from 0..1 to colours, for views; data are never coloured.
///
/// `white-hot` (the default) and `black-hot` are grey, the byte rising in equal steps. `ironbow`,
/// `inferno` and `viridis` run through the control points of the source, linear in CIE L*a*b*
/// between them, so that lightness rises all the way and a grey print keeps the order of the
/// values. `diverging` runs from blue over white at the centre to red, for signed differences
/// alone. What lies below or above the limits, and what is no number, has colours of its own that
/// are not in the map.
class ColorMap {
  public:
    /// 1021 entries: four to a grey level, and one exactly in the centre.
    static constexpr std::size_t size = 1021;
    static constexpr const char* defaultName = "white-hot";

    /// Throws InputError that lists the names.
    static const ColorMap& named(const std::string& name);
    static std::vector<std::string> names();

    const std::string& name() const { return name_; }
    bool isDiverging() const { return name_ == "diverging"; }
    /// The colour at `t`, clamped to 0..1; that of NaN for NaN.
    Rgb at(double t) const;
    Rgb below() const { return below_; }
    Rgb above() const { return above_; }
    Rgb notANumber() const { return notANumber_; }
    /// The colour of a value shown between the limits (low < high), infinities being out of range:
    /// that of the nearer end, or the mark for what is outside where the limits ask for it.
    Rgb color(double value, const DisplayLimits& limits) const;
    const std::array<Rgb, size>& table() const { return table_; }

  private:
    struct Definition;
    explicit ColorMap(const Definition& definition);
    static const std::vector<ColorMap>& all();

    std::string name_;
    std::array<Rgb, size> table_;
    Rgb below_, above_, notANumber_;
};

} // namespace irsg
