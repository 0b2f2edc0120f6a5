#include "irsg/image/PngView.h"

#include <cmath>

#include <gmock/gmock.h>
#include <png.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::infinity;
using test::inputErrorOf;
using test::nanValue;
using testing::HasSubstr;

/// A PNG as the library reads it back.
Canvas readPng(const std::filesystem::path& file) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&picture, file.c_str()), 0) << picture.message;
    EXPECT_EQ(picture.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(picture));
    EXPECT_NE(png_image_finish_read(&picture, nullptr, bytes.data(), 0, nullptr), 0);
    Canvas canvas(static_cast<int>(picture.width), static_cast<int>(picture.height));
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            const std::size_t i = 3 * static_cast<std::size_t>(y * canvas.width() + x);
            canvas.set(x, y, {bytes[i], bytes[i + 1], bytes[i + 2]});
        }
    }
    return canvas;
}

RadianceImage imageOf(int width, int height, std::vector<float> values) {
    RadianceImage image(width, height);
    image.primary().values = std::move(values);
    return image;
}

PngViewOptions plain() {
    PngViewOptions options;
    options.colorBar = false;
    return options;
}

TEST(PngView, IsTheMapOfTheValuesTopRowFirst) {
    const test::TemporaryFolder folder;
    writePngView(imageOf(3, 2, {0, 51, 102, 153, 204, 255}), folder / "a.png", plain());
    const Canvas png = readPng(folder / "a.png");
    ASSERT_EQ(png.width(), 3);
    ASSERT_EQ(png.height(), 2);
    const std::uint8_t expected[] = {0, 51, 102, 153, 204, 255};
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(png.at(i % 3, i / 3), (Rgb{expected[i], expected[i], expected[i]})) << i;
    }
}

TEST(PngView, KeepsEverySizeThatAnImageCanHave) {
    const test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 13}, {13, 1}, {61, 67}}) {
        const RadianceImage image = test::patternImage(width, height);
        writePngView(image, folder / "a.png", plain());
        EXPECT_EQ(readPng(folder / "a.png").width(), width);
        EXPECT_EQ(readPng(folder / "a.png").height(), height);
        const Canvas withBar = renderView(image, image.primary());
        EXPECT_GT(withBar.width(), width);
        EXPECT_GT(withBar.height(), 160);
    }
}

TEST(PngView, WhatIsOutOfRangeSaturatesOrIsMarked) {
    PngViewOptions options = plain();
    options.limits = DisplayLimits{.low = 0, .high = 10, .marksOutside = true};
    const RadianceImage image = imageOf(6, 1, {-1, 0, 10, 11, nanValue, -infinity});
    const ColorMap& map = ColorMap::named("white-hot");
    Canvas view = renderView(image, image.primary(), options);
    EXPECT_EQ(view.at(0, 0), map.below());
    EXPECT_EQ(view.at(1, 0), map.at(0));
    EXPECT_EQ(view.at(2, 0), map.at(1));
    EXPECT_EQ(view.at(3, 0), map.above());
    EXPECT_EQ(view.at(4, 0), map.notANumber());
    EXPECT_EQ(view.at(5, 0), map.below());

    options.limits->marksOutside = false;
    view = renderView(image, image.primary(), options);
    EXPECT_EQ(view.at(0, 0), map.at(0));
    EXPECT_EQ(view.at(3, 0), map.at(1));
    EXPECT_EQ(view.at(4, 0), map.notANumber());
    EXPECT_EQ(view.at(5, 0), map.at(0));
}

TEST(PngView, EnlargesPixelsToSquares) {
    PngViewOptions options = plain();
    options.magnification = 3;
    const RadianceImage image = imageOf(2, 1, {0, 1});
    const Canvas view = renderView(image, image.primary(), options);
    ASSERT_EQ(view.width(), 6);
    ASSERT_EQ(view.height(), 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 6; ++x) {
            EXPECT_EQ(view.at(x, y).red, x < 3 ? 0 : 255);
        }
    }
}

TEST(PngView, CentresDifferencesOnWhite) {
    PngViewOptions options = plain();
    options.colorMap = "diverging";
    const RadianceImage image = imageOf(3, 1, {-1, 0, 4});
    const Canvas view = renderView(image, image.primary(), options);
    EXPECT_EQ(view.at(1, 0), (Rgb{255, 255, 255}));
    EXPECT_EQ(view.at(2, 0), ColorMap::named("diverging").at(1.0));
    EXPECT_EQ(view.at(0, 0), ColorMap::named("diverging").at(0.375));
}

/// The column of colours beside the picture: the rows between its frame lines.
std::vector<Rgb> barColumn(const Canvas& view, int x) {
    std::vector<Rgb> column;
    for (int y = 0; y < view.height(); ++y) {
        column.push_back(view.at(x, y));
    }
    return column;
}

TEST(PngView, DrawsTheWholeMapInItsBarBrightAtTheTop) {
    RadianceImage image = imageOf(1, 1, {5});
    PngViewOptions options;
    options.colorMap = "inferno";
    options.limits = DisplayLimits{0, 10};
    options.magnification = 64;
    options.textScale = 1;
    const Canvas view = renderView(image, image.primary(), options);

    // The bar begins 20 px behind the picture, which begins at 16.
    const std::vector<Rgb> column = barColumn(view, 16 + 64 + 20 + 9);
    const ColorMap& map = ColorMap::named("inferno");
    std::vector<Rgb> bar;
    for (const Rgb& color : column) {
        if (std::ranges::find(map.table(), color) != map.table().end()) {
            bar.push_back(color);
        }
    }
    ASSERT_EQ(bar.size(), 160U);
    for (std::size_t i = 0; i < bar.size(); ++i) {
        EXPECT_EQ(bar[i], map.at(1.0 - (static_cast<double>(i) + 0.5) / 160.0)) << i;
    }
}

TEST(PngView, AddsSwatchesOnlyForWhatIsThere) {
    const ColorMap& map = ColorMap::named("white-hot");
    const auto hasBeyondPicture = [&](const RadianceImage& image, Rgb color) {
        PngViewOptions options;
        options.limits = DisplayLimits{.low = 0, .high = 10, .marksOutside = true};
        options.magnification = 1;
        const Canvas view = renderView(image, image.primary(), options);
        int pixels = 0;
        for (int y = 0; y < view.height(); ++y) {
            for (int x = 16 + image.width() + 2; x < view.width(); ++x) {
                pixels += view.at(x, y) == color ? 1 : 0;
            }
        }
        return pixels == 18 * 12;
    };
    const RadianceImage clean = imageOf(2, 1, {0, 10});
    const RadianceImage dirty = imageOf(5, 1, {0, 10, -1, 11, nanValue});
    for (const Rgb& color : {map.below(), map.above(), map.notANumber()}) {
        EXPECT_FALSE(hasBeyondPicture(clean, color));
        EXPECT_TRUE(hasBeyondPicture(dirty, color));
    }
}

TEST(PngView, IsNeverCutByTitleOrLabel) {
    RadianceImage image = imageOf(1, 1, {1});
    PngViewOptions options;
    options.title = "A title that is much longer than so small a picture is wide, by far and away";
    options.label = "And a label of the bar that is long as well";
    const Canvas view = renderView(image, image.primary(), options);
    for (int y = 0; y < view.height(); ++y) {
        EXPECT_EQ(view.at(0, y), (Rgb{255, 255, 255}));
        EXPECT_EQ(view.at(view.width() - 1, y), (Rgb{255, 255, 255}));
    }
}

TEST(PngView, ShowsImagesWithoutAnyFiniteValue) {
    const RadianceImage image = imageOf(2, 1, {nanValue, infinity});
    const Canvas view = renderView(image, image.primary(), plain());
    EXPECT_EQ(view.at(0, 0), ColorMap::named("white-hot").notANumber());
    EXPECT_EQ(view.at(1, 0), ColorMap::named("white-hot").at(1.0));
}

TEST(PngView, RefusesOptionsThatCannotBe) {
    const RadianceImage image = imageOf(1, 1, {1});
    const struct {
        const char* name;
        PngViewOptions options;
        const char* says;
    } rows[] = {
        {"unknown map", {.colorMap = "jet"}, "colour map"},
        {"reversed limits", {.limits = DisplayLimits{2, 1}}, "display limits"},
        {"equal limits", {.limits = DisplayLimits{1, 1}}, "display limits"},
        {"infinite limits", {.limits = DisplayLimits{0, infinity}}, "display limits"},
        {"NaN limits", {.limits = DisplayLimits{nanValue, 1}}, "display limits"},
        {"negative magnification", {.magnification = -1}, "magnification"},
        {"huge magnification", {.magnification = 65}, "magnification"},
        {"huge text", {.textScale = 9}, "text scale"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(inputErrorOf([&] { renderView(image, image.primary(), row.options); }),
                    HasSubstr(row.says))
            << row.name;
    }

    const RadianceImage wide(2000, 1);
    EXPECT_THAT(inputErrorOf([&] { renderView(wide, wide.primary(), {.magnification = 64}); }),
                HasSubstr("at most 65535"));
}

TEST(PngView, RefusesChannelsAndFoldersThatAreNotThere) {
    const test::TemporaryFolder folder;
    const RadianceImage image(1, 1);
    EXPECT_THROW(writePngView(image, folder / "a.png", {}, "alpha"), LogicError);
    EXPECT_THROW(writePngView(RadianceImage(), folder / "a.png"), LogicError);
    EXPECT_THAT(inputErrorOf([&] { writePngView(image, folder / "none/a.png"); }),
                HasSubstr("none/a.png"));
}

} // namespace
} // namespace irsg
