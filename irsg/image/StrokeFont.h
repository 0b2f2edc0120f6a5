#pragma once

#include <string>
#include <string_view>

#include "irsg/image/Canvas.h"

namespace irsg {

/// A small stroke font of our own for labels in pictures, so that a view needs no font file and
/// looks the same everywhere. Stems lie on whole pixels at every scale. Printable ASCII, and
/// − · ° µ × ± λ – and superscript digits with their signs; any other character is a box.

/// Height of a capital letter in pixels at scale 1; a pixel is one unit of the glyphs.
inline constexpr int capHeight_px = 10;
/// Deepest a letter reaches below its base line at scale 1.
inline constexpr int descent_px = 3;

/// Width of a line of UTF-8 text from the first stem to the last, px.
int textWidth(std::string_view text, int scale);

/// Draws a line of UTF-8 text that begins at `x` on the base line `y` (the lowest row of letters
/// without descender).
void drawText(Canvas& canvas, int x, int y, std::string_view text, int scale, Rgb color);

} // namespace irsg
