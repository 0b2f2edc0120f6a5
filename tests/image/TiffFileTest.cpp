#include "irsg/image/TiffFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tiffio.h>

#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
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
    HandMade& entry(std::uint16_t tag, std::uint16_t type, std::uint32_t value,
                    std::size_t count = 1) {
        entries_.push_back({tag, type, static_cast<std::uint32_t>(count), value});
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
    /// `at` is where it stands in the file, `next` where the next page begins.
    std::string page(std::uint32_t at, bool hasNext, std::uint16_t photometric = 1) {
        std::string made = bytes(photometric, at, hasNext).substr(8);
        made.resize((made.size() + 1) & ~std::size_t{1});
        return made;
    }
    std::string bytes(std::uint16_t photometric = 1, std::uint32_t at = 8, bool hasNext = false) {
        entry(259, 3, 1).entry(262, 3, photometric).entry(278, 4, 1U << 20);
        entry(273, 4, 0).entry(279, 4, static_cast<std::uint32_t>(pixels_.size()));
        std::ranges::sort(entries_, {}, [](const auto& one) { return one[0]; });
        const auto start = static_cast<std::uint32_t>(at + 2 + 12 * entries_.size() + 4);
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
        const auto end = static_cast<std::uint32_t>(start + pixels_.size());
        put(out, hasNext ? (end + 1) & ~1U : 0, 4);
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

TEST(TiffFile, ReadsStoredValuesThatStandForNoneAsNaN) {
    /// ASCII of up to four bytes stands in the entry itself.
    const auto read = [](std::uint16_t tag, const std::string& text, std::uint16_t type = 2) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * i);
        }
        return readTiff(
            writtenFile(ownFolder() / "gdal.tif", HandMade()
                                                      .size(2, 2, 16, 2)
                                                      .entry(tag, type, value, text.size() + 1)
                                                      .data(std::vector<std::int16_t>{-9, 9, 7, -9})
                                                      .bytes()));
    };
    constexpr std::uint16_t noData = 42113, byteType = 1;
    {
        const CollectedRemarks remarks;
        const std::vector<float> values = read(noData, "-9").primary().values;
        EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[3]));
        EXPECT_EQ(values[1], 9.0F);
        EXPECT_EQ(values[2], 7.0F);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                    HasSubstr("page 1: 2 values are GDAL_NODATA and are read as NaN"));
    }
    const CollectedRemarks remarks;
    EXPECT_EQ(read(noData, "nan").primary().values[0], -9.0F);
    EXPECT_EQ(read(noData, "-8").primary().values[0], -9.0F);
    EXPECT_EQ(read(noData, "-9", byteType).primary().values[0], -9.0F) << "no text";
    EXPECT_TRUE(remarks.sentences().empty());
    EXPECT_EQ(read(noData, "x").primary().values[0], -9.0F);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("'x' is no number"));
}

/// A page of two pixels of two samples, 1 10 and 2 20, with the text of this tag behind it.
std::filesystem::path gdalFile(const std::string& metadata, const std::string& missing = "") {
    const auto made = [&](std::uint32_t place) {
        HandMade page;
        page.size(2, 1, 16, 1).entry(277, 3, 2);
        page.entry(42112, 2, place, metadata.size() + 1);
        if (!missing.empty()) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < missing.size(); ++i) {
                value |= static_cast<std::uint32_t>(static_cast<unsigned char>(missing[i]))
                         << (8 * i);
            }
            page.entry(42113, 2, value, missing.size() + 1);
        }
        return page.data(std::vector<std::uint16_t>{1, 10, 2, 20}).bytes();
    };
    const auto place = static_cast<std::uint32_t>(made(0).size());
    return writtenFile(ownFolder() / "gdal.tif", made(place) + metadata + std::string(1, '\0'));
}
std::string gdalItem(const std::string& role, const std::string& sample, const std::string& text) {
    return "<Item name=\"X\" sample=\"" + sample + "\" role=\"" + role + "\">" + text + "</Item>";
}
std::string gdalMetadata(const std::string& items) {
    return "<GDALMetadata>\n<Item name=\"AREA\">some words &amp; more</Item>\n" + items +
           "</GDALMetadata>\n";
}

TEST(TiffFile, AppliesScaleOffsetAndUnitOfGdalToEachSample) {
    const CollectedRemarks remarks;
    const RadianceImage image = readTiff(
        gdalFile(gdalMetadata(gdalItem("scale", "0", "0.5") + gdalItem("offset", "0", "273.25") +
                              gdalItem("unittype", "0", "K") + gdalItem("offset", "1", "-1e1"))));
    ASSERT_EQ(image.channels.size(), 2U);
    EXPECT_EQ(image.channels[0].values, (std::vector<float>{273.75F, 274.25F}));
    EXPECT_EQ(image.channels[0].unit, "K");
    EXPECT_EQ(image.channels[1].values, (std::vector<float>{0.0F, 10.0F}));
    EXPECT_EQ(image.channels[1].unit, "");
    const std::string told = testing::PrintToString(remarks.sentences());
    EXPECT_THAT(told, HasSubstr("page 1, sample 1: scale 0.5 and offset 273.25"));
    EXPECT_THAT(told, HasSubstr("page 1, sample 2: scale 1 and offset -10"));
    EXPECT_THAT(told, HasSubstr("sample 1: the unit K"));
    // The value that stands for none is a stored one, not one that the scale makes.
    const RadianceImage holed = readTiff(gdalFile(gdalMetadata(gdalItem("scale", "0", "2")), "2"));
    EXPECT_EQ(holed.channels[0].values[0], 2.0F);
    EXPECT_TRUE(std::isnan(holed.channels[0].values[1]));
    EXPECT_EQ(holed.channels[1].values, (std::vector<float>{10.0F, 20.0F}));
}

TEST(TiffFile, LeavesOutWhatGdalStatesInVainWithARemark) {
    const struct {
        const char* name;
        std::string metadata;
        const char* told; ///< "" for nothing
    } rows[] = {
        {"no number", gdalMetadata(gdalItem("scale", "0", "half")), "the scale 'half'"},
        {"nothing", gdalMetadata(gdalItem("offset", "0", "")), "the offset ''"},
        {"infinite", gdalMetadata(gdalItem("offset", "1", "inf")), "the offset 'inf'"},
        {"a scale of 0", gdalMetadata(gdalItem("scale", "0", "0")), "the scale '0'"},
        {"a third sample", gdalMetadata(gdalItem("scale", "2", "3")), "sample '2'"},
        {"a negative sample", gdalMetadata(gdalItem("scale", "-1", "3")), "sample '-1'"},
        {"damaged", "<GDALMetadata><Item role=\"scale\" sample=\"0\">2", "no sound XML"},
        {"of the whole file", gdalMetadata("<Item name=\"s\" role=\"scale\">3</Item>"),
         "sample ''"},
        {"other words", gdalMetadata(gdalItem("description", "0", "2")), ""},
        {"another root", "<Other>" + gdalItem("scale", "0", "3") + "</Other>", ""},
        {"scale 1", gdalMetadata(gdalItem("scale", "0", "1") + gdalItem("offset", "0", "0")), ""}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const CollectedRemarks remarks;
        const RadianceImage image = readTiff(gdalFile(row.metadata));
        EXPECT_EQ(image.channels[0].values, (std::vector<float>{1.0F, 2.0F}));
        EXPECT_EQ(image.channels[1].values, (std::vector<float>{10.0F, 20.0F}));
        if (*row.told == '\0') {
            EXPECT_TRUE(remarks.sentences().empty());
        } else {
            EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr(row.told));
        }
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

const std::filesystem::path strangers =
    std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers/multipage-tiff";

TEST(TiffFile, ReadsAPageByItsNumberAndSaysWhatItLeavesOut) {
    const RadianceImage one = readTiff(strangers / "one.tif");
    const CollectedRemarks remarks;
    const RadianceImage both = readTiff(strangers / "two.tif");
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("holds 2 pages"));
    ASSERT_EQ(both.channels.size(), 2U);
    EXPECT_EQ(both.channels[1].name, "page2");
    EXPECT_EQ(both.attributes.at("description"), "{\"shape\": [2, 4, 6]}");
    const CollectedRemarks none;
    for (const int page : {1, 2}) {
        const RadianceImage image = readImageFile(strangers / "two.tif", {.page = page});
        ASSERT_EQ(image.channels.size(), 1U);
        EXPECT_EQ(image.primary().name, "L");
        EXPECT_EQ(image.primary().values, both.channels[static_cast<std::size_t>(page) - 1].values);
    }
    EXPECT_TRUE(none.sentences().empty());
    EXPECT_EQ(imageParts(strangers / "two.tif").size(), 2U);
    EXPECT_THAT(inputErrorOf([] { readTiff(strangers / "two.tif", {.page = 3}); }),
                HasSubstr("no page 3, expected a page from 1 to 2"));
    EXPECT_THAT(inputErrorOf([] { readImageFile(strangers / "two.tif", {.part = "2"}); }),
                HasSubstr("part 2: found a file without parts"));
}

TEST(TiffFile, LeavesOutCopiesAndOtherSizesWithARemark) {
    const std::vector<float> whole = {1, 2, 3, 4}, small = {9};
    const std::pair<HandMade, const char*> second[] = {
        {HandMade().size(1, 1, 32, 3).data(small), "page 2 (1 x 1 pixels)"},
        {HandMade().size(2, 2, 32, 3).entry(254, 4, 1).data(whole), "page 2 (a reduced copy)"},
        {HandMade().size(2, 2, 32, 3).entry(254, 4, 4).data(whole), "page 2 (a mask)"}};
    for (auto [made, says] : second) {
        SCOPED_TRACE(says);
        std::string bytes = HandMade().size(2, 2, 32, 3).data(whole).bytes(1, 8, true);
        bytes.resize((bytes.size() + 1) & ~std::size_t{1});
        bytes += made.page(static_cast<std::uint32_t>(bytes.size()), false);
        const CollectedRemarks remarks;
        const RadianceImage image = readTiff(writtenFile(ownFolder() / "pages.tif", bytes));
        EXPECT_EQ(image.channels.size(), 1U);
        EXPECT_EQ(image.primary().values, whole);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr(says));
    }
}

TEST(TiffFile, ReadsTheFirstPageBehindCopiesAndMasks) {
    const std::vector<float> whole = {1, 2, 3, 4}, small = {9};
    const auto read = [&](int kind, int last) {
        std::string bytes =
            HandMade().size(1, 1, 32, 3).entry(254, 4, kind).data(small).bytes(1, 8, true);
        bytes.resize((bytes.size() + 1) & ~std::size_t{1});
        bytes += HandMade()
                     .size(2, 2, 32, 3)
                     .entry(254, 4, last)
                     .data(whole)
                     .page(static_cast<std::uint32_t>(bytes.size()), false);
        return readTiff(writtenFile(ownFolder() / "pages.tif", bytes));
    };
    for (const int kind : {1, 4}) {
        const CollectedRemarks remarks;
        const RadianceImage image = read(kind, 0);
        EXPECT_EQ(image.channels.size(), 1U);
        EXPECT_EQ(image.primary().values, whole);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                    HasSubstr(kind == 1 ? "leaves out page 1 (a reduced copy)"
                                        : "leaves out page 1 (a mask)"));
    }
    // Where there are copies alone, the first is read.
    EXPECT_EQ(read(1, 1).primary().values, small);
}

TEST(TiffFile, LeavesOutPagesThatHoldNoValuesWithARemark) {
    const std::vector<float> whole = {1, 2, 3, 4};
    const std::vector<std::uint8_t> bytes(24, 7);
    const struct {
        HandMade made;
        std::uint16_t photometric;
        const char* says;
    } others[] = {
        {HandMade().size(2, 2, 8, 1).entry(277, 3, 3).data(bytes), 2, "(colours (photometric"},
        {HandMade().size(2, 2, 1, 1).data(bytes), 1, "(1-bit samples of format 1)"},
        {HandMade().size(2, 2, 64, 6).data(bytes), 1, "(64-bit samples of format 6)"},
        {HandMade().size(2, 2, 8, 1).data(bytes), 0, "(colours (photometric"}};
    for (const auto& other : others) {
        for (const bool isFirst : {true, false}) {
            SCOPED_TRACE(std::string(other.says) + (isFirst ? " first" : " last"));
            HandMade one = other.made, two = HandMade().size(2, 2, 32, 3).data(whole);
            if (!isFirst) {
                std::swap(one, two);
            }
            std::string file = one.bytes(isFirst ? other.photometric : 1, 8, true);
            file.resize((file.size() + 1) & ~std::size_t{1});
            file += two.page(static_cast<std::uint32_t>(file.size()), false,
                             isFirst ? 1 : other.photometric);
            const CollectedRemarks remarks;
            const auto place = writtenFile(ownFolder() / "pages.tif", file);
            const RadianceImage image = readTiff(place);
            EXPECT_EQ(image.channels.size(), 1U);
            EXPECT_EQ(image.primary().values, whole);
            EXPECT_THAT(
                testing::PrintToString(remarks.sentences()),
                HasSubstr(std::string("leaves out page ") + (isFirst ? "1 " : "2 ") + other.says));
            // Asked for by its number it is refused.
            EXPECT_THAT(inputErrorOf([&] { readTiff(place, {.page = isFirst ? 1 : 2}); }),
                        HasSubstr(isFirst ? "page 1" : "page 2"));
        }
    }
    // A whole number of other bits beside floats is a plane.
    std::string both = HandMade().size(2, 2, 32, 3).data(whole).bytes(1, 8, true);
    both.resize((both.size() + 1) & ~std::size_t{1});
    both += HandMade()
                .size(2, 2, 8, 1)
                .data(bytes)
                .page(static_cast<std::uint32_t>(both.size()), false);
    EXPECT_EQ(readTiff(writtenFile(ownFolder() / "pages.tif", both)).channels.size(), 2U);
}

TEST(TiffFile, FollowsTheOrientation) {
    const std::vector<float> stored = {1, 2, 3, 4, 5, 6};
    const std::pair<std::uint32_t, std::vector<float>> rows[] = {{1, {1, 2, 3, 4, 5, 6}},
                                                                 {2, {3, 2, 1, 6, 5, 4}},
                                                                 {3, {6, 5, 4, 3, 2, 1}},
                                                                 {4, {4, 5, 6, 1, 2, 3}}};
    for (const auto& [orientation, seen] : rows) {
        const auto file = writtenFile(
            ownFolder() / "turned.tif",
            HandMade().size(3, 2, 32, 3).entry(274, 3, orientation).data(stored).bytes());
        EXPECT_EQ(readTiff(file).primary().values, seen) << orientation;
    }
    const auto file =
        writtenFile(ownFolder() / "turned.tif",
                    HandMade().size(3, 2, 32, 3).entry(274, 3, 6).data(stored).bytes());
    EXPECT_THAT(inputErrorOf([&] { readTiff(file); }), HasSubstr("orientation 6"));
}

TEST(TiffFile, ReadsColoursOfFloatsAsPlanes) {
    const auto file =
        writtenFile(ownFolder() / "rgb.tif", HandMade()
                                                 .size(2, 1, 32, 3)
                                                 .entry(277, 3, 3)
                                                 .data(std::vector<float>{1, 2, 3, 4, 5, 6})
                                                 .bytes(2));
    const RadianceImage image = readTiff(file);
    ASSERT_EQ(image.channels.size(), 3U);
    EXPECT_EQ(image.find("R")->values, (std::vector<float>{1, 4}));
    EXPECT_EQ(image.find("B")->values, (std::vector<float>{3, 6}));
}

TEST(TiffFile, ReadsEveryByteOrder) {
    const std::vector<float> values = {1.5F, -2.0F};
    for (const char* mode : {"wl", "wb", "wl8", "wb8"}) {
        const auto file = ownFolder() / "order.tif";
        TIFF* const tiff = TIFFOpen(file.c_str(), mode);
        ASSERT_NE(tiff, nullptr);
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
        TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 1);
        std::vector<float> row = values;
        TIFFWriteScanline(tiff, row.data(), 0, 0);
        TIFFClose(tiff);
        EXPECT_EQ(readTiff(file).primary().values, values) << mode;
    }
}

TEST(TiffFile, SaysWhatWasCompressedWithLossOrStandsWithinAPage) {
    const auto file = ownFolder() / "said.tif";
    for (const bool isLossy : {true, false}) {
        TIFF* const tiff = TIFFOpen(file.c_str(), "w");
        ASSERT_NE(tiff, nullptr);
        toff_t offsets[1] = {0};
        if (!isLossy) {
            TIFFSetField(tiff, TIFFTAG_SUBIFD, 1, offsets);
        }
        for (int page = 0; page < (isLossy ? 1 : 2); ++page) {
            TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 16);
            TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 16);
            TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
            TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
            TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
            TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 16);
            TIFFSetField(tiff, TIFFTAG_COMPRESSION, isLossy ? COMPRESSION_JPEG : COMPRESSION_NONE);
            std::vector<unsigned char> values(256, 7);
            TIFFWriteEncodedStrip(tiff, 0, values.data(), 256);
            TIFFWriteDirectory(tiff);
        }
        TIFFClose(tiff);
        const CollectedRemarks remarks;
        EXPECT_EQ(readTiff(file).channels.size(), 1U);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                    HasSubstr(isLossy ? "with loss (JPEG)" : "within the page are left out"));
    }
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
        Bad{"oddFloat", HandMade().size(3, 2, 24, 3).data(six).bytes(), "24-bit"},
        Bad{"whiteIsZero", HandMade().size(3, 2, 32, 3).data(six).bytes(0), "colours"},
        Bad{"inks", HandMade().size(3, 2, 8, 1).data(six).bytes(5), "colours"},
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
