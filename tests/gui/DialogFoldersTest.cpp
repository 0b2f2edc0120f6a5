#include "gui/widgets/DialogFolders.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/TemporaryFolder.h"

namespace smat::gui {
namespace {

TEST(DialogFolders, EachDialogBeginsWhereItWasLastAnswered) {
    const smat::test::TemporaryFolder root;
    const auto folder = [&](const char* name) {
        std::filesystem::create_directories(root / name);
        return QString::fromStdString((root / name).string());
    };
    const QString models = folder("models"), pictures = folder("pictures");
    EXPECT_EQ(remembered("Open a model of the test", models + "/a.ac"), models + "/a.ac");
    remembered("Save a picture of the test", pictures + "/b.png");
    EXPECT_EQ(lastFolder("Open a model of the test"), models);
    EXPECT_EQ(lastFolder("Save a picture of the test"), pictures);
    EXPECT_EQ(lastFolder("Another of the test"), pictures) << "the last of any";
    remembered("Open a model of the test", "");
    EXPECT_EQ(lastFolder("Open a model of the test"), models) << "no answer, nothing new";
    EXPECT_EQ(startOf("Open a model of the test", "c.ac"), models + "/c.ac");
    EXPECT_EQ(startOf("Open a model of the test", "/tmp/c.ac"), "/tmp/c.ac");
    EXPECT_EQ(startOf("Open a model of the test", ""), models);
    std::filesystem::remove(root / "models");
    EXPECT_EQ(lastFolder("Open a model of the test"), pictures) << "that one is gone";
}

} // namespace
} // namespace smat::gui
