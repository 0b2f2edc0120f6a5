#include "smatcore/project/NamedPaths.h"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/project/ShippedFiles.h"
#include "smatcore/support/TextFile.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

namespace fs = std::filesystem;

const fs::path source = SMAT_SOURCE_DIR;
const fs::path winter = "resources/atmospheres/subarctic-winter.xml";

/// With the data of the source tree, whatever the environment of the tests says.
class NamedPathsTest : public testing::Test {
  protected:
    NamedPathsTest() { setenv("SMAT_DATA", SMAT_SOURCE_DIR, 1); }
    ~NamedPathsTest() override { unsetenv("SMAT_DATA"); }
    const test::TemporaryFolder folder;
    const fs::path project = folder / "moved.smat";
};

TEST_F(NamedPathsTest, AProjectThatWasCopiedFindsTheAirThatComesWithTheProgram) {
    const irsg::WrittenPath found = namedPath(project, fs::path("../..") / winter);
    EXPECT_EQ(found.file, source / winter);
    EXPECT_THAT(found.remark, testing::HasSubstr("comes with the program"));
    // From another machine.
    EXPECT_EQ(namedPath(project, "/home/ann/smat/" + winter.string()).file, source / winter);
    // A sample names another one.
    EXPECT_EQ(namedPath(project, "../turboprop4/turboprop4.flt").file,
              source / "samples/turboprop4/turboprop4.flt");
}

TEST_F(NamedPathsTest, WhatLiesThereIsWhatIsMeant) {
    fs::create_directories(folder / "resources/atmospheres");
    writeTextFile(folder / winter, "another one");
    const irsg::WrittenPath found = namedPath(project, winter);
    EXPECT_EQ(found.file, folder / winter);
    EXPECT_EQ(found.remark, "");
}

TEST_F(NamedPathsTest, ANameAloneMayBeAnyFileAndStaysMissing) {
    for (const char* name : {"ship.flt", "turboprop4.sigdb", "/somewhere/ship.flt", "ship/ship.flt",
                             "../ship.flt", "../../no/such.xml"}) {
        const irsg::WrittenPath found = namedPath(project, name);
        EXPECT_EQ(found.remark, "") << name;
        EXPECT_FALSE(fs::exists(found.file)) << name;
        EXPECT_TRUE(shippedFile(name).empty()) << name;
    }
}

} // namespace
} // namespace smat
