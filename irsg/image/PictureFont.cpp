#include "irsg/image/PictureFont.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <string>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "irsg/core/Errors.h"
#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

/// FreeType's lengths: 64 a pixel.
constexpr FT_Pos perPixel = 64;
constexpr std::int64_t widest = std::int64_t{INT_MAX} * perPixel;
/// Stems as they are drawn, level lines on whole pixels.
constexpr FT_Int32 loading = FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP;

void check(FT_Error error, const char* step) {
    if (error != 0)
        throw LogicError("FreeType fails to " + std::string(step) + " (error " +
                         std::to_string(error) + ")");
}

} // namespace

struct PictureFont::Face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    int capHeight = 0;

    ~Face() {
        // With it goes the face.
        if (library != nullptr)
            FT_Done_FreeType(library);
    }

    /// Loads each letter of a line and hands it on with the place of its origin; returns where the
    /// line ends.
    template <typename Each>
    std::int64_t walk(std::string_view text, const Each& each) const {
        std::int64_t pen = 0;
        FT_UInt previous = 0;
        for (const char32_t character : charactersOf(text)) {
            const bool isControl = character < 0x20 || (character >= 0x7F && character < 0xA0);
            const FT_UInt glyph = FT_Get_Char_Index(face, isControl ? U' ' : character);
            FT_Vector kerning{};
            if (previous != 0 && glyph != 0)
                check(FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning),
                      "kern letters");
            check(FT_Load_Glyph(face, glyph, loading), "load a letter");
            pen = std::min(pen + kerning.x, widest);
            each(pen);
            pen = std::min(pen + (face->glyph->linearHoriAdvance >> 10), widest); // of 16.16
            previous = glyph;
        }
        return pen;
    }
};

PictureFont::PictureFont(FontWeight weight, double size_px) : face_(std::make_unique<Face>()) {
    if (!(size_px >= 1.0 && size_px <= 1000.0))
        throw LogicError("a font of " + std::to_string(size_px) + " pixels was asked for");
    check(FT_Init_FreeType(&face_->library), "start");
    const std::string_view file = fontFile(weight);
    check(FT_New_Memory_Face(face_->library, reinterpret_cast<const FT_Byte*>(file.data()),
                             static_cast<FT_Long>(file.size()), 0, &face_->face),
          "open the font");
    check(FT_Set_Char_Size(face_->face, 0, std::lround(size_px * perPixel), 72, 72),
          "set the size of the font");
    check(FT_Load_Char(face_->face, 'H', loading), "load a letter");
    face_->capHeight = static_cast<int>(face_->face->glyph->metrics.horiBearingY / perPixel);
}

PictureFont::~PictureFont() = default;

int PictureFont::capHeight() const {
    return face_->capHeight;
}

int PictureFont::width(std::string_view text) const {
    const std::int64_t end = face_->walk(text, [](std::int64_t) {});
    return static_cast<int>((end + perPixel - 1) / perPixel);
}

void PictureFont::draw(Canvas& canvas, int x, int y, std::string_view text, Rgb color) const {
    face_->walk(text, [&](std::int64_t pen) {
        FT_GlyphSlot slot = face_->face->glyph;
        FT_Outline_Translate(&slot->outline, pen % perPixel, 0);
        check(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), "draw a letter");
        const FT_Bitmap& bitmap = slot->bitmap;
        const std::int64_t left = x + pen / perPixel + slot->bitmap_left;
        if (left >= canvas.width())
            return;
        for (unsigned row = 0; row < bitmap.rows; ++row)
            for (unsigned column = 0; column < bitmap.width; ++column)
                if (const auto coverage = bitmap.buffer[row * bitmap.pitch + column]; coverage > 0)
                    canvas.blend(static_cast<int>(left + column),
                                 y - slot->bitmap_top + static_cast<int>(row), color,
                                 coverage / 255.0);
    });
}

} // namespace irsg
