#include <algorithm>
#include <fstream>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "gui/database/CopyEntriesDialog.h"
#include "gui/database/DatabaseBanner.h"
#include "gui/database/FindingsPanel.h"
#include "gui/database/NodeEditor.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/MaterialLibrary.h"
#include "irsg/signature/ScalingXml.h"
#include "smatcore/analysis/ProjectLint.h"
#include "tests/gui/DatabaseEditorFixture.h"

namespace smat::gui {
namespace {

using test::DatabaseEditorTest;

TEST_F(DatabaseEditorTest, EveryTabInBothThemes) {
    const auto keep = [this](const QString& name) {
        QTest::qWait(60);
        test::keepScreenshot(*window, "editor-" + name.toStdString());
    };
    for (const auto theme : {ThemeMode::light, ThemeMode::dark}) {
        applyTheme(*qApp, theme);
        window.reset();
        makeWindow();
        openCopy("turboprop4", small());
        window->resize(1500, 920);
        window->resizeDocks({&dock()}, {560}, Qt::Horizontal);
        const QString ending = theme == ThemeMode::light ? "-light" : "-dark";
        QTest::qWait(30);
        dock().select({EntryKind::material, 1});
        chooseTab("materialTabs", "Emissivity");
        keep("material" + ending);
        dock().select({EntryKind::material, 2});
        chooseTab("materialTabs", "Transmissivity");
        keep("transmissivity" + ending);
        chooseTab("materialTabs", "N angle factor");
        keep("angle" + ending);
        chooseTab("materialTabs", "Surface");
        keep("surface" + ending);
        chooseTab("materialTabs", "Notes");
        keep("notes" + ending);
        dock().select({EntryKind::temperature, 2});
        chooseTab("temperatureTabs", "Result");
        keep("temperature" + ending);
        dock().select({EntryKind::temperature, 5});
        chooseTab("temperatureTabs", "Equation terms");
        int table = 0;
        for (; table < 4; ++table) {
            find<QTabBar>("termTables")->setCurrentIndex(table);
            if (!find<QWidget>("termsPanel")->findChild<NodeEditor*>()->nodes().empty()) {
                break;
            }
        }
        EXPECT_LT(table, 4) << "the exhaust pipes have one";
        keep("terms" + ending);
        for (const auto& [index, entry] : session().value().temperatures) {
            if (entry.mode == irsg::EmissionMode::userSpectrum) {
                dock().select({EntryKind::temperature, index});
            }
        }
        chooseTab("temperatureTabs", "Result");
        keep("emitted" + ending);
        chooseTab("temperatureTabs", "Factors");
        keep("factors" + ending);
        tabs()->setCurrentIndex(2);
        chooseTab("spectrumTabs", "View");
        keep("spectrum" + ending);
        chooseTab("spectrumTabs", "Table");
        keep("spectrum-table" + ending);
        tabs()->setCurrentIndex(3);
        keep("findings" + ending);
    }
    applyTheme(*qApp, ThemeMode::light);
    EXPECT_FALSE(session().isDirty()) << "looking changes nothing";
    EXPECT_FALSE(workbench.undoStack().canUndo());
}

TEST_F(DatabaseEditorTest, AddsDuplicatesRenumbersAndDeletesWithALookAtTheFaces) {
    const auto before = session().value();
    dock().select({EntryKind::material, 1});
    auto* list = tabs()->widget(0);
    find<QToolButton>("duplicateEntry", list)->click();
    const int copy = dock().current()->index;
    EXPECT_EQ(session().value().materials.at(copy), before.materials.at(1));
    find<QToolButton>("addEntry", list)->click();
    EXPECT_EQ(session().value().materials.size(), before.materials.size() + 2);

    dock().select({EntryKind::material, copy});
    QString said;
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("newKey")->setText("1");
        EXPECT_NE(dialog.findChild<QLabel*>("consequence")->text(), "") << "1 is taken";
        dialog.findChild<QLineEdit*>("newKey")->setText("77");
        said = dialog.findChild<QLabel*>("consequence")->text();
        test::keepScreenshot(dialog, "editor-renumber");
    };
    find<QToolButton>("renumberEntry", list)->click();
    EXPECT_TRUE(session().value().materials.contains(77));
    EXPECT_FALSE(session().value().materials.contains(copy));
    EXPECT_EQ(said, "No face of the model carries either index.");

    // Faces use material 1: deleting it asks.
    dock().select({EntryKind::material, 1});
    accept = false;
    onDialog = [&](QDialog& dialog) {
        said = dialog.findChild<QLabel*>("question")->text();
        test::keepScreenshot(dialog, "editor-delete");
    };
    find<QToolButton>("removeEntry", list)->click();
    EXPECT_TRUE(said.contains("faces")) << said.toStdString();
    EXPECT_TRUE(session().value().materials.contains(1));
    accept = true;
    find<QToolButton>("removeEntry", list)->click();
    EXPECT_FALSE(session().value().materials.contains(1));
    onDialog = nullptr;

    // The findings name it at once, and their button adds it.
    dock().findings()->look();
    EXPECT_GE(dock().findings()->errors(), 1);
    tabs()->setCurrentIndex(3);
    test::keepScreenshot(*window, "editor-finding-missing");
    auto* findings = find<QTreeWidget>("findings");
    const auto rows = findings->findItems("materials.1", Qt::MatchExactly);
    ASSERT_FALSE(rows.isEmpty());
    auto* repair = qobject_cast<QPushButton*>(findings->itemWidget(rows.front(), 3));
    ASSERT_NE(repair, nullptr);
    repair->click();
    EXPECT_TRUE(session().value().materials.contains(1));

    const auto edited = session().value();
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(session().value(), before);
    while (workbench.undoStack().canRedo()) {
        workbench.undoStack().redo();
    }
    EXPECT_EQ(session().value(), edited);
}

TEST_F(DatabaseEditorTest, SelectsWithViewAndTreeAndFollowsTheModelThatIsMeant) {
    Project project = workbench.editedProject();
    const auto box = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box";
    project.models.push_back(project.models.front());
    project.models.back().file = box / "box.flt";
    project.models.back().database = box / "box.sigdb";
    saveProject(project, folder / "two.smat");
    ASSERT_TRUE(opens(folder / "two.smat"));
    auto* tree = window->findChild<SceneTreeDock*>();
    ASSERT_TRUE(test::waitUntil([&] { return !tree->isLoading(); }));
    SceneView& view = *window->sceneView();
    const auto material = [](int index) { return EntryKey{EntryKind::material, index}; };
    dock().select(material(4));
    dock().select(material(1));
    EXPECT_TRUE(view.highlighted().empty()) << "marked is what a person selects, not a program";

    // A person steps down the list: the faces of the entry are marked, until an edit comes.
    QApplication::setActiveWindow(window.get());
    tabs()->setCurrentIndex(0);
    dock().select(material(1));
    auto* table = find<QTableView>("entryTable", tabs()->widget(0));
    table->setFocus();
    ASSERT_TRUE(test::waitUntil([&] { return QApplication::focusWidget() == table; }, 5.0));
    QTest::keyClick(table, Qt::Key_Down);
    ASSERT_EQ(*dock().current(), material(2));
    EXPECT_EQ(view.highlighted(), (FaceSelection{{}, 2, 0}));
    session().edit("title", [](auto& database) { database.title = "x"; });
    EXPECT_TRUE(view.highlighted().empty());

    // A face that is picked: both lists have its entries, the tree its model.
    emit view.facePicked(5, 4, 0, {});
    EXPECT_EQ(*dock().current(), material(4));
    EXPECT_EQ(view.highlighted(), (FaceSelection{5, 4, 0}));
    tabs()->setCurrentIndex(1);
    EXPECT_EQ(*dock().current(), (EntryKey{EntryKind::temperature, 5}));
    tabs()->setCurrentIndex(0);
    const auto modelInTree = [&] {
        const auto* item = tree->findChild<QTreeWidget*>()->currentItem();
        const auto* model = item == nullptr ? nullptr : item->parent()->parent();
        return model == nullptr
                   ? -1
                   : model->parent()->indexOfChild(const_cast<QTreeWidgetItem*>(model));
    };
    EXPECT_EQ(modelInTree(), 0);
    emit view.facePicked(2, 1, 1, {});
    EXPECT_EQ(*dock().current(), material(1)) << "of the database of that model";
    EXPECT_EQ(session().file(), box / "box.sigdb");
    EXPECT_EQ(view.highlighted(), (FaceSelection{2, 1, 1}));
    EXPECT_EQ(modelInTree(), 1);

    // The tree selects in the editor, which goes to the model's database; Enter brings it to the
    // front.
    emit tree->indexSelected(IndexKind::material, 3, 0);
    EXPECT_EQ(*dock().current(), material(3));
    EXPECT_EQ(view.highlighted(), (FaceSelection{{}, 3, 0}));
    emit tree->indexSelected(IndexKind::material, 1, 1);
    EXPECT_EQ(*dock().current(), material(1));
    EXPECT_EQ(session().file(), box / "box.sigdb");
    EXPECT_EQ(view.highlighted(), (FaceSelection{{}, 1, 1}));
    window->findChild<QDockWidget*>("resultsDock")->raise();
    QTest::qWait(50);
    ASSERT_TRUE(dock().visibleRegion().isEmpty());
    emit tree->indexActivated(IndexKind::material, 2, 0);
    QTest::qWait(50);
    EXPECT_FALSE(dock().visibleRegion().isEmpty());
    EXPECT_EQ(*dock().current(), material(2));
    session().discard();
}

TEST_F(DatabaseEditorTest, NamesAndNotesAreOneStepATyping) {
    dock().select({EntryKind::temperature, 1});
    type("entryName", "fuselage skin", find<QWidget>("temperaturePanel"));
    EXPECT_EQ(session().value().temperatures.at(1).name, "fuselage skin");
    EXPECT_EQ(workbench.undoStack().count(), 1);
    EXPECT_EQ(workbench.undoStack().undoText(), "Rename temperature 1");
    chooseTab("temperatureTabs", "Notes");
    auto* notes = find<QPlainTextEdit>("entryNotes", find<QWidget>("temperaturePanel"));
    notes->selectAll();
    QTest::keyClicks(notes, "measured");
    EXPECT_EQ(session().value().temperatures.at(1).notes, "measured");
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_EQ(session().value(), session().saved());
    EXPECT_EQ(notes->toPlainText().toStdString(), session().saved().temperatures.at(1).notes);
}

TEST_F(DatabaseEditorTest, AddsFromTheLibraryAndResolvesClashes) {
    const auto before = session().value();
    onDialog = [&](QDialog& dialog) {
        auto& copy = dynamic_cast<CopyEntriesDialog&>(dialog);
        copy.choose({EntryKind::material, 1});
        copy.choose({EntryKind::material, 7});
        // Index 1 is taken: replaced; 7 goes to 40.
        auto* list = copy.findChild<QTreeWidget*>("copyList");
        auto* group = list->topLevelItem(0);
        auto* clash = static_cast<QComboBox*>(list->itemWidget(group->child(0), 3));
        EXPECT_FALSE(clash->isHidden());
        clash->setCurrentIndex(1);
        static_cast<QLineEdit*>(list->itemWidget(group->child(6), 2))->setText("40");
        test::keepScreenshot(dialog, "editor-library");
    };
    find<QToolButton>("addFromLibrary")->click();
    onDialog = nullptr;
    const auto& library = irsg::materialLibrary().materials;
    EXPECT_EQ(session().value().materials.at(1), library.at(1));
    EXPECT_EQ(session().value().materials.at(40), library.at(7));
    EXPECT_EQ(session().value().materials.size(), before.materials.size() + 1);
    EXPECT_EQ(workbench.undoStack().count(), 1);
    workbench.undoStack().undo();
    EXPECT_EQ(session().value(), before);
}

TEST_F(DatabaseEditorTest, CopiesFromAnotherDatabase) {
    const auto box = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box/box.sigdb";
    const auto source = irsg::loadSignatureFile(box).database;
    chosen = QString::fromStdString(box.string());
    onDialog = [&](QDialog& dialog) {
        dynamic_cast<CopyEntriesDialog&>(dialog).choose({EntryKind::temperature, 2});
        test::keepScreenshot(dialog, "editor-copy");
    };
    find<QAction>("copyFromDatabase")->trigger();
    onDialog = nullptr;
    const auto key = dock().current();
    ASSERT_TRUE(key.has_value());
    EXPECT_NE(key->index, 2) << "2 is taken: the next free one";
    EXPECT_EQ(session().value().temperatures.at(key->index), source.temperatures.at(2));
}

TEST_F(DatabaseEditorTest, FollowsTheFileThatTheProjectNames) {
    const auto own = session().file();
    const auto other = folder / "other.sigdb";
    auto value = session().value();
    value.title = "other";
    irsg::saveSignatureFile(value, other);
    chosen = QString::fromStdString(other.string());
    window->findChild<QAction*>("openDatabase")->trigger();
    EXPECT_EQ(session().file(), other);
    EXPECT_EQ(workbench.undoStack().undoText(), "Use database other.sigdb");
    workbench.undoStack().undo();
    EXPECT_EQ(session().file(), own);
    workbench.undoStack().redo();
    EXPECT_EQ(session().value().title, "other");
}

TEST_F(DatabaseEditorTest, FindsWhatTheCommandLineFindsWithTheWholeProject) {
    // An analysis in a band that the paints have no values for, and one at a Mach number beyond
    // the tables; an entry that the faces of a second model alone carry.
    Project project = workbench.editedProject();
    Settings far = project.settings, fast = project.settings;
    far.set("sensor.band", "15-20");
    fast.set("state.mach", "2.5");
    project.analyses = {{"far", AnalysisKind::polar, far}, {"fast", AnalysisKind::image, fast}};
    std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box/box.flt",
                               folder / "box.flt");
    project.models.push_back(project.models.front());
    project.models.back().file = "box.flt";
    saveProject(project, folder / "turboprop4.smat");
    auto* list = find<QTreeWidget>("findings");
    EXPECT_EQ(list->topLevelItemCount(), 0);
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));

    SceneBuilder builder;
    const auto expected =
        irsg::lint(session().value(), lintScopeOf(project, session().file(), builder));
    ASSERT_GT(expected.size(), 2U);
    const auto found = [&] {
        QStringList places;
        for (int i = 0; i < list->topLevelItemCount(); ++i) {
            places << list->topLevelItem(i)->text(0) + ": " + list->topLevelItem(i)->text(2);
        }
        return places;
    };
    QStringList places;
    bool band = false, state = false;
    for (const auto& finding : expected) {
        places << QString::fromStdString(finding.place + ": " + finding.reason);
        band = band || finding.reason.find("15") != std::string::npos;
        state = state || finding.value.find("fast") != std::string::npos ||
                finding.reason.find("fast") != std::string::npos;
    }
    EXPECT_TRUE(band) << places.join('\n').toStdString();
    EXPECT_TRUE(test::waitUntil([&] { return found() == places; }, 10.0))
        << found().join('\n').toStdString() << "\n---\n"
        << places.join('\n').toStdString();

    // Without the analysis its findings go.
    Project less = workbench.editedProject();
    less.analyses.clear();
    workbench.edit(less, "remove analyses");
    EXPECT_TRUE(test::waitUntil([&] { return list->topLevelItemCount() < places.size(); }, 10.0));
}

TEST_F(DatabaseEditorTest, FindsFaultWithTheScalesBesideTheModel) {
    auto* list = find<QTreeWidget>("findings");
    ASSERT_EQ(list->topLevelItemCount(), 0);
    const int material = session().value().materials.begin()->first;
    irsg::ScalingTable table;
    table[material].distribution = irsg::Distribution(irsg::DistributionKind::uniform, 0.5, 20.0);
    table[4711].distribution = irsg::Distribution(irsg::DistributionKind::uniform, 0.9, 1.1);
    std::ofstream(irsg::scalingFile(folder / "turboprop4.flt", irsg::ScalingKind::emissivity))
        << irsg::scalingXml(table);
    // Looked at with the next edit.
    session().edit("title", [](auto& database) { database.title = "x"; });
    ASSERT_TRUE(test::waitUntil([&] { return list->topLevelItemCount() > 0; }, 5.0));
    ASSERT_EQ(list->topLevelItemCount(), 2);
    EXPECT_TRUE(list->topLevelItem(0)->text(0).contains("(emissivitiesScalings).xml"));
    EXPECT_TRUE(list->topLevelItem(0)->text(1).contains("times 20"));
    EXPECT_TRUE(list->topLevelItem(1)->text(2).contains("that the database has"));
    // A double click goes to the entry.
    dock().tabs()->setCurrentIndex(3);
    test::keepScreenshot(*window, "database-findings-scales");
    emit list->itemActivated(list->topLevelItem(0), 0);
    ASSERT_TRUE(dock().current().has_value());
    EXPECT_EQ(*dock().current(), (EntryKey{EntryKind::material, material}));
    session().discard();
}

} // namespace
} // namespace smat::gui
