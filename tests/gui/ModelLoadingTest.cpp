#include <QLabel>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTimer>

#include "gui/view/SceneLoader.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/HeldPool.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

const std::filesystem::path samples = std::filesystem::path(SMAT_SOURCE_DIR) / "samples";

/// A project that takes its time: the aircraft many times over.
Project large(std::size_t models = 40) {
    Project project;
    project.models.assign(models, {.file = samples / "turboprop4/turboprop4.flt",
                                   .database = samples / "turboprop4/turboprop4.sigdb"});
    return project;
}

Project small() {
    Project project;
    project.models = {{.file = samples / "ship/ship.flt", .database = {}}};
    return project;
}

TEST(SceneLoaderTest, AnotherProjectSupersedesTheOneThatIsBeingRead) {
    SceneLoader loader(std::make_shared<ModelStore>());
    std::vector<std::size_t> counts;
    QObject::connect(&loader, &SceneLoader::loaded,
                     [&](const std::shared_ptr<DisplayScene>& scene) {
                         counts.push_back(scene->models.size());
                     });
    const QSignalSpy failed(&loader, &SceneLoader::failed);
    loader.load(large(), {});
    EXPECT_TRUE(loader.isBusy());
    loader.load(small(), {});
    ASSERT_TRUE(test::waitUntil([&] { return !loader.isBusy(); }));
    // What the first one still reads is dropped when it comes.
    backgroundPool().waitForDone();
    QTest::qWait(20);
    EXPECT_EQ(counts, std::vector<std::size_t>{1});
    EXPECT_TRUE(failed.isEmpty());
}

TEST(SceneLoaderTest, TellsOfAllModelsThatCannotBeRead) {
    SceneLoader loader(std::make_shared<ModelStore>());
    QStringList sentences;
    QObject::connect(&loader, &SceneLoader::failed, [&](const QStringList& s) { sentences = s; });
    Project project = small();
    project.models.push_back({.file = "/nowhere/gone.flt", .database = {}});
    project.models.push_back({.file = "/nowhere/away.flt", .database = {}});
    loader.load(project, {});
    ASSERT_TRUE(test::waitUntil([&] { return !loader.isBusy(); }));
    EXPECT_TRUE(sentences.join(' ').contains("gone.flt"));
    EXPECT_TRUE(sentences.join(' ').contains("away.flt"));
}

class ModelLoadingTest : public test::WindowFixture {};

TEST_F(ModelLoadingTest, TheWindowLivesWhileALargeModelIsRead) {
    saveProject(large(), folder / "large.smat");
    int beats = 0;
    QTimer heart;
    QObject::connect(&heart, &QTimer::timeout, [&] { beats += window->isLoadingModel() ? 1 : 0; });
    heart.start(1);
    auto* label = window->findChild<QLabel*>("loadingWords");
    {
        const test::HeldPool nothingIsRead;
        ASSERT_TRUE(window->open(folder / "large.smat"));
        EXPECT_TRUE(window->isLoadingModel());
        // Settings that change meanwhile count for what is shown then.
        workbench.set("target.altitude", "321");
        EXPECT_TRUE(test::waitUntil([&] { return beats > 2 && label->isVisible(); }));
        EXPECT_TRUE(window->isLoadingModel());
        EXPECT_TRUE(label->text().contains("turboprop4.flt")) << label->text().toStdString();
        EXPECT_TRUE(window->findChild<QProgressBar*>("loadingBusy")->isVisible());
    }
    ASSERT_TRUE(waitForModel());
    EXPECT_FALSE(label->isVisible());
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_TRUE(test::waitUntil([&] {
        window->sceneView()->showWholeModel();
        return !window->sceneView()->facesAt(window->sceneView()->rect().center()).empty();
    }));
}

TEST_F(ModelLoadingTest, ASecondProjectTakesThePlaceOfTheFirst) {
    saveProject(large(), folder / "large.smat");
    ASSERT_TRUE(window->open(folder / "large.smat"));
    EXPECT_TRUE(window->isLoadingModel());
    openSample();
    EXPECT_TRUE(window->windowTitle().startsWith("ship.smat"));
    backgroundPool().waitForDone();
    QTest::qWait(20);
    window->sceneView()->showWholeModel();
    QTest::qWait(20);
    const auto hits = window->sceneView()->facesAt(window->sceneView()->rect().center());
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits.front().model, 0);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(ModelLoadingTest, ClosingWhileAModelIsReadIsClean) {
    saveProject(large(), folder / "large.smat");
    ASSERT_TRUE(window->open(folder / "large.smat"));
    EXPECT_TRUE(window->close());
    window.reset();
    backgroundPool().waitForDone();
    QTest::qWait(20);
}

} // namespace
} // namespace smat::gui
