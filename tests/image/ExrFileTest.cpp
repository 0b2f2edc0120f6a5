#include "irsg/image/ExrFile.h"

#include <fstream>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>
#include <gmock/gmock.h>

#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Remarks.h"
#include "irsg/image/ImageFile.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::bitsOf;
using test::inputErrorOf;
using test::patternImage;
using testing::HasSubstr;

TEST(ExrFile, ReturnsEveryFloatBitForBitAtEverySize) {
    const test::TemporaryFolder folder;
    const std::pair<int, int> sizes[] = {{1, 1}, {1, 17}, {17, 1}, {2, 2}, {61, 67}, {640, 33}};
    for (const auto& [width, height] : sizes) {
        SCOPED_TRACE(testing::Message() << width << " x " << height);
        const RadianceImage image = patternImage(width, height);
        writeExr(image, folder / "a.exr");
        const RadianceImage back = readExr(folder / "a.exr");
        EXPECT_EQ(back.width(), width);
        EXPECT_EQ(back.height(), height);
        EXPECT_EQ(bitsOf(back.primary().values), bitsOf(image.primary().values));
        EXPECT_EQ(back.primary().name, "L");
        EXPECT_EQ(back.primary().unit, "W m-2 sr-1");
    }
}

TEST(ExrFile, KeepsThePayloadOfNaN) {
    const test::TemporaryFolder folder;
    RadianceImage image(2, 1);
    image.primary().values = {std::bit_cast<float>(0x7fc12345U), std::bit_cast<float>(0xffc00001U)};
    writeExr(image, folder / "a.exr");
    EXPECT_EQ(bitsOf(readExr(folder / "a.exr").primary().values), bitsOf(image.primary().values));
}

TEST(ExrFile, KeepsChannelsInTheirOrderWithTheirUnits) {
    const test::TemporaryFolder folder;
    RadianceImage image(3, 2, "range", "m");
    image.channel("temperature_index").values[1] = 4.0F;
    image.channel("L", "W m-2 sr-1").values[5] = 1e6F;
    image.channel("alpha").values[0] = -1.0F;
    writeExr(image, folder / "a.exr");
    EXPECT_EQ(readExr(folder / "a.exr"), image);
}

TEST(ExrFile, KeepsEveryAttributeUnderItsName) {
    const test::TemporaryFolder folder;
    RadianceImage image(1, 1);
    image.attributes = {{"band", "3-5 um"},
                        {"empty", ""},
                        {"lines", "one\ntwo: #three"},
                        {"µm · °", "ε"},
                        {"compression", "ours"},
                        {"dataWindow", "ours"},
                        {"type", "ours"},
                        {"channelOrder", "ours"},
                        {"unit.L", "ours"},
                        {"attribute.x", "ours"},
                        {std::string(180, 'n'), std::string(5000, 'v')}};
    writeExr(image, folder / "a.exr");
    EXPECT_EQ(readExr(folder / "a.exr"), image);
}

// An image of 2 x 2 pixels as another program writes it: 1 and 2 in the top row, 3 and 4 below.
struct ForeignChannel {
    const char* name;
    Imf::PixelType type;
};

void writeForeign(const std::filesystem::path& file, const std::vector<ForeignChannel>& channels,
                  int originX = 0, int originY = 0, int sampling = 1) {
    const Imath::Box2i window({originX, originY}, {originX + 1, originY + 1});
    Imf::Header header(Imath::Box2i({0, 0}, {639, 479}), window);
    header.insert("exposure", Imf::FloatAttribute(0.25F));
    header.insert("frame", Imf::IntAttribute(7));
    const float floats[] = {1, 2, 3, 4};
    const half halves[] = {1, 2, 3, 4};
    const unsigned integers[] = {1, 2, 3, 4};
    Imf::FrameBuffer frame;
    for (const ForeignChannel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(channel.type, sampling, sampling));
        const void* data = channel.type == Imf::HALF   ? static_cast<const void*>(halves)
                           : channel.type == Imf::UINT ? static_cast<const void*>(integers)
                                                       : static_cast<const void*>(floats);
        frame.insert(channel.name,
                     Imf::Slice::Make(channel.type, data, window, 0, 0, sampling, sampling));
    }
    Imf::OutputFile output(file.c_str(), header);
    output.setFrameBuffer(frame);
    output.writePixels(2);
}

TEST(ExrFile, ReadsSingleChannelsOfOtherPrograms) {
    const test::TemporaryFolder folder;
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
        writeForeign(folder / "f.exr", {{"Y", type}});
        const RadianceImage image = readExr(folder / "f.exr");
        EXPECT_EQ(image.primary().name, "Y");
        EXPECT_EQ(image.primary().unit, "");
        EXPECT_EQ(image.primary().values, (std::vector<float>{1, 2, 3, 4}));
        EXPECT_EQ(image.attributes.at("exposure"), "0.25");
        EXPECT_EQ(image.attributes.at("frame"), "7");
    }
}

TEST(ExrFile, TakesThePixelsOfTheDataWindowWhereverItLies) {
    const test::TemporaryFolder folder;
    for (const auto& [x, y] : {std::pair{100, 37}, std::pair{-5, -9}}) {
        writeForeign(folder / "f.exr", {{"Y", Imf::FLOAT}}, x, y);
        const RadianceImage image = readExr(folder / "f.exr");
        EXPECT_EQ(image.width(), 2);
        EXPECT_EQ(image.primary().values, (std::vector<float>{1, 2, 3, 4}));
    }
}

TEST(ExrFile, ShowsRadianceFirstThenLuminanceThenTheFirstName) {
    const test::TemporaryFolder folder;
    writeForeign(folder / "f.exr", {{"A", Imf::HALF}, {"L", Imf::HALF}, {"Y", Imf::HALF}});
    EXPECT_EQ(readExr(folder / "f.exr").primary().name, "L");
    writeForeign(folder / "f.exr", {{"A", Imf::HALF}, {"Y", Imf::HALF}});
    EXPECT_EQ(readExr(folder / "f.exr").primary().name, "Y");
    writeForeign(folder / "f.exr", {{"R", Imf::HALF}, {"G", Imf::HALF}, {"B", Imf::HALF}});
    EXPECT_EQ(readExr(folder / "f.exr").primary().name, "B");
}

TEST(ExrFile, ReadsTiles) {
    const test::TemporaryFolder folder;
    Imf::Header header(2, 2);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(1, 1));
    float values[] = {1, 2, 3, 4};
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values), 4, 8));
    {
        Imf::TiledOutputFile output((folder / "t.exr").c_str(), header);
        output.setFrameBuffer(frame);
        output.writeTiles(0, 1, 0, 1);
    }
    EXPECT_EQ(readExr(folder / "t.exr").primary().values, (std::vector<float>{1, 2, 3, 4}));
}

const std::filesystem::path strangers =
    std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers";

TEST(ExrFile, ReadsThePartWithRadianceAndSaysWhatItLeavesOut) {
    const RadianceImage alone = readExr(strangers / "multipart-exr/radiance.exr");
    for (const char* name : {"depth-first.exr", "radiance-first.exr"}) {
        const CollectedRemarks remarks;
        const RadianceImage image = readExr(strangers / "multipart-exr" / name);
        EXPECT_EQ(image.primary().values, alone.primary().values) << name;
        EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("holds 2 parts"));
    }
    const auto file = strangers / "multipart-exr/depth-first.exr";
    const std::vector<ImagePart> parts = imageParts(file);
    ASSERT_EQ(parts.size(), 2U);
    const CollectedRemarks remarks;
    EXPECT_EQ(readImageFile(file, parts[1].reading).primary().values, alone.primary().values);
    EXPECT_NE(readExr(file, {.part = "1"}).primary().values, alone.primary().values);
    EXPECT_TRUE(remarks.sentences().empty());
    EXPECT_THAT(inputErrorOf([&] { readExr(file, {.part = "3"}); }),
                HasSubstr("no part '3', expected one of its parts: 1 "));
    EXPECT_THAT(inputErrorOf([&] { readImageFile(file, {.page = 2}); }), HasSubstr("page 2"));
    EXPECT_TRUE(imageParts(strangers / "multipart-exr/radiance.exr").empty());
}

/// A part of four pixels, in tiles or lines, or of deep data.
struct PartMade {
    const char* name;
    const char* channel;
    std::string type;
    float first;
};

void writeParts(const std::filesystem::path& file, const std::vector<PartMade>& parts) {
    std::vector<Imf::Header> headers;
    for (const PartMade& part : parts) {
        Imf::Header header(2, 2);
        header.setName(part.name);
        header.setType(part.type);
        header.channels().insert(part.channel, Imf::Channel(Imf::FLOAT));
        header.compression() = Imf::ZIPS_COMPRESSION;
        if (part.type == Imf::TILEDIMAGE) {
            header.setTileDescription(Imf::TileDescription(1, 1, Imf::MIPMAP_LEVELS));
        }
        headers.push_back(header);
    }
    Imf::MultiPartOutputFile output(file.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const float first = parts[i].first;
        float values[] = {first, first + 1, first + 2, first + 3};
        const auto number = static_cast<int>(i);
        if (parts[i].type == Imf::DEEPSCANLINE) {
            unsigned counts[] = {1, 1, 1, 1};
            float* pointers[] = {values, values + 1, values + 2, values + 3};
            Imf::DeepFrameBuffer frame;
            frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts),
                                                    sizeof counts[0], 2 * sizeof counts[0]));
            frame.insert(parts[i].channel,
                         Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers),
                                        sizeof pointers[0], 2 * sizeof pointers[0], sizeof(float)));
            Imf::DeepScanLineOutputPart part(output, number);
            part.setFrameBuffer(frame);
            part.writePixels(2);
            continue;
        }
        Imf::FrameBuffer frame;
        frame.insert(parts[i].channel,
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values), 4, 8));
        if (parts[i].type == Imf::TILEDIMAGE) {
            Imf::TiledOutputPart part(output, number);
            for (int level = 0; level < part.numLevels(); ++level) {
                part.setFrameBuffer(frame);
                part.writeTiles(0, part.numXTiles(level) - 1, 0, part.numYTiles(level) - 1, level);
            }
        } else {
            Imf::OutputPart part(output, number);
            part.setFrameBuffer(frame);
            part.writePixels(2);
        }
    }
}

TEST(ExrFile, ReadsTiledPartsBesideDeepOnes) {
    const test::TemporaryFolder folder;
    const PartMade deep{"samples", "L", Imf::DEEPSCANLINE, 10.0F};
    const PartMade tiled{"radiance", "L", Imf::TILEDIMAGE, 20.0F};
    const PartMade lines{"depth", "Z", Imf::SCANLINEIMAGE, 30.0F};
    const std::vector<float> radiance = {20, 21, 22, 23}, depth = {30, 31, 32, 33};
    const auto file = folder / "parts.exr";
    for (const std::vector<PartMade>& parts :
         {std::vector{deep, tiled, lines}, {lines, deep, tiled}, {tiled, lines, deep}}) {
        writeParts(file, parts);
        const CollectedRemarks remarks;
        EXPECT_EQ(readExr(file).primary().values, radiance) << parts[0].name;
        EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("deep data"));
        EXPECT_EQ(readExr(file, {.part = "radiance"}).primary().values, radiance);
        EXPECT_EQ(readExr(file, {.part = "depth"}).primary().values, depth);
        EXPECT_THAT(inputErrorOf([&] { readExr(file, {.part = "samples"}); }),
                    HasSubstr("found deep data"));
        EXPECT_EQ(imageParts(file).size(), 3U);
    }
    writeParts(file, {deep, {"more", "Z", Imf::DEEPSCANLINE, 1.0F}});
    EXPECT_THAT(inputErrorOf([&] { readExr(file); }), HasSubstr("part 1: found deep data"));
}

TEST(ExrFile, StoresItsFirstPlaneAsOtherProgramsShowIt) {
    const test::TemporaryFolder folder;
    RadianceImage image(2, 1, "L", "W m-2 sr-1");
    image.primary().values = {0.25F, 0.75F};
    image.channel("range", "m").values = {7.0F, 8.0F};
    writeExr(image, folder / "a.exr");
    {
        const Imf::InputFile stored((folder / "a.exr").c_str());
        EXPECT_NE(stored.header().channels().findChannel("Y"), nullptr);
        EXPECT_EQ(stored.header().channels().findChannel("L"), nullptr);
    }
    EXPECT_EQ(readExr(folder / "a.exr"), image);
    // Names of colours stay.
    RadianceImage colours(2, 1, "R");
    colours.channel("G");
    writeExr(colours, folder / "b.exr");
    EXPECT_EQ(readExr(folder / "b.exr"), colours);
}

TEST(ExrFile, ReadsEveryCompression) {
    const test::TemporaryFolder folder;
    for (int kind = 0; kind < Imf::NUM_COMPRESSION_METHODS; ++kind) {
        Imf::Header header(64, 40);
        header.compression() = static_cast<Imf::Compression>(kind);
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        std::vector<float> values(64U * 40U, 0.5F);
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 256));
        {
            Imf::OutputFile output((folder / "c.exr").c_str(), header);
            output.setFrameBuffer(frame);
            output.writePixels(40);
        }
        const RadianceImage image = readExr(folder / "c.exr");
        EXPECT_NEAR(image.at(63, 39), 0.5F, 1e-3F) << kind;
    }
}

TEST(ExrFile, ReadsEveryLineOrder) {
    const test::TemporaryFolder folder;
    for (const Imf::LineOrder order : {Imf::INCREASING_Y, Imf::DECREASING_Y}) {
        Imf::Header header(1, 3);
        header.lineOrder() = order;
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
        std::vector<float> values = {1, 2, 3};
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 4));
        {
            Imf::OutputFile output((folder / "o.exr").c_str(), header);
            output.setFrameBuffer(frame);
            output.writePixels(3);
        }
        EXPECT_EQ(readExr(folder / "o.exr").primary().values, values);
    }
}

TEST(ExrFile, KeepsLayersAndViewsAsPlanes) {
    const test::TemporaryFolder folder;
    writeForeign(folder / "f.exr", {{"left.Y", Imf::HALF}, {"right.Y", Imf::HALF}});
    const RadianceImage image = readExr(folder / "f.exr");
    EXPECT_NE(image.find("left.Y"), nullptr);
    EXPECT_NE(image.find("right.Y"), nullptr);
}

TEST(ExrFile, SaysThatPixelsAreNotSquare) {
    const test::TemporaryFolder folder;
    Imf::Header header(1, 1, 2.0F);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    float value = 1.0F;
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&value), 4, 4));
    {
        Imf::OutputFile output((folder / "a.exr").c_str(), header);
        output.setFrameBuffer(frame);
        output.writePixels(1);
    }
    const CollectedRemarks remarks;
    readExr(folder / "a.exr");
    EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("2 times as wide as high"));
}

TEST(ExrFile, RefusesDeepParts) {
    const test::TemporaryFolder folder;
    Imf::Header header(1, 1);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    unsigned count = 1;
    float value = 1.0F;
    float* pointer = &value;
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(
        Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count), sizeof count, sizeof count));
    frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&pointer), sizeof pointer,
                                     sizeof pointer, sizeof value));
    {
        Imf::DeepScanLineOutputFile output((folder / "d.exr").c_str(), header);
        output.setFrameBuffer(frame);
        output.writePixels(1);
    }
    EXPECT_THAT(inputErrorOf([&] { readExr(folder / "d.exr"); }), HasSubstr("found deep data"));
}

TEST(ExrFile, RefusesWhatIsNoImageWithItsName) {
    const test::TemporaryFolder folder;
    writeFileDurably(folder / "text.exr", "this is no picture\n");
    writeFileDurably(folder / "empty.exr", "");
    writeFileDurably(folder / "signature.exr", "\x76\x2f\x31\x01");
    writeFileDurably(folder / "noise.exr", "\x76\x2f\x31\x01\x02" + std::string(400, '\x5a'));
    writeForeign(folder / "subsampled.exr", {{"Y", Imf::FLOAT}}, 0, 0, 2);

    const struct {
        const char* file;
        const char* says;
    } rows[] = {
        {"missing.exr", "no such file"},
        {"", "a folder"},
        {"text.exr", "byte 0: found no OpenEXR signature"},
        {"empty.exr", "an empty file"},
        {"signature.exr", "expected an OpenEXR image"},
        {"noise.exr", "expected an OpenEXR image"},
        {"subsampled.exr", "channel Y: found a sample every 2 x 2 pixels"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.file);
        const std::string message = inputErrorOf([&] { readExr(folder / row.file); });
        EXPECT_THAT(message, HasSubstr((folder / row.file).string()));
        EXPECT_THAT(message, HasSubstr(row.says));
    }
}

TEST(ExrFile, RefusesAFileCutAtAnyByte) {
    const test::TemporaryFolder folder;
    RadianceImage image = patternImage(40, 40);
    image.attributes["band"] = "3-5 um";
    writeExr(image, folder / "whole.exr");
    const std::string bytes = readFile(folder / "whole.exr");
    for (std::size_t size = 0; size < bytes.size(); size += size < 700 ? 1 : 97) {
        writeFileDurably(folder / "cut.exr", std::string_view(bytes).substr(0, size));
        EXPECT_THAT(inputErrorOf([&] { readExr(folder / "cut.exr"); }), HasSubstr("cut.exr"))
            << size << " of " << bytes.size() << " bytes";
    }
}

TEST(ExrFile, TakesNoMemoryForLengthsThatTheFileOnlyClaims) {
    const test::TemporaryFolder folder;
    RadianceImage image = patternImage(20, 20);
    image.attributes["band"] = "3-5 um";
    writeExr(image, folder / "whole.exr");
    const std::string whole = readFile(folder / "whole.exr");
    const struct {
        const char* name;
        std::string before; ///< the number that is written over follows
        std::string number; ///< little endian
        const char* says;
    } rows[] = {
        {"text", std::string("band\0string\0", 12), std::string("\0\0\0\x70", 4),
         "found an attribute of 1879048192 bytes"},
        {"negative", std::string("band\0string\0", 12), "\xff\xff\xff\xff",
         "found an attribute of 4294967295 bytes"},
        {"list of texts", std::string("channelOrder\0stringvector\0\x05\0\0\0", 30),
         std::string("\0\0\0\x70", 4), "found a text of 1879048192 bytes"},
        {"channels", std::string("channels\0chlist\0", 16), std::string("\x10\0\0\0", 4),
         "list of channels"},
        {"compression", std::string("compression\0compression\0", 24), std::string("\x02\0\0\0", 4),
         "found a compression of 2 bytes"},
        {"rows", std::string("dataWindow\0box2i\0\x10\0\0\0\0\0\0\0\0\0\0\0\x13\0\0\0", 33),
         "\xff\xff\xff\x7f", "found 20 x 2147483648 pixels"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        std::string bytes = whole;
        const auto at = bytes.find(row.before);
        ASSERT_NE(at, bytes.npos);
        bytes.replace(at + row.before.size(), 4, row.number);
        writeFileDurably(folder / "bad.exr", bytes);
        const std::string message = inputErrorOf([&] { readExr(folder / "bad.exr"); });
        EXPECT_THAT(message, HasSubstr("bad.exr: byte "));
        EXPECT_THAT(message, HasSubstr(row.says));
    }
}

TEST(ExrFile, NeverCrashesOnADamagedByte) {
    const test::TemporaryFolder folder;
    writeExr(patternImage(20, 20), folder / "whole.exr");
    const std::string whole = readFile(folder / "whole.exr");
    int refused = 0;
    for (std::size_t i = 4; i < whole.size(); i += 3) {
        std::string bytes = whole;
        bytes[i] = static_cast<char>(bytes[i] ^ 0xff);
        writeFileDurably(folder / "bad.exr", bytes);
        refused += inputErrorOf([&] { readExr(folder / "bad.exr"); }).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 0);
}

TEST(ExrFile, SaysTheRowWhereDataAreDamaged) {
    const test::TemporaryFolder folder;
    RadianceImage image(64, 64);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        image.primary().values[i] = std::bit_cast<float>(
            static_cast<std::uint32_t>(0x3f800000U + (i * 2654435761U) % 8388607U));
    }
    writeExr(image, folder / "a.exr");
    std::string bytes = readFile(folder / "a.exr");
    ASSERT_GT(bytes.size(), 8000U);
    std::fill(bytes.end() - 2000, bytes.end(), '\x01');
    writeFileDurably(folder / "a.exr", bytes);
    EXPECT_THAT(inputErrorOf([&] { readExr(folder / "a.exr"); }), HasSubstr("row 48"));
}

TEST(ExrFile, RefusesToWriteWhereItCannot) {
    const test::TemporaryFolder folder;
    const std::string message =
        inputErrorOf([&] { writeExr(RadianceImage(1, 1), folder / "none/a.exr"); });
    EXPECT_THAT(message, HasSubstr("none/a.exr"));
    EXPECT_THAT(message, HasSubstr("a folder that does not exist"));
}

TEST(ExrFile, RefusesImagesThatAreBrokenInThemselves) {
    const test::TemporaryFolder folder;
    const auto file = folder / "a.exr";
    EXPECT_THROW(writeExr(RadianceImage(), file), LogicError);
    RadianceImage small(2, 2);
    small.primary().values.resize(3);
    EXPECT_THROW(writeExr(small, file), LogicError);
    RadianceImage twice(1, 1);
    twice.channels.push_back(twice.channels.front());
    EXPECT_THROW(writeExr(twice, file), LogicError);
    RadianceImage nameless(1, 1, "");
    EXPECT_THROW(writeExr(nameless, file), LogicError);
    EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace
} // namespace irsg
