#include "irsg/image/PictureFont.h"

#include <set>

#include <gmock/gmock.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};
constexpr int margin = 10;

/// A line on a canvas with room around it; the base line is at 2 * margin.
Canvas drawn(std::string_view text, double size_px = 12.0,
             FontWeight weight = FontWeight::regular) {
    const PictureFont font(weight, size_px);
    const int room = margin + static_cast<int>(2.0 * size_px);
    Canvas canvas(font.width(text) + 2 * margin, 2 * room);
    font.draw(canvas, margin, room, text, black);
    return canvas;
}

/// The rows and columns that have ink, relative to where the line begins on its base line.
struct Ink {
    int left = 1000, right = -1000, top = 1000, bottom = -1000;
};
Ink inkOf(const Canvas& canvas) {
    Ink ink;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            if (canvas.at(x, y) != white) {
                ink.left = std::min(ink.left, x - margin);
                ink.right = std::max(ink.right, x - margin);
                ink.top = std::min(ink.top, y - canvas.height() / 2);
                ink.bottom = std::max(ink.bottom, y - canvas.height() / 2);
            }
        }
    }
    return ink;
}

TEST(PictureFont, StandsOnItsBaseLineAndIsAsHighAsItSays) {
    for (const FontWeight weight : {FontWeight::regular, FontWeight::bold}) {
        for (const double size_px : {11.0, 12.0, 13.0, 24.0, 96.0}) {
            const Ink ink = inkOf(drawn("HLE", size_px, weight));
            EXPECT_EQ(ink.bottom, -1) << size_px;
            EXPECT_EQ(ink.top, -PictureFont(weight, size_px).capHeight()) << size_px;
            EXPECT_NEAR(-ink.top, 0.729 * size_px, 1.1); // cap height of DejaVu Sans
            EXPECT_GT(inkOf(drawn("g", size_px, weight)).bottom, 0) << size_px;
        }
    }
}

TEST(PictureFont, IsSmoothedAndBolderWhereItIsBold) {
    const auto darkness = [](const Canvas& canvas) {
        double sum = 0.0;
        for (const std::uint8_t value : canvas.bytes()) {
            sum += 255 - value;
        }
        return sum;
    };
    const Canvas sound = drawn("Sound");
    const std::set<int> greys(sound.bytes().begin(), sound.bytes().end());
    EXPECT_GT(greys.size(), 20U);
    EXPECT_GT(darkness(drawn("Sound", 12.0, FontWeight::bold)), 1.2 * darkness(sound));
}

TEST(PictureFont, HasWhatUnitsNamesAndTitlesAreWrittenWith) {
    std::set<std::vector<std::uint8_t>> pictures{drawn("\u4E2D").bytes()}; // the box
    std::size_t count = 1;
    const auto add = [&](std::u32string_view characters) {
        for (const char32_t c : characters) {
            std::string text;
            if (c < 0x80) {
                text += static_cast<char>(c);
            } else if (c < 0x800) {
                text += static_cast<char>(0xC0 | (c >> 6));
                text += static_cast<char>(0x80 | (c & 0x3F));
            } else {
                text += static_cast<char>(0xE0 | (c >> 12));
                text += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
                text += static_cast<char>(0x80 | (c & 0x3F));
            }
            pictures.insert(drawn(text, 24.0).bytes());
            EXPECT_EQ(pictures.size(), ++count) << text;
        }
    };
    pictures.insert(drawn("\u4E2D", 24.0).bytes());
    count = pictures.size();
    for (char32_t c = U'!'; c <= U'~'; ++c) {
        add(std::u32string(1, c));
    }
    for (char32_t c = 0xA1; c <= 0xFF; ++c) {
        if (c != 0xAD) { // a place to break a line
            add(std::u32string(1, c));
        }
    }
    add(U"−–—‘’“”…λΔσθ⁰⁴⁵⁶⁷⁸⁹⁺⁻₀₁₂≤≥∞√∫←→ŁřşěЖд");
}

TEST(PictureFont, TakesWhatItLacksAndWhatIsNoTextWithoutComplaint) {
    EXPECT_EQ(drawn("\u4E2D").bytes(), drawn("\u4E8C").bytes()) << "two boxes";
    EXPECT_NE(drawn("\u4E2D").bytes(), drawn(" ").bytes());
    EXPECT_EQ(drawn("a\xff").bytes(), drawn("a\uFFFD").bytes());
    EXPECT_EQ(drawn("\xe2\x88").bytes(), drawn("\uFFFD\uFFFD").bytes());
    EXPECT_EQ(drawn("a\n\tb\x7f").bytes(), drawn("a  b ").bytes());
    EXPECT_EQ(drawn(std::string_view("a\0b", 3)).bytes(), drawn("a b").bytes());
    const PictureFont font(FontWeight::regular, 12.0);
    EXPECT_EQ(font.width(""), 0);
    for (int first = 0; first < 256; ++first) {
        for (int second = 0; second < 256; ++second) {
            EXPECT_GE(font.width(std::string{static_cast<char>(first), static_cast<char>(second)}),
                      0);
        }
    }
}

TEST(PictureFont, KernsAndKeepsFractionsOfPixels) {
    const PictureFont font(FontWeight::regular, 12.0), large(FontWeight::regular, 960.0);
    EXPECT_LT(large.width("AV"), large.width("A") + large.width("V") - 10);
    const std::string line(100, 'i');
    EXPECT_NEAR(font.width(line), large.width(line) / 80.0, 2.0);
    EXPECT_NEAR(font.width("Radiance (W·m⁻²·sr⁻¹)"), large.width("Radiance (W·m⁻²·sr⁻¹)") / 80.0,
                2.0);
}

TEST(PictureFont, HoldsAllInkInItsWidth) {
    for (const char* text : {"Radiance (W·m⁻²·sr⁻¹)", "AVAVA", "jT", "3–5 µm, 20 °C", "Wf"}) {
        const Canvas canvas = drawn(text, 24.0);
        const Ink ink = inkOf(canvas);
        EXPECT_GE(ink.left, -5) << text; // a j reaches back
        EXPECT_LE(ink.right, canvas.width() - 2 * margin + 2) << text;
        EXPECT_GE(ink.right, canvas.width() - 2 * margin - 6) << text;
    }
}

TEST(PictureFont, MakesEqualPixelsOfEqualText) {
    EXPECT_EQ(drawn("Contrast 3–5 µm").bytes(), drawn("Contrast 3–5 µm").bytes());
    // One object after other work too.
    const PictureFont font(FontWeight::bold, 13.0);
    Canvas once(200, 40), again(200, 40);
    font.draw(once, 5, 20, "Heron", black);
    font.draw(again, 5, 20, "Heron", black);
    EXPECT_EQ(once.bytes(), again.bytes());
}

TEST(PictureFont, IsCutAtTheEdgesOfTheCanvas) {
    const PictureFont font(FontWeight::regular, 24.0);
    Canvas whole(60, 40), cut(20, 12);
    font.draw(whole, 10, 30, "MMM", black);
    font.draw(cut, 0, 12, "MMM", black);
    for (int y = 0; y < cut.height(); ++y) {
        for (int x = 0; x < cut.width(); ++x) {
            EXPECT_EQ(cut.at(x, y), whole.at(x + 10, y + 18)) << x << " " << y;
        }
    }
    Canvas clean(5, 5);
    font.draw(clean, -500, -500, "MMM", black);
    font.draw(clean, 60000, 60000, "MMM", black);
    EXPECT_EQ(clean.bytes(), Canvas(5, 5).bytes());
}

TEST(PictureFont, RefusesSizesThatNobodyReads) {
    for (const double size_px : {0.0, -1.0, 1001.0, std::nan("")}) {
        EXPECT_THROW(PictureFont(FontWeight::regular, size_px), LogicError) << size_px;
    }
}

TEST(PictureFont, IsAPartOfTheLibrary) {
    for (const FontWeight weight : {FontWeight::regular, FontWeight::bold}) {
        EXPECT_GT(fontFile(weight).size(), 300000U);
        EXPECT_EQ(fontFile(weight).substr(0, 4), std::string_view("\0\1\0\0", 4)); // TrueType
    }
    EXPECT_NE(fontFile(FontWeight::regular), fontFile(FontWeight::bold));
}

TEST(Canvas, RefusesSizesWithoutPixels) {
    EXPECT_THROW(Canvas(0, 1), LogicError);
    EXPECT_THROW(Canvas(1, 65536), LogicError);
}

} // namespace
} // namespace irsg
