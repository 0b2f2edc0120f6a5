#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/scattering/FinishedBatches.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

const std::string recipe = std::string(FinishedBatches::firstWords) + "; of a test";

class FinishedBatchesTest : public testing::Test {
  protected:
    void write(const std::string& text) const { std::ofstream(file) << text; }
    std::size_t read() const { return FinishedBatches::read(file, recipe, 2).size(); }

    smat::test::TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "a.mtf.part";
};

TEST_F(FinishedBatchesTest, AreReadToTheLastBit) {
    EXPECT_EQ(read(), 0u) << "no file";
    const PhotonSums sums{20000, {0.1, 1.0 / 3.0}, {1e-300, -0.0}};
    FinishedBatches(file, recipe, 2).keep({1, 5}, sums);
    FinishedBatches again(file, recipe, 2);
    again.keep({0, 0}, sums);
    const PhotonSums* found = again.find({1, 5});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->photons, sums.photons);
    EXPECT_EQ(found->sums, sums.sums);
    EXPECT_EQ(found->squares, sums.squares);
    EXPECT_EQ(again.find({1, 4}), nullptr);
    EXPECT_EQ(read(), 2u);
    EXPECT_TRUE(FinishedBatches::read(file, recipe + "2", 2).empty()) << "another recipe";
}

TEST_F(FinishedBatchesTest, TakeNoLineThatIsDamaged) {
    const std::string good = "0 1 2 0.5 0.5 0.25 0.25 .\n";
    for (const char* bad :
         {"", "0 1 2 0.5 0.5 0.25 0.25 .", "0 1 2 0.5 0.5 0.25 .\n", "0 1 2 0.5 0.5 0.25 nan .\n",
          "0 1 2 0.5 0.5 0.25 1,5 .\n", "0 -1 2 0.5 0.5 0.25 0.25 .\n",
          "0 1 2 0.5 0.5 0.25 0.25 . 1\n", "0 1 2 0.5 0.5 0.25 0x1p-2 .\n", "\n", " . \n"}) {
        write(recipe + "\n" + bad);
        EXPECT_EQ(read(), 0u) << bad;
    }
    write(recipe + "\n" + "0 0 2 0.5 inf 0.25 0.25 .\n" + good);
    EXPECT_EQ(read(), 1u) << "the next line is sound";
}

TEST_F(FinishedBatchesTest, RefuseWhatIsNoFileOfTheirs) {
    write("a letter\n");
    EXPECT_THROW(FinishedBatches(file, recipe, 2), InputError);
    EXPECT_EQ(readFile(file), "a letter\n");
    // What never ends, and what nobody writes into.
    std::filesystem::remove(file);
    std::filesystem::create_symlink("/dev/zero", file);
    EXPECT_THROW(read(), InputError);
    std::filesystem::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_THROW(read(), InputError);
}

} // namespace
} // namespace irsg
