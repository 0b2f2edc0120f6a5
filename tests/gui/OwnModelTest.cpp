// The guide's chapter "Your own aircraft": a model without codes, in centimetres, from its file to
// a polar plot.
#include <algorithm>
#include <fstream>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

#include "gui/database/NumberField.h"
#include "gui/project/FirstSignatureDialog.h"
#include "gui/project/PlacingFields.h"
#include "irsg/scene/model/PlacingGuess.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class OwnModelTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        try {
            irsg::placingGuess(copyOfSample());
        } catch (const irsg::InputError& error) {
            if (std::string(error.what()).find("Assimp") != std::string::npos) {
                GTEST_SKIP() << "built without what reads glTF";
            }
        }
    }
    std::filesystem::path copyOfSample() {
        const auto file = folder / "helicopter.gltf";
        std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) /
                                       "samples/helicopter/helicopter.gltf",
                                   file, std::filesystem::copy_options::overwrite_existing);
        return file;
    }
    /// The row of a surface in the dialog's table, by its name.
    static QString rowOf(const QDialog& dialog, const QString& name) {
        const auto* table = dialog.findChild<QTableWidget*>("surfaces");
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 0)->text() == name) {
                return QString::number(row);
            }
        }
        return "none";
    }
    static bool isReady(const QDialog& dialog) {
        const auto* create = dialog.findChild<QPushButton*>("create");
        const auto* placing = dialog.findChild<PlacingFields*>();
        return test::waitUntil([&] { return create->isEnabled() && placing->guess() != nullptr; });
    }
};

TEST_F(OwnModelTest, FromAFileWithoutCodesToAPolarPlot) {
    ASSERT_TRUE(opens(copyOfSample())) << told.join('\n').toStdString();
    onDialog = [&](QDialog& dialog) {
        ASSERT_TRUE(isReady(dialog));
        const auto* table = dialog.findChild<QTableWidget*>("surfaces");
        EXPECT_EQ(table->rowCount(), 9);
        const QString pipe = rowOf(dialog, "Exhaust_Pipe"), canopy = rowOf(dialog, "Canopy");
        EXPECT_EQ(dialog.findChild<QComboBox*>("material." + pipe)->currentText(),
                  "nickel alloy, oxidised (exhaust parts)");
        EXPECT_EQ(dialog.findChild<NumberField*>("kelvin." + pipe)->value(), 400.0);
        EXPECT_EQ(dialog.findChild<QComboBox*>("material." + canopy)->currentText(),
                  "acrylic canopy, 8 mm");
        EXPECT_FALSE(dialog.findChild<NumberField*>("kelvin." + canopy)->isVisible());
        dialog.findChild<QComboBox*>("temperature." + canopy)->setCurrentIndex(3);
        EXPECT_EQ(dialog.findChild<NumberField*>("kelvin." + canopy)->value(), 300.0);
        test::keepScreenshot(dialog, "own-aircraft-surfaces");
        dialog.findChild<QTabWidget*>()->setCurrentIndex(1);
        EXPECT_EQ(dialog.findChild<QComboBox*>("placing.unit")->currentText(), "centimetres");
        EXPECT_TRUE(dialog.findChild<QLabel*>("placing.said")->text().contains("1167 m long"));
        QTest::qWait(50);
        test::keepScreenshot(dialog, "own-aircraft-placing");
        dialog.findChild<QComboBox*>("placing.nose")->setCurrentIndex(3); // +Y, which is up
        EXPECT_FALSE(dialog.findChild<QPushButton*>("create")->isEnabled());
        dialog.findChild<QPushButton*>("placing.guess")->click();
        EXPECT_TRUE(dialog.findChild<QPushButton*>("create")->isEnabled());
    };
    auto* fromNames = window->findChild<QPushButton*>("firstSignature");
    ASSERT_NE(fromNames, nullptr);
    fromNames->click();
    onDialog = nullptr;
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_TRUE(waitForModel());
    EXPECT_TRUE(std::filesystem::exists(folder / "helicopter.codes.json"));
    EXPECT_TRUE(std::filesystem::exists(folder / "helicopter.sigdb"));
    ASSERT_TRUE(workbench.database().isOpen());
    EXPECT_EQ(workbench.database().value().materials.size(), 8U);

    // Seen from the side: 11.7 m long, the pipes far hotter than anything else.
    workbench.set("sensor.band", "3-5");
    workbench.set("camera.azimuth", "120");
    workbench.set("camera.elevation", "12");
    workbench.set("camera.range", "60");
    workbench.set("sensor.fov", "12");
    workbench.set("sensor.width", "320");
    workbench.set("sensor.height", "256");
    workbench.set("render.antialiasing", "1");
    workbench.set("render.lightError", "0.02");
    trigger("infraredDisplay");
    auto* view = window->findChild<SceneView*>();
    ASSERT_NE(view, nullptr);
    ASSERT_TRUE(test::waitUntil(
        [&] {
            const auto* picture = view->shownPicture();
            return picture != nullptr && !picture->coarse && view->isUpToDate();
        },
        60.0));
    test::keepScreenshot(*window, "own-aircraft-infrared");
    runAnalysis("image");
    const auto& values = workbench.results().back().data->image.primary().values;
    const auto hot = std::ranges::count_if(values, [](float value) { return value > 30.0F; });
    const auto lit = std::ranges::count_if(values, [](float value) { return value > 0.01F; });
    EXPECT_GT(hot, 20);
    EXPECT_LT(hot, lit / 8);
    EXPECT_GT(lit, 3000);

    workbench.set("polar.step", "45");
    runAnalysis("polar");
    const auto polar = workbench.results().back().data->table;
    chosen = QString::fromStdString((folder / "helicopter.smat").string());
    trigger("saveProject");
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();

    const Project saved = loadProject(folder / "helicopter.smat");
    EXPECT_EQ(saved.models.front().options.placing.unit_m, 0.01);
    AnalysisData data = AnalysisData::of(saved, AnalysisKind::polar, workbench.settings());
    EXPECT_EQ(runDirectly(data).table.columns(), polar.columns());
}

TEST_F(OwnModelTest, AFileThatIsThereAlreadyIsNotWrittenOver) {
    std::ofstream(folder / "helicopter.sigdb") << "something else";
    const auto file = copyOfSample();
    ASSERT_TRUE(window->open(file));
    ASSERT_TRUE(waitForModel());
    told.clear();
    onDialog = [&](QDialog& dialog) { ASSERT_TRUE(isReady(dialog)); };
    trigger("firstSignature");
    EXPECT_TRUE(std::filesystem::exists(folder / "helicopter-2.sigdb"));
    EXPECT_EQ(std::filesystem::file_size(folder / "helicopter.sigdb"), 14U);
    trigger("undo");
    EXPECT_EQ(workbench.project().models.front().options.placing, irsg::ModelPlacing());
}

} // namespace
} // namespace smat::gui
