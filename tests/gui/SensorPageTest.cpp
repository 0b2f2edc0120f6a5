// Tools, Sensor chain: stages with their transfer functions, and a picture behind each.
#include "gui/tools/SensorPage.h"

#include <fstream>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/tools/PlanePane.h"
#include "gui/tools/SensorScene.h"
#include "gui/tools/StageCard.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/sensor/SensorTransfer.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class SensorPageTest : public test::WindowFixture {
  protected:
    void openPage() {
        trigger("sensorChain");
        page = window->findChild<SensorPage*>();
        ASSERT_NE(page, nullptr);
        ASSERT_TRUE(test::waitUntil([&] { return page->pictures().has_value(); }, 60.0));
    }
    template <typename Widget>
    Widget* find(const char* name) {
        return page->findChild<Widget*>(name);
    }
    irsg::SensorDescription sensor() {
        return irsg::loadSensor(
            find<QComboBox>("sensorFile")->currentData().toString().toStdString());
    }

    SensorPage* page = nullptr;
};

TEST_F(SensorPageTest, CardsHaveTheTransferOfTheirStageWhoseProductIsThatOfTheChain) {
    openPage();
    const irsg::SensorTransfer transfer(sensor());
    const double nyquist = 0.5 / sensor().pixelAngle_rad();
    const auto at = [&](const char* card) {
        const std::vector<double>& curve = find<StageCard>(card)->curve();
        return curve.at((curve.size() - 1) / 2);
    };
    EXPECT_NEAR(at("stageOptics") * at("stageDetector") * at("stageMotion"), at("stageChain"),
                1e-12);
    EXPECT_NEAR(at("stageChain"), transfer.at(nyquist, 0.0), 1e-12);
    EXPECT_GT(at("stageChain"), 0.01);
    EXPECT_TRUE(find<StageCard>("stageElectronics")->curve().empty());
    EXPECT_TRUE(find<StageCard>("stageElectronics")->number().endsWith(" mK"));
    EXPECT_EQ(page->plot().cartesian()->data().curves.size(), 4u);
    find<StageCard>("stageOptics")->click();
    EXPECT_EQ(page->plot().cartesian()->data().curves.front().name, "diffraction");
    EXPECT_EQ(page->plot().cartesian()->data().curves.size(), 5u);
    EXPECT_TRUE(find<QLineEdit>("command")->text().startsWith("smat-batch sensor mtf "));
    page->exportTo(folder / "mtf.csv");
    EXPECT_EQ(ResultTable::load(folder / "mtf.csv").find("system")->values,
              page->table().find("system")->values);
}

TEST_F(SensorPageTest, ShowsTheSceneBeforeAndBehindTheStageThatIsChosen) {
    openPage();
    window->resize(1280, 800);
    EXPECT_TRUE(find<PlanePane>("before")->title().startsWith("Scene"));
    EXPECT_TRUE(find<PlanePane>("behind")->title().startsWith("Counts"));
    EXPECT_EQ(find<PlanePane>("before")->plane().width(), 4 * 64);
    EXPECT_EQ(find<PlanePane>("behind")->plane().width(), 64);
    EXPECT_NEAR(find<PlanePane>("before")->plane().at(0, 0),
                irsg::bandRadiance_W_m2_sr(sensor().band(), 300.0), 1e-4);
    test::keepScreenshot(*window, "sensor-chain");
    find<StageCard>("stageDetector")->click();
    EXPECT_TRUE(find<PlanePane>("before")->title().startsWith("After: Optics"));
    EXPECT_EQ(find<PlanePane>("behind")->plane().at(40, 40),
              page->pictures()->radiance_W_m2_sr[2][40 * 256 + 40]);
    test::keepScreenshot(*window, "sensor-detector");
    find<StageCard>("stageElectronics")->click();
    EXPECT_TRUE(find<PlanePane>("before")->title().startsWith("After: Motion"));
    EXPECT_TRUE(find<QLabel>("stageNumbers")->text().contains("photons"));
    test::keepScreenshot(*window, "sensor-electronics");
}

TEST_F(SensorPageTest, TakesAnImageOfTheProjectAndAnotherSensor) {
    openSample();
    runAnalysis("image");
    openPage();
    auto* scenes = find<QComboBox>("stageScene");
    ASSERT_EQ(scenes->count(), 2);
    scenes->setCurrentIndex(1);
    EXPECT_TRUE(find<QLabel>("stageSceneText")->text().contains("pixels of the image"));
    ASSERT_TRUE(test::waitUntil([&] { return page->pictures().has_value(); }, 60.0));
    const irsg::RadianceImage& image = workbench.results().front().data->image;
    const irsg::StageScene piece = pieceOf(image, sensor());
    EXPECT_EQ(page->pictures()->radiance_W_m2_sr[0], piece.radiance_W_m2_sr);
    // The cell beside the middle is the pixel there.
    const std::size_t cells = piece.columns_px * 4;
    EXPECT_EQ(piece.radiance_W_m2_sr[(piece.rows_px * 2) * cells + cells / 2],
              image.find("L")->values[image.offset(image.width() / 2, image.height() / 2)]);
    window->resize(1280, 800);
    test::keepScreenshot(*window, "sensor-image");

    const std::filesystem::path bad = folder / "bad.smatsensor";
    std::ofstream(bad) << "{\"format\": \"smat-sensor\", \"version\": 1}";
    chosen = QString::fromStdString(bad.string());
    auto* sensors = find<QComboBox>("sensorFile");
    emit sensors->activated(sensors->count() - 1);
    EXPECT_FALSE(find<QLabel>("problem")->text().isEmpty());
    EXPECT_TRUE(page->table().empty());
    EXPECT_FALSE(page->pictures());
    EXPECT_TRUE(page->exportFilters().isEmpty());
    sensors->setCurrentIndex(1);
    emit sensors->activated(1);
    EXPECT_TRUE(test::waitUntil([&] { return page->pictures().has_value(); }, 60.0));
}

} // namespace
} // namespace smat::gui
