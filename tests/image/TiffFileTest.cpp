#include "irsg/image/TiffFile.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFile.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using smat::test::ownFolder;
using smat::test::writtenFile;
using test::bitsOf;
using test::inputErrorOf;
using test::patternImage;
using testing::HasSubstr;

RadianceImage imageWithEverything(int width, int height) {
    RadianceImage image = patternImage(width, height);
    image.primary().unit = "W m-2 sr-1";
    image.channel("range_m", "m").values.assign(image.pixelCount(), 1234.5F);
    image.attributes = {{"band", "3-5 um"},
                        {"two\nlines", "a: b\nc\\d"},
                        {"unit", "an attribute of that name"},
                        {"empty", ""},
                        {"accents", "Québec, 20 °C"}};
    return image;
}

TEST(TiffFile, KeepsEveryBitOfEveryPlaneWithUnitsAndAttributes) {
    // Strips of 64 rows: less than one, whole ones, and a rest.
    for (const auto& [width, height] : {std::pair(1, 1), {7, 64}, {33, 200}}) {
        const RadianceImage image = imageWithEverything(width, height);
        const auto file = ownFolder() / "image.tif";
        writeTiff(image, file);
        for (const RadianceImage& read : {readTiff(file), readImageFile(file)}) {
            ASSERT_EQ(read.channels.size(), 2U);
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_EQ(read.channels[i].name, image.channels[i].name);
                EXPECT_EQ(read.channels[i].unit, image.channels[i].unit);
                EXPECT_EQ(bitsOf(read.channels[i].values), bitsOf(image.channels[i].values));
            }
            EXPECT_EQ(read.attributes, image.attributes);
        }
    }
}

/// A little-endian TIFF of one strip, put together by hand from the TIFF 6.0 specification.
class HandMade {
  public:
    HandMade& entry(std::uint16_t tag, std::uint16_t type, std::uint32_t value) {
        entries_.push_back({tag, type, 1, value});
        return *this;
    }
    HandMade& size(std::uint32_t width, std::uint32_t height, std::uint16_t bits,
                   std::uint16_t format) {
        return entry(256, 4, width).entry(257, 4, height).entry(258, 3, bits).entry(339, 3, format);
    }
    template <typename Number>
    HandMade& data(const std::vector<Number>& values) {
        pixels_.assign(reinterpret_cast<const char*>(values.data()),
                       values.size() * sizeof(Number));
        return *this;
    }
    std::string bytes(std::uint16_t photometric = 1) {
        entry(259, 3, 1).entry(262, 3, photometric).entry(278, 4, 1U << 20);
        entry(273, 4, 0).entry(279, 4, static_cast<std::uint32_t>(pixels_.size()));
        std::ranges::sort(entries_, {}, [](const auto& one) { return one[0]; });
        const auto start = static_cast<std::uint32_t>(8 + 2 + 12 * entries_.size() + 4);
        std::string out = "II*";
        out += '\0';
        put(out, 8, 4);
        put(out, static_cast<std::uint32_t>(entries_.size()), 2);
        for (const auto& one : entries_) {
            put(out, one[0], 2);
            put(out, one[1], 2);
            put(out, one[2], 4);
            put(out, one[0] == 273 ? start : one[3], 4);
        }
        put(out, 0, 4);
        return out + pixels_;
    }

  private:
    static void put(std::string& out, std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) {
            out += static_cast<char>((value >> (8 * i)) & 0xFFU);
        }
    }
    std::vector<std::array<std::uint32_t, 4>> entries_;
    std::string pixels_;
};

TEST(TiffFile, ReadsNumbersOfEveryTypeOfOthers) {
    const auto readOf = [](HandMade made) {
        return readTiff(writtenFile(ownFolder() / "foreign.tif", made.bytes()));
    };
    const std::vector<float> expected = {1.0F, 2.0F, 250.0F, 4.0F, 5.0F, 6.0F};
    const auto as = [&]<typename Number>(Number) {
        return std::vector<Number>(expected.begin(), expected.end());
    };
    for (const RadianceImage& image :
         {readOf(HandMade().size(3, 2, 32, 3).data(as(0.0F))),
          readOf(HandMade().size(3, 2, 64, 3).data(as(0.0))),
          readOf(HandMade().size(3, 2, 8, 1).data(as(std::uint8_t{}))),
          readOf(HandMade().size(3, 2, 16, 1).data(as(std::uint16_t{}))),
          readOf(HandMade().size(3, 2, 32, 1).data(as(std::uint32_t{}))),
          readOf(HandMade().size(3, 2, 16, 2).data(as(std::int16_t{}))),
          readOf(HandMade().size(3, 2, 32, 2).data(as(std::int32_t{})))}) {
        ASSERT_EQ(image.width(), 3);
        ASSERT_EQ(image.height(), 2);
        EXPECT_EQ(image.primary().name, "L");
        EXPECT_EQ(image.primary().values, expected);
    }
}

TEST(TiffFile, SplitsSamplesOfAPixelIntoPlanes) {
    const RadianceImage image = readTiff(
        writtenFile(ownFolder() / "two.tif", HandMade()
                                                 .size(2, 1, 16, 1)
                                                 .entry(277, 3, 2)
                                                 .data(std::vector<std::uint16_t>{1, 10, 2, 20})
                                                 .bytes()));
    ASSERT_EQ(image.channels.size(), 2U);
    EXPECT_EQ(image.channels[0].values, (std::vector<float>{1.0F, 2.0F}));
    EXPECT_EQ(image.channels[1].values, (std::vector<float>{10.0F, 20.0F}));
}

struct Bad {
    const char* name;
    std::string bytes;
    const char* word;
};
void PrintTo(const Bad& bad, std::ostream* out) {
    *out << bad.name;
}
class BadTiffFiles : public testing::TestWithParam<Bad> {};

TEST_P(BadTiffFiles, AreRefusedByName) {
    const auto file = writtenFile(ownFolder() / "bad.tif", GetParam().bytes);
    const std::string message = inputErrorOf([&] { readImageFile(file); });
    EXPECT_THAT(message, HasSubstr("bad.tif"));
    EXPECT_THAT(message, HasSubstr(GetParam().word));
}

const std::vector<float> six = {1, 2, 3, 4, 5, 6};
INSTANTIATE_TEST_SUITE_P(
    OfTiff, BadTiffFiles,
    testing::Values(
        Bad{"header", std::string("II*\0", 4), "TIFF"},
        Bad{"colours", HandMade().size(3, 2, 8, 1).data(six).bytes(2), "colours"},
        Bad{"complex", HandMade().size(3, 2, 64, 6).data(six).bytes(), "format 6"},
        Bad{"half", HandMade().size(3, 2, 16, 3).data(six).bytes(), "16-bit"},
        Bad{"cut", HandMade().size(3, 2, 32, 3).data(std::vector<float>{1}).bytes(), "page 1"},
        Bad{"boast", HandMade().size(30000, 30000, 32, 3).data(six).bytes(), "holds what it"},
        Bad{"huge", HandMade().size(40000, 1, 32, 3).data(six).bytes(), "40000"}),
    [](const auto& row) { return row.param.name; });

TEST(TiffFile, ACutOrDamagedFileIsRefusedOrReadWhole) {
    const auto whole = ownFolder() / "whole.tif";
    writeTiff(imageWithEverything(40, 130), whole);
    const std::string bytes = readFile(whole);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 60) {
        EXPECT_THROW(readTiff(writtenFile(ownFolder() / "cut.tif", bytes.substr(0, length))),
                     InputError)
            << length;
    }
    // Any one byte may change what is said, but never brings the program down.
    for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 400) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        try {
            readTiff(writtenFile(ownFolder() / "damaged.tif", damaged));
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("damaged.tif"));
        }
    }
}

TEST(TiffFile, AnIndependentReaderFindsPagesFloatsAndNames) {
    const auto file = ownFolder() / "image.tif", said = ownFolder() / "said.txt";
    writeTiff(imageWithEverything(20, 10), file);
    ASSERT_EQ(
        std::system(("tiffinfo '" + file.string() + "' > '" + said.string() + "' 2>&1").c_str()),
        0);
    const std::string text = readFile(said);
    EXPECT_THAT(text, HasSubstr("IEEE floating point"));
    EXPECT_THAT(text, HasSubstr("Image Width: 20 Image Length: 10"));
    EXPECT_THAT(text, HasSubstr("PageName: range_m"));
}

} // namespace
} // namespace irsg
