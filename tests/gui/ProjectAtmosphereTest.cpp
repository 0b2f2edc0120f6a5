// The atmospheres of a project, and imports.
#include <QApplication>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QTreeWidget>
#include <QWindow>

#include "gui/atmosphere/ImportAtmosphereDialog.h"
#include "gui/atmosphere/ProjectAtmospherePage.h"
#include "irsg/core/Errors.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/gui/AtmosphereFixture.h"
#include "tests/support/SharedMaterial.h"

namespace smat::gui {
namespace {

class ProjectAtmosphereTest : public test::AtmosphereFixture {
  protected:
    void SetUp() override {
        AtmosphereFixture::SetUp();
        if (IsSkipped()) {
            return;
        }
        openSample();
        smat::test::write(folder / "haze.csv",
                          "# name: haze\n# air_temperature [K]: 290\nwavelength [um],extinction "
                          "[km-1]\n2.5,1\n13,4\n");
        irsg::toKarma(irsg::AtmosphereSmartParameters{}).write(folder / "own.xml");
        workbench.set("sensor.band", "3-5, 8-12");
        const std::string base = folder.string();
        workbench.set("environment.atmospheres", base + "/own.xml;" + base + "/haze.csv;none");
        trigger("projectAir");
        air = dynamic_cast<ProjectAtmospherePage*>(
            window->findChild<QTabWidget*>("tabs")->currentWidget());
        ASSERT_NE(air, nullptr);
        list = air->findChild<QListWidget*>("airList");
        table = air->findChild<QTableWidget*>("airAnswers");
        settleAnswers();
    }
    void settleAnswers() {
        ASSERT_TRUE(test::waitUntil([&] { return !air->isBusy(); }));
    }
    QStringList order() {
        QStringList names;
        for (const auto& one : workbench.settings()[key::environmentAtmospheres]) {
            names << QString::fromStdString(one.filename().string());
        }
        return names;
    }
    QString answered(const QString& quantity, int band) {
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->verticalHeaderItem(row)->text() == quantity) {
                return table->item(row, band)->text();
            }
        }
        return "no such quantity";
    }

    ProjectAtmospherePage* air = nullptr;
    QListWidget* list = nullptr;
    QTableWidget* table = nullptr;
};

TEST_F(ProjectAtmosphereTest, ProvidersAreToldPerQuantityAndBand) {
    EXPECT_EQ(table->columnCount(), 2);
    EXPECT_EQ(answered("transmittance", 0), "AtmosphereSmart (own.xml)");
    EXPECT_EQ(answered("transmittance", 1), "haze"); // the first holds 3 to 5 um alone
    EXPECT_EQ(answered("upward flux", 0), "AtmosphereSmart (own.xml)");
    EXPECT_EQ(answered("wideband-ck", 0), "AtmosphereSmart (own.xml)");
    EXPECT_EQ(answered("wideband-ck", 1), "haze");
    // As the command line says it.
    const auto ran = smat::test::smatBatch(
        {"atmosphere", "answers", "own.xml", "haze.csv", "none", "--band", "3-5", "--band", "8-12"},
        folder);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    const auto second = ran.out.find("8 to 12 um");
    ASSERT_NE(second, std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("own.xml"), std::string::npos);
    const auto line = ran.out.find("transmittance", second);
    EXPECT_EQ(ran.out.substr(line, ran.out.find('\n', line) - line),
              "transmittance             haze");
    test::keepScreenshot(*window, "project-air");
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(30);
    test::keepScreenshot(*window, "project-air-dark");
    applyTheme(*qApp, ThemeMode::light);
}

TEST_F(ProjectAtmosphereTest, TheOrderIsChangedByKeysAndDragAndUndone) {
    ASSERT_EQ(order(), (QStringList{"own.xml", "haze.csv", "none"}));
    EXPECT_EQ(list->count(), 2); // "none" answers last whatever stands before it
    list->setCurrentRow(1);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(order(), (QStringList{"haze.csv", "own.xml"}));
    settleAnswers();
    EXPECT_EQ(answered("transmittance", 0), "haze");
    EXPECT_EQ(list->currentRow(), 0);
    steps().undo();
    EXPECT_EQ(order(), (QStringList{"own.xml", "haze.csv", "none"}));
    EXPECT_EQ(list->item(0)->text(), QString::fromStdString((folder / "own.xml").string()));

    // What a drop of the first below the second makes of the rows.
    EXPECT_EQ(list->dragDropMode(), QAbstractItemView::InternalMove);
    ASSERT_TRUE(list->model()->moveRow({}, 0, {}, 2));
    EXPECT_EQ(order(), (QStringList{"haze.csv", "own.xml"}));
    EXPECT_EQ(steps().undoText(), "Order the atmospheres");
}

/// The mouse takes the first below the second: pressed, moved past the drag distance, dropped.
TEST_F(ProjectAtmosphereTest, TheOrderIsChangedByTheMouse) {
    QWidget* rows = list->viewport();
    const QPoint from = list->visualItemRect(list->item(0)).center();
    const QRect second = list->visualItemRect(list->item(1));
    const QPoint to(second.center().x(), second.bottom());
    const auto point = [&](QEvent::Type type, QPoint at, Qt::MouseButton button,
                           Qt::MouseButtons held) {
        QMouseEvent event(type, QPointF(at), QPointF(rows->mapToGlobal(at)), button, held,
                          Qt::NoModifier);
        QApplication::sendEvent(rows, &event);
    };
    // QDrag runs its own loop until it sees the release: moves and release come from inside it.
    bool isDropped = false;
    QTimer ticks;
    int step = 0;
    QObject::connect(&ticks, &QTimer::timeout, &ticks, [&] {
        QWindow* const handle = window->windowHandle();
        const QPoint at = rows->mapTo(window.get(), step < 3 ? (from + to) / 2 : to);
        if (step < 6) {
            QTest::mouseMove(handle, at);
        } else if (!isDropped) {
            isDropped = true;
            QTest::mouseRelease(handle, Qt::LeftButton, Qt::NoModifier, at);
        }
        ++step;
    });
    ticks.start(20);
    point(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    point(QEvent::MouseMove, from + QPoint(0, 2 * QApplication::startDragDistance()), Qt::NoButton,
          Qt::LeftButton);
    point(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    ASSERT_TRUE(test::waitUntil([&] { return isDropped; }));
    ticks.stop();
    EXPECT_EQ(order(), (QStringList{"haze.csv", "own.xml"}));
    EXPECT_EQ(steps().undoText(), "Order the atmospheres");
    settleAnswers();
    EXPECT_EQ(answered("transmittance", 0), "haze");
    steps().undo();
    EXPECT_EQ(order(), (QStringList{"own.xml", "haze.csv", "none"}));
}

/// A copy that a crash left beside an air of the project, and one of air that has no file.
TEST_F(ProjectAtmosphereTest, CopiesThatWereLeftBehindAreOfferedWithTheProjectAndItsPage) {
    auto thick = irsg::AtmosphereSmartParameters{};
    thick.visibility_m = 1234.0;
    irsg::toKarma(thick).write(folder / "own.xml.recovery");
    workbench.saveAs(folder / "p.smat");
    asked.clear();
    answer = 0;
    workbench.open(folder / "p.smat");
    ASSERT_TRUE(test::waitUntil([&] { return !asked.isEmpty(); }));
    EXPECT_EQ(asked, QStringList{"Recover unsaved changes"});
    ASSERT_NE(shownPage(), nullptr);
    EXPECT_EQ(shownPage()->document().file(), folder / "own.xml");
    EXPECT_EQ(shownPage()->document().parameters().visibility_m, 1234.0);
    EXPECT_TRUE(shownPage()->document().isModified());

    makeNew();
    give("AtmosphereModel", "6");
    page->recovery().writeNow();
    window.reset();
    asked.clear();
    makeWindow();
    answer = 0;
    trigger("projectAir");
    EXPECT_TRUE(asked.contains("Recover unsaved changes"));
    ASSERT_NE(shownPage(), nullptr);
    EXPECT_TRUE(shownPage()->document().file().empty());
}

TEST_F(ProjectAtmosphereTest, AtmospheresAreAddedEditedAndRemoved) {
    chosen = QString::fromStdString((folder / "own.xml").string());
    list->setCurrentRow(0);
    ASSERT_TRUE(air->findChild<QPushButton*>("airEdit")->isEnabled());
    air->findChild<QPushButton*>("airEdit")->click();
    ASSERT_NE(shownPage(), nullptr) << told.join('\n').toStdString();
    EXPECT_EQ(shownPage()->document().file(), folder / "own.xml");
    EXPECT_FALSE(shownPage()->findChild<QPushButton*>("useAir")->isEnabled());
    trigger("projectAir");
    list->setCurrentRow(1);
    EXPECT_FALSE(air->findChild<QPushButton*>("airEdit")->isEnabled());
    QTest::keyClick(list, Qt::Key_Delete);
    EXPECT_EQ(order(), QStringList{"own.xml"});
    air->findChild<QPushButton*>("airRemove")->click();
    EXPECT_EQ(order(), QStringList());
    EXPECT_TRUE(air->findChild<QLabel*>("noAir")->isVisible());
    air->findChild<QPushButton*>("airAdd")->click();
    EXPECT_EQ(order(), QStringList{"own.xml"});
    // New air goes first.
    makeNew();
    give("BaseWavelengthMax", "5.5");
    chosen = QString::fromStdString((folder / "first.xml").string());
    page->findChild<QPushButton*>("useAir")->click();
    EXPECT_EQ(order(), (QStringList{"first.xml", "own.xml"}));
    while (steps().canUndo()) {
        steps().undo();
    }
    EXPECT_NE(order(), (QStringList{"first.xml", "own.xml"}));
}

TEST_F(ProjectAtmosphereTest, AnAirThatCannotBeReadIsTold) {
    smat::test::write(folder / "haze.csv", "wavelength [um],extinction [km-1]\n2.5,much\n");
    workbench.set("sensor.band", "3-5");
    settleAnswers();
    EXPECT_TRUE(air->findChild<QLabel*>("airListProblems")->text().contains("haze.csv"));
}

class ImportAtmosphereTest : public ProjectAtmosphereTest {
  protected:
    /// The dialog with these files, as long as `look` takes.
    void imports(const std::vector<std::filesystem::path>& files,
                 const std::function<void(ImportAtmosphereDialog&)>& look) {
        bool isSeen = false;
        onDialog = [&](QDialog& dialog) {
            auto* shown = dynamic_cast<ImportAtmosphereDialog*>(&dialog);
            ASSERT_NE(shown, nullptr);
            for (const auto& file : files) {
                chosen = QString::fromStdString(file.string());
                shown->findChild<QPushButton*>("addRun")->click();
            }
            ASSERT_TRUE(test::waitUntil([&] { return !shown->isBusy(); }));
            isSeen = true;
            look(*shown);
        };
        trigger("importAir");
        EXPECT_TRUE(isSeen);
    }
    static QString notes(const ImportAtmosphereDialog& dialog, int row) {
        return dialog.findChild<QTreeWidget*>("importedFiles")->topLevelItem(row)->text(2);
    }
    void saveTable(const ImportAtmosphereDialog& dialog, const char* name) {
        chosen = QString::fromStdString((folder / name).string());
        dialog.findChild<QPushButton*>("saveTable")->click();
    }
};

TEST_F(ImportAtmosphereTest, AFamilyIsWhatTheCommandMakesOfIt) {
    irsg::SyntheticRun run;
    smat::test::write(folder / "a-tape7", irsg::tape7(run));
    run.range_km = 2.0;
    run.depth = [](double) { return 0.2; };
    smat::test::write(folder / "b-tape7", irsg::tape7(run));
    imports({folder / "a-tape7", folder / "b-tape7"}, [&](ImportAtmosphereDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QLabel*>("importedFamily")->text().startsWith("2 runs"))
            << dialog.findChild<QLabel*>("importedFamily")->text().toStdString();
        test::keepScreenshot(dialog, "import-air");
        saveTable(dialog, "window.smatatm");
    });
    const auto ran =
        smat::test::smatBatch({"atmosphere", "import", (folder / "a-tape7").string(),
                               (folder / "b-tape7").string(), "--out", "terminal.smatatm"},
                              folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(content("window.smatatm"), content("terminal.smatatm"));
    EXPECT_EQ(order().front(), "window.smatatm");
    steps().undo();
    EXPECT_EQ(order().front(), "own.xml");
}

TEST_F(ImportAtmosphereTest, WhatIsWrongIsShownBesideItsFileAndNothingIsSaved) {
    irsg::SyntheticRun run;
    smat::test::write(folder / "good-tape7", irsg::tape7(run));
    smat::test::write(folder / "bad-tape7", irsg::tape7(run).substr(0, 700));
    run.model = 2;
    run.range_km = 3.0;
    smat::test::write(folder / "other-tape7", irsg::tape7(run));
    imports({folder / "good-tape7", folder / "bad-tape7"}, [&](ImportAtmosphereDialog& dialog) {
        EXPECT_TRUE(notes(dialog, 1).contains("bad-tape7")) << notes(dialog, 1).toStdString();
        EXPECT_FALSE(dialog.findChild<QPushButton*>("saveTable")->isEnabled());
        test::keepScreenshot(dialog, "import-air-wrong");
        dialog.findChild<QTreeWidget*>("importedFiles")
            ->setCurrentItem(dialog.findChild<QTreeWidget*>("importedFiles")->topLevelItem(1));
        dialog.findChild<QPushButton*>("removeRun")->click();
        ASSERT_TRUE(test::waitUntil([&] { return !dialog.isBusy(); }));
        EXPECT_TRUE(dialog.findChild<QPushButton*>("saveTable")->isEnabled());
    });
    // Runs of another air are no family.
    imports({folder / "good-tape7", folder / "other-tape7"}, [&](ImportAtmosphereDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QLabel*>("importedFamily")->text().contains("MODEL"))
            << dialog.findChild<QLabel*>("importedFamily")->text().toStdString();
        EXPECT_FALSE(dialog.findChild<QPushButton*>("saveTable")->isEnabled());
    });
}

TEST_F(ImportAtmosphereTest, EveryFileOfTheSharedResultsIsImported) {
    const auto shared = smat::test::sharedMaterial("data/atmosphere/modtran");
    if (shared.empty()) {
        GTEST_SKIP() << "the shared MODTRAN files are not there";
    }
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("tape7") && entry.path().extension() != ".fl7") {
            continue;
        }
        ++files;
        SCOPED_TRACE(entry.path().string());
        imports({entry.path()}, [&](ImportAtmosphereDialog& dialog) {
            EXPECT_TRUE(dialog.findChild<QPushButton*>("saveTable")->isEnabled())
                << notes(dialog, 0).toStdString();
            saveTable(dialog, "window.smatatm");
        });
        std::filesystem::remove(folder / "terminal.smatatm");
        const auto ran = smat::test::smatBatch(
            {"atmosphere", "import", entry.path().string(), "--out", "terminal.smatatm"}, folder);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(content("window.smatatm"), content("terminal.smatatm"));
    }
    EXPECT_EQ(files, 14);
}

} // namespace
} // namespace smat::gui
