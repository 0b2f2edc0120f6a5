#include "gui/project/SceneTreeDock.h"

#include <algorithm>

#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/database/DatabaseDock.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

bool hasMissing(const ModelIndex& index) {
    const auto missing = [](const auto& use) { return use.second.isMissing(); };
    return std::ranges::any_of(index.temperatures, missing) ||
           std::ranges::any_of(index.materials, missing);
}

TEST(SceneIndexTest, PutsWhatAModelUsesBesideWhatADatabaseHas) {
    irsg::SignatureDatabase database;
    database.temperatures[1].name = "hull";
    database.temperatures[7].name = "spare";
    database.materials[2].name = "paint";
    const ModelCodes codes{{{1, 2}, {10, 4.0}}, {{1, 3}, {5, 1.5}}, {{9, 2}, {1, 0.25}}};
    ProjectModel model;
    ModelIndex index = makeModelIndex(model, codes, database);
    EXPECT_EQ(index.temperatures.at(1).faces, 15);
    EXPECT_EQ(index.temperatures.at(1).area_m2, 5.5);
    EXPECT_EQ(index.temperatures.at(1).name, "hull");
    EXPECT_EQ(index.materials.at(2).faces, 11);
    EXPECT_TRUE(index.temperatures.at(9).isMissing());
    EXPECT_TRUE(index.materials.at(3).isMissing());
    EXPECT_FALSE(index.temperatures.at(7).isMissing());
    EXPECT_EQ(index.temperatures.at(7).faces, 0);

    model.fallbackTemperature = 1;
    model.fallbackMaterial = 44; // no such entry: nothing stands in
    index = makeModelIndex(model, codes, database);
    EXPECT_FALSE(index.temperatures.at(9).isMissing());
    EXPECT_TRUE(index.materials.at(3).isMissing());
}

class SceneTreeTest : public test::WindowFixture {
  protected:
    void wait() {
        ASSERT_TRUE(test::waitUntil([this] { return !window->tree().isLoading(); }));
    }
    QTreeWidgetItem* find(const QString& start) {
        for (QTreeWidgetItemIterator it(window->findChild<QTreeWidget*>("sceneTree")); *it; ++it) {
            if ((*it)->text(0).startsWith(start)) {
                return *it;
            }
        }
        return nullptr;
    }
};

TEST_F(SceneTreeTest, ShowsModelsIndicesSensorAirAndAnalyses) {
    ASSERT_TRUE(
        opens(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/turboprop4/turboprop4.smat"));
    wait();
    const auto database = irsg::loadSignatureFile(std::filesystem::path(SMAT_SOURCE_DIR) /
                                                  "samples/turboprop4/turboprop4.sigdb")
                              .database;
    const auto& [number, entry] = *database.temperatures.begin();
    EXPECT_NE(find(QString("%1  %2").arg(number).arg(QString::fromStdString(entry.name))), nullptr);
    for (const auto* start : {"Sensor", "Atmosphere", "Sun", "Analyses", "polar", "Materials"}) {
        EXPECT_NE(find(start), nullptr) << start;
    }
    EXPECT_FALSE(hasMissing(window->tree().index().front()));
    find("Temperatures")->setExpanded(true);
    find("Materials")->setExpanded(true);
    test::keepScreenshot(*window, "window-scene-tree");
    // What a person has opened stays open when the project is saved or edited.
    Project changed = workbench.project();
    changed.title = "Renamed";
    workbench.edit(changed, "Rename");
    EXPECT_NE(find("Renamed"), nullptr);
    EXPECT_TRUE(find("Materials")->isExpanded());
}

TEST_F(SceneTreeTest, SelectingAnIndexTellsWhichAndPickingSelectsIt) {
    openSample();
    wait();
    std::vector<std::tuple<IndexKind, int, int>> selected;
    QObject::connect(
        &window->tree(), &SceneTreeDock::indexSelected,
        [&](IndexKind kind, int index, int model) { selected.emplace_back(kind, index, model); });
    const int number = window->tree().index().front().materials.begin()->first;
    find("Materials")->child(0)->setSelected(true);
    ASSERT_EQ(selected.size(), 1U);
    EXPECT_EQ(selected.front(), std::tuple(IndexKind::material, number, 0));
    const int temperature = window->tree().index().front().temperatures.begin()->first;
    window->tree().showIndex(IndexKind::temperature, temperature);
    EXPECT_EQ(selected.size(), 1U);
    EXPECT_TRUE(find("Temperatures")->child(0)->isSelected());
}

TEST_F(SceneTreeTest, AnIndexIsSelectedInTheEditorAndItsFacesAreMarked) {
    openSample();
    wait();
    auto& editor = window->databaseEditor();
    SceneView& view = *window->sceneView();
    const auto check = [&](const char* group, EntryKind kind) {
        auto* branch = find(group);
        for (int i = 0; i < branch->childCount(); ++i) {
            const int number = branch->child(i)->text(0).section(' ', 0, 0).toInt();
            branch->treeWidget()->setCurrentItem(branch->child(i));
            ASSERT_TRUE(editor.current().has_value());
            EXPECT_EQ(*editor.current(), (EntryKey{kind, number})) << group;
            const FaceSelection marked = view.highlighted();
            EXPECT_EQ(kind == EntryKind::material ? marked.material : marked.temperature, number);
            EXPECT_EQ(marked.model, 0);
        }
    };
    check("Temperatures", EntryKind::temperature);
    check("Materials", EntryKind::material);

    // Enter brings the editor to the front.
    editor.hide();
    emit find("Materials")->treeWidget()->itemActivated(find("Materials")->child(0), 0);
    EXPECT_TRUE(editor.isVisible());

    // A face that is picked: tree, both lists of the editor, and the mark name the same.
    view.showWholeModel();
    QTest::qWait(50);
    const auto hits = view.facesAt(view.rect().center());
    ASSERT_FALSE(hits.empty());
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    QTest::qWait(20);
    const auto codes = hits.front().codes;
    EXPECT_EQ(view.highlighted(), (FaceSelection{codes.temperature, codes.material, 0}));
    EXPECT_TRUE(find("Temperatures")
                    ->treeWidget()
                    ->currentItem()
                    ->text(0)
                    .startsWith(QString::number(codes.temperature) + " "));
    for (const auto& [kind, index] : {std::pair(EntryKind::material, codes.material),
                                      std::pair(EntryKind::temperature, codes.temperature)}) {
        editor.tabs()->setCurrentIndex(static_cast<int>(kind));
        EXPECT_EQ(*editor.current(), (EntryKey{kind, index}));
    }
}

TEST_F(SceneTreeTest, ShowsTheEntriesAsTheyAreEdited) {
    // A copy: editing writes beside the file.
    const auto ship = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship";
    for (const char* name : {"ship.flt", "ship.sigdb"}) {
        std::filesystem::copy_file(ship / name, folder / name);
    }
    saveProject(projectOfModel(folder / "ship.flt", folder / "ship.sigdb"), folder / "ship.smat");
    ASSERT_TRUE(window->open(folder / "ship.smat"));
    wait();
    auto& session = workbench.database();
    const int number = session.value().materials.begin()->first;
    window->findChild<QTreeWidget*>("sceneTree")->setCurrentItem(find("Materials")->child(1));
    const QString chosenText = find("Materials")->child(1)->text(0);
    session.edit("rename", [&](auto& database) { database.materials[number].name = "fresh"; });
    EXPECT_NE(find(QString("%1  fresh").arg(number)), nullptr);
    EXPECT_EQ(window->findChild<QTreeWidget*>("sceneTree")->currentItem()->text(0), chosenText)
        << "what is selected stays";
    workbench.undoStack().undo();
    EXPECT_EQ(find(QString("%1  fresh").arg(number)), nullptr);
    session.discard();
}

TEST_F(SceneTreeTest, MarksFilesThatAreMissingAndTakesOthers) {
    const auto file = test::writeSampleProject(folder);
    Project project = loadProject(file);
    const auto model = project.models.front();
    project.models.front().file = "vanished.flt";
    project.models.front().database = "vanished.sigdb";
    saveProject(project, file);
    opens(file);
    wait();
    EXPECT_FALSE(told.isEmpty());
    EXPECT_TRUE(told.join(' ').contains("vanished.flt"));
    EXPECT_TRUE(window->tree().index().front().modelProblem.contains("vanished.flt"));
    EXPECT_TRUE(window->tree().index().front().databaseProblem.contains("vanished.sigdb"));
    test::keepScreenshot(*window, "window-missing-files");

    // Enter on what is marked repairs it, as a step to undo.
    told.clear();
    auto* tree = window->findChild<QTreeWidget*>("sceneTree");
    chosen = QString::fromStdString(
        (std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.flt").string());
    emit tree->itemActivated(find("ship"), 0);
    wait();
    chosen.replace(".flt", ".sigdb");
    emit tree->itemActivated(find("vanished.sigdb"), 0);
    wait();
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_TRUE(window->tree().index().front().modelProblem.isEmpty());
    EXPECT_FALSE(hasMissing(window->tree().index().front()));
    EXPECT_EQ(workbench.undoStack().count(), 2);
    EXPECT_EQ(workbench.undoStack().undoText(), "Use database ship.sigdb");
}

TEST_F(SceneTreeTest, FollowsADatabaseThatIsEdited) {
    openSample();
    wait();
    auto database =
        irsg::loadSignatureFile(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.sigdb")
            .database;
    const int number = window->tree().index().front().materials.begin()->first;
    database.materials[number].name = "fresh paint";
    database.materials[77].name = "new";
    const int gone = window->tree().index().front().temperatures.begin()->first;
    database.temperatures.erase(gone);
    window->tree().setDatabase(0, database);
    EXPECT_NE(find(QString("%1  fresh paint").arg(number)), nullptr);
    EXPECT_NE(find("77  new"), nullptr);
    EXPECT_TRUE(window->tree().index().front().temperatures.at(gone).isMissing());
}

} // namespace
} // namespace smat::gui
