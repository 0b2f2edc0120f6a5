#pragma once

#include <string_view>

namespace irsg {

/// A letter as strokes. Units: capitals are 10 high, small letters 7, descenders reach -3; x grows
/// to the right from the first stem, y up from the base line.
///
/// `path` is made of: M x y (go there), L x y (a line from the last point), A cx cy rx ry a b (an
/// arc of an ellipse from angle a to b in degrees, 0 to the right, 90 up; its end is the last
/// point).
struct StrokeGlyph {
    char32_t code;
    double width;
    std::string_view path;
};

/// The glyph of a character; a box for one that has none.
const StrokeGlyph& strokeGlyph(char32_t code);

} // namespace irsg
