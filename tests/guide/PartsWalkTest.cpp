// What the guide says of contributions by part, units, moving a project and two pages.
#include <QComboBox>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"
#include "gui/image/IndexLegend.h"
#include "gui/image/LinkedViews.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/settings/Preferences.h"
#include "gui/view/ModelPage.h"
#include "gui/view/StatePage.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/workbench/PageTabs.h"
#include "smatcore/data/ColumnName.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class PartsWalkTest : public test::GuideFixture {
  protected:
    void TearDown() override {
        Preferences().save(); // for the windows to come
        DisplayUnitsWatch::instance().set({});
        LinkedViews::instance().setOn(false);
    }
    PageTabs& pages() { return *get<PageTabs>("tabs"); }
    ResultPage& result() { return *pages().currentResult(); }
};

TEST_F(PartsWalkTest, WhoMakesALobe) {
    test::GuideWalk walk("plots", "Contribution by part");
    ASSERT_TRUE(opens(own("heron")));
    for (const auto& [key, value] : {std::pair("sensor.width", "120"),
                                     {"sensor.height", "90"},
                                     {"polar.step", "60"},
                                     {"render.errors", "off"},
                                     {"environment.atmospheres", "none"}}) {
        workbench.set(key, value);
    }
    walk.step("Contributions by part of a new polar, range, time, condition or table analysis (by "
              "temperature index, by material index) adds to each sum what the faces of each index "
              "add to it, at every point. Parts of an object add up to the object.");
    onDialog = [](QDialog& dialog) {
        auto* box = dialog.findChild<QComboBox*>("render.parts");
        if (box != nullptr) {
            EXPECT_EQ(box->itemText(1), "by temperature index");
            choose(box, 1);
        }
    };
    runAnalysis("polar");
    onDialog = nullptr;
    const ResultTable& table = workbench.results().back().data->table;
    const std::vector<double>& whole = table.find("contrast_intensity")->values;
    std::vector<double> sum(whole.size(), 0.0);
    int parts = 0;
    for (const ResultColumn* column : columnsOf(table, "contrast_intensity")) {
        if (!ColumnName::of(column->key).part().empty()) {
            ++parts;
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] += column->values[i];
            }
        }
    }
    ASSERT_GT(parts, 3);
    for (std::size_t i = 0; i < sum.size(); ++i) {
        EXPECT_NEAR(sum[i] / whole[i], 1.0, 1e-9);
    }

    walk.step(
        "The plot stacks the six largest parts and the rest as one, the largest at the bottom");
    const PolarPlot& plot = *result().polarPlot();
    const std::vector<Curve> layers = plot.data().curves;
    ASSERT_GT(layers.size(), 2U);
    EXPECT_TRUE(layers.front().isLayer());
    EXPECT_EQ(layers.back().name, "all");
    EXPECT_EQ(layers.back().y, whole);
    test::keepScreenshot(*window, "plot-by-part");
    walk.note(
        "The box Stack goes back to lines. The crosshair shows the value of each part, and a click "
        "in the legend hides one.");
    auto* stack = get<QCheckBox>("stack", &result());
    EXPECT_TRUE(stack->isChecked());
    stack->click();
    EXPECT_FALSE(plot.data().curves.front().isLayer());
    stack->click();
    walk.step("A stack has one band and one view offset. Negative contrasts go downwards, the "
              "others upwards.");
    for (std::size_t i = 0; i < whole.size(); ++i) {
        double highest = 0.0, lowest = 0.0;
        for (const Curve& curve : plot.data().curves) {
            if (curve.isLayer()) {
                highest = std::max(highest, curve.y[i]);
                lowest = std::min(lowest, curve.y[i]);
            }
        }
        EXPECT_NEAR((highest + lowest) / whole[i], 1.0, 1e-9);
    }
    walk.step("The same from a terminal, with columns such as heron/turbine exit.intensity");
    bool hasPipes = false;
    for (const ResultColumn& column : table.columns()) {
        hasPipes = hasPipes || column.key == "heron/turbine exit.intensity";
    }
    EXPECT_TRUE(hasPipes);
    walk.step("smat-batch polar heron.smat --by-part temperature --out parts.csv");

    walk.step("In an image with truth layers the planes Temperature index, Material index and, of "
              "several models, Object index have a colour for each index");
    workbench.set("image.truthLayers", "true");
    runAnalysis("image");
    ImageView& image = *result().imageView();
    auto* planes = get<QComboBox>("plane", &image);
    const int place = planes->findText("Temperature index");
    ASSERT_GE(place, 0);
    choose(planes, place);
    EXPECT_TRUE(image.indexLegend()->isVisible());
    EXPECT_FALSE(image.colorBar()->isVisible());
    EXPECT_GT(image.indexLegend()->count(), 2);
    EXPECT_FALSE(image.indexLegend()->indices().front().name.isEmpty());
    test::keepScreenshot(*window, "image-by-index");
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(PartsWalkTest, UnitsOfDisplay) {
    test::GuideWalk walk("plots", "Units of display");
    openSample();
    runAnalysis("range");
    const CartesianPlot& plot = *result().cartesianPlot();
    const QString values = plotValues(plot, PlotPart::all);
    walk.step("Edit → Preferences… chooses the units of plots, images and read-outs: Spectral axes "
              "in µm or cm⁻¹, Intensities in W·sr⁻¹ or dB re 1 W·sr⁻¹, Temperatures in K or °C.");
    onDialog = [](QDialog& dialog) {
        dialog.findChild<QComboBox*>("intensityUnit")->setCurrentIndex(1);
    };
    act("preferences");
    onDialog = nullptr;
    EXPECT_TRUE(plot.data().yTitle.contains("dB re 1 W·sr⁻¹")) << plot.data().yTitle.toStdString();
    walk.step("Projects, results and saved values keep their own units");
    EXPECT_EQ(plotValues(plot, PlotPart::all), values);
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(PartsWalkTest, MovingAProject) {
    test::GuideWalk walk("window", "Moving a project");
    ASSERT_TRUE(opens(own("ship")));
    const auto elsewhere = folder / "elsewhere";
    std::filesystem::create_directories(elsewhere);
    walk.step("File → Save project as… into another folder asks whether the files that lie outside "
              "of it are used where they are or copied beside the project. File → Collect files… "
              "writes a copy of the project");
    chosen = QString::fromStdString((folder / "collected/ship.smat").string());
    act("collectFiles");
    EXPECT_TRUE(told.isEmpty()) << said();
    EXPECT_NE(workbench.project().file, folder / "collected/ship.smat");
    chosen = QString::fromStdString((elsewhere / "ship.smat").string());
    answer = 1;
    act("saveProjectAs");
    EXPECT_TRUE(asked.contains("Save the project elsewhere"));
    EXPECT_TRUE(told.isEmpty()) << said();
    walk.step("Copied are models with their textures, materials, codes and scalings, databases");
    for (const auto& place : {folder / "collected", elsewhere}) {
        const Project copy = loadProject(place / "ship.smat");
        for (const ProjectModel& model : copy.models) {
            for (const auto& file : {copy.resolve(model.file), copy.resolve(model.database)}) {
                EXPECT_TRUE(file.string().starts_with((place / "ship.files").string())) << file;
                EXPECT_TRUE(std::filesystem::exists(file)) << file;
            }
        }
    }
    EXPECT_EQ(workbench.project().file, elsewhere / "ship.smat");
    EXPECT_TRUE(workbench.database().isOpen());
    walk.note("The same from a terminal, also for a scenario with its trajectories:");
    walk.step("smat-batch project collect ship.smat copy/ship.smat");
    const auto ran = smat::test::runProgram({std::string(SMAT_BINARY_DIR) + "/bin/smat-batch",
                                             "project", "collect", "ship.smat", "copy/ship.smat"},
                                            elsewhere);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
}

TEST_F(PartsWalkTest, TwoPagesSideBySide) {
    test::GuideWalk walk("window", "Two pages side by side");
    openSample();
    for (const char* side : {"sensor.width", "sensor.height"}) {
        workbench.set(side, "48");
    }
    runAnalysis("image");
    ImageView* one = result().imageView();
    workbench.database().edit("paint", [](irsg::SignatureDatabase& database) {
        database.materials.begin()->second.emissivity = irsg::Spectrum::constant(0.2);
    });
    runAnalysis("image");
    ImageView* other = result().imageView();
    walk.step("A page goes beside the others by View → Show the page beside the others "
              "(Ctrl+Shift+B), by the menu of its tab, or when its tab is dragged to the right "
              "half.");
    EXPECT_EQ(get<QAction>("moveAcross")->shortcut(), QKeySequence("Ctrl+Shift+B"));
    act("moveAcross");
    pages().setCurrentIndex(1);
    QTest::qWait(30);
    EXPECT_TRUE(one->isVisible() && other->isVisible());
    test::keepScreenshot(*window, "pages-beside");
    walk.step("View → Link image pages lets images of equal size show the same part and read the "
              "same pixel");
    act("linkImages");
    one->canvas()->centreOn({24, 24}, 12.0);
    EXPECT_EQ(other->canvas()->zoom(), 12.0);
    workbench.database().discard();
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(PartsWalkTest, TwoStatesTurnTogether) {
    test::GuideWalk walk("window", "Two states with linked cameras");
    openSample();
    auto* model = window->findChild<ModelPage*>();
    walk.step("View → Keep this state beside (Ctrl+Shift+K) puts a second view of the project "
              "beside the others.");
    EXPECT_EQ(get<QAction>("keepState")->shortcut(), QKeySequence("Ctrl+Shift+K"));
    act("keepState");
    auto* state = get<StatePage>("statePage");
    ASSERT_TRUE(test::waitUntil([&] { return !state->view()->scene().models.empty(); }));
    EXPECT_TRUE(pages().isBeside(state));
    walk.step("While Link cameras above the kept state is on, a drag in one view turns both");
    QTest::keyClick(state->view(), Qt::Key_Left);
    EXPECT_EQ(model->view()->cameras(), state->view()->cameras());
    workbench.set("camera.azimuth", "20");
    EXPECT_TRUE(
        test::waitUntil([&] { return state->view()->cameras().sensor().azimuth_deg == 20.0; }));
    test::keepScreenshot(*window, "states-beside");
    walk.step("Another project closes kept states. They are not saved; File → Export… writes the "
              "view as a picture.");
    EXPECT_EQ(state->exportFilters().size(), 1);
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
