#include "smatcore/support/PartialFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "smatcore/data/ResultTable.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

namespace fs = std::filesystem;

ResultTable tableOf(const char* state) {
    ResultTable table;
    table.add("x", "");
    table.addRow({1.0});
    table.provenance.add("program", "smat");
    table.provenance.add("state", state);
    return table;
}

TEST(PartialFile, ReplacesNothingThatIsWhole) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.csv", "a.json"}) {
        const fs::path file = folder / name, beside = partialFileBeside(file);
        EXPECT_EQ(beside.filename(), std::string("a.partial") + file.extension().string());
        EXPECT_EQ(placeOfPartial(file), file) << "nothing is there";
        tableOf("partial").save(file);
        EXPECT_TRUE(isPartialResult(file));
        EXPECT_EQ(placeOfPartial(file), file);
        tableOf("complete").save(file);
        EXPECT_FALSE(isPartialResult(file));
        EXPECT_EQ(placeOfPartial(file), beside);

        const auto save = [](const char* state) {
            return [state](const fs::path& place) { tableOf(state).save(place); };
        };
        EXPECT_EQ(savedResult(file, false, save("partial")), beside);
        EXPECT_TRUE(isPartialResult(beside));
        EXPECT_FALSE(isPartialResult(file));
        EXPECT_EQ(savedResult(file, true, save("complete")), file);
        EXPECT_FALSE(fs::exists(beside));
        // A whole file of that name is somebody's own.
        tableOf("complete").save(beside);
        removePartialBeside(file);
        EXPECT_TRUE(fs::exists(beside));
    }
}

TEST(PartialFile, IsNoneThatCannotBeRead) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "folder.csv");
    ASSERT_EQ(mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
    for (const char* name : {"folder.csv", "pipe.csv", "nothing.csv"}) {
        EXPECT_FALSE(isPartialResult(folder / name)) << name;
        EXPECT_EQ(placeOfPartial(folder / name), folder / name) << name;
    }
}

} // namespace
} // namespace smat
