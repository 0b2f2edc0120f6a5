#include "gui/project/ProjectPropertiesDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTabWidget>

#include "gui/project/NamedAnalyses.h"
#include "gui/project/SceneTreeDock.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

TEST(NamedAnalysesTest, KeepsWhatDiffersFromTheProject) {
    Project project;
    project.analyses.push_back({.name = "polar", .kind = AnalysisKind::polar});
    Settings inEffect;
    inEffect.set("camera.azimuth", "10");
    AnalysisData data;
    data.name = "polar";
    data.kind = AnalysisKind::polar;
    data.settings = inEffect;
    data.settings.set("sensor.band", "8-12");
    data.settings.set("polar.step", "30");
    data.settings.set("range.points", "7"); // of another kind
    const Project changed = withAnalysis(project, inEffect, data);
    ASSERT_EQ(changed.analyses.size(), 2U);
    const NamedAnalysis* kept = changed.find("polar 2");
    ASSERT_NE(kept, nullptr);
    EXPECT_EQ(kept->settings.values().size(), 2U);
    EXPECT_EQ(kept->settings.text("sensor.band"), "8-12");
    EXPECT_EQ(kept->settings.text("polar.step"), "30");
    EXPECT_EQ(withoutAnalysis(changed, "polar 2").analyses, project.analyses);
}

TEST(NamedAnalysesTest, StaySortedByName) {
    Project project;
    AnalysisData data;
    for (const auto* name : {"mid", "zero", "alpha", "mid"}) {
        data.name = name;
        project = withAnalysis(project, {}, data);
    }
    std::vector<std::string> names;
    for (const auto& one : project.analyses) {
        names.push_back(one.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"alpha", "mid", "mid 2", "zero"}));
}

using ProjectPropertiesTest = test::WindowFixture;

TEST_F(ProjectPropertiesTest, AnAnalysisThatWasRunIsKeptSavedAndRemoved) {
    openSample();
    EXPECT_FALSE(window->findChild<QAction*>("keepAnalysis")->isEnabled());
    workbench.set("sensor.band", "8-12");
    runAnalysis("range");
    workbench.set("sensor.band", "3-5");
    trigger("keepAnalysis");
    EXPECT_EQ(workbench.undoStack().undoText(), "Keep an analysis");
    trigger("saveProject");
    const Project saved = loadProject(folder / "ship.smat");
    ASSERT_EQ(saved.analyses.size(), 1U);
    EXPECT_EQ(saved.analyses.front().kind, AnalysisKind::range);
    EXPECT_EQ(saved.analyses.front().settings.text("sensor.band"), "8-12");
    EXPECT_EQ(
        AnalysisData::of(saved, saved.analyses.front().name).settings,
        AnalysisData::of(saved, AnalysisKind::range, saved.analyses.front().settings).settings);
    const QString name = QString::fromStdString(saved.analyses.front().name);
    emit window->tree().removeAnalysisWanted(name);
    EXPECT_TRUE(workbench.project().analyses.empty());
    EXPECT_EQ(workbench.undoStack().undoText(), "Remove analysis " + name);
    trigger("undo");
    EXPECT_EQ(workbench.project().analyses.size(), 1U);
}

TEST_F(ProjectPropertiesTest, PropertiesAreChangedUndoneAndReopenedFromTheFile) {
    openSample();
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("title")->setText("Ship, painted");
        dialog.findChild<QPlainTextEdit*>("notes")->setPlainText("two\nlines");
        dialog.findChild<QComboBox*>("placing.0.nose")->setCurrentIndex(1);
        dialog.findChild<QCheckBox*>("twoSided.0")->click();
        dialog.findChild<QCheckBox*>("cutTextureAlpha.0")->click();
        auto* temperature = dialog.findChild<QSpinBox*>("fallbackTemperature.0");
        EXPECT_TRUE(temperature->text().contains("refused"));
        temperature->setValue(0);
        test::keepScreenshot(dialog, "dialog-project-properties");
        dialog.findChild<QTabWidget*>()->setCurrentIndex(1);
        QTest::qWait(20);
        test::keepScreenshot(dialog, "dialog-project-properties-model");
    };
    trigger("projectProperties");
    trigger("saveProject");
    Project saved = loadProject(folder / "ship.smat");
    EXPECT_EQ(saved.title, "Ship, painted");
    EXPECT_EQ(saved.notes, "two\nlines");
    EXPECT_EQ(saved.models.front().options.placing.nose, irsg::ModelAxis::plusX);
    EXPECT_TRUE(saved.models.front().options.forceTwoSided);
    EXPECT_TRUE(saved.models.front().options.cutsTextureAlpha);
    EXPECT_EQ(saved.models.front().fallbackTemperature, 0);
    EXPECT_FALSE(saved.models.front().fallbackMaterial.has_value());
    trigger("undo");
    EXPECT_EQ(workbench.project().title, "Ship in the test basin");
    EXPECT_FALSE(workbench.project().models.front().options.placing.nose.has_value());
}

} // namespace
} // namespace smat::gui
