#include <cmath>
#include <fstream>
#include <numbers>

#include <QCheckBox>
#include <QComboBox>
#include <QTabBar>
#include <QToolButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/SurfaceTemperature.h"
#include "smatcore/project/SceneBuilder.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

constexpr double tolerance = 2e-4; // relative, of the renderer's in-band tables and float pixels

/// What is edited in the window shows in the picture by the computed amount. The nose side of the
/// black box, temperature 1, fills the picture; no air, no sun.
class DatabasePictureTest : public test::DatabaseFixture {
  protected:
    void SetUp() override {
        DatabaseFixture::SetUp();
        if (IsSkipped()) {
            return;
        }
        openCopy("box", {{"sensor.width", "9"},
                         {"sensor.height", "9"},
                         {"sensor.fov", "0.01"},
                         {"camera.azimuth", "8"},
                         {"camera.elevation", "0"},
                         {"camera.range", "1000"},
                         {"target.altitude", "2000"},
                         {"render.sun", "off"},
                         {"render.ambientReflection", "off"},
                         {"render.background", "none"},
                         {"render.antialiasing", "0"},
                         {"state.time", "3"},
                         {"state.power", "0.6"},
                         {"state.mach", "0.8"}});
        const Project& project = workbench.project();
        state.time_s = 3.0;
        state.power = 0.6;
        state.mach = 0.8;
        state.altitude_m = 2000.0;
        state.ambient_K = environmentOf(project, workbench.settings())
                              .ambientTemperature_K(state.altitude_m)
                              .value;
        state.aspectAngle_rad = 8.0 * std::numbers::pi / 180.0;
        dock().select({EntryKind::temperature, 1});
    }
    irsg::Band band() { return sensorOf(workbench.project(), workbench.settings()).band; }
    /// Runs the picture and compares it with black radiance at eq. 7's temperature.
    void expectTemperature(const irsg::TemperatureTerms& terms, const char* what) {
        const double expected =
            irsg::bandRadiance_W_m2_sr(band(), irsg::surfaceTemperature_K(terms, state));
        EXPECT_NEAR(middlePixel(), expected, tolerance * expected) << what;
        EXPECT_EQ(session().value().temperatures.at(1).terms, terms) << what;
    }
    QWidget* terms() { return find<QWidget>("termsPanel"); }

    irsg::EntityState state;
};

TEST_F(DatabasePictureTest, EachTermOfEquation7AndAllTogether) {
    irsg::TemperatureTerms expected;
    expected.base_K = 300.0;
    expected.ambientFactor = 0.0;
    expectTemperature(expected, "as the sample has it");
    chooseTab("temperatureTabs", "Equation terms");

    type("base_K", "340");
    expected.base_K = 340.0;
    expectTemperature(expected, "T0");
    type("base_K", "60");
    type("ambientFactor", "0.9");
    expected.base_K = 60.0;
    expected.ambientFactor = 0.9;
    expectTemperature(expected, "a T_amb");
    type("recoveryFactor", "0,89");
    expected.recoveryFactor = 0.89;
    expectTemperature(expected, "0.2 r M^2");
    type("ambientOffset_K", "-12.5");
    expected.ambientOffset_K = -12.5;
    expectTemperature(expected, "delta T");

    struct Table {
        int tab;
        Nodes nodes;
        irsg::LookupTable irsg::TemperatureTerms::*member;
    };
    for (const auto& [tab, nodes, member] :
         {Table{0, {{0, 0}, {4, 40}}, &irsg::TemperatureTerms::time},
          Table{1, {{0, 5}, {0.5, 25}, {1, 30}}, &irsg::TemperatureTerms::power},
          Table{2, {{0, 0}, {4000, -20}}, &irsg::TemperatureTerms::altitude},
          Table{3, {{0, 0}, {1, 15}}, &irsg::TemperatureTerms::mach},
          Table{4, {{270, -8}, {300, 8}}, &irsg::TemperatureTerms::ambient}}) {
        find<QTabBar>("termTables")->setCurrentIndex(tab);
        fill(terms(), nodes);
        expected.*member = tableOf(nodes, false);
        expectTemperature(expected, std::to_string(tab).c_str());
    }
    test::keepScreenshot(*window, "database-terms");

    // Time 3 s of a loop of 2 s is 1 s.
    find<QTabBar>("termTables")->setCurrentIndex(0);
    auto* table = terms()->findChild<NodeTable*>();
    ASSERT_TRUE(table->model()->setData(table->model()->index(1, 0), "2", Qt::EditRole));
    find<QCheckBox>("loop", terms())->click();
    expected.time = {{0, 2}, {0, 40}, true};
    expectTemperature(expected, "loop");

    // All the way back, step by step.
    const auto edited = session().value();
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(session().value(), session().saved());
    while (workbench.undoStack().canRedo()) {
        workbench.undoStack().redo();
    }
    EXPECT_EQ(session().value(), edited);
}

TEST_F(DatabasePictureTest, EmissivityTransmissivityAndNAngleFactor) {
    const double black = irsg::bandRadiance_W_m2_sr(band(), 300.0);
    EXPECT_NEAR(middlePixel(), black, tolerance * black);
    dock().select({EntryKind::material, 1});
    auto* emissivity = find<QWidget>("emissivity");
    type("greyValue", "0.6", emissivity);
    EXPECT_NEAR(middlePixel(), 0.6 * black, tolerance * black) << "grey";
    EXPECT_EQ(workbench.undoStack().undoText(), "Set emissivity of material 1 to a grey value");

    // Spectral: a step from 0.2 to 0.8 within the band.
    auto* form = find<QComboBox>("form", emissivity);
    form->setCurrentIndex(1);
    emit form->activated(1);
    const auto range = band().range();
    const Nodes nodes = {{range.min_um, 0.2}, {range.centre_um(), 0.2}, {range.max_um, 0.8}};
    fill(emissivity, nodes);
    const irsg::Spectrum spectrum = spectrumOf(nodes, irsg::Spectrum::Outside::hold);
    const auto emitted = [&](double temperature_K) {
        double sum = 0.0;
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            const double at = range.min_um + (i + 0.5) * range.width_um() / steps;
            sum += spectrum.at(at) * irsg::planckRadiance_W_m2_sr_um(at, temperature_K) *
                   range.width_um() / steps;
        }
        return sum;
    };
    const double expected = emitted(300.0);
    EXPECT_NEAR(middlePixel(), expected, tolerance * expected) << "spectral";
    test::keepScreenshot(*window, "database-emissivity");

    chooseTab("materialTabs", "N angle factor");
    type("nAngleFactor", "1.5");
    const double angled = expected * std::pow(std::cos(state.aspectAngle_rad), 1.5);
    EXPECT_NEAR(middlePixel(), angled, tolerance * angled) << "cos^N";
    test::keepScreenshot(*window, "database-angle");

    // The tail side of 320 K, of the same material, shines through from within; behind it is
    // nothing. What the sides send each other within would shine through as well.
    workbench.set("render.bounces", "0");
    chooseTab("materialTabs", "Transmissivity");
    type("greyValue", "0.15", find<QWidget>("transmissivity"));
    EXPECT_EQ(session().value().materials.at(1).transmissivity, irsg::Spectrum::constant(0.15));
    const double through = 0.15 * emitted(320.0) * std::pow(std::cos(state.aspectAngle_rad), 1.5);
    EXPECT_NEAR(middlePixel(), angled + through, tolerance * angled) << "transmissivity";
    type("greyValue", "0.5", find<QWidget>("transmissivity"));
    EXPECT_EQ(session().value().materials.at(1).transmissivity, irsg::Spectrum::constant(0.15))
        << "emissivity leaves only 0.2";
    test::keepScreenshot(*window, "database-transmissivity");
}

TEST_F(DatabasePictureTest, EachFactorOfAUserDefinedSpectrum) {
    const auto file = folder / "gas.csv";
    std::ofstream(file) << "um,CO2,H2O\n3,1,2\n4,3,2\n5,1,2\n";
    dock().tabs()->setCurrentIndex(2);
    chosen = QString::fromStdString(file.string());
    onDialog = [](QDialog& dialog) {
        auto* unit = dialog.findChild<QComboBox*>("radianceUnit");
        ASSERT_NE(unit, nullptr);
        unit->setCurrentText("W m-2 sr-1 um-1");
        dialog.findChild<QLineEdit*>("importDistance")->setText("12");
        test::keepScreenshot(dialog, "database-import-spectrum");
    };
    find<QToolButton>("importSpectrum")->click();
    onDialog = nullptr;
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_TRUE(session().value().spectra.contains("gas"));
    EXPECT_EQ(session().value().spectra.at("gas").referenceDistance_m, 12.0);
    test::keepScreenshot(*window, "database-spectrum");

    dock().select({EntryKind::temperature, 1});
    auto* mode = find<QComboBox>("emissionMode");
    mode->setCurrentIndex(1);
    emit mode->activated(1);
    workbench.set("sensor.band", "3-5");
    // Integrals over 3 to 5 um: CO2 (1 + 3)/2 twice, H2O 2 times 2.
    constexpr double co2 = 4.0, h2o = 4.0;
    EXPECT_NEAR(middlePixel(), co2 + h2o, tolerance * 8.0) << "no factors";

    chooseTab("temperatureTabs", "Factors");
    auto* factors = find<QWidget>("factorsPanel");
    type("factorConstant", "0.5", factors);
    EXPECT_NEAR(middlePixel(), 0.5 * co2 + h2o, tolerance * 8.0) << "constant";
    EXPECT_EQ(workbench.undoStack().undoText(), "Set constant factor of CO2 of temperature 1");

    fill(factors, {{0, 1}, {2, 3}, {4, 1}});
    EXPECT_NEAR(middlePixel(), 2.0 * co2 + h2o, tolerance * 12.0) << "time, 3 s";
    find<QCheckBox>("loop", factors)->click();
    workbench.set("state.time", "8.5");
    EXPECT_NEAR(middlePixel(), 1.5 * co2 + h2o, tolerance * 12.0) << "loop, 8.5 s is 0.5 s";

    find<QTabBar>("factorAxis")->setCurrentIndex(1);
    fill(factors, {{0, 1}, {16, 3}, {180, 3}});
    EXPECT_NEAR(middlePixel(), 2.0 * 1.5 * co2 + h2o, tolerance * 20.0) << "angle, 8 degrees";
    test::keepScreenshot(*window, "database-factors");

    // Both are kept, one counts.
    auto* selection = find<QComboBox>("factorSelection", factors);
    selection->setFocus();
    QTest::keyClick(selection, Qt::Key_Down);
    EXPECT_NEAR(middlePixel(), 0.5 * co2 + h2o, tolerance * 8.0) << "the constant alone";
    EXPECT_EQ(workbench.undoStack().undoText(), "Set selection of CO2 of temperature 1");
    EXPECT_TRUE(find<QTreeWidget>("components", factors)
                    ->topLevelItem(0)
                    ->text(2)
                    .endsWith("loop, not used"));
    test::keepScreenshot(*window, "database-factors-constant");
    workbench.undoStack().undo();
    EXPECT_EQ(selection->currentText(), "Tables");
    EXPECT_NEAR(middlePixel(), 2.0 * 1.5 * co2 + h2o, tolerance * 20.0) << "tables again";

    // Tables of a file, for both components at once; a component that is not there is refused.
    std::ofstream(folder / "angles.csv") << ",CO2,H2O\n0,0,1\n16,2,1\n180,2,1\n";
    chosen = QString::fromStdString((folder / "angles.csv").string());
    find<QToolButton>("importFactors")->click();
    EXPECT_NEAR(middlePixel(), 1.0 * 1.5 * co2 + h2o, tolerance * 20.0) << "imported";
    const auto kept = session().value();
    std::ofstream(folder / "wrong.csv") << ",CO2,CO\n0,0,1\n180,6,1\n";
    chosen = QString::fromStdString((folder / "wrong.csv").string());
    find<QToolButton>("importFactors")->click();
    EXPECT_TRUE(told.join(' ').contains("CO")) << told.join(' ').toStdString();
    EXPECT_EQ(session().value(), kept);
    told.clear();

    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "N angle factor");
    type("nAngleFactor", "2");
    EXPECT_NEAR(middlePixel(), (1.5 * co2 + h2o) * std::pow(std::cos(state.aspectAngle_rad), 2.0),
                tolerance * 20.0)
        << "cos^N in both modes";
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(session().value(), session().saved());
}

TEST_F(DatabasePictureTest, EditsShowAtOnceInTheViewAndPickingSelects) {
    auto* view = window->sceneView();
    view->setDisplay(ViewDisplay::infrared);
    const auto middle = [&] {
        EXPECT_TRUE(test::waitUntil([&] { return view->isUpToDate(); }));
        const auto* picture = view->shownPicture();
        if (picture == nullptr) {
            return 0.0;
        }
        const auto& image = *picture->image;
        const auto& values = image.primary().values;
        const auto at =
            static_cast<std::size_t>(image.height() / 2) * static_cast<std::size_t>(image.width()) +
            static_cast<std::size_t>(image.width() / 2);
        return static_cast<double>(values[at]);
    };
    const double cold = irsg::bandRadiance_W_m2_sr(band(), 300.0);
    EXPECT_NEAR(middle(), cold, tolerance * cold);
    chooseTab("temperatureTabs", "Equation terms");
    type("base_K", "350");
    const double hot = irsg::bandRadiance_W_m2_sr(band(), 350.0);
    EXPECT_NEAR(middle(), hot, tolerance * hot);
    workbench.undoStack().undo();
    EXPECT_NEAR(middle(), cold, tolerance * cold);

    dock().select({EntryKind::temperature, 4});
    QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
    QTest::qWait(50);
    ASSERT_TRUE(dock().current().has_value());
    EXPECT_EQ(dock().current()->index, 1) << "the nose side";
    EXPECT_EQ(view->highlighted().temperature, 1);
    EXPECT_EQ(view->highlighted().material, 1);
}

TEST_F(DatabasePictureTest, ProvenanceSaysWhetherEditsWereSaved) {
    const auto database = [this] {
        runAnalysis("image");
        return workbench.results().back().data->table.provenance.value("database");
    };
    EXPECT_EQ(database(), "box.sigdb");
    chooseTab("temperatureTabs", "Equation terms");
    type("base_K", "333");
    EXPECT_EQ(database(), "box.sigdb, with edits that are not saved");
    const auto unsaved = workbench.results().back().data->image.primary().values;
    window->findChild<QAction*>("saveDatabase")->trigger();
    EXPECT_FALSE(session().isDirty());
    EXPECT_EQ(database(), "box.sigdb");
    EXPECT_EQ(workbench.results().back().data->image.primary().values, unsaved);
    EXPECT_EQ(irsg::loadSignatureFile(folder / "box.sigdb").database, session().value());
}

} // namespace
} // namespace smat::gui
