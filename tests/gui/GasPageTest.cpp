#include "gui/tools/GasPage.h"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/tools/GasLayersBox.h"
#include "gui/tools/GasPlot.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberField.h"
#include "irsg/signature/Lint.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/tools/GasLayerText.h"
#include "tests/cli/Program.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

const std::string haze = "# name: haze\n# air_temperature [K]: 290\n# ground_temperature [K]: 300\n"
                         "# sky_temperature [K]: 230\nwavelength [um],extinction [km-1]\n"
                         "2.5,1\n6,1\n";

class GasPageTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (IsSkipped()) {
            return;
        }
        openSample();
        smat::test::write(folder / "haze.csv", haze);
        workbench.set("environment.atmospheres", "none");
        trigger("hotGas");
        page = dynamic_cast<GasPage*>(window->findChild<QTabWidget*>("tabs")->currentWidget());
        ASSERT_NE(page, nullptr);
        window->activateWindow();
        QTest::qWait(20);
    }
    template <typename Widget>
    Widget* get(const char* name) {
        auto* found = page->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void type(const char* name, const char* text) {
        auto* field = get<QLineEdit>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    void leave(const char* name) { QTest::keyClick(get<QLineEdit>(name), Qt::Key_Tab); }
    void press(const char* name) { QTest::mouseClick(get<QAbstractButton>(name), Qt::LeftButton); }
    void choose(const char* name, int index) {
        auto* box = get<QComboBox>(name);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    void chooseHaze() {
        chosen = QString::fromStdString((folder / "haze.csv").string());
        choose("gasAtmosphere", get<QComboBox>("gasAtmosphere")->count() - 1);
    }
    void compute() {
        press("compute");
        ASSERT_TRUE(test::waitUntil([&] { return !page->isRunning(); }, 60.0));
        QTest::qWait(20);
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    QString problems() { return get<QLabel>("problems")->text(); }
    QString command() { return get<QLineEdit>("commandLine")->text(); }
    /// The page's file, and that of the shown command with this file behind --out, which is a part
    /// of the provenance.
    void expectTheFileOfTheCommand(const std::string& file) {
        std::vector<std::string> words;
        for (const QString& word : command().split(' ')) {
            words.push_back(word.toStdString());
        }
        words.erase(words.begin());
        ASSERT_EQ(words.back(), "gas.csv");
        words.back() = file;
        const auto ran = smat::test::smatBatch(words, folder);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        std::string written = smat::test::contentOf(folder / file);
        const std::size_t out = written.find("--out " + file);
        ASSERT_NE(out, std::string::npos);
        written.replace(out, 6 + file.size(), "--out gas.csv");
        page->exportTo(folder / ("page-" + file));
        EXPECT_GT(written.size(), 2000U);
        EXPECT_EQ(smat::test::contentOf(folder / ("page-" + file)), written)
            << command().toStdString();
    }
    std::vector<std::string> curves() {
        std::vector<std::string> names;
        for (const Curve& curve : page->plot().plot().cartesian()->data().curves) {
            names.push_back(curve.name.toStdString());
        }
        return names;
    }

    GasPage* page = nullptr;
};

TEST_F(GasPageTest, EditsOfLayersAreStepsThatCanBeUndone) {
    const QUndoStack& stack = workbench.undoStack();
    std::vector<std::vector<irsg::GasLayer>> states{page->layers().layers()};
    QStringList steps;
    const int before = stack.count();
    const auto expectStep = [&](const char* name) {
        states.push_back(page->layers().layers());
        steps << name;
        EXPECT_EQ(stack.undoText(), name);
        EXPECT_NE(states.back(), states[states.size() - 2]) << name;
        ASSERT_EQ(stack.count() - before, steps.size()) << name; // typing is one step
    };
    type("T_K", "850");
    leave("T_K");
    expectStep("Set Temperature of gas layer 1");
    press("addLayer");
    expectStep("Add gas layer 2");
    type("CO", "0.0125");
    leave("CO");
    expectStep("Set CO of gas layer 2");
    type("CO", "0.02"); // another time
    leave("CO");
    expectStep("Set CO of gas layer 2");
    press("layerUp");
    expectStep("Move gas layer 2 towards the sensor");
    press("layerDown");
    expectStep("Move gas layer 1 away from the sensor");
    page->layers().choose(0);
    press("removeLayer");
    expectStep("Remove gas layer 1");

    for (int i = static_cast<int>(states.size()) - 2; i >= 0; --i) {
        trigger("undo");
        EXPECT_EQ(page->layers().layers(), states[static_cast<std::size_t>(i)]) << i;
        const irsg::GasLayer& shown = page->layers().layers()[page->layers().chosen()];
        EXPECT_EQ(get<NumberField>("T_K")->value(), shown.temperature_K) << i;
        EXPECT_EQ(get<QListWidget>("gasLayers")->count(),
                  static_cast<int>(states[static_cast<std::size_t>(i)].size()));
    }
    EXPECT_EQ(stack.index(), before);
    for (std::size_t i = 1; i < states.size(); ++i) {
        trigger("redo");
        EXPECT_EQ(page->layers().layers(), states[i]) << i;
    }
    EXPECT_FALSE(stack.canRedo());
}

TEST_F(GasPageTest, WhatIsRefusedOrLookedAtIsNoStep) {
    const QUndoStack& stack = workbench.undoStack();
    const int before = stack.count();
    type("T_K", "-5");
    leave("T_K");
    EXPECT_EQ(stack.count(), before);
    type("T_K", "700"); // as it was
    leave("T_K");
    EXPECT_EQ(stack.count(), before);
    press("addLayer");
    type("T_K", "900");
    leave("T_K");
    const auto layers = page->layers().layers();
    page->layers().choose(0);
    EXPECT_EQ(stack.count(), before + 2);
    trigger("undo");
    EXPECT_EQ(page->layers().chosen(), 1U); // where it was edited
    trigger("redo");
    EXPECT_EQ(page->layers().layers(), layers);
    // Steps of a closed page are passed over.
    const double range_m = workbench.settings()[key::cameraRange];
    workbench.set("camera.range", "1234");
    auto* tabs = window->findChild<QTabWidget*>("tabs");
    emit tabs->tabCloseRequested(tabs->currentIndex());
    QTest::qWait(20);
    trigger("undo");
    EXPECT_EQ(workbench.settings()[key::cameraRange], range_m);
    while (stack.canUndo()) {
        trigger("undo");
        QTest::qWait(20);
    }
    EXPECT_EQ(stack.index(), 0);
}

TEST_F(GasPageTest, WritesTheFileOfItsCommandByteForByte) {
    type("T_K", "850");
    press("addLayer");
    type("T_K", "1200");
    type("CO", "0.01");
    type("soot_ppmv", "0.2");
    type("gasBand", "3.5-4.8");
    type("step", "10");
    leave("step");
    choose("gasSource", 1);
    press("hasBackground");
    type("background", "310");
    leave("background");
    compute();
    for (const char* file : {"gas.csv", "other.json"}) {
        expectTheFileOfTheCommand(file);
    }
    EXPECT_EQ(page->table().provenance.value("step [cm-1]"), "10");
    EXPECT_EQ(page->table().provenance.value("background_temperature [K]"), "310");
    page->exportTo(folder / "gas.svg");
    EXPECT_TRUE(std::filesystem::exists(folder / "gas.svg"));

    // Through an atmosphere as well.
    chooseHaze();
    type("--altitude", "10");
    type("--range", "1500");
    press("hasSensorAltitude");
    type("--sensor-altitude", "40");
    leave("--sensor-altitude");
    compute();
    EXPECT_TRUE(command().contains("--sensor-altitude=40")) << command().toStdString();
    for (const char* file : {"gas.csv", "other.json"}) {
        expectTheFileOfTheCommand(file);
    }
    EXPECT_EQ(page->table().provenance.value("sensor_altitude [m]"), "40");
}

TEST_F(GasPageTest, OrdersAddsAndRemovesLayers) {
    auto* list = get<QListWidget>("gasLayers");
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(gasLayerText(page->layers().layers()[0]), gasLayerExample);
    for (const char* button : {"removeLayer", "layerUp", "layerDown"}) {
        EXPECT_FALSE(get<QToolButton>(button)->isEnabled()) << button;
    }
    press("addLayer");
    type("T_K", "300");
    type("length_m", "2");
    type("H2O", "0");
    leave("H2O");
    ASSERT_EQ(list->count(), 2);
    EXPECT_EQ(list->currentRow(), 1);
    EXPECT_EQ(list->item(1)->text().toStdString(), "300 K, 1 atm, 2 m: CO2 0.033");
    EXPECT_FALSE(get<QToolButton>("layerDown")->isEnabled());
    press("layerUp");
    EXPECT_EQ(list->currentRow(), 0);
    EXPECT_EQ(page->layers().layers()[0].temperature_K, 300.0);
    EXPECT_TRUE(command().contains("--layer T_K=300,p_atm=1,length_m=2,CO2=0.033 --layer T_K=700"))
        << command().toStdString();
    EXPECT_FALSE(get<QToolButton>("layerUp")->isEnabled());

    // The fields are those of the layer that is chosen.
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(1)).center());
    EXPECT_EQ(get<NumberField>("T_K")->value(), 700.0);
    EXPECT_EQ(get<NumberField>("H2O")->value(), 0.033);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up);
    EXPECT_EQ(get<NumberField>("T_K")->value(), 300.0);
    press("layerDown");
    EXPECT_EQ(page->layers().layers()[1].temperature_K, 300.0);
    press("removeLayer");
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(page->layers().layers()[0].temperature_K, 700.0);
    EXPECT_EQ(get<NumberField>("T_K")->value(), 700.0);
    EXPECT_FALSE(get<QToolButton>("removeLayer")->isEnabled());
}

TEST_F(GasPageTest, SaysAtTheFieldWhatTheLibraryRefuses) {
    struct Wrong {
        const char *field, *text, *sentence;
    };
    for (const Wrong& wrong :
         {Wrong{"T_K", "9", "a number from 250 to 3000 K is needed instead of 9"},
          Wrong{"p_atm", "11", "a number from 0.05 to 10 atm"},
          Wrong{"length_m", "0", "a number above 0, up to 10000 m"},
          Wrong{"CO2", "1.2", "a number from 0 to 1"},
          Wrong{"soot_ppmv", "-1", "a number from 0 to 1000 ppmv"},
          Wrong{"step", "0.5", "a number from 1 to 100 cm⁻¹"}}) {
        auto* field = get<NumberField>(wrong.field);
        const double before = field->value();
        type(wrong.field, wrong.text);
        EXPECT_TRUE(field->toolTip().contains(wrong.sentence)) << field->toolTip().toStdString();
        EXPECT_FALSE(field->isRight());
        EXPECT_TRUE(problems().contains(wrong.sentence)) << problems().toStdString();
        EXPECT_FALSE(get<QPushButton>("compute")->isEnabled()) << wrong.field;
        // What cannot stand goes with the focus.
        leave(wrong.field);
        EXPECT_EQ(field->value(), before) << wrong.field;
        EXPECT_EQ(problems().toStdString(), "");
        EXPECT_TRUE(get<QPushButton>("compute")->isEnabled()) << wrong.field;
    }

    // What is wrong with a layer as a whole, and with the band.
    type("CO2", "0.6");
    type("O2", "0.6");
    leave("O2");
    EXPECT_TRUE(problems().contains("Layer 1, mole fractions")) << problems().toStdString();
    EXPECT_TRUE(problems().contains("in sum"));
    EXPECT_FALSE(get<QPushButton>("compute")->isEnabled());
    type("O2", "0");
    for (const char* band : {"0.4-5", "3-", "5-3", "mid"}) {
        type("gasBand", band);
        EXPECT_FALSE(get<QPushButton>("compute")->isEnabled()) << band;
        EXPECT_TRUE(problems().startsWith("Band: ")) << problems().toStdString();
        EXPECT_TRUE(problems().contains(get<QLineEdit>("gasBand")->toolTip()))
            << get<QLineEdit>("gasBand")->toolTip().toStdString();
    }
    type("gasBand", "3-5");
    EXPECT_TRUE(get<QPushButton>("compute")->isEnabled()) << problems().toStdString();

    // Of the path, and of what only the tables can tell.
    choose("gasAtmosphere", 1);
    EXPECT_TRUE(problems().contains("no atmosphere")) << problems().toStdString();
    chooseHaze();
    type("--altitude", "10");
    type("--range", "5");
    press("hasSensorAltitude");
    type("--sensor-altitude", "40");
    EXPECT_TRUE(get<NumberField>("--sensor-altitude")->isRight());
    EXPECT_TRUE(problems().contains("Range: at least the difference of the altitudes, 30 m"))
        << problems().toStdString();
    type("--range", "50");
    EXPECT_EQ(problems().toStdString(), "");
    std::filesystem::remove(folder / "haze.csv");
    press("compute");
    ASSERT_TRUE(test::waitUntil([&] { return !page->isRunning(); }));
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains("haze.csv")) << told[0].toStdString();
    EXPECT_TRUE(page->table().empty());
}

TEST_F(GasPageTest, PlotsWhatIsChosenBeside) {
    type("soot_ppmv", "0.05");
    compute();
    EXPECT_EQ(curves(), (std::vector<std::string>{"all"}));
    EXPECT_FALSE(get<QCheckBox>("gasProduct")->isEnabled()) << "there is no atmosphere";
    const Curve all = page->plot().plot().cartesian()->data().curves[0];
    EXPECT_EQ(all.error, page->table().find("error_spectral_radiance")->values);
    press("gasParts");
    EXPECT_EQ(curves(), (std::vector<std::string>{"CO2", "H2O", "soot", "all"}));
    press("gasRadcal");
    EXPECT_EQ(curves()[3], "RADCAL");
    const Curve radcal = page->plot().plot().cartesian()->data().curves[3];
    choose("gasSource", 2);
    compute();
    EXPECT_EQ(radcal.y, page->table().find("spectral_radiance")->values);
    EXPECT_FALSE(get<QCheckBox>("gasRadcal")->isEnabled());
    EXPECT_EQ(curves(), (std::vector<std::string>{"CO2", "H2O", "soot", "all"}));
    choose("gasSource", 0);
    chooseHaze();
    type("--altitude", "10");
    type("--range", "1000");
    compute();
    press("gasProduct");
    EXPECT_EQ(curves(), (std::vector<std::string>{"CO2", "H2O", "soot", "RADCAL",
                                                  "product of means", "all"}));
    test::keepScreenshot(*window, "hot-gas");
    choose("quantity", 1);
    EXPECT_EQ(curves(), (std::vector<std::string>{"gas", "atmosphere", "all"}));
    EXPECT_FALSE(get<QCheckBox>("gasParts")->isEnabled());
    const auto& shown = page->plot().plot().cartesian()->data();
    for (const double tau : shown.curves[1].y) {
        EXPECT_NEAR(tau, std::exp(-1.0), 1e-3);
    }

    // The units are those of the preferences.
    EXPECT_TRUE(shown.xTitle.contains("µm")) << shown.xTitle.toStdString();
    const double longest_um = shown.curves[0].x.front();
    DisplayUnitsWatch::instance().set({.spectral = DisplayUnits::Spectral::wavenumber});
    EXPECT_TRUE(page->plot().plot().cartesian()->data().xTitle.contains("cm⁻¹"));
    EXPECT_NEAR(page->plot().plot().cartesian()->data().curves[0].x.back(), 1e4 / longest_um, 1e-6);
    DisplayUnitsWatch::instance().set({});
}

TEST_F(GasPageTest, TellsTheNumbersOfTheBandAndWhoAnsweredForThem) {
    compute();
    const QString figures = get<QLabel>("figures")->text();
    const auto number = [&](const char* key) {
        return QString::number(
            QString::fromStdString(page->table().provenance.value(key)).toDouble(), 'g', 4);
    };
    EXPECT_TRUE(figures.contains("Band radiance: " + number("band_radiance [W m-2 sr-1]")))
        << figures.toStdString();
    EXPECT_TRUE(figures.contains(" ± ")) << figures.toStdString();
    EXPECT_TRUE(figures.contains("Band transmittance: "));
    EXPECT_TRUE(figures.contains("RADCAL"));
    EXPECT_TRUE(figures.contains("CO2 adds")) << figures.toStdString();
    EXPECT_TRUE(figures.contains("by lines"));
    EXPECT_FALSE(figures.contains("CH4")) << "there is none";
    press("keepResult");
    ASSERT_EQ(workbench.results().size(), 1U);
    EXPECT_EQ(workbench.results()[0].data->kind, AnalysisKind::gas);
    EXPECT_EQ(workbench.results()[0].data->table, page->table());
}

TEST_F(GasPageTest, AddsALayerToTheDatabaseInOneStep) {
    auto& session = workbench.database();
    const irsg::SignatureDatabase before = session.value();
    type("T_K", "950");
    press("addLayer");
    type("T_K", "400");
    leave("T_K");
    int material = 0, temperature = 0;
    onDialog = [&](QDialog& dialog) {
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        auto* index = dialog.findChild<QLineEdit*>("gasEntryMaterial");
        const QString offered = index->text();
        material = offered.toInt();
        temperature = dialog.findChild<QLineEdit*>("gasEntryTemperature")->text().toInt();
        EXPECT_FALSE(before.materials.contains(material));
        EXPECT_FALSE(before.temperatures.contains(temperature));
        EXPECT_TRUE(ok->isEnabled());
        // What is taken, or no index, is refused while one types.
        for (const QString& wrong :
             {QString::number(before.materials.begin()->first), QString("x"), QString()}) {
            index->selectAll();
            QTest::keyClicks(index, wrong);
            if (wrong.isEmpty()) {
                index->clear();
            }
            EXPECT_FALSE(ok->isEnabled()) << wrong.toStdString();
            EXPECT_TRUE(dialog.findChild<QLabel*>("outcome")->text().contains("material index",
                                                                              Qt::CaseInsensitive));
        }
        index->selectAll();
        QTest::keyClicks(index, offered);
        EXPECT_TRUE(ok->isEnabled());
        auto* name = dialog.findChild<QLineEdit*>("gasEntryName");
        name->selectAll();
        QTest::keyClicks(name, "exhaust");
        test::keepScreenshot(dialog, "gas-entry");
    };
    const int steps = workbench.undoStack().index();
    press("addToDatabase");
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(workbench.undoStack().index(), steps + 1);
    ASSERT_TRUE(session.value().materials.contains(material));
    EXPECT_EQ(session.value().materials.at(material).name, "exhaust");
    EXPECT_TRUE(session.value().materials.at(material).isGas());
    EXPECT_EQ(session.value().temperatures.at(temperature).terms.base_K, 400.0)
        << "the layer that is chosen";
    workbench.undoStack().undo();
    EXPECT_TRUE(session.value() == before);
    workbench.undoStack().redo();

    // Cancelled: nothing.
    accept = false;
    onDialog = {};
    press("addToDatabase");
    EXPECT_EQ(workbench.undoStack().index(), steps + 1);
}

TEST_F(GasPageTest, AddsTheSpectrumOfAllLayersToTheDatabaseInOneStep) {
    auto& session = workbench.database();
    const irsg::SignatureDatabase before = session.value();
    press("addLayer");
    const int steps = workbench.undoStack().index();
    GasEntryPlace place;
    onDialog = [&](QDialog& dialog) {
        auto* what = dialog.findChild<QComboBox*>("gasEntryWhat");
        ASSERT_EQ(what->count(), 3);
        what->setCurrentIndex(2);
        place = {dialog.findChild<QLineEdit*>("gasEntryName")->text().toStdString(),
                 dialog.findChild<QLineEdit*>("gasEntryMaterial")->text().toInt(),
                 dialog.findChild<QLineEdit*>("gasEntryTemperature")->text().toInt()};
    };
    press("addToDatabase");
    ASSERT_TRUE(test::waitUntil([&] { return !page->isAdding(); }));
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(workbench.undoStack().index(), steps + 1);
    irsg::SignatureDatabase expected = before;
    addGasSurface(expected, gasSurface(page->input().gas), place);
    EXPECT_TRUE(session.value() == expected);
    workbench.undoStack().undo();
    EXPECT_TRUE(session.value() == before);
}

TEST_F(GasPageTest, StartsWithBandAltitudeAndRangeOfTheProject) {
    workbench.set("sensor.band", "8-12");
    workbench.set("environment.atmospheres", (folder / "haze.csv").string());
    workbench.set("target.altitude", "120");
    workbench.set("camera.range", "750");
    EXPECT_EQ(get<QLineEdit>("gasBand")->text().toStdString(), "3-5") << "as it was opened";
    press("takeFromProject");
    const GasInput input = page->input();
    EXPECT_EQ(input.gas.band, (irsg::SpectralRange{8.0, 12.0}));
    EXPECT_EQ(input.altitude_m, 120.0);
    EXPECT_EQ(input.range_m, 750.0);
    ASSERT_EQ(input.atmosphere.size(), 1U);
    EXPECT_EQ(input.atmosphere[0], folder / "haze.csv");
    choose("gasAtmosphere", 0);
    EXPECT_TRUE(page->input().atmosphere.empty());
    EXPECT_FALSE(get<NumberField>("--range")->isEnabled());
}

TEST_F(GasPageTest, StaysAliveWhileItComputesAndClosesThen) {
    type("gasBand", "1-200");
    type("step", "1");
    press("compute");
    EXPECT_TRUE(page->isRunning()) << "it is computed in a thread of its own";
    press("cancel");
    EXPECT_FALSE(page->isRunning());
    press("compute");
    delete page;
    trigger("hotGas");
    page = dynamic_cast<GasPage*>(window->findChild<QTabWidget*>("tabs")->currentWidget());
    compute();
    EXPECT_FALSE(page->table().empty());
}

TEST_F(GasPageTest, NeedsNoProject) {
    window.reset();
    Workbench empty;
    GasPage alone(empty, people);
    alone.show();
    EXPECT_FALSE(alone.findChild<QPushButton*>("takeFromProject")->isEnabled());
    EXPECT_FALSE(alone.findChild<QPushButton*>("addToDatabase")->isEnabled());
    alone.findChild<QPushButton*>("compute")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !alone.isRunning(); }));
    EXPECT_GT(alone.table().rowCount(), 200U);
    EXPECT_TRUE(told.isEmpty());
}

} // namespace
} // namespace smat::gui
