#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <string>

#include <osg/Image>
#include <osgDB/WriteFile>

#include <png.h>

#include "irsg/core/Errors.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/PngPlane.h"
#include "irsg/render/background/Skybox.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using smat::test::refusalOf;
using smat::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// Values of a 3 x 2 picture in 1/65535, top row first.
constexpr std::uint16_t values16[6] = {0, 1, 257, 30000, 65534, 65535};
constexpr std::uint8_t values8[6] = {0, 1, 127, 128, 254, 255};

void write(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

void writePng(const fs::path& file, int width, int height, int format, const void* pixels) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.width = static_cast<png_uint_32>(width);
    picture.height = static_cast<png_uint_32>(height);
    picture.format = static_cast<png_uint_32>(format);
    ASSERT_NE(png_image_write_to_file(&picture, file.c_str(), 0, pixels, 0, nullptr), 0);
}

/// An uncompressed grey TIFF of one strip, little-endian.
std::string tiff(int bits, const void* pixels, std::size_t count) {
    std::string bytes("II*\0", 4);
    const auto number = [&](std::uint32_t value, int size) {
        for (int i = 0; i < size; ++i) {
            bytes.push_back(static_cast<char>(value >> (8 * i) & 0xff));
        }
    };
    number(static_cast<std::uint32_t>(8 + count), 4);
    bytes.append(static_cast<const char*>(pixels), count);
    const std::uint32_t entries[][3] = {
        {256, 3, 3}, {257, 3, 2}, {258, 3, static_cast<std::uint32_t>(bits)},
        {259, 3, 1}, {262, 3, 1}, {273, 4, 8},
        {277, 3, 1}, {278, 3, 2}, {279, 4, static_cast<std::uint32_t>(count)}};
    number(9, 2);
    for (const auto& [tag, type, value] : entries) {
        number(tag, 2);
        number(type, 2);
        number(1, 4);
        number(value, 4);
    }
    number(0, 4);
    return bytes;
}

/// A square grey picture of 8 bits.
void writeGrey(const fs::path& file, int side, std::uint8_t value) {
    const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(side * side), value);
    writePng(file, side, side, PNG_FORMAT_GRAY, pixels.data());
}

} // namespace

TEST(Texture, OfEightBitsIsItsNumbersOver255) {
    const TemporaryFolder folder;
    writePng(folder / "grey.png", 3, 2, PNG_FORMAT_GRAY, values8);
    write(folder / "grey.tif", tiff(8, values8, sizeof values8));
    for (const char* name : {"grey.png", "grey.tif"}) {
        const TextureImage image = readTexture(folder / name);
        ASSERT_EQ(image.width_px, 3) << name;
        ASSERT_EQ(image.height_px, 2) << name;
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(image.values[i], static_cast<float>(values8[i]) / 255.0f) << name;
        }
    }
}

TEST(Texture, TakesTheRedOfColours) {
    const TemporaryFolder folder;
    const std::uint8_t pixels[] = {10, 200, 30, 40, 50, 250};
    writePng(folder / "colour.png", 2, 1, PNG_FORMAT_RGB, pixels);
    const TextureImage image = readTexture(folder / "colour.png");
    EXPECT_EQ(image.values, (std::vector<float>{10.0f / 255.0f, 40.0f / 255.0f}));
}

TEST(Texture, OfSixteenBitsKeepsThemAll) {
    const TemporaryFolder folder;
    write(folder / "grey.tiff", tiff(16, values16, sizeof values16));
    const TextureImage image = readTexture(folder / "grey.tiff");
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_FLOAT_EQ(image.values[i], static_cast<float>(values16[i]) / 65535.0f);
    }
    // A picture that libpng calls linear is one of 16 bits with a gamma of 1.
    writePng(folder / "grey.png", 3, 2, PNG_FORMAT_LINEAR_Y, values16);
    const PngPlane plane = readPngPlane(folder / "grey.png");
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(plane.values[i], static_cast<float>(values16[i]) / 65535.0f);
    }
}

TEST(Texture, OfFloatsIsTheFloats) {
    const TemporaryFolder folder;
    RadianceImage image(3, 2, "R");
    image.primary().values = {-5.0f, 123.25f, 0.0f, 1e-7f, 3e8f, 0.5f};
    writeExr(image, folder / "float.exr");
    EXPECT_EQ(readTexture(folder / "float.exr").values, image.primary().values);

    // Radiance HDR: mantissas and a common exponent of 128 + 1, so 2 * mantissa / 256.
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n";
    bytes += std::string("\x80\x20\x10\x81", 4) + std::string("\x40\x20\x10\x82", 4);
    write(folder / "light.hdr", bytes);
    const TextureImage light = readTexture(folder / "light.hdr");
    ASSERT_EQ(light.height_px, 2);
    EXPECT_NEAR(light.values[0], 1.0f, 0.01f);
    EXPECT_NEAR(light.values[1], 1.0f, 0.01f);
}

TEST(Texture, OfAJpegIsWithinItsLoss) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(16, 16, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < 16; ++y) {
        std::memset(picture->data(0, static_cast<unsigned int>(y)), y < 8 ? 60 : 180, 48);
    }
    ASSERT_TRUE(osgDB::writeImageFile(*picture, (folder / "p.jpg").string()));
    const TextureImage image = readTexture(folder / "p.jpg");
    EXPECT_NEAR(image.values[0], 180.0f / 255.0f, 0.02f) << "top row first";
    EXPECT_NEAR(image.values[255], 60.0f / 255.0f, 0.02f);
}

TEST(Texture, ThatIsNoPictureIsRefused) {
    const TemporaryFolder folder;
    write(folder / "cut.png", "\x89PNG\r\n\x1a\n");
    write(folder / "text.png", "no picture");
    write(folder / "text.tif", "no picture");
    write(folder / "text.jpg", "no picture");
    write(folder / "text.hdr", "no picture");
    write(folder / "text.exr", "no picture");
    write(folder / "empty.png", "");
    write(folder / "some.flat", "no picture");
    writeGrey(folder / "whole.png", 64, 7);
    fs::resize_file(folder / "whole.png", fs::file_size(folder / "whole.png") / 2);
    RadianceImage image(2, 1, "R");
    image.primary().values = {1.0f, std::numeric_limits<float>::quiet_NaN()};
    writeExr(image, folder / "nan.exr");
    for (const char* name :
         {"cut.png", "text.png", "text.tif", "text.jpg", "text.hdr", "text.exr", "empty.png",
          "some.flat", "whole.png", "nan.exr", "missing.png", "missing.jpg", "missing.exr"}) {
        const std::string message = refusalOf([&] { readTexture(folder / name); });
        EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
    }
}

TEST(SkyboxFiles, AreFoundByTheirNames) {
    const TemporaryFolder folder;
    std::uint8_t value = 10;
    for (const char* name : {"N.png", "south.png", "East.png", "w.png", "UP.png", "Down.png"}) {
        writeGrey(folder / name, 4, value++);
    }
    write(folder / "README.md", "not a face");
    const auto sky = Skybox::load(folder.path());
    EXPECT_EQ(sky->faceSize(), 4);
    EXPECT_FLOAT_EQ(static_cast<float>(sky->at({0, 1, 0})), 10.0f / 255.0f);
    EXPECT_FLOAT_EQ(static_cast<float>(sky->at({1, 0, 0})), 12.0f / 255.0f);
    EXPECT_FLOAT_EQ(static_cast<float>(sky->at({0, 0, -1})), 15.0f / 255.0f);
}

TEST(SkyboxFiles, ThatAreMissingOrWrongAreNamed) {
    const TemporaryFolder folder;
    for (const char* name : {"north.png", "south.png", "east.png", "down.png"}) {
        writeGrey(folder / name, 4, 1);
    }
    const std::string missing = refusalOf([&] { Skybox::load(folder.path()); });
    EXPECT_NE(missing.find("face west"), std::string::npos) << missing;
    EXPECT_NE(missing.find("face up"), std::string::npos) << missing;

    writeGrey(folder / "west.png", 5, 1);
    const std::uint8_t pixels[12] = {};
    writePng(folder / "up.png", 4, 3, PNG_FORMAT_GRAY, pixels);
    const std::string sizes = refusalOf([&] { Skybox::load(folder.path()); });
    EXPECT_NE(sizes.find("west.png: found 5 x 5 texels"), std::string::npos) << sizes;
    EXPECT_NE(sizes.find("up.png: found 4 x 3 texels"), std::string::npos) << sizes;

    write(folder / "east.png", "damaged");
    write(folder / "n.jpg", "");
    const std::string twice = refusalOf([&] { Skybox::load(folder.path()); });
    EXPECT_NE(twice.find("n.jpg and north.png"), std::string::npos) << twice;
    fs::remove(folder / "n.jpg");
    const std::string damaged = refusalOf([&] { Skybox::load(folder.path()); });
    EXPECT_NE(damaged.find("east.png: skybox face east"), std::string::npos) << damaged;

    EXPECT_NE(refusalOf([&] { Skybox::load(folder / "nowhere"); }).find("nowhere"),
              std::string::npos);
    EXPECT_NE(refusalOf([] { Skybox::load(std::array<fs::path, 6>{}); }).find("face north"),
              std::string::npos);
}
