#include "gui/project/RecoveryCopy.h"

#include "gui/project/ProjectFiles.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// What earlier runs and tests leave behind, of never-saved projects in the user's folder and
/// beside recent ones, is taken away before and after.
class RecoveryCopyTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        empty();
    }
    void TearDown() override { empty(); }
    void edit() { workbench.set("target.altitude", "1234"); }
    static std::filesystem::path ship() {
        return std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.flt";
    }
    void empty() const {
        for (const auto& recent : workbench.recentFiles()) {
            for (const auto& copy : RecoveryCopy::leftBehind(recent.toStdString())) {
                RecoverySlot::remove(copy);
            }
        }
        for (const auto& copy : RecoveryCopy::leftBehind({})) {
            RecoverySlot::remove(copy);
        }
    }
    static void shutDown(const std::string& title, int number = 1) {
        Project left = projectOfModel(ship());
        left.title = title;
        const auto copy = RecoveryCopy::pathFor({}, number);
        std::filesystem::create_directories(copy.parent_path());
        saveProject(left, copy);
        std::filesystem::last_write_time(copy, std::filesystem::file_time_type::clock::now() -
                                                   std::chrono::hours(number));
    }
    static QStringList leftTitles() {
        QStringList titles;
        for (const auto& copy : RecoveryCopy::leftBehind({})) {
            titles << QString::fromStdString(RecoveryCopy::read(copy, {}).title);
        }
        return titles;
    }
};

TEST_F(RecoveryCopyTest, ACopyThatWasLeftBehindIsNeverWrittenOver) {
    shutDown("Of the crash");
    answer = -1;
    EXPECT_TRUE(window->begin(ship()));
    EXPECT_EQ(asked, QStringList{"Recover unsaved changes"});
    ASSERT_TRUE(waitForModel());
    EXPECT_NE(workbench.project().title, "Of the crash");
    QObject::connect(&window->files(), &ProjectFiles::said,
                     [&](const QString& sentence) { told << sentence; });
    edit();
    window->files().recovery().writeNow();
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(leftTitles(), QStringList{"Of the crash"});
    const auto own = RecoveryCopy::pathFor({}, 2);
    EXPECT_EQ(RecoveryCopy::read(own, {}).settings.text("target.altitude"), "1234");
    window->files().recovery().forget();
    EXPECT_FALSE(std::filesystem::exists(own));
    EXPECT_EQ(leftTitles(), QStringList{"Of the crash"});
}

TEST_F(RecoveryCopyTest, AModelOfTheCommandLineComesAfterWhatIsRecovered) {
    shutDown("Of the crash");
    QStringList said;
    QObject::connect(&window->files(), &ProjectFiles::said,
                     [&](const QString& sentence) { said << sentence; });
    answer = 0;
    EXPECT_TRUE(window->begin(ship()));
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.project().title, "Of the crash");
    EXPECT_TRUE(said.join(' ').contains("ship.flt is not opened")) << said.join(' ').toStdString();
    // The copy is that of the window now: later edits go there, and a save takes it away.
    EXPECT_TRUE(RecoveryCopy::leftBehind({}).empty());
    edit();
    window->files().recovery().writeNow();
    EXPECT_EQ(loadProject(RecoveryCopy::pathFor({})).settings.text("target.altitude"), "1234");
    chosen = QString::fromStdString((folder / "recovered.smat").string());
    trigger("saveProjectAs");
    EXPECT_FALSE(std::filesystem::exists(RecoveryCopy::pathFor({})));
}

TEST_F(RecoveryCopyTest, EveryCopyThatWasLeftBehindIsOffered) {
    for (int number = 1; number <= 3; ++number) {
        shutDown("Crash " + std::to_string(number), number);
    }
    // Newest first; the first is discarded, the second left alone and the third taken.
    answers = {1, -1, 0};
    EXPECT_TRUE(window->begin({}));
    EXPECT_EQ(asked.size(), 3);
    EXPECT_EQ(workbench.project().title, "Crash 3");
    EXPECT_EQ(leftTitles(), QStringList{"Crash 2"});
    EXPECT_FALSE(std::filesystem::exists(RecoveryCopy::pathFor({})));
    window->files().recovery().forget();
}

TEST_F(RecoveryCopyTest, AStartOffersTheNewestUnsavedChangesOfTheRecentProjects) {
    const auto older = test::writeSampleProject(test::freshFolder("older"));
    const auto newer = test::writeSampleProject(test::freshFolder("newer"));
    const auto clean = test::writeSampleProject(test::freshFolder("clean"));
    for (const auto& project : {newer, older, clean}) {
        EXPECT_TRUE(opens(project));
    }
    auto leaveOf = [](const std::filesystem::path& project, const char* range, int hours) {
        Project left = loadProject(project);
        left.settings.set("camera.range", range);
        const auto copy = RecoveryCopy::pathFor(project);
        saveProject(left, copy);
        std::filesystem::last_write_time(copy, std::filesystem::file_time_type::clock::now() -
                                                   std::chrono::hours(hours));
    };
    leaveOf(older, "7", 5);
    leaveOf(newer, "8", 2);
    for (const int reply : {-1, 0}) {
        Workbench bench;
        MainWindow fresh(bench, people);
        asked.clear();
        answer = reply;
        EXPECT_EQ(fresh.begin({}), reply == 0);
        EXPECT_EQ(asked, QStringList{"Recover unsaved changes"});
        EXPECT_EQ(bench.hasProject(), reply == 0);
        EXPECT_TRUE(std::filesystem::exists(RecoveryCopy::pathFor(newer)));
        EXPECT_TRUE(std::filesystem::exists(RecoveryCopy::pathFor(older)));
        if (reply != 0) {
            continue;
        }
        EXPECT_EQ(bench.project().file, newer);
        EXPECT_EQ(bench.settings().text("camera.range"), "8");
        EXPECT_TRUE(bench.isModified());
        EXPECT_TRUE(fresh.files().save());
        EXPECT_FALSE(std::filesystem::exists(RecoveryCopy::pathFor(newer)));
    }
    EXPECT_EQ(loadProject(newer).settings.text("camera.range"), "8");
    EXPECT_EQ(loadProject(older).settings.text("camera.range"), "1000");
}

} // namespace
} // namespace smat::gui
