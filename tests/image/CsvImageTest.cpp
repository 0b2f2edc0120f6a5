#include "irsg/image/CsvImage.h"

#include <cmath>

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
using testing::StartsWith;

RadianceImage readText(const test::TemporaryFolder& folder, const std::string& text) {
    writeFileDurably(folder / "m.csv", text);
    return readCsvImage(folder / "m.csv");
}

TEST(CsvImage, ReturnsEveryFloatBitForBitAtEverySize) {
    const test::TemporaryFolder folder;
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 17}, {17, 1}, {2, 2}, {61, 67}, {640, 33}}) {
        SCOPED_TRACE(testing::Message() << width << " x " << height);
        const RadianceImage image = patternImage(width, height);
        writeCsvImage(image, folder / "a.csv");
        const RadianceImage back = readCsvImage(folder / "a.csv");
        EXPECT_EQ(back.width(), width);
        EXPECT_EQ(back.height(), height);
        EXPECT_EQ(bitsOf(back.primary().values), bitsOf(image.primary().values));
    }
}

TEST(CsvImage, WritesTheTopRowFirstWithNineDigits) {
    const test::TemporaryFolder folder;
    RadianceImage image(2, 2);
    image.primary().values = {1.0F / 3.0F, test::nanValue, -test::infinity, 16777216.0F};
    image.attributes["band"] = "3-5 um";
    writeCsvImage(image, folder / "a.csv");
    EXPECT_EQ(readFile(folder / "a.csv"), "# channel: L\n"
                                          "# unit: W m-2 sr-1\n"
                                          "# width: 2\n"
                                          "# height: 2\n"
                                          "# band: 3-5 um\n"
                                          "0.333333343,nan\n"
                                          "-inf,16777216\n");
}

TEST(CsvImage, KeepsNameUnitAndEveryAttribute) {
    const test::TemporaryFolder folder;
    RadianceImage image(2, 1, "T_apparent", "K");
    image.attributes = {{"band", "3-5 um"},     {"empty", ""},           {"blanks", "  two  "},
                        {"lines", "a\nb\r\\n"}, {"with: colon", "x:y"},  {"unit", "ours"},
                        {"width", "ours"},      {"attribute.x", "ours"}, {"µ", "·"}};
    writeCsvImage(image, folder / "a.csv");
    EXPECT_EQ(readCsvImage(folder / "a.csv"), image);
}

TEST(CsvImage, ReadsOurFilesAsSpreadsheetsSaveThem) {
    const test::TemporaryFolder folder;
    const RadianceImage image =
        readText(folder, "# channel: T,,\n\"# unit: K\",,\n# width: 3,,\n# height: 2,,\n"
                         "\"# note: a, b\",,\n1,2,3\n4,5,6\n");
    EXPECT_EQ(image.primary().name, "T");
    EXPECT_EQ(image.primary().unit, "K");
    EXPECT_EQ(image.attributes.at("note"), "a, b");
    EXPECT_EQ(image.width(), 3);
}

TEST(CsvImage, WritesTheChannelThatIsAskedFor) {
    const test::TemporaryFolder folder;
    RadianceImage image(1, 1);
    image.channel("range", "m").values = {7.0F};
    writeCsvImage(image, folder / "a.csv", "range");
    const RadianceImage back = readCsvImage(folder / "a.csv");
    EXPECT_EQ(back.primary(), *image.find("range"));
    EXPECT_THROW(writeCsvImage(image, folder / "a.csv", "alpha"), LogicError);
    EXPECT_THROW(writeCsvImage(RadianceImage(), folder / "a.csv"), LogicError);
}

TEST(CsvImage, ReadsPlainMatricesAsOtherProgramsWriteThem) {
    const test::TemporaryFolder folder;
    const struct {
        const char* name;
        std::string text;
    } rows[] = {
        {"commas", "1,2,3\n4,5,6\n"},
        {"no line break at the end", "1,2,3\n4,5,6"},
        {"separator at the end of a row", "1,2,3,\n4,5,6,\n"},
        {"blanks around", " 1 , 2 ,3 \n\t4, 5,\t6\n"},
        {"semicolons", "1;2;3\n4;5;6\n"},
        {"tabs", "1\t2\t3\n4\t5\t6\n"},
        {"blanks alone", "  1.0   2.0   3.0\n  4.0   5.0   6.0\n"},
        {"carriage returns and line feeds", "1,2,3\r\n4,5,6\r\n"},
        {"carriage returns alone", "1,2,3\r4,5,6\r"},
        {"blank lines", "\n1,2,3\n\n  \n4,5,6\n\n"},
        {"byte order mark", "\xEF\xBB\xBF"
                            "1,2,3\n4,5,6\n"},
        {"exponents and signs", "+1e0,2E+0,30e-1\n4.,.5e1,+6\n"},
        {"comments without a colon", "# written by hand\n1,2,3\n4,5,6\n"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const RadianceImage image = readText(folder, row.text);
        EXPECT_EQ(image.width(), 3);
        EXPECT_EQ(image.height(), 2);
        EXPECT_EQ(image.primary().values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(image.primary().name, "L");
        EXPECT_EQ(image.primary().unit, "");
        EXPECT_TRUE(image.attributes.empty());
    }
}

TEST(CsvImage, ReadsTheSameNumbersFromEveryFormOfStrangers) {
    const std::filesystem::path strangers =
        std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers";
    const RadianceImage plain = readCsvImage(strangers / "image-forms/plain.csv");
    EXPECT_EQ(plain.width(), 4);
    EXPECT_EQ(plain.at(3, 2), 40.25F);
    for (const char* name : {"camera-head-lines.csv", "envi.hdr", "envi.img", "fortran-d.txt",
                             "grid.asc", "grid.pfm", "matrix.npy", "quoted.csv"}) {
        EXPECT_EQ(readImageFile(strangers / "image-forms" / name).primary().values,
                  plain.primary().values)
            << name;
    }
    const RadianceImage english = readCsvImage(strangers / "matrix-decimal-comma/english.csv");
    EXPECT_EQ(english.at(2, 1), 40.25F);
    for (const char* name : {"german.csv", "tabs.txt"}) {
        EXPECT_EQ(readImageFile(strangers / "matrix-decimal-comma" / name), english) << name;
    }
}

TEST(CsvImage, LeavesOutHeadLinesOfCamerasButNoNamesOfColumns) {
    const test::TemporaryFolder folder;
    const struct {
        const char* name;
        std::string text;
        bool isRead;
    } rows[] = {
        {"keys and a blank line", "File;x\nFrame;1\n\n1;2;3\n4;5;6\n", true},
        {"keys alone", "File;x\nFrame;1\n1;2;3\n4;5;6\n", true},
        {"one word", "Temperature\n1;2;3\n4;5;6\n", true},
        {"names of columns", "a;b;c\n1;2;3\n4;5;6\n", false},
        {"names of columns and a blank line", "a;b;c\n\n1;2;3\n4;5;6\n", false},
        {"a row of numbers that is wrong", "1;2;3x\n4;5;6\n7;8;9\n", false},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const CollectedRemarks remarks;
        const std::string message = inputErrorOf([&] {
            EXPECT_EQ(readText(folder, row.text).primary().values,
                      (std::vector<float>{1, 2, 3, 4, 5, 6}));
            EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr("head lines"));
        });
        EXPECT_EQ(message.empty(), row.isRead) << message;
    }
}

TEST(CsvImage, ReadsNotANumberAndInfinityInAnyCase) {
    const test::TemporaryFolder folder;
    const RadianceImage image = readText(folder, "NaN,nan,-Inf,INF,infinity\n");
    EXPECT_TRUE(std::isnan(image.at(0, 0)));
    EXPECT_TRUE(std::isnan(image.at(1, 0)));
    EXPECT_EQ(image.at(2, 0), -test::infinity);
    EXPECT_EQ(image.at(3, 0), test::infinity);
    EXPECT_EQ(image.at(4, 0), test::infinity);
}

TEST(CsvImage, TakesWhatIsTooSmallForFloatAsZero) {
    const test::TemporaryFolder folder;
    const std::string dot0 = "0." + std::string(400, '0') + "1";
    EXPECT_EQ(bitsOf(readText(folder, "1e-60,-1e-60,1e-400," + dot0).primary().values),
              (std::vector<std::uint32_t>{0U, 0x80000000U, 0U, 0U}));
}

TEST(CsvImage, RefusesBadTextWithItsPlace) {
    const test::TemporaryFolder folder;
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"empty file", "", "found no number"},
        {"comments alone", "# band: x\n", "found no number"},
        {"short row", "1,2,3\n4,5\n", "line 2: found 2 values, expected 3 values"},
        {"long row", "1,2\n# c\n\n3,4,5\n", "line 4: found 3 values, expected 2 values"},
        {"word", "1,2\n3,four\n", "line 2, column 2: found four, expected a number"},
        {"trailing letters", "1,2x\n", "line 1, column 2: found 2x"},
        {"empty field", "1,,3\n", "line 1, column 2: found an empty field"},
        {"leading comma", ",1\n", "line 1, column 1: found an empty field"},
        {"two decimal signs", "1,5;2,5\n1,5;2.5\n",
         "line 2, column 2: found 2.5, expected a number, "
         "with a decimal comma"},
        {"two ways", "1,5, 2,5\n3,5, 4,5\n", "line 1: found '1,5, 2,5', which can be read in two"},
        {"hexadecimal", "0x10\n", "line 1, column 1: found 0x10"},
        {"two signs", "+-1\n", "line 1, column 1: found +-1"},
        {"beyond float", "1,1e39\n", "within the range of 32-bit float"},
        {"beyond float without exponent", "1" + std::string(60, '0') + "\n",
         "within the range of 32-bit float"},
        {"beyond double", "1e999\n", "within the range of 32-bit float"},
        {"width denied", "# width: 3\n1,2\n", "width: found 2, expected 3, as the header says"},
        {"height denied", "# height: 1\n1\n2\n", "height: found 2, expected 1"},
        {"NUL byte", std::string("1,\0", 3), "byte 2: found a NUL byte"},
        {"a table of results", "# command: x\nrange [m],radiance image\n1,2\n",
         "line 2: found a table of results (columns range [m],radiance image), expected an image"},
        {"quoted names", "\"range\";\"L\"\n1;2\n", "line 1: found a table of results"},
        {"a letter", "Dear reader,\n1,2\n", "line 1: found text that is no image (Dear reader,)"},
        {"JSON", "{\"columns\": 3}\n", "line 1: found text that is no image ({"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const std::string message = inputErrorOf([&] { readText(folder, row.text); });
        EXPECT_THAT(message, StartsWith((folder / "m.csv").string()));
        EXPECT_THAT(message, HasSubstr(row.says));
    }
}

TEST(CsvImage, CollectsDiagnosticsButNotWithoutEnd) {
    const test::TemporaryFolder folder;
    writeFileDurably(folder / "m.csv", "1,2\na,b\n3\n");
    try {
        readCsvImage(folder / "m.csv");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 3U);
    }
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text += "1x,y\n";
    }
    writeFileDurably(folder / "m.csv", text);
    try {
        readCsvImage(folder / "m.csv");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 20U);
    }
}

TEST(CsvImage, ATableOfResultsIsRefusedInOneSentence) {
    const test::TemporaryFolder folder;
    std::string text = "step [m],L [W m-2 sr-1]\n";
    for (int i = 0; i < 100; ++i) {
        text += "1,two\n";
    }
    writeFileDurably(folder / "m.csv", text);
    try {
        readCsvImage(folder / "m.csv");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 1U);
    }
}

TEST(CsvImage, IsToldByItsFirstRowOrItsHeader) {
    const std::pair<const char*, bool> rows[] = {
        {"1,2\n", true},
        {"\xEF\xBB\xBF\n\n -1e3;2\n", true},
        {"nan,2\n", true},
        {"inf nan\n", true},
        {"# by hand\r\n1 2 3", true},
        {"# channel: L\n# width: 1\n# height: 1\nx\n", true},
        {"range [m],L\n1,2\n", false},
        {"# channel: L\nrange,L\n1,2\n", false},
        {"nano,2\n", false},
        {"{\"a\": 1}\n", false},
        {"# alone\n", false},
        {"", false}};
    for (const auto& [text, isImage] : rows) {
        EXPECT_EQ(beginsAsCsvImage(text), isImage) << text;
    }
}

TEST(CsvImage, RefusesMissingFilesAndFoldersThatCannotBeWritten) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(inputErrorOf([&] { readCsvImage(folder / "none.csv"); }), HasSubstr("none.csv"));
    EXPECT_THAT(inputErrorOf([&] { writeCsvImage(RadianceImage(1, 1), folder / "no/a.csv"); }),
                HasSubstr("no/a.csv"));
}

} // namespace
} // namespace irsg
