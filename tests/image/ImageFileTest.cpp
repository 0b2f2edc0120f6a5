#include "irsg/image/ImageFile.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageComparison.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using smat::test::ownFolder;
using smat::test::writtenFile;
using test::inputErrorOf;
using testing::HasSubstr;

const std::vector<float> values = {1.0F, 2.5F, 3.0F, 4.0F, 5.0F, 6.0F};

/// A foreign 3 x 2 EXR with one channel.
std::filesystem::path foreignExr(const std::string& channel, Imf::PixelType type, int left = 0,
                                 int top = 0) {
    const std::filesystem::path file = ownFolder() / "foreign.exr";
    Imf::Header header(Imath::Box2i({0, 0}, {99, 99}),
                       Imath::Box2i({left, top}, {left + 2, top + 1}));
    header.channels().insert(channel, Imf::Channel(type));
    std::vector<half> halves(values.begin(), values.end());
    std::vector<unsigned> integers(values.begin(), values.end());
    std::vector<float> floats = values;
    const auto slice = [&](auto& pixels) {
        return Imf::Slice::Make(type, pixels.data(), header.dataWindow());
    };
    Imf::FrameBuffer buffer;
    buffer.insert(channel, type == Imf::HALF   ? slice(halves)
                           : type == Imf::UINT ? slice(integers)
                                               : slice(floats));
    Imf::OutputFile output(file.string().c_str(), header);
    output.setFrameBuffer(buffer);
    output.writePixels(2);
    return file;
}

TEST(ImageFile, ReadsAnySingleChannelOfAnyTypeFromAnyDataWindow) {
    for (const auto& [type, name] :
         {std::pair(Imf::HALF, "Y"), {Imf::FLOAT, "radiance.mid wave"}, {Imf::UINT, "id"}}) {
        for (const int offset : {0, 17, -5}) {
            const RadianceImage image = readImageFile(foreignExr(name, type, offset, -offset));
            ASSERT_EQ(image.width(), 3);
            ASSERT_EQ(image.height(), 2);
            std::vector<float> expected = values;
            if (type == Imf::UINT) {
                expected[1] = 2.0F;
            }
            EXPECT_EQ(chosenPlane(image, "", "it").values, expected) << name << " " << offset;
        }
    }
}

struct Matrix {
    const char* name;
    const char* text;
};
void PrintTo(const Matrix& row, std::ostream* out) {
    *out << row.name;
}
class Matrices : public testing::TestWithParam<Matrix> {};

TEST_P(Matrices, AreReadTopRowFirstWhateverSeparatesTheirNumbers) {
    const RadianceImage image = readImageFile(writtenFile(ownFolder() / "m.txt", GetParam().text));
    ASSERT_EQ(image.width(), 3);
    ASSERT_EQ(image.height(), 2);
    EXPECT_EQ(image.primary().values, values);
}

INSTANTIATE_TEST_SUITE_P(Plain, Matrices,
                         testing::Values(Matrix{"comma", "1,2.5,3\n4,5,6\n"},
                                         Matrix{"semicolon", "1;2.5;3\r\n4;5;6\r\n"},
                                         Matrix{"space", "1 2.5 3\n4 5 6"},
                                         Matrix{"tab", "1\t2.5\t3\n4\t5\t6\n"},
                                         Matrix{"trailing", "1,2.5,3,\n4,5,6,\n\n"},
                                         Matrix{"exponents", "1e0, 25e-1, 3.0\n4, 5, 6E+00\n"}),
                         [](const auto& row) { return row.param.name; });

struct Bad {
    const char* name;
    std::string content;
    std::vector<std::string> words;
};
void PrintTo(const Bad& row, std::ostream* out) {
    *out << row.name;
}
class BadFiles : public testing::TestWithParam<Bad> {};

TEST_P(BadFiles, AreRefusedWithTheirNameAndWhatIsWrong) {
    const auto file = writtenFile(ownFolder() / "bad.csv", GetParam().content);
    const std::string message = inputErrorOf([&] { readImageFile(file); });
    EXPECT_THAT(message, HasSubstr("bad.csv"));
    for (const std::string& word : GetParam().words) {
        EXPECT_THAT(message, HasSubstr(word));
    }
}

INSTANTIATE_TEST_SUITE_P(
    OfImages, BadFiles,
    testing::Values(Bad{"png", "\x89PNG\r\n\x1a\n0000", {"PNG", "OpenEXR image"}},
                    Bad{"matlab",
                        "MATLAB 5.0 MAT-file" + std::string(9, '\0'),
                        {"found a MATLAB file", "OpenEXR image"}},
                    Bad{"netcdf4",
                        "\x89HDF\r\n\x1a\n" + std::string(4, '\0'),
                        {"found a netCDF or HDF5 file", "OpenEXR image"}},
                    Bad{"netcdf3", std::string("CDF\1\0\0", 6), {"found a netCDF file"}},
                    Bad{"jpeg", "\xFF\xD8\xFF\xE0 JFIF", {"JPEG"}}, Bad{"empty", "", {"no number"}},
                    Bad{"word", "1,2\n3,hot\n", {"line 2", "hot"}},
                    Bad{"ragged", "1,2\n3\n", {"line 2"}},
                    Bad{"damagedExr", std::string("\x76\x2f\x31\x01rest", 8), {"OpenEXR"}}),
    [](const auto& row) { return row.param.name; });

TEST(ImageFile, AMissingFileIsNamed) {
    EXPECT_THAT(inputErrorOf([] { readImageFile("/nowhere/at all.exr"); }),
                HasSubstr("/nowhere/at all.exr"));
}

TEST(ImageFile, ChoosesLAmongMany) {
    RadianceImage image(1, 1, "E");
    image.channel("L");
    EXPECT_EQ(chosenPlane(image, "", "it").name, "L");
    EXPECT_EQ(chosenPlane(image, "E", "it").name, "E");
}

TEST(ImageFile, OurCsvAndExrOfOneImageAreEqualPixelByPixel) {
    RadianceImage image(5, 4);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        image.primary().values[i] = 1.0F / static_cast<float>(i + 3);
    }
    image.channel("range_m", "m");
    writeExr(image, ownFolder() / "i.exr");
    writeCsvImage(image, ownFolder() / "i.csv");
    ComparisonOptions exact;
    exact.fail.absolute = exact.warn.absolute = 0.0;
    EXPECT_EQ(compareImages(readImageFile(ownFolder() / "i.exr"),
                            readImageFile(ownFolder() / "i.csv"), exact)
                  .verdict,
              Verdict::pass);
}

} // namespace
} // namespace irsg
