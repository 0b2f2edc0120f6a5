#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Remarks.h"
#include "irsg/image/EnviFile.h"
#include "irsg/image/ImageComparison.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/PlainImages.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using smat::test::ownFolder;
using smat::test::writtenFile;
using test::inputErrorOf;
using testing::HasSubstr;

/// Numbers as a file stores them.
template <typename Number>
std::string bytesOf(const std::vector<double>& values, bool isBigEndian = false) {
    std::string bytes;
    for (const double value : values) {
        const auto number = static_cast<Number>(value);
        char one[sizeof(Number)];
        std::memcpy(one, &number, sizeof number);
        if (isBigEndian) {
            std::reverse(one, one + sizeof number);
        }
        bytes.append(one, sizeof number);
    }
    return bytes;
}

std::string envi(const std::string& more) {
    return "ENVI\nsamples = 2\nlines = 1\nbands = 2\n" + more;
}

TEST(ForeignImages, EnviBandsAreReadInEveryOrderTypeAndInterleave) {
    const auto header = ownFolder() / "a.hdr", data = ownFolder() / "a.raw";
    // Band 1 is 1, 2 and band 2 is 3, 4.
    const std::pair<const char*, std::vector<double>> orders[] = {
        {"bsq", {1, 2, 3, 4}}, {"bil", {1, 2, 3, 4}}, {"BIP", {1, 3, 2, 4}}};
    for (const auto& [interleave, values] : orders) {
        for (const bool isBig : {false, true}) {
            const std::pair<int, std::string> types[] = {
                {1, bytesOf<std::uint8_t>(values)},
                {2, bytesOf<std::int16_t>(values, isBig)},
                {3, bytesOf<std::int32_t>(values, isBig)},
                {4, bytesOf<float>(values, isBig)},
                {5, bytesOf<double>(values, isBig)},
                {12, bytesOf<std::uint16_t>(values, isBig)},
                {13, bytesOf<std::uint32_t>(values, isBig)},
                {14, bytesOf<std::int64_t>(values, isBig)},
                {15, bytesOf<std::uint64_t>(values, isBig)}};
            for (const auto& [type, bytes] : types) {
                writtenFile(header,
                            envi("header offset = 3\nband names = {\n mid,\n long}\n"
                                 "interleave = " +
                                 std::string(interleave) + "\nbyte order = " + (isBig ? "1" : "0") +
                                 "\ndata type = " + std::to_string(type) + "\n"));
                writtenFile(data, "xyz" + bytes);
                for (const auto& asked : {header, data}) {
                    const RadianceImage image = readImageFile(asked);
                    ASSERT_EQ(image.channels.size(), 2U);
                    EXPECT_EQ(image.find("mid")->values, (std::vector<float>{1, 2})) << type;
                    EXPECT_EQ(image.find("long")->values, (std::vector<float>{3, 4})) << type;
                }
            }
        }
    }
}

TEST(ForeignImages, EnviFilesFindEachOtherWhateverTheCaseOfTheirNames) {
    const std::string header = envi("interleave = bsq\ndata type = 1\n"), data = "\1\2\3\4";
    for (const auto& [headerName, dataName] :
         {std::pair("A.HDR", "A.IMG"), std::pair("a.HDR", "a.img"), std::pair("A.hdr", "a.Raw"),
          std::pair("a.dat.HDR", "a.dat")}) {
        const test::TemporaryFolder folder;
        const auto headerFile = writtenFile(folder / headerName, header);
        const auto dataFile = writtenFile(folder / dataName, data);
        for (const auto& asked : {headerFile, dataFile}) {
            EXPECT_EQ(readImageFile(asked).channels.back().values, (std::vector<float>{3, 4}))
                << asked;
        }
    }
}

TEST(ForeignImages, EnviHeadersThatDoNotFitAreRefused) {
    const auto header = ownFolder() / "a.hdr", data = ownFolder() / "a.img";
    const std::pair<std::string, const char*> rows[] = {
        {"ENVI\nsamples = 2\n", "no lines, expected a whole number"},
        {envi(""), "no data type"},
        {envi("data type = 6\n"), "line 5: found data type = 6, expected 1 to 5"},
        {envi("data type = 4\ninterleave = tiled\n"), "bsq, bil or bip"},
        {envi("data type = 5\n"), "found 16 bytes, expected 32 bytes"},
        {"ENVI\nsamples = -2\nlines = 1\n", "samples = -2"}};
    writtenFile(data, std::string(16, '\0'));
    for (const auto& [text, says] : rows) {
        writtenFile(header, text);
        EXPECT_THAT(inputErrorOf([&] { readImageFile(header); }), HasSubstr(says));
    }
    std::filesystem::remove(data);
    writtenFile(header, envi("data type = 4\n"));
    EXPECT_THAT(inputErrorOf([&] { readImageFile(header); }), HasSubstr("no data beside"));
}

TEST(ForeignImages, MissingValuesAreNaNWithARemark) {
    const CollectedRemarks remarks;
    writtenFile(ownFolder() / "a.hdr", envi("data type = 4\ndata ignore value = -1\n"));
    writtenFile(ownFolder() / "a", bytesOf<float>({-1, 2, 3, 4}));
    EXPECT_TRUE(std::isnan(readImageFile(ownFolder() / "a.hdr").channels[0].values[0]));
    const auto grid =
        writtenFile(ownFolder() / "g.asc", "NCOLS 2\nNROWS 1\nNODATA_value -9\n-9 2\n");
    const RadianceImage image = readImageFile(grid);
    EXPECT_TRUE(std::isnan(image.at(0, 0)));
    EXPECT_EQ(image.at(1, 0), 2.0F);
    const std::string all = testing::PrintToString(remarks.sentences());
    EXPECT_THAT(all, HasSubstr("1 values are the 'data ignore value'"));
    EXPECT_THAT(all, HasSubstr("1 values are NODATA_value"));
}

TEST(ForeignImages, EnviGainsAndOffsetsOfBandsApplyToStoredValues) {
    const CollectedRemarks remarks;
    const auto header = ownFolder() / "a.hdr";
    writtenFile(ownFolder() / "a", bytesOf<std::int16_t>({10, -1, 10, -3}));
    const auto read = [&](const std::string& lines) {
        writtenFile(header, envi("data type = 2\ninterleave = bsq\n" + lines));
        return readImageFile(header);
    };
    const std::string gains = "data gain values = {2.0,\n 0.5}\n";
    const RadianceImage both = read(gains + "data offset values = {1, -2}\n"
                                            "data ignore value = -1\n");
    EXPECT_EQ(both.channels[0].values[0], 21.0F);
    EXPECT_TRUE(std::isnan(both.channels[0].values[1])) << "stored values are compared";
    EXPECT_EQ(both.channels[1].values, (std::vector<float>{3.0F, -3.5F}));
    EXPECT_EQ(read(gains).channels[1].values, (std::vector<float>{5.0F, -1.5F}));
    EXPECT_EQ(read("data offset values = {1, -2}\n").channels[0].values,
              (std::vector<float>{11.0F, 0.0F}));
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("gain * stored value"));

    const std::pair<const char*, const char*> rows[] = {
        {"data gain values = {2.0}\n", "line 7: found data gain values = 2.0, expected 2 numbers, "
                                       "one for each band, not 1"},
        {"data offset values = {1,2,3}\n", "line 7: found data offset values = 1,2,3"},
        {"data gain values = {1,two}\n", "numbers between commas"},
        {"data gain values = {}\n", "not 0"}};
    for (const auto& [lines, says] : rows) {
        EXPECT_THAT(inputErrorOf([&, lines = lines] { read(lines); }), HasSubstr(says));
    }
}

TEST(ForeignImages, GridsMayGoOverLinesAndHaveDecimalCommas) {
    const auto read = [](const std::string& text) {
        return readImageFile(writtenFile(ownFolder() / "g.asc", text));
    };
    EXPECT_EQ(read("ncols 2\nnrows 2\nxllcorner 0,5\n1,5 2,5 3,5\n4,5\n").primary().values,
              (std::vector<float>{1.5F, 2.5F, 3.5F, 4.5F}));
    const std::pair<const char*, const char*> rows[] = {
        {"ncols 2\n1 2\n", "no nrows"},
        {"ncols 2\nnrows 1\n1 two\n", "line 3: found 'two'"},
        {"ncols 2\nnrows 1\n1\n", "found 1 values, expected 2"},
        {"ncols 2\nnrows 1\n1 2 3\n", "line 3: found more values"},
        {"ncols two\nnrows 1\n", "line 1: found 'two'"}};
    for (const auto& [text, says] : rows) {
        EXPECT_THAT(inputErrorOf([&, text = text] { read(text); }), HasSubstr(says));
    }
}

TEST(ForeignImages, FloatMapsAreReadInBothOrdersFromTheBottom) {
    const auto read = [](const std::string& bytes) {
        return readImageFile(writtenFile(ownFolder() / "a.pfm", bytes));
    };
    const std::vector<float> expected = {3, 4, 1, 2};
    EXPECT_EQ(read("Pf\n2 2\n-1.0\n" + bytesOf<float>({1, 2, 3, 4})).primary().values, expected);
    EXPECT_EQ(read("Pf 2 2 1\n" + bytesOf<float>({1, 2, 3, 4}, true)).primary().values, expected);
    const RadianceImage colours = read("PF\n1 1\n-1\n" + bytesOf<float>({1, 2, 3}));
    EXPECT_EQ(channelList(colours), "R, G, B");
    EXPECT_EQ(colours.find("B")->values[0], 3.0F);
    const CollectedRemarks remarks;
    EXPECT_EQ(read("Pf\n1 1\n-2.5\n" + bytesOf<float>({7})).at(0, 0), 7.0F);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("its scale of 2.5"));
    for (const std::string& bad :
         {std::string("Pf\n2 2\n0\n0000000000000000"), "Pf\n2 2\n-1\n" + bytesOf<float>({1}),
          std::string("Pf\nx 2\n-1\n0000")}) {
        EXPECT_NE(inputErrorOf([&] { read(bad); }), "");
    }
}

TEST(ForeignImages, ArraysOfNumpyAreReadInEveryOrder) {
    const auto npy = [](std::string dictionary, const std::string& data, char version = 1) {
        dictionary += '\n';
        std::string bytes = "\x93NUMPY";
        bytes += version;
        bytes += '\0';
        bytes += static_cast<char>(dictionary.size());
        bytes += '\0';
        if (version > 1) {
            bytes += std::string(2, '\0');
        }
        return writtenFile(ownFolder() / "a.npy", bytes + dictionary + data);
    };
    const auto head = [](const char* type, const char* shape, bool isFortran = false) {
        return std::string("{'descr': '") + type +
               "', 'fortran_order': " + (isFortran ? "True" : "False") + ", 'shape': " + shape +
               ", }";
    };
    const std::vector<float> expected = {1, 2, 3, 4, 5, 6};
    for (const auto& file : {npy(head("<f4", "(2, 3)"), bytesOf<float>({1, 2, 3, 4, 5, 6}))}) {
        EXPECT_EQ(readImageFile(file).primary().values, expected);
    }
    EXPECT_EQ(readImageFile(npy(head(">f8", "(2, 3)"), bytesOf<double>({1, 2, 3, 4, 5, 6}, true)))
                  .primary()
                  .values,
              expected);
    EXPECT_EQ(
        readImageFile(npy(head("|u1", "(2, 3)", true), bytesOf<std::uint8_t>({1, 4, 2, 5, 3, 6})))
            .primary()
            .values,
        expected);
    EXPECT_EQ(
        readImageFile(npy(head("<i2", "(1, 2, 3)"), bytesOf<std::int16_t>({1, 2, 3, 4, 5, 6}), 2))
            .primary()
            .values,
        expected);
    EXPECT_THAT(inputErrorOf([&] { readImageFile(npy(head("<c8", "(2, 3)"), "")); }),
                HasSubstr("found '<c8'"));
    EXPECT_THAT(inputErrorOf([&] { readImageFile(npy(head("<f4", "(2, 3, 2)"), "")); }),
                HasSubstr("two dimensions"));
    EXPECT_THAT(inputErrorOf([&] { readImageFile(npy(head("<f4", "(2, 3)"), "abc")); }),
                HasSubstr("as its header says"));
    EXPECT_NE(inputErrorOf([&] { readImageFile(writtenFile(ownFolder() / "a.npy", "\x93NUMPY")); }),
              "");
}

TEST(ForeignImages, APlaneOfColoursIsComparedWithTheUsualOneOfTheOtherImage) {
    RadianceImage radiance(2, 1, "L"), colours(2, 1, "R");
    radiance.primary().values = {1, 2};
    colours.primary().values = {1, 2};
    colours.channel("G").values = {5, 6};
    ComparisonOptions options;
    options.nameA = "a.exr";
    options.channel = "R";
    const CollectedRemarks remarks;
    EXPECT_EQ(compareImages(radiance, colours, options).verdict, Verdict::pass);
    EXPECT_THAT(testing::PrintToString(remarks.sentences()),
                HasSubstr("a.exr: has no channel 'R'; its 'L' is compared with it"));
    options.channel = "";
    EXPECT_NE(inputErrorOf([&] { compareImages(radiance, colours, options); }), "");
    options.channelB = "G";
    const Comparison comparison = compareImages(radiance, colours, options);
    EXPECT_EQ(comparison.channelA, "L");
    EXPECT_EQ(comparison.channelB, "G");
    options.channel = "X";
    options.channelB = "";
    EXPECT_THAT(inputErrorOf([&] { compareImages(radiance, colours, options); }),
                HasSubstr("no channel 'X'"));
}

} // namespace
} // namespace irsg
