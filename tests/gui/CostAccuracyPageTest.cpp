// Tools, Time against error: measured as a job, marked, used as one step, kept and exported.
#include "gui/tools/CostAccuracyPage.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTreeWidget>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/analysis/ResultPage.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/widgets/Theme.h"
#include "smatcore/analysis/Conditions.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class CostAccuracyPageTest : public test::WindowFixture {
  protected:
    void openPage() {
        openSample();
        workbench.set("render.bounces", "0");
        trigger("frontier");
        page = window->findChild<CostAccuracyPage*>();
        ASSERT_NE(page, nullptr);
        find<QSpinBox>("repeats")->setValue(1);
    }
    template <typename Widget>
    Widget* find(const char* name) {
        return page->findChild<Widget*>(name);
    }
    void measure() {
        QSignalSpy ended(page, &CostAccuracyPage::ended);
        find<QPushButton>("run")->click();
        EXPECT_FALSE(find<QPushButton>("run")->isEnabled());
        ASSERT_TRUE(test::waitUntil([&] { return !ended.isEmpty(); }, 120.0));
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    const ResultTable& table() const { return page->panel().table(); }

    CostAccuracyPage* page = nullptr;
};

TEST_F(CostAccuracyPageTest, MeasuresAllConfigurationsWithTheNumbersOfTheCommandLine) {
    openPage();
    find<QComboBox>("ways")->setCurrentIndex(1);
    ASSERT_TRUE(test::waitUntil([&] { return !find<QLabel>("wayCount")->text().isEmpty(); }));
    const CostAccuracyStudy::Size size =
        CostAccuracyStudy::sizeOf(workbench.project(), page->asked().settings, page->options());
    EXPECT_TRUE(find<QLabel>("wayCount")->text().startsWith(QString::number(size.all)));
    const QString command = find<QLineEdit>("command")->text();
    EXPECT_TRUE(command.startsWith("smat-batch cost-accuracy ")) << command.toStdString();
    EXPECT_TRUE(command.contains("--target-error=1") && command.contains("--repeats 1"))
        << command.toStdString();
    measure();
    ASSERT_EQ(table().rowCount(), size.all);

    // What the command runs.
    AnalysisData same = page->asked();
    SceneBuilder builder;
    CostAccuracyStudy::run(
        same, openRenderDoor(),
        [&](const Project& project, const Settings& settings) {
            return builder.build(project, settings);
        },
        page->options());
    ASSERT_EQ(same.table.rowCount(), size.all);
    auto ours = table().find("true_error")->values, theirs = same.table.find("true_error")->values;
    EXPECT_EQ(ours, theirs);

    // Kept as a result, quietly: its page shows it already.
    ASSERT_EQ(workbench.results().size(), 1u);
    EXPECT_EQ(workbench.results().front().data->kind, CostAccuracyStudy::kind());
    EXPECT_EQ(workbench.results().front().data->table, table());
}

TEST_F(CostAccuracyPageTest, MarksAConfigurationAndUsesItAsOneStep) {
    openPage();
    find<QComboBox>("ways")->setCurrentIndex(0);
    find<QLineEdit>("targetError")->setText("20");
    measure();
    const auto chosen = table().find("chosen")->values;
    const auto at = static_cast<std::size_t>(std::ranges::find(chosen, 1.0) - chosen.begin());
    ASSERT_LT(at, chosen.size());
    EXPECT_EQ(page->panel().marked(), at) << "the chosen one at first";
    // The front is a line of what is quicker and quicker; all ways are dots.
    const PlotData& plot = page->panel().plot().cartesian()->data();
    EXPECT_TRUE(plot.xLogarithmic && plot.yLogarithmic);
    ASSERT_EQ(plot.curves.size(), 3u);
    EXPECT_TRUE(std::ranges::is_sorted(plot.curves[0].x));
    EXPECT_TRUE(std::ranges::is_sorted(plot.curves[0].y, std::greater<>()));
    EXPECT_EQ(plot.curves[1].x.size(), 2 * table().rowCount());
    EXPECT_EQ(plot.curves[2].x, std::vector{table().find("true_error")->values[at]});
    auto* configurations = find<QTreeWidget>("frontierWays");
    EXPECT_EQ(configurations->topLevelItemCount(),
              std::ranges::count(table().find("on_front")->values, 1.0));
    find<QCheckBox>("frontierAll")->setChecked(true);
    EXPECT_EQ(static_cast<std::size_t>(configurations->topLevelItemCount()), table().rowCount());
    EXPECT_EQ(page->panel().marked(), at) << "stays marked";

    // Another way, by its row.
    const std::size_t other = table().rowCount() - 1;
    page->panel().mark(other);
    const Settings before = workbench.settings();
    const Settings configuration = CostAccuracyStudy::settingsOf(table(), other);
    find<QPushButton>("useWay")->click();
    EXPECT_EQ(workbench.settings(), before.with(configuration));
    EXPECT_EQ(workbench.settings().text("render.antialiasing"),
              std::to_string(static_cast<int>(table().find("antialiasing")->values[other])));
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.settings(), before) << "one step";
    EXPECT_EQ(workbench.settings().text("render.targetError"), "none");
}

TEST_F(CostAccuracyPageTest, IsSeenInBothThemesAndKeepsItsWaysAfterACancel) {
    openPage();
    window->resize(1280, 800);
    test::keepScreenshot(*window, "frontier-before");
    find<QComboBox>("ways")->setCurrentIndex(1);
    find<QSpinBox>("repeats")->setValue(30);
    std::size_t done = 0;
    QObject::connect(&workbench, &Workbench::jobProgressed,
                     [&](const Progress& p) { done = p.done; });
    QSignalSpy ended(page, &CostAccuracyPage::ended);
    find<QPushButton>("run")->click();
    ASSERT_TRUE(test::waitUntil([&] { return done >= 8; }, 60.0));
    find<QPushButton>("cancel")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !ended.isEmpty() && table().rowCount() > 0; }, 60.0));
    EXPECT_EQ(table().provenance.value("state"), "partial");
    ASSERT_EQ(workbench.results().size(), 1u);
    EXPECT_TRUE(workbench.results().front().title.contains("partial"));
    test::keepScreenshot(*window, "frontier-light");
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(50);
    test::keepScreenshot(*window, "frontier-dark");
    applyTheme(*qApp, ThemeMode::light);
    for (const char* suffix : {".csv", ".json", ".png", ".svg"}) {
        const auto file = folder / (std::string("ways") + suffix);
        page->exportTo(file);
        EXPECT_GT(std::filesystem::file_size(file), 500u) << suffix;
    }
    EXPECT_EQ(ResultTable::load(folder / "ways.csv").rowCount(), table().rowCount());
    // As a result on a page of its own, which can be used as well.
    window->findChild<QAction*>("showResult");
    ResultPage kept({workbench.results().front()});
    ASSERT_NE(kept.costAccuracy(), nullptr);
    EXPECT_EQ(kept.costAccuracy()->table().rowCount(), table().rowCount());
}

} // namespace
} // namespace smat::gui
