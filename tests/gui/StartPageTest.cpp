#include "gui/start/StartPage.h"

#include <fstream>

#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>

#include "gui/WindowLayout.h"
#include "gui/image/ColorBar.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/start/DataFolder.h"
#include "gui/start/GuidePage.h"
#include "gui/view/ModelPage.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class StartPageTest : public test::WindowFixture {
  protected:
    StartPage& start() { return *window->findChild<StartPage*>(); }
    void click(const char* name) {
        auto* button = window->findChild<QToolButton*>(name);
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isVisible()) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QAction& action(const char* name) { return *window->findChild<QAction*>(name); }
};

TEST_F(StartPageTest, ItIsTwoActionsToTheFirstInfraredPicture) {
    EXPECT_TRUE(start().isVisible());
    test::keepScreenshot(*window, "start-page");
    QElapsedTimer clock;
    clock.start();
    click("sample-turboprop4");
    ASSERT_TRUE(waitForModel());
    EXPECT_FALSE(start().isVisible());
    click("showInfrared");
    SceneView& view = *window->sceneView();
    ASSERT_TRUE(
        test::waitUntil([&] { return view.isUpToDate() && view.shownPicture() != nullptr; }));
    RecordProperty("seconds", std::to_string(0.001 * static_cast<double>(clock.elapsed())));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_FALSE(workbench.isModified()) << "looking changes nothing";
    test::keepScreenshot(*window, "start-first-picture");
}

TEST_F(StartPageTest, ShowsWhatWasOpenLastTime) {
    openSample();
    makeWindow();
    auto* recent = start().findChild<QToolButton*>("recentFile");
    ASSERT_NE(recent, nullptr);
    EXPECT_EQ(recent->text(), "ship.smat");
}

TEST_F(StartPageTest, TellsFilesOfOneNameApartByTheirFolders) {
    makeWindow();
    QTemporaryDir folder;
    QStringList files;
    for (const char* name : {"first/heron.smat", "second/heron.smat", "second/ship.smat"}) {
        files.append(folder.filePath(name));
        QDir().mkpath(QFileInfo(files.back()).path());
        QFile file(files.back());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    start().setRecentFiles(files);
    QStringList texts;
    for (const QToolButton* button : start().findChildren<QToolButton*>("recentFile")) {
        texts.append(button->text());
    }
    EXPECT_EQ(texts, (QStringList{"heron.smat in first", "heron.smat in second", "ship.smat"}));
}

TEST_F(StartPageTest, EveryEntryLeadsSomewhere) {
    const struct {
        const char *button, *tellsOf;
    } rows[] = {{"startModel", "model"}, {"startOpen", "open"}};
    for (const auto& row : rows) {
        QStringList titles;
        Dialogs people = this->people;
        people.openFile = [&](QWidget*, const QString& title, const QStringList&) {
            titles << title;
            return QString();
        };
        window = std::make_unique<MainWindow>(workbench, people);
        window->show();
        QTest::qWait(30);
        click(row.button);
        ASSERT_EQ(titles.size(), 1) << row.button;
    }
    accept = false;
    bool opened = false;
    onDialog = [&](QDialog&) { opened = true; };
    makeWindow();
    click("startProject");
    EXPECT_TRUE(opened);
    click("startGuide");
    EXPECT_NE(window->findChild<GuidePage*>(), nullptr);
}

TEST_F(StartPageTest, TheFileMenuHasTheSamples) {
    const auto actions = window->findChild<QMenu*>("samples")->actions();
    ASSERT_EQ(static_cast<std::size_t>(actions.size()), samples().size());
    ASSERT_GE(actions.size(), 5);
    for (const Sample& sample : samples()) {
        EXPECT_TRUE(std::filesystem::exists(sample.picture)) << sample.picture;
    }
    actions.back()->trigger(); // the sphere
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.project().displayName(), "sphere.smat");
}

TEST_F(StartPageTest, TheGuideOpensFromHelp) {
    trigger("openGuide");
    const auto* guide = window->findChild<GuidePage*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_TRUE(guide->isVisible());
    EXPECT_TRUE(guide->toPlainText().contains("Your first signature"));
    test::keepScreenshot(*window, "start-guide");
}

TEST_F(StartPageTest, AnalysesThatCannotBeRunAreGreyAndSayWhy) {
    const QAction& polar = action("new-polar");
    EXPECT_FALSE(polar.isEnabled());
    EXPECT_TRUE(polar.toolTip().contains("Open a project")) << polar.toolTip().toStdString();
    // A model alone has no temperatures.
    const auto model = folder / "alone.flt";
    std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box/box.flt",
                               model);
    ASSERT_TRUE(opens(model));
    EXPECT_FALSE(polar.isEnabled());
    EXPECT_TRUE(polar.toolTip().contains("no signature database")) << polar.toolTip().toStdString();
    openSample();
    EXPECT_TRUE(polar.isEnabled());
    EXPECT_FALSE(polar.toolTip().contains("first")) << polar.toolTip().toStdString();
}

/// Larger than what is read within a moment.
constexpr std::size_t large_bytes = 4'500'000;

TEST_F(StartPageTest, ALargeDamagedModelLeavesWhatIsOpenUntouched) {
    openSample();
    workbench.set("camera.azimuth", "7");
    answer = 1;
    for (const char* ending : {".flt", ".obj", ".stl"}) {
        const auto damaged = folder / (std::string("large") + ending);
        std::ofstream(damaged, std::ios::binary) << std::string(large_bytes, 'x');
        told.clear();
        window->open(damaged);
        ASSERT_TRUE(waitForModel());
        ASSERT_FALSE(told.isEmpty()) << ending;
        EXPECT_TRUE(told.front().contains("large")) << told.front().toStdString();
        ASSERT_EQ(workbench.project().displayName(), "ship.smat") << ending;
        EXPECT_EQ(workbench.settings().text("camera.azimuth"), "7");
        EXPECT_EQ(workbench.undoStack().count(), 1);
        EXPECT_TRUE(asked.isEmpty()) << "nothing is given up for a file that cannot be read";
    }
}

/// A sound model of many equal triangles.
void writeLargeModel(const std::filesystem::path& file) {
    constexpr std::uint32_t facets = large_bytes / 50;
    std::ofstream out(file, std::ios::binary);
    const std::string head(80, ' ');
    out << head;
    out.write(reinterpret_cast<const char*>(&facets), sizeof facets);
    const float corners[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::string facet(reinterpret_cast<const char*>(corners), sizeof corners);
    facet.resize(50, '\0');
    for (std::uint32_t i = 0; i < facets; ++i) {
        out << facet;
    }
}

TEST_F(StartPageTest, ALargeModelTakesThePlaceOfWhatIsOpenWhenItWasReadOnce) {
    openSample();
    workbench.set("camera.azimuth", "7");
    const auto file = folder / "large.stl";
    writeLargeModel(file);
    answer = 2;
    const long before = workbench.models()->readings();
    EXPECT_TRUE(window->open(file));
    EXPECT_EQ(workbench.project().displayName(), "ship.smat") << "while it is being read";
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.project().displayName(), "ship.smat") << "the answer was to stay";
    ASSERT_EQ(asked.size(), 1);
    answer = 1;
    EXPECT_TRUE(opens(file));
    EXPECT_EQ(workbench.project().models.front().file.filename(), "large.stl");
    ASSERT_TRUE(test::waitUntil([&] { return !window->tree().isLoading(); }));
    EXPECT_EQ(workbench.models()->readings() - before, 1);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(StartPageTest, WhoOpensSomethingElseIsNotSurprisedByALargeModel) {
    const auto file = folder / "large.stl";
    writeLargeModel(file);
    EXPECT_TRUE(window->open(file));
    openSample();
    backgroundPool().waitForDone();
    QTest::qWait(50);
    EXPECT_EQ(workbench.project().displayName(), "ship.smat");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(StartPageTest, ADamagedModelLeavesWhatIsOpenUntouched) {
    openSample();
    workbench.set("camera.azimuth", "7");
    for (const char* ending : {".flt", ".obj", ".stl"}) {
        const auto damaged = folder / (std::string("damaged") + ending);
        std::ofstream(damaged, std::ios::binary) << "This is a letter to my aunt.\n";
        answer = 1;
        told.clear();
        EXPECT_FALSE(window->open(damaged)) << ending;
        ASSERT_FALSE(told.isEmpty()) << ending;
        EXPECT_TRUE(told.front().contains("damaged")) << told.front().toStdString();
        ASSERT_EQ(workbench.project().displayName(), "ship.smat") << ending;
        EXPECT_EQ(workbench.settings().text("camera.azimuth"), "7");
        EXPECT_EQ(workbench.undoStack().count(), 1);
    }
}

TEST_F(StartPageTest, AllDocksGoAwayAndComeBackByOneKey) {
    openSample();
    const auto inSight = [&] {
        QStringList names;
        for (auto* dock : window->findChildren<QDockWidget*>()) {
            if (!dock->isHidden()) {
                names << dock->objectName();
            }
        }
        names.sort();
        return names;
    };
    const QStringList before = inSight();
    ASSERT_GE(before.size(), 3);
    const int narrow = window->sceneView()->width();
    EXPECT_EQ(action("collapseDocks").shortcut(), QKeySequence(Qt::Key_F6));
    trigger("collapseDocks");
    QTest::qWait(30);
    EXPECT_TRUE(inSight().isEmpty());
    EXPECT_GT(window->sceneView()->width(), narrow + 300);
    trigger("collapseDocks");
    QTest::qWait(30);
    EXPECT_EQ(inSight(), before);
}

TEST_F(StartPageTest, TheFirstStartFitsTheScreen) {
    for (const QSize screen : {QSize(1280, 800), QSize(1366, 768), QSize(960, 600)}) {
        const QSize size = WindowLayout::firstSize(screen);
        EXPECT_LT(size.width(), screen.width());
        EXPECT_LT(size.height(), screen.height());
    }
    EXPECT_EQ(WindowLayout::firstSize({3840, 2160}), QSize(1360, 840));
}

TEST_F(StartPageTest, EveryCardIsWholeBesideTheEditorOnASmallScreen) {
    for (const QSize size : {QSize(1280, 800), QSize(1600, 1000)}) {
        window->resize(size);
        QTest::qWait(30);
        auto* page = window->findChild<StartPage*>();
        ASSERT_NE(page, nullptr);
        int cards = 0;
        for (const auto* card : page->findChildren<QToolButton*>()) {
            const QRect place(card->mapTo(page, QPoint(0, 0)), card->size());
            EXPECT_GE(place.left(), 0) << card->objectName().toStdString();
            EXPECT_LE(place.right(), page->width()) << card->objectName().toStdString();
            cards += card->objectName().startsWith("sample-") ? 1 : 0;
        }
        EXPECT_GE(cards, 7);
    }
}

TEST_F(StartPageTest, TheColourBarStaysInSightBesideTheEditorOnASmallScreen) {
    window->resize(1280, 800);
    openSample();
    auto* database = window->findChild<QDockWidget*>("databaseDock");
    database->show();
    database->raise();
    click("showInfrared");
    ASSERT_TRUE(test::waitUntil([&] { return window->sceneView()->shownPicture() != nullptr; }));
    QTest::qWait(50);
    test::keepScreenshot(*window, "small-database-infrared");
    const auto* bar = window->findChild<ModelPage*>()->colorBar();
    ASSERT_TRUE(bar->isVisible());
    const QRect seen = bar->visibleRegion().boundingRect();
    EXPECT_EQ(seen.size(), bar->size()) << seen.width() << " of " << bar->width();
    EXPECT_EQ(window->size(), QSize(1280, 800));
}

} // namespace
} // namespace smat::gui
