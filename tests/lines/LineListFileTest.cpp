#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <zlib.h>

#include "irsg/core/Errors.h"
#include "tests/support/SharedMaterial.h"
#include "tests/support/TemporaryFolder.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::lbl {
namespace {

// Made-up lines in the columns of Rothman et al. 2005.
const std::string first =
    " 21  667.661000 3.000E-19 1.523E+00.07890.099  100.25000.74-.000510       0 1 1 01";
const std::string second = " 2A  640.500000 1.250E-25 1.523E+00.06500.000   -1.00000.690.001000";

std::filesystem::path fileOf(const std::string& text, const std::string& name = "lines.par") {
    return smat::test::writtenFile(smat::test::ownFolder() / name, text);
}

TEST(LineListFile, ReadsTheColumnsInOrderOfWavenumber) {
    const LineList list = readLineList(Gas::CO2, fileOf(first + "\r\n\n" + second));
    ASSERT_EQ(list.lines.size(), 2u);
    const Line& strong = list.lines[1];
    EXPECT_EQ(strong.wavenumber_per_cm, 667.661);
    EXPECT_EQ(strong.intensity, 3e-19);
    EXPECT_EQ(strong.lowerEnergy_per_cm, 100.25);
    EXPECT_FLOAT_EQ(strong.airWidth_cm_atm, 0.0789f);
    EXPECT_FLOAT_EQ(strong.selfWidth_cm_atm, 0.099f);
    EXPECT_FLOAT_EQ(strong.widthExponent, 0.74f);
    EXPECT_FLOAT_EQ(strong.airShift_cm_atm, -0.00051f);
    EXPECT_EQ(strong.isotopologue, 1);
    // An unknown self width is that in air, an unknown energy nothing.
    const Line& weak = list.lines[0];
    EXPECT_EQ(weak.wavenumber_per_cm, 640.5);
    EXPECT_EQ(weak.isotopologue, 11);
    EXPECT_EQ(weak.lowerEnergy_per_cm, 0.0);
    EXPECT_FLOAT_EQ(weak.selfWidth_cm_atm, 0.065f);
}

TEST(LineListFile, ReadsWhatGzipCompressed) {
    const std::filesystem::path file = smat::test::ownFolder() / "compressed.par.gz";
    const gzFile out = gzopen(file.c_str(), "wb");
    std::string text;
    for (int i = 0; i < 20000; ++i) {
        text += first + "\n";
    }
    ASSERT_EQ(gzwrite(out, text.data(), static_cast<unsigned>(text.size())),
              static_cast<int>(text.size()));
    gzclose(out);
    EXPECT_EQ(readLineList(Gas::CO2, file).lines.size(), 20000u);

    // What stops in the middle is refused, be it at the end of a record or without one left.
    std::ifstream in(file, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), {});
    for (const std::size_t size : {bytes.size() - 1, bytes.size() - 8, bytes.size() / 2,
                                   bytes.size() / 5, std::size_t{30}}) {
        try {
            (void)readLineList(Gas::CO2, fileOf(bytes.substr(0, size), "cut.par.gz"));
            ADD_FAILURE() << size;
        } catch (const InputError& error) {
            EXPECT_EQ(error.diagnostics().front().value, "damaged compression") << size;
        }
    }
}

TEST(LineListFile, NamesTheLineThatIsNoRecord) {
    struct Case {
        const char* name;
        std::string text;
        const char* position;
    };
    auto with = [](std::size_t at, const std::string& text) {
        std::string record = first;
        return first + "\n" + record.replace(at, text.size(), text);
    };
    const Case cases[] = {
        {"another gas", with(0, " 1"), "line 2"},
        {"no isotopologue", with(2, "?"), "line 2"},
        {"wavenumber", with(3, " 667.66x000"), "line 2"},
        {"negative wavenumber", with(3, "-667.661000"), "line 2"},
        {"negative intensity", with(15, "-3.000E-19"), "line 2"},
        {"not a number", with(45, "       nan"), "line 2"},
        {"width", with(35, "*****"), "line 2"},
        {"exponent", with(55, "    "), "line 2"},
        {"cut short", first + "\n" + first.substr(0, 60), "line 2"},
        {"empty", "", ""},
        {"text", "<html>\n", "line 1"},
    };
    for (const Case& bad : cases) {
        try {
            (void)readLineList(Gas::CO2, fileOf(bad.text));
            ADD_FAILURE() << bad.name;
        } catch (const InputError& error) {
            EXPECT_EQ(error.diagnostics().front().position, bad.position) << bad.name;
        }
    }
    EXPECT_THROW((void)readLineList(Gas::CO2, "no/such/file.par"), InputError);
}

TEST(LineListFile, ReadsTheSharedLists) {
    const auto file = smat::test::sharedMaterial("data/atmosphere/lines/CO.par.gz");
    if (file.empty()) {
        GTEST_SKIP() << "the line lists of the shared material are not here";
    }
    const LineList list = readLineList(Gas::CO, file);
    EXPECT_EQ(list.lines.size(), 4606u);
    // R(7) of the fundamental band, one of its strongest lines.
    const auto strongest = std::ranges::max_element(list.lines, {}, &Line::intensity);
    EXPECT_NEAR(strongest->wavenumber_per_cm, 2172.7588, 1e-9);
    EXPECT_NEAR(strongest->intensity, 4.461e-19, 1e-28);
}

} // namespace
} // namespace irsg::lbl
