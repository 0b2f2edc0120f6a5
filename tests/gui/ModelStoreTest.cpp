#include <atomic>
#include <latch>
#include <semaphore>
#include <thread>

#include "gui/project/SceneTreeDock.h"
#include "gui/tools/RadiativePage.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/workbench/ModelStore.h"
#include "irsg/core/Errors.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

const fs::path box = fs::path(SMAT_SOURCE_DIR) / "samples/box/box.flt";

irsg::InputError damaged() {
    return irsg::InputError({"box.flt", "byte 12", "a damaged record", "a whole one"});
}

TEST(ModelStoreTest, ThoseWhoAskAtTheSameTimeShareOneReading) {
    std::binary_semaphore mayEnd(0);
    ModelStore store([&](const ModelKey& key) {
        mayEnd.acquire();
        return irsg::Model::load(key.file);
    });
    constexpr int askers = 4;
    std::vector<std::shared_ptr<const irsg::Model>> models(askers);
    std::latch asking(askers);
    {
        std::vector<std::jthread> threads;
        for (auto& model : models) {
            threads.emplace_back([&] {
                asking.count_down();
                model = store.model({box});
            });
        }
        asking.wait();
        EXPECT_FALSE(store.isThere({box}));
        mayEnd.release();
    }
    EXPECT_TRUE(store.isThere({box}));
    EXPECT_EQ(store.readings(), 1);
    for (const auto& model : models) {
        ASSERT_NE(model, nullptr);
        EXPECT_EQ(model, models.front());
    }
}

TEST(ModelStoreTest, AFileThatWasWrittenSinceIsReadAnew) {
    const fs::path file = test::freshFolder("model-store") / "box.flt";
    fs::copy_file(box, file, fs::copy_options::overwrite_existing);
    ModelStore store;
    const auto before = store.model({file});
    EXPECT_EQ(store.model({file}), before);
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(2));
    EXPECT_FALSE(store.isThere({file}));
    EXPECT_NE(store.model({file}), before);
    EXPECT_EQ(store.readings(), 2);
}

TEST(ModelStoreTest, TheSameFileReadInAnotherWayIsAnotherModel) {
    ModelStore store;
    const auto ahead = store.model({box});
    EXPECT_NE(store.model({box, {.placing = {.nose = irsg::ModelAxis::plusX}}}), ahead);
    EXPECT_NE(store.model({box, {.forceTwoSided = true}}), ahead);
    EXPECT_EQ(store.readings(), 3);
}

TEST(ModelStoreTest, AFailureIsToldAndTheNextOneWhoAsksReadsAnew) {
    std::atomic<bool> isDamaged = true;
    ModelStore store([&](const ModelKey& key) -> std::shared_ptr<const irsg::Model> {
        if (isDamaged) {
            throw damaged();
        }
        return irsg::Model::load(key.file);
    });
    EXPECT_THROW(store.model({box}), irsg::InputError);
    EXPECT_FALSE(store.isThere({box}));
    isDamaged = false;
    EXPECT_NE(store.model({box}), nullptr);
    EXPECT_EQ(store.readings(), 2);
}

TEST(ModelStoreTest, LetsGoOfTheModelsOfAProjectThatWasClosed) {
    ModelStore store;
    std::weak_ptr<const irsg::Model> kept = store.model({box});
    std::weak_ptr<const irsg::Model> gone =
        store.model({box, {.placing = {.nose = irsg::ModelAxis::plusX}}});
    store.keepOnly({{box}});
    EXPECT_FALSE(kept.expired());
    EXPECT_TRUE(gone.expired());
    EXPECT_TRUE(store.isThere({box}));
}

class SharedModelTest : public test::DatabaseFixture {};

TEST_F(SharedModelTest, ViewTreeEditorAndToolsReadTheModelOnce) {
    openCopy("ship", {});
    ASSERT_TRUE(test::waitUntil([&] { return !window->tree().isLoading(); }));
    RadiativePage page(workbench, people);
    backgroundPool().waitForDone();
    QTest::qWait(20);
    EXPECT_EQ(workbench.models()->readings(), 1);

    // A project of another model lets go of the first.
    const ModelKey ship{folder / "ship.flt"};
    EXPECT_TRUE(workbench.models()->isThere(ship));
    openCopy("box", {});
    EXPECT_FALSE(workbench.models()->isThere(ship));
}

TEST_F(SharedModelTest, AModelThatIsChosenAnewIsCountedInTheEditor) {
    openCopy("ship", {});
    const auto faces = [this] {
        const auto* rows =
            dock().tabs()->widget(0)->findChild<QAbstractItemView*>("entryTable")->model();
        QStringList all;
        for (int row = 0; row < rows->rowCount(); ++row) {
            all << rows->index(row, 2).data().toString();
        }
        return all;
    };
    const QStringList ofShip = faces();
    EXPECT_FALSE(ofShip.contains("–"));
    fs::copy_file(box, folder / "box.flt", fs::copy_options::overwrite_existing);
    Project project = workbench.project();
    project.models.front().file = folder / "box.flt";
    workbench.edit(project, "Choose a model");
    ASSERT_TRUE(waitForModel());
    EXPECT_FALSE(faces().contains("–"));
    EXPECT_NE(faces(), ofShip);
    workbench.undoStack().undo();
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(faces(), ofShip);
}

TEST_F(SharedModelTest, AModelThatVanishesIsToldAndNoEditIsLost) {
    openCopy("ship", {});
    const int index = session().value().temperatures.begin()->first;
    dock().select({EntryKind::temperature, index});
    chooseTab("temperatureTabs", "Equation terms");
    type("base_K", "345.5");
    fs::remove(folder / "ship.flt");
    Project project = workbench.project();
    project.models.front().options.forceTwoSided = true;
    workbench.edit(project, "Force two sides");
    ASSERT_TRUE(waitForModel());
    ASSERT_FALSE(told.isEmpty());
    EXPECT_TRUE(told.join(' ').contains("ship.flt")) << told.join('\n').toStdString();
    told.clear();
    EXPECT_TRUE(session().isDirty());
    EXPECT_EQ(session().value().temperatures.at(index).terms.base_K, 345.5);
    session().save();
    EXPECT_EQ(
        irsg::loadSignatureFile(folder / "ship.sigdb").database.temperatures.at(index).terms.base_K,
        345.5);
}

/// The editor beside a model that takes its time.
class SlowModelTest : public ::testing::Test {
  protected:
    SlowModelTest() { workbench.open(project()); }
    ~SlowModelTest() override {
        mayEnd.release();
        backgroundPool().waitForDone();
    }
    fs::path project() {
        const fs::path folder = test::freshFolder("slow-model");
        for (const char* name : {"box.flt", "box.sigdb"}) {
            fs::copy_file(box.parent_path() / name, folder / name,
                          fs::copy_options::overwrite_existing);
        }
        return folder / "box.flt";
    }
    QString facesOfFirst() {
        const auto* view = dock.tabs()->widget(0)->findChild<QAbstractItemView*>("entryTable");
        return view->model()->index(0, 2).data().toString();
    }

    std::counting_semaphore<> mayEnd{0};
    std::atomic<bool> isDamaged = false;
    Workbench workbench{openRenderDoor, nullptr,
                        std::make_shared<ModelStore>(
                            [this](const ModelKey& key) -> std::shared_ptr<const irsg::Model> {
                                mayEnd.acquire();
                                if (isDamaged) {
                                    throw damaged();
                                }
                                return irsg::Model::load(key.file);
                            })};
    DatabaseDock dock{workbench, {}, nullptr};
};

TEST_F(SlowModelTest, TheEditorDoesNotWaitForTheModelAndCountsItsFacesWhenItIsThere) {
    EXPECT_TRUE(dock.isReadingModel());
    ASSERT_TRUE(workbench.database().isOpen());
    EXPECT_EQ(facesOfFirst(), "–");
    mayEnd.release();
    ASSERT_TRUE(test::waitUntil([&] { return !dock.isReadingModel(); }));
    EXPECT_GT(facesOfFirst().toInt(), 0);
}

TEST_F(SlowModelTest, TheDatabaseOfADamagedModelCanBeEdited) {
    isDamaged = true;
    mayEnd.release();
    ASSERT_TRUE(test::waitUntil([&] { return !dock.isReadingModel(); }));
    EXPECT_EQ(facesOfFirst(), "–");
    EXPECT_TRUE(workbench.database().isOpen());
}

} // namespace
} // namespace smat::gui
