#include <fstream>

#include <QToolButton>

#include "gui/project/ProjectFiles.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"
#include "tests/gui/SmallDisk.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class RobustnessTest : public test::WindowFixture {
  protected:
    /// A project whose model and database lie beside it and can be taken away.
    std::filesystem::path writeOwnProject() {
        const auto file = test::writeSampleProject(folder);
        Project project = loadProject(file);
        for (auto* path : {&project.models.front().file, &project.models.front().database}) {
            const auto from = project.resolve(*path);
            std::filesystem::copy_file(from, folder / from.filename());
            *path = from.filename();
        }
        saveProject(project, file);
        return file;
    }
};

TEST_F(RobustnessTest, AModelThatVanishesWhileItIsOpenIsTold) {
    ASSERT_TRUE(opens(writeOwnProject()));
    workbench.set("camera.azimuth", "5");
    std::filesystem::remove(folder / "ship.flt");
    trigger("new-image");
    ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
    ASSERT_EQ(told.size(), 1) << told.join('\n').toStdString();
    EXPECT_TRUE(told.front().contains("ship.flt"));
    EXPECT_EQ(workbench.settings().text("camera.azimuth"), "5");
    trigger("saveProject");
    EXPECT_EQ(loadProject(folder / "ship.smat").settings.text("camera.azimuth"), "5");
}

TEST_F(RobustnessTest, ProjectsThatCannotBeReadAreToldAndNothingIsLost) {
    openSample();
    workbench.set("camera.azimuth", "5");
    const std::string good = readTextFile(folder / "ship.smat");
    struct Row {
        const char* name;
        std::string text;
        const char* said;
    };
    std::string newer = good;
    newer.replace(newer.find("\"version\": 1"), 12, "\"version\": 99");
    for (const Row& row : {Row{"newer", newer, "99"}, Row{"cut", good.substr(0, 40), "line"},
                           Row{"empty", "", "damaged.smat"},
                           Row{"binary", std::string("\x00\x01\xff\xfe", 4), "damaged.smat"},
                           Row{"other json", "[1, 2, 3]", "damaged.smat"},
                           Row{"wrong value", R"({"version": 1, "camera": {"range": "far"}})",
                               "instead of \"far\""}}) {
        std::ofstream(folder / "damaged.smat", std::ios::binary) << row.text;
        told.clear();
        answer = 1; // the changes of the one that is open may go, if the other can be opened
        EXPECT_FALSE(window->open(folder / "damaged.smat")) << row.name;
        ASSERT_FALSE(told.isEmpty()) << row.name;
        EXPECT_TRUE(told.join(' ').contains(row.said))
            << row.name << ": " << told.join(' ').toStdString();
        EXPECT_EQ(workbench.project().displayName(), "ship.smat") << row.name;
        EXPECT_EQ(workbench.settings().text("camera.azimuth"), "5") << row.name;
        EXPECT_TRUE(workbench.undoStack().canUndo()) << row.name;
    }
}

TEST_F(RobustnessTest, AFullDiskLeavesTheOldFileWhole) {
    const test::SmallDisk disk("full-disk");
    if (!disk.isThere()) {
        GTEST_SKIP() << "a small disk can be mounted by root alone";
    }
    const auto file = disk / "ship.smat";
    std::filesystem::copy_file(test::writeSampleProject(folder), file);
    const std::string before = readTextFile(file);
    opens(file);
    told.clear(); // relative paths of the copy lead nowhere
    disk.fill();

    workbench.set("camera.azimuth", "5");
    trigger("saveProject");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("ship.smat")) << told.front().toStdString();
    EXPECT_EQ(readTextFile(file), before);
    EXPECT_TRUE(workbench.isModified());
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
    window->files().recovery().writeNow(); // cannot be kept either: said, not thrown
    EXPECT_EQ(readTextFile(file), before);

    disk.empty();
    trigger("saveProject");
    EXPECT_EQ(loadProject(file).settings.text("camera.azimuth"), "5");
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(RobustnessTest, AFolderThatMayNotBeWrittenIsTold) {
    openSample();
    workbench.set("camera.azimuth", "5");
    chosen = "/proc/no-such-place/ship.smat";
    trigger("saveProjectAs");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("/proc/no-such-place"));
    EXPECT_EQ(workbench.project().file, folder / "ship.smat");
    EXPECT_TRUE(workbench.isModified());
}

TEST_F(RobustnessTest, ClosingWhileAnAnalysisRunsAsksAboutChangesAndEndsTheJob) {
    openSample();
    workbench.set("polar.step", "0.05");
    trigger("new-polar");
    QTest::qWait(50);
    ASSERT_TRUE(workbench.isRunning());
    answer = -1;
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(workbench.isRunning());
    answers = {0, 1}; // quit, and discard the changed step
    EXPECT_TRUE(window->close());
    EXPECT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(RobustnessTest, EveryFieldOfTheDocksIsReachedByTab) {
    openSample();
    window->activateWindow();
    auto* first = window->findChild<QWidget*>("camera.azimuth");
    first->setFocus();
    QStringList reached;
    QWidget* at = first;
    do {
        at = at->nextInFocusChain();
        if (at->focusPolicy() & Qt::TabFocus) {
            reached << at->objectName();
        }
    } while (at != first);
    for (const auto* name : {"camera.azimuth", "camera.azimuth.slider", "camera.range",
                             "target.roll", "state.mach", "sceneTree", "resultList"}) {
        EXPECT_TRUE(reached.contains(name)) << name;
    }
    // In the order in which they stand.
    EXPECT_LT(reached.indexOf("camera.elevation"), reached.indexOf("camera.range"));
    EXPECT_LT(reached.indexOf("target.yaw"), reached.indexOf("target.pitch"));
}

} // namespace
} // namespace smat::gui
