#pragma once

#include <memory>
#include <string_view>

#include "irsg/image/Canvas.h"

namespace irsg {

enum class FontWeight { regular, bold };

/// The font of every picture that is exported, DejaVu Sans, as the bytes of its file: a part of the
/// library, so that pictures look the same on every machine, with fonts or without.
std::string_view fontFile(FontWeight weight);

/// That font at one size, set by FreeType. Text is UTF-8 on one line: a control character is a
/// blank, a character that the font lacks is a box, a byte that is no UTF-8 a question mark.
/// Letters are kerned and stand at fractions of pixels, from left to right; scripts whose letters
/// join are not shaped. Equal text makes equal pixels. An object is for one thread.
class PictureFont {
  public:
    /// Height of the em in pixels, 1 to 1000 (LogicError).
    PictureFont(FontWeight weight, double size_px);
    ~PictureFont();
    PictureFont(const PictureFont&) = delete;
    PictureFont& operator=(const PictureFont&) = delete;

    /// Of a capital without a bow, px.
    int capHeight() const;
    /// Of a line from where it begins to where another letter would stand, px, rounded up; INT_MAX
    /// for what is beyond any picture.
    int width(std::string_view text) const;
    /// Draws a line that begins at `x` on the base line `y`: letters without descender have their
    /// lowest pixels right above that row.
    void draw(Canvas& canvas, int x, int y, std::string_view text, Rgb color) const;

  private:
    struct Face;
    std::unique_ptr<Face> face_;
};

} // namespace irsg
