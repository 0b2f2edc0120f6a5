#include "gui/analysis/AnalysisJob.h"

#include <QApplication>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/workbench/Workbench.h"
#include "tests/gui/GatedSource.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

using test::Gate;

class AnalysisJobTest : public ::testing::Test {
  protected:
    AnalysisJobTest()
        : workbench(std::make_unique<Workbench>([this] { return test::gatedDoor(gate); })) {
        workbench->open(test::writeSampleProject(test::freshFolder("job")));
        QObject::connect(workbench.get(), &Workbench::jobFailed,
                         [this](const QStringList& sentences, bool) { told += sentences; });
    }
    /// Whatever failed: a shut gate would hold the end of the workbench for ever.
    ~AnalysisJobTest() override { gate.drawings(1 << 30); }

    void startPolar() {
        workbench->start(AnalysisData::of(workbench->project(), AnalysisKind::polar));
    }
    bool settle() {
        return test::waitUntil([this] { return !workbench->isRunning(); }, 20.0);
    }

    Gate gate;
    QStringList told;
    std::unique_ptr<Workbench> workbench;
};

TEST_F(AnalysisJobTest, CancelIsAnsweredWhileADrawingIsUnderWayAndKeepsWhatIsDone) {
    gate.drawings(3);
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 4; }));
    workbench->cancel();
    // The fourth drawing cannot end before the gate opens, and yet there is an answer.
    ASSERT_TRUE(settle());
    ASSERT_EQ(workbench->results().size(), 1U);
    const AnalysisData& kept = *workbench->results().front().data;
    EXPECT_EQ(kept.state, AnalysisState::partial);
    EXPECT_EQ(kept.table.rowCount(), 3U);
    EXPECT_EQ(kept.table.provenance.value("state"), "partial");
    EXPECT_EQ(kept.table.provenance.value("warning"), "stopped after 3 of 12 cases");
    EXPECT_FALSE(kept.summary.empty());
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    gate.drawings(1 << 30);
}

TEST_F(AnalysisJobTest, TheNextAnalysisStartsBesideADrawingThatWasLeft) {
    gate.drawings(0);
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 1; }));
    workbench->cancel();
    ASSERT_TRUE(settle());
    EXPECT_TRUE(workbench->results().empty()); // no case was done
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.renderers == 2; }));
    gate.drawings(1 << 30);
    ASSERT_TRUE(settle());
    ASSERT_EQ(workbench->results().size(), 1U);
    EXPECT_EQ(workbench->results().front().data->state, AnalysisState::complete);
    // The one that was left goes with its renderer.
    EXPECT_TRUE(test::waitUntil([this] { return gate.renderers == 1; }));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(AnalysisJobTest, AShortDrawingEndsTheRunItself) {
    gate.drawings(2);
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 3; }));
    workbench->cancel();
    gate.drawings(1 << 30);
    ASSERT_TRUE(settle());
    ASSERT_EQ(workbench->results().size(), 1U);
    EXPECT_EQ(workbench->results().front().data->table.rowCount(), 3U);
    EXPECT_EQ(gate.renderers, 1);
    startPolar();
    ASSERT_TRUE(settle());
    EXPECT_EQ(gate.renderers, 1); // and leaves its renderer to the next
}

TEST_F(AnalysisJobTest, GoesCleanlyWhileDrawingsAreUnderWay) {
    gate.drawings(0);
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 1; }));
    workbench->cancel();
    ASSERT_TRUE(settle());
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 2; }));
    gate.drawings(1 << 30);
    workbench.reset();
    EXPECT_EQ(gate.renderers, 0);
}

TEST_F(AnalysisJobTest, TellsTheStageOfACaseAndNoneOnceItIsDone) {
    gate.drawings(0);
    startPolar();
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 1; }));
    EXPECT_EQ(workbench->job()->stage(), "gate: waiting, 25 %");
    workbench->cancel();
    gate.drawings(1 << 30);
    ASSERT_TRUE(settle());
}

TEST_F(AnalysisJobTest, SaysHowFarItIs) {
    std::vector<std::size_t> done;
    QObject::connect(workbench.get(), &Workbench::jobProgressed,
                     [&](const Progress& now) { done.push_back(now.done); });
    startPolar();
    ASSERT_TRUE(settle());
    ASSERT_GE(done.size(), 2U);
    EXPECT_EQ(done.front(), 0U);
    EXPECT_EQ(done.back(), 12U);
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
}

} // namespace
} // namespace smat::gui
