#include "gui/Shutdown.h"

#include <semaphore>

#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

const std::filesystem::path box = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box/box.flt";

/// A program of its own whose model is never read to its end. It opens the model, does what a
/// person does and is left; what ends it else is the time limit of the test.
void leaveWhileReading(const std::function<void(Workbench&, MainWindow&)>& act) {
    std::binary_semaphore never(0);
    Workbench workbench(openRenderDoor, nullptr,
                        std::make_shared<ModelStore>([&](const ModelKey& key) {
                            never.acquire();
                            return irsg::Model::load(key.file);
                        }));
    {
        Dialogs people;
        people.ask = [](QWidget*, const QString&, const QString&, const QStringList& answers) {
            return static_cast<int>(answers.size()) - 1; // quit, or discard what has changed
        };
        people.run = [](QDialog&) { return false; };
        MainWindow window(workbench, people);
        window.show();
        act(workbench, window);
        QTest::qWait(100);
        if (!window.close()) {
            _exit(1);
        }
    }
    shutDown(workbench, 7);
    _exit(2); // it came back although somebody reads
}

class ShutdownTest : public ::testing::Test {
  protected:
    void SetUp() override {
        GTEST_FLAG_SET(death_test_style, "threadsafe");
        if (test::lacksGl()) {
            GTEST_SKIP() << "this desktop gives no OpenGL context";
        }
    }
};

TEST_F(ShutdownTest, DoesNotWaitForAModelThatIsBeingRead) {
    // Through the project, so that view, tree and editor all ask for it.
    EXPECT_EXIT(leaveWhileReading([](Workbench& workbench, MainWindow&) { workbench.open(box); }),
                ::testing::ExitedWithCode(7), "");
}

TEST_F(ShutdownTest, DoesNotWaitForAnAnalysisWhoseModelIsBeingRead) {
    EXPECT_EXIT(leaveWhileReading([](Workbench& workbench, MainWindow&) {
                    workbench.open(box);
                    AnalysisData data;
                    data.project = workbench.project();
                    data.kind = AnalysisKind::image;
                    workbench.start(data);
                }),
                ::testing::ExitedWithCode(7), "");
}

TEST_F(ShutdownTest, ComesBackWhereNothingRuns) {
    Workbench workbench;
    {
        MainWindow window(workbench);
        window.show();
        ASSERT_TRUE(window.open(box));
        ASSERT_TRUE(test::waitUntil([&] { return !window.isLoadingModel(); }));
        ASSERT_TRUE(window.close());
    }
    shutDown(workbench, 7);
    SUCCEED();
}

} // namespace
} // namespace smat::gui
