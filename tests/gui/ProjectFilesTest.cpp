#include "gui/project/ProjectFiles.h"

#include <fstream>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSemaphore>

#include "gui/project/ConvertModelDialog.h"
#include "gui/project/NewProjectDialog.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/widgets/NumberField.h"
#include "irsg/geometry/model/ModelPlacing.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ProjectFilesTest : public test::WindowFixture {
  protected:
    std::filesystem::path file() const { return folder / "ship.smat"; }
    void edit() { workbench.set("camera.range", "1234"); }
    static std::filesystem::path sample(const char* name) {
        return std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship" / name;
    }
    void drop(const std::filesystem::path& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &enter);
        QDropEvent event({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &event);
        QTest::qWait(50);
    }
};

TEST_F(ProjectFilesTest, SavesWhatWasEditedAndShowsAnAsteriskUntilThen) {
    openSample();
    EXPECT_FALSE(window->isWindowModified());
    edit();
    EXPECT_TRUE(window->isWindowModified());
    trigger("saveProject");
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_EQ(loadProject(file()).settings.text("camera.range"), "1234");
    trigger("undo");
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_TRUE(told.isEmpty() && asked.isEmpty());
}

TEST_F(ProjectFilesTest, SavesUnderAnotherNameAndGoesOnThere) {
    openSample();
    edit();
    chosen = QString::fromStdString((folder / "other.smat").string());
    trigger("saveProjectAs");
    EXPECT_EQ(loadProject(file()).settings.text("camera.range"), "1000");
    EXPECT_EQ(loadProject(folder / "other.smat").settings.text("camera.range"), "1234");
    EXPECT_TRUE(window->windowTitle().startsWith("other.smat"));
    EXPECT_EQ(workbench.recentFiles().front(), chosen);
}

TEST_F(ProjectFilesTest, AsksAboutUnsavedChangesBeforeItCloses) {
    openSample();
    edit();
    answer = -1;
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, QStringList{"Unsaved changes"});
    EXPECT_TRUE(window->isVisible());
    answer = 0;
    EXPECT_TRUE(window->close());
    EXPECT_EQ(loadProject(file()).settings.text("camera.range"), "1234");
}

TEST_F(ProjectFilesTest, DiscardsWhenToldTo) {
    openSample();
    edit();
    window->files().recovery().writeNow();
    answer = 1;
    EXPECT_TRUE(window->close());
    EXPECT_EQ(loadProject(file()).settings.text("camera.range"), "1000");
    EXPECT_FALSE(std::filesystem::exists(RecoveryCopy::pathFor(file())));
}

TEST_F(ProjectFilesTest, AskedToStayItOpensNothingElse) {
    openSample();
    edit();
    const auto other = test::writeSampleProject(test::freshFolder("other-project"));
    EXPECT_FALSE(window->open(other));
    EXPECT_EQ(workbench.project().file, file());
    EXPECT_EQ(workbench.settings().text("camera.range"), "1234");
    answer = 1;
    EXPECT_TRUE(opens(other));
    EXPECT_EQ(workbench.project().file, other);
}

TEST_F(ProjectFilesTest, KeepsARecoveryCopyBesideTheFileNeverOverIt) {
    openSample();
    const std::string before = readTextFile(file());
    window->files().recovery().setDelay(0);
    edit();
    const auto copy = RecoveryCopy::pathFor(file());
    ASSERT_TRUE(test::waitUntil([&] { return std::filesystem::exists(copy); }, 5));
    EXPECT_EQ(copy.parent_path(), folder);
    EXPECT_EQ(readTextFile(file()), before);
    EXPECT_EQ(loadProject(copy).settings.text("camera.range"), "1234");
    trigger("saveProject");
    EXPECT_FALSE(std::filesystem::exists(copy));
    EXPECT_FALSE(std::filesystem::exists(copy.string() + ".lock"));
}

TEST_F(ProjectFilesTest, OffersWhatACrashLeftBehind) {
    struct Row {
        const char* name;
        int answer;
        const char* range;
        bool opened, modified, copyStays;
    };
    for (const Row& row : {Row{"recover", 0, "1234", true, true, true},
                           Row{"discard", 1, "1000", true, false, false},
                           Row{"cancel", -1, "", false, false, true}}) {
        Workbench bench;
        Dialogs dialogs = people;
        MainWindow fresh(bench, dialogs);
        const auto project = test::writeSampleProject(test::freshFolder("crashed"));
        Project left = loadProject(project);
        left.settings.set("camera.range", "1234");
        saveProject(left, RecoveryCopy::pathFor(project));
        asked.clear();
        answer = row.answer;
        EXPECT_EQ(fresh.open(project), row.opened) << row.name;
        EXPECT_EQ(asked, QStringList{"Recover unsaved changes"}) << row.name;
        EXPECT_EQ(bench.hasProject(), row.opened) << row.name;
        if (row.opened) {
            EXPECT_EQ(bench.settings().text("camera.range"), row.range) << row.name;
        }
        EXPECT_EQ(bench.isModified(), row.modified) << row.name;
        EXPECT_EQ(std::filesystem::exists(RecoveryCopy::pathFor(project)), row.copyStays)
            << row.name;
        EXPECT_EQ(loadProject(project).settings.text("camera.range"), "1000") << row.name;
    }
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(ProjectFilesTest, ADamagedRecoveryCopyIsToldAndTheSavedProjectOpened) {
    const auto project = test::writeSampleProject(folder);
    std::ofstream(RecoveryCopy::pathFor(project)) << "{ not a project";
    EXPECT_TRUE(opens(project));
    ASSERT_FALSE(told.isEmpty());
    EXPECT_TRUE(told.front().contains("ship.smat.recovery"));
    EXPECT_TRUE(asked.isEmpty());
    EXPECT_EQ(workbench.settings().text("camera.range"), "1000");
}

TEST_F(ProjectFilesTest, OffersANewProjectThatACrashLeftBehind) {
    const auto copy = RecoveryCopy::pathFor({});
    Project left = projectOfModel(sample("ship.flt"));
    left.title = "Never saved";
    std::filesystem::create_directories(copy.parent_path());
    saveProject(left, copy);
    answer = 0;
    window->begin({});
    RecoverySlot::remove(copy);
    ASSERT_TRUE(workbench.hasProject());
    EXPECT_EQ(workbench.project().title, "Never saved");
    EXPECT_TRUE(workbench.project().file.empty());
    EXPECT_TRUE(workbench.isModified());
    EXPECT_TRUE(std::filesystem::exists(workbench.project().models.front().file));
}

TEST_F(ProjectFilesTest, AskedBeforeReplacingWhatAnotherProgramWrote) {
    openSample();
    edit();
    Project other = loadProject(file());
    other.title = "Written elsewhere";
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    saveProject(other, file());
    answer = -1;
    trigger("saveProject");
    EXPECT_EQ(asked, QStringList{"Changed by another program"});
    EXPECT_EQ(loadProject(file()).title, "Written elsewhere");
    EXPECT_TRUE(workbench.isModified());
    answer = 0;
    trigger("saveProject");
    EXPECT_EQ(loadProject(file()).settings.text("camera.range"), "1234");
}

TEST_F(ProjectFilesTest, AnotherWindowIsNotOfferedWhatThisOneIsAtWorkOn) {
    openSample();
    edit();
    window->files().recovery().writeNow();
    const std::string copy = readTextFile(RecoveryCopy::pathFor(file()));
    EXPECT_TRUE(RecoveryCopy::isInUse(file()));
    EXPECT_TRUE(RecoveryCopy::leftBehind(file()).empty());

    Workbench bench;
    MainWindow other(bench, people);
    QStringList said;
    QObject::connect(&other.files(), &ProjectFiles::said,
                     [&](const QString& sentence) { said << sentence; });
    EXPECT_TRUE(other.open(file()));
    EXPECT_TRUE(asked.isEmpty());
    EXPECT_TRUE(said.join(' ').contains("another window")) << said.join(' ').toStdString();
    EXPECT_EQ(bench.settings().text("camera.range"), "1000");
    // Nor does it write over the other's copy: its own lies beside it.
    bench.set("camera.range", "77");
    other.files().recovery().writeNow();
    EXPECT_EQ(readTextFile(RecoveryCopy::pathFor(file())), copy);
    EXPECT_EQ(loadProject(RecoveryCopy::pathFor(file(), 2)).settings.text("camera.range"), "77");
    other.files().recovery().forget();
    EXPECT_EQ(readTextFile(RecoveryCopy::pathFor(file())), copy);
    EXPECT_FALSE(std::filesystem::exists(RecoveryCopy::pathFor(file(), 2)));
}

TEST_F(ProjectFilesTest, AnInternalErrorKeepsUnsavedChanges) {
    openSample();
    edit();
    window->tellInternalError("a promise was broken");
    EXPECT_TRUE(told.front().contains("a promise was broken"));
    EXPECT_EQ(loadProject(RecoveryCopy::pathFor(file())).settings.text("camera.range"), "1234");
}

TEST_F(ProjectFilesTest, RecentFilesThatAreGoneAreShownAsSuch) {
    openSample();
    const auto gone = folder / "gone & away.smat";
    std::filesystem::copy_file(file(), gone);
    EXPECT_TRUE(opens(gone));
    std::filesystem::remove(gone);
    auto* menu = window->findChild<QMenu*>("recentFiles");
    emit menu->aboutToShow();
    ASSERT_GE(menu->actions().size(), 2);
    EXPECT_FALSE(menu->actions()[0]->isEnabled());
    EXPECT_TRUE(menu->actions()[0]->text().contains("gone && away.smat"));
    EXPECT_TRUE(menu->actions()[1]->isEnabled());
}

TEST_F(ProjectFilesTest, BeginsAProjectFromAModel) {
    onDialog = [&](QDialog& dialog) {
        auto& form = dynamic_cast<NewProjectDialog&>(dialog);
        EXPECT_FALSE(form.isAcceptable());
        chosen = QString::fromStdString(sample("ship.flt").string());
        form.findChild<QAbstractButton*>("model.browse")->click();
        EXPECT_TRUE(form.isAcceptable());
        EXPECT_TRUE(form.findChild<QLineEdit*>("database")->text().endsWith("ship.sigdb"));
        EXPECT_EQ(form.findChild<QLineEdit*>("title")->text(), "ship");
        test::keepScreenshot(dialog, "dialog-new-project");
    };
    trigger("newProject");
    ASSERT_TRUE(workbench.hasProject());
    EXPECT_TRUE(workbench.project().file.empty());
    EXPECT_TRUE(window->isWindowModified());
    onDialog = {};
    chosen = QString::fromStdString((folder / "begun.smat").string());
    trigger("saveProject"); // without a file yet, asks for a name
    EXPECT_FALSE(window->isWindowModified());
    const Project saved = loadProject(folder / "begun.smat");
    EXPECT_TRUE(
        std::filesystem::equivalent(saved.resolve(saved.models.front().file), sample("ship.flt")));
}

TEST_F(ProjectFilesTest, LookingAtABareModelLeavesNothingToSave) {
    chosen = QString::fromStdString(sample("ship.flt").string());
    trigger("openModel");
    ASSERT_TRUE(workbench.hasProject());
    window->sceneView()->showWholeModel();
    QTest::keyClick(window->sceneView(), Qt::Key_Right);
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_TRUE(window->close());
    EXPECT_TRUE(asked.isEmpty());
}

TEST_F(ProjectFilesTest, TakesWhatIsDropped) {
    drop(test::writeSampleProject(folder));
    EXPECT_EQ(workbench.project().displayName(), "ship.smat");
    drop(sample("ship.flt"));
    EXPECT_TRUE(workbench.project().file.empty());
    QStringList opened;
    window->openWith({"ir1", "ir2"}, [&](const std::filesystem::path& path) {
        opened << QString::fromStdString(path.filename().string());
        return true;
    });
    drop(folder / "a.ir1");
    drop(folder / "b.IR2");
    EXPECT_EQ(opened, (QStringList{"a.ir1", "b.IR2"}));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    drop(folder / "notes.xyz");
    EXPECT_EQ(told.size(), 1);
}

TEST_F(ProjectFilesTest, ConvertsAModelAndSaysWhatItDid) {
    const auto out = folder / "ship.osgb";
    onDialog = [&](QDialog& dialog) {
        auto* form = dynamic_cast<ConvertModelDialog*>(&dialog);
        if (form == nullptr) {
            return;
        }
        form->setInput(QString::fromStdString(sample("ship.flt").string()));
        form->findChild<QLineEdit*>("output")->setText(QString::fromStdString(out.string()));
        form->findChild<QPushButton*>("convert")->click();
        EXPECT_TRUE(form->isRunning());
        EXPECT_TRUE(test::waitUntil([&] { return !form->isRunning(); }));
        const QString said = form->findChild<QPlainTextEdit*>("report")->toPlainText();
        EXPECT_TRUE(said.contains("polygons")) << said.toStdString();
        test::keepScreenshot(dialog, "dialog-convert");
    };
    trigger("convertModel");
    EXPECT_TRUE(std::filesystem::exists(out));
    ASSERT_TRUE(workbench.hasProject());
    EXPECT_EQ(workbench.project().models.front().file, out);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(ProjectFilesTest, ConvertsAModelOfAnotherUnitAndOtherAxes) {
    const auto out = folder / "ship.osgb";
    const auto extentOf = [](const std::filesystem::path& model) {
        const irsg::ModelShape shape = irsg::shapeOf(model);
        irsg::BoundingBox box = irsg::BoundingBox::nowhere();
        for (const irsg::Float3& corner : shape.corners) {
            box.include(irsg::toVec3(corner));
        }
        return box.max - box.min;
    };
    onDialog = [&](QDialog& dialog) {
        auto* form = dynamic_cast<ConvertModelDialog*>(&dialog);
        if (form == nullptr) {
            return;
        }
        form->setInput(QString::fromStdString(sample("ship.flt").string()));
        form->findChild<QLineEdit*>("output")->setText(QString::fromStdString(out.string()));
        EXPECT_FALSE(form->findChild<QComboBox*>("convert.origin")->isVisible());
        auto* convert = form->findChild<QPushButton*>("convert");
        auto* up = form->findChild<QComboBox*>("convert.up");
        auto* nose = form->findChild<QComboBox*>("convert.nose");
        up->setCurrentIndex(up->findText("+Y of the file"));
        nose->setCurrentIndex(nose->findText("+Y of the file"));
        EXPECT_FALSE(convert->isEnabled()) << "up and nose along one axis";
        nose->setCurrentIndex(nose->findText("+X of the file"));
        auto* unit = form->findChild<QComboBox*>("convert.unit");
        unit->setCurrentIndex(unit->count() - 1);
        form->findChild<NumberField*>("convert.unit_m")->setValue(0.5);
        EXPECT_TRUE(convert->isEnabled());
        convert->click();
        EXPECT_TRUE(test::waitUntil([&] { return !form->isRunning(); }));
        EXPECT_TRUE(form->findChild<QPlainTextEdit*>("report")->toPlainText().contains("polygons"));
    };
    trigger("convertModel");
    const irsg::Vec3 before = extentOf(sample("ship.flt")), after = extentOf(out);
    EXPECT_NEAR(after.y, 0.5 * before.x, 1e-4);
    EXPECT_NEAR(after.z, 0.5 * before.y, 1e-4);
    EXPECT_NEAR(after.x, 0.5 * before.z, 1e-4);
}

TEST_F(ProjectFilesTest, AConversionThatFailsSaysWhyAndOpensNothing) {
    onDialog = [&](QDialog& dialog) {
        auto* form = dynamic_cast<ConvertModelDialog*>(&dialog);
        ASSERT_NE(form, nullptr);
        form->setInput(QString::fromStdString(sample("ship.flt").string()));
        form->findChild<QLineEdit*>("output")->setText("/no/such/folder/ship.osgb");
        form->findChild<QPushButton*>("convert")->click();
        EXPECT_TRUE(test::waitUntil([&] { return !form->isRunning(); }));
        EXPECT_TRUE(
            form->findChild<QPlainTextEdit*>("report")->toPlainText().contains("/no/such/folder"));
    };
    trigger("convertModel");
    EXPECT_FALSE(workbench.hasProject());
}

TEST_F(ProjectFilesTest, ACancelledConversionAnswersAtOnceAndWritesNothing) {
    const auto out = folder / "converted" / "ship.osgb";
    std::filesystem::create_directories(out.parent_path());
    // No thread is free, so that no conversion is over before it is cancelled.
    QSemaphore leave;
    const int threads = backgroundPool().maxThreadCount();
    for (int i = 0; i < threads; ++i) {
        backgroundPool().start([&leave] { leave.acquire(); });
    }
    const auto convert = [&](QDialog& dialog) {
        auto& form = dynamic_cast<ConvertModelDialog&>(dialog);
        form.setInput(QString::fromStdString(sample("ship.flt").string()));
        form.findChild<QLineEdit*>("output")->setText(QString::fromStdString(out.string()));
        form.findChild<QPushButton*>("convert")->click();
        EXPECT_TRUE(form.isRunning());
        const auto* elapsed = form.findChild<QLabel*>("elapsed");
        EXPECT_TRUE(elapsed->isVisible() && elapsed->text().endsWith(" s"))
            << elapsed->text().toStdString();
    };
    onDialog = [&](QDialog& dialog) {
        convert(dialog);
        auto* close = dialog.findChild<QPushButton*>("close");
        EXPECT_EQ(close->text(), "&Cancel");
        close->click();
        EXPECT_FALSE(dynamic_cast<ConvertModelDialog&>(dialog).isRunning());
        EXPECT_TRUE(dialog.isVisible());
        EXPECT_EQ(close->text(), "&Close");
        EXPECT_TRUE(
            dialog.findChild<QPlainTextEdit*>("report")->toPlainText().contains("Cancelled"));
        // Another one, given up with the dialog.
        convert(dialog);
    };
    trigger("convertModel");
    leave.release(threads);
    EXPECT_TRUE(backgroundPool().waitForDone(60000));
    EXPECT_TRUE(std::filesystem::is_empty(out.parent_path()));
    EXPECT_FALSE(workbench.hasProject());
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

} // namespace
} // namespace smat::gui
