#include "irsg/image/StrokeFont.h"

#include <set>

#include <gmock/gmock.h>

#include "irsg/image/StrokeGlyphs.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {
namespace {

constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

/// Rows of '#' for dark pixels, from the top.
std::vector<std::string> drawn(const std::string& text, int scale) {
    Canvas canvas(std::max(1, textWidth(text, scale)), 16 * scale);
    drawText(canvas, 0, 12 * scale, text, scale, black);
    std::vector<std::string> rows;
    for (int y = 0; y < canvas.height(); ++y) {
        rows.emplace_back();
        for (int x = 0; x < canvas.width(); ++x) {
            rows.back() += canvas.at(x, y).red < 100 ? '#' : '.';
        }
    }
    return rows;
}

TEST(StrokeFont, DrawsAStemAsOneCrispLineOfPixels) {
    for (const int scale : {1, 2, 3}) {
        Canvas canvas(9 * scale, 14 * scale);
        drawText(canvas, 4 * scale, 12 * scale, "l", scale, black);
        for (int x = 0; x < canvas.width(); ++x) {
            const bool isStem = x >= 4 * scale && x < 5 * scale;
            const int value = canvas.at(x, 7 * scale).red;
            EXPECT_TRUE(isStem ? value == 0 : value > 230) << scale << " " << x << " " << value;
        }
    }
}

TEST(StrokeFont, DrawsAnLAsItLooks) {
    EXPECT_THAT(drawn("L", 1),
                testing::ElementsAre("......", "......", "#.....", "#.....", "#.....", "#.....",
                                     "#.....", "#.....", "#.....", "#.....", "#.....", "#.....",
                                     "######", "......", "......", "......"));
}

TEST(StrokeFont, TellsAllItsCharactersApart) {
    std::string text;
    for (char c = '!'; c <= '~'; ++c) {
        text += c;
    }
    std::set<std::vector<std::string>> pictures;
    std::size_t count = 0;
    const auto add = [&](const std::string& character) {
        pictures.insert(drawn(character, 2));
        ++count;
    };
    for (const char c : text) {
        // These pairs are as alike in print as here.
        if (c != 'l' && c != 'I') {
            add(std::string(1, c));
        }
    }
    for (const char* other :
         {"−", "·", "°", "µ", "×", "±", "λ", "⁰", "¹", "²", "³", "⁴", "⁻", "∑"}) {
        add(other);
    }
    EXPECT_EQ(pictures.size(), count);
}

TEST(StrokeFont, HasAGlyphForAllOfPrintableAscii) {
    const StrokeGlyph& box = strokeGlyph(0x2211);
    EXPECT_EQ(box.code, 0U);
    for (char32_t c = U' '; c <= U'~'; ++c) {
        EXPECT_EQ(strokeGlyph(c).code, c);
    }
}

TEST(StrokeFont, TakesBrokenUtf8AsBoxes) {
    EXPECT_EQ(drawn("\xff", 1), drawn("∑", 1));
    EXPECT_EQ(drawn("\xe2\x88", 1), drawn("∑∑", 1));
    EXPECT_EQ(textWidth("", 1), 0);
}

TEST(StrokeFont, WidthGrowsWithScaleAndHoldsAllInk) {
    const std::string text = "Radiance (W·m⁻²·sr⁻¹)";
    const int width = textWidth(text, 1);
    EXPECT_NEAR(textWidth(text, 2), 2 * width, 10);
    Canvas canvas(width + 20, 30);
    drawText(canvas, 10, 20, text, 1, black);
    for (int y = 0; y < canvas.height(); ++y) {
        for (const int x : {0, 5, 8, width + 12, width + 19}) {
            EXPECT_EQ(canvas.at(x, y), white) << x << " " << y;
        }
    }
}

TEST(StrokeFont, IsCutAtTheEdgeOfTheCanvas) {
    Canvas canvas(5, 5);
    drawText(canvas, -3, 2, "MMM", 2, black);
    drawText(canvas, 1000, 1000, "MMM", 2, black);
    SUCCEED();
}

TEST(Canvas, RefusesSizesWithoutPixels) {
    EXPECT_THROW(Canvas(0, 1), LogicError);
    EXPECT_THROW(Canvas(1, 65536), LogicError);
}

} // namespace
} // namespace irsg
