#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

std::filesystem::path written(const std::string& name, const std::string& text) {
    return smat::test::writtenFile(smat::test::ownFolder() / name, text);
}

} // namespace

TEST(AtmosphereFile, EveryKindIsRecognised) {
    const std::string table =
        TabulatedAtmosphere(parseTape7(TextLines::parse(tape7({}), "run")), "my air").toText();
    const struct {
        const char* file;
        std::string text;
        const char* name;
    } rows[] = {
        {"haze.csv", "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n",
         "Beer-Lambert (haze.csv)"},
        {"spectra.csv",
         "# analysis: radiative\n# sensor_altitude [m]: 0\n# target_altitude [m]: 0\n# range [m]: "
         "9\nwavelength [um],transmittance\n3,1\n5,1\n",
         "spectra of spectra.csv"},
        {"tape7", tape7({}), "tabulated (tape7)"},
        {"run.fl7", tape7({}), "tabulated (run.fl7)"},
        {"tape7.scn", "\n" + tape7({}), "tabulated (tape7.scn)"},
        {"modtran.csv", "# ITYPE: 1\n# IEMSCT: 0\n# RANGE: 1\nfreq,tot_trans\n2000,0.5\n2010,0.5\n",
         "tabulated (modtran.csv)"},
        {"air.smatatm", table, "my air"},
        {"air.json", table, "my air"},
    };
    for (const auto& row : rows) {
        const auto air = loadAtmosphere(written(row.file, row.text));
        EXPECT_EQ(air->name(), row.name);
        EXPECT_TRUE(air->supports(AtmosphereProperty::transmittance)) << row.file;
    }
}

TEST(AtmosphereFile, WhatIsNoAtmosphereIsRefusedByName) {
    const struct {
        const char* file;
        const char* text;
        const char* says;
    } rows[] = {
        {"letter.txt", "Dear reader,\n", "letter.txt: found no atmosphere"},
        {"empty.txt", "", "empty.txt: found no atmosphere"},
        {"other.json", "{\"a\": 1}", "other.json: found no atmosphere"},
        {"bad.smatatm", "{\"a\": 1}", "bad.smatatm: format"},
        {"words.csv", "a,b\n1,2\n", "words.csv"},
    };
    for (const auto& row : rows) {
        try {
            loadAtmosphere(written(row.file, row.text));
            ADD_FAILURE() << row.file << " was not refused";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(row.says)) << row.file;
        }
    }
    EXPECT_THROW(loadAtmosphere("no/such/file"), InputError);
    EXPECT_THROW(loadAtmosphere(smat::test::ownFolder()), InputError);
}
