#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/ParticleTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using Kind = ParticleTable::Kind;

ParticleTable readText(const std::string& text, Kind kind,
                       const std::vector<std::string>& columns) {
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "particles.csv", text);
    return ParticleTable::read(file, kind, columns);
}

const std::vector<std::string> opticsNames = {"a_ext", "a_abs", "a_asym"};

TEST(ParticleTable, ReadsTheColumnsItIsAskedFor) {
    const ParticleTable table = readText("# source: a test\nwavelength [um],b,a_asym,a_abs,a_ext\n"
                                         "0.2,9,0.7,0.1,1.5\n40,9,-0.2,0.3,0.5\n",
                                         Kind::optics, opticsNames);
    EXPECT_THAT(table.first(), testing::ElementsAre(0.2, 40.0));
    EXPECT_THAT(table.column("a_ext"), testing::ElementsAre(1.5, 0.5));
    EXPECT_THAT(table.column("a_asym"), testing::ElementsAre(0.7, -0.2));
    EXPECT_THROW(table.column("b"), LogicError);
}

TEST(ParticleTable, TheShippedTablesAreWhole) {
    for (const char* name : {"particles-humid.csv", "particles-dry.csv", "particles-desert.csv",
                             "particles-navy.csv"}) {
        EXPECT_NO_THROW(ParticleTable::read(atmosphereResource(name), Kind::logarithms, {}))
            << name;
    }
    for (const char* name : {"particles-profiles.csv", "particles-clouds.csv"}) {
        EXPECT_NO_THROW(ParticleTable::read(atmosphereResource(name), Kind::profile, {})) << name;
    }
}

struct Damage {
    const char* name;
    Kind kind;
    const char* text;
    const char* says; ///< part of the message
};

const std::vector<Damage> damages = {
    {"empty", Kind::optics, "", "no rows"},
    {"comments only", Kind::optics, "# nothing\n", "no rows"},
    {"a column missing", Kind::optics, "um,a_ext,a_abs\n0.2,1,0\n40,1,0\n", "no column a_asym"},
    {"header only", Kind::optics, "um,a_ext,a_abs,a_asym\n", "0.2 to 40 um"},
    {"one row", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0,0\n", "0.2 to 40 um"},
    {"too short a range", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0,0\n14,1,0,0\n",
     "0.2 to 40 um"},
    {"a short row", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0\n40,1,0,0\n", "line 2"},
    {"a long row", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0,0\n40,1,0,0,1\n", "line 3"},
    {"a word", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,none,0\n40,1,0,0\n", "none"},
    {"not a number", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,nan,0,0\n40,1,0,0\n", "nan"},
    {"an empty cell", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,,0\n40,1,0,0\n", "line 2"},
    {"descending wavelengths", Kind::optics, "um,a_ext,a_abs,a_asym\n40,1,0,0\n0.2,1,0,0\n",
     "more than the 40"},
    {"twice a wavelength", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0,0\n0.2,1,0,0\n40,1,0,0\n",
     "more than the 0.2"},
    {"negative extinction", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,-1,0,0\n40,1,0,0\n",
     "an extinction"},
    {"no extinction", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,0,0,0\n40,1,0,0\n",
     "an extinction"},
    {"negative absorption", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,-0.1,0\n40,1,0,0\n",
     "an absorption"},
    {"more absorption than extinction", Kind::optics,
     "um,a_ext,a_abs,a_asym\n0.2,1,1.1,0\n40,1,0,0\n", "at most the extinction 1"},
    {"asymmetry above 1", Kind::optics, "um,a_ext,a_abs,a_asym\n0.2,1,0,1.2\n40,1,0,0\n",
     "an asymmetry"},
    {"a logarithm of a thousand", Kind::logarithms,
     "um,a_ext,a_abs,a_asym\n0.2,1000,0,0\n40,1,0,0\n", "a logarithm"},
    {"negative in a profile", Kind::profile, "z,a_ext,a_abs,a_asym\n0,1,-1,0\n1000,1,0,0\n",
     "from 0 to 1e6"},
    {"a profile that floats", Kind::profile, "z,a_ext,a_abs,a_asym\n100,1,1,0\n1000,1,0,0\n",
     "altitudes from 0 m"}};

TEST(ParticleTable, EveryDamageIsRefusedByName) {
    for (const Damage& damage : damages) {
        try {
            readText(damage.text, damage.kind, opticsNames);
            ADD_FAILURE() << damage.name << " was accepted";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("particles.csv: ")) << damage.name;
            EXPECT_THAT(error.what(), testing::HasSubstr(damage.says)) << damage.name;
        }
    }
}

TEST(ParticleTable, AllDiagnosticsOfAFileComeAtOnce) {
    try {
        readText("um,a_ext,a_abs,a_asym\n0.2,-1,0,7\n0.1,1,x,0\n", Kind::optics, opticsNames);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_GE(error.diagnostics().size(), 4u);
    }
}

TEST(ParticleTable, AMissingFileIsNamed) {
    EXPECT_THROW(ParticleTable::read("/nowhere/particles-humid.csv", Kind::optics, opticsNames),
                 InputError);
}

} // namespace
} // namespace irsg
