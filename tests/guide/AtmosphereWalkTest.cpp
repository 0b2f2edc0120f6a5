#include <QTableWidget>
#include <QTreeWidget>

#include "gui/atmosphere/AtmospherePage.h"
#include "gui/atmosphere/AtmospherePlots.h"
#include "gui/atmosphere/AtmosphereRecovery.h"
#include "gui/atmosphere/ImportAtmosphereDialog.h"
#include "gui/atmosphere/ProjectAtmospherePage.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/tools/GasLayersBox.h"
#include "gui/tools/GasPage.h"
#include "gui/tools/GasPlot.h"
#include "gui/tools/RadiativePage.h"
#include "gui/tools/TemperatureProfilePage.h"
#include "smatcore/analysis/ResultFile.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

const std::string haze = "# name: haze\n# air_temperature [K]: 290\n# ground_temperature [K]: 300\n"
                         "# sky_temperature [K]: 230\nwavelength [um],extinction [km-1]\n"
                         "2.5,1\n4,3\n6,2\n13,4\n";

class AtmosphereWalkTest : public test::GuideFixture {
  protected:
    ~AtmosphereWalkTest() override {
        window.reset();
        for (const auto& copy : AtmosphereRecovery::leftBehind({})) {
            RecoverySlot::remove(copy);
        }
    }
    void openHaze() {
        openSample();
        smat::test::write(folder / "haze.csv", haze);
        workbench.set("environment.atmospheres", (folder / "haze.csv").string());
        workbench.set("target.altitude", "1000");
        workbench.set("camera.range", "500");
    }
    void compute(AtmosphereToolPage& tool) {
        get<QPushButton>("compute", &tool)->click();
        ASSERT_TRUE(test::waitUntil([&] { return !tool.isRunning(); }, 60.0));
        QTest::qWait(20);
        ASSERT_TRUE(told.isEmpty()) << said();
    }
    QStringList order() {
        QStringList names;
        for (const auto& one : workbench.settings()[key::environmentAtmospheres]) {
            names << QString::fromStdString(one.filename().string());
        }
        return names;
    }
    std::string content(const char* name) { return smat::test::contentOf(folder / name); }
    bool settles(AtmospherePage& air) {
        return test::waitUntil([&] { return !air.isBusy(); });
    }
    static bool isBold(AtmospherePage& air, const QString& name) {
        return std::ranges::any_of(air.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->text() == name && label->font().bold();
        });
    }
};

TEST_F(AtmosphereWalkTest, RadiativeOutput) {
    test::GuideWalk walk("air", "Radiative output");
    openHaze();
    walk.step("Tools → Radiative output… computes transmittance, path radiance, background "
              "radiance, the sun's irradiance and the upward and downward fluxes as spectra");
    act("radiativeOutput");
    auto* tool = page<RadiativePage>();
    ASSERT_NE(tool, nullptr);
    compute(*tool);
    for (const char* one : {"transmittance", "path", "background", "sun", "up", "down"}) {
        EXPECT_NE(get<QCheckBox>(one, tool), nullptr);
    }
    EXPECT_GE(tool->table().columns().size(), 2U + 6U);

    walk.step("Take from the project fills in camera, target, band and sun as they are.");
    auto* range = get<QLineEdit>("camera.range", tool);
    write(range, "2000");
    get<QPushButton>("takeFromProject", tool)->click();
    EXPECT_EQ(range->text(), "500");
    compute(*tool);
    walk.step(
        "Keep among the results makes the spectra a result, for overlays and differences. Use "
        "in the project… saves them and puts them first among the project's atmospheres");
    get<QPushButton>("keepResult", tool)->click();
    ASSERT_EQ(workbench.results().size(), 1U);
    EXPECT_EQ(workbench.results()[0].data->table, tool->table());
    // So thin that its extent along the model does not count.
    smat::test::write(folder / "haze.csv",
                      "# name: thin\n# air_temperature [K]: 270\nwavelength [um],extinction "
                      "[km-1]\n3,0.1\n5,0.1\n");
    workbench.set("sensor.band", "3-4.9");
    workbench.set("sensor.band", "3-5");
    compute(*tool);
    const auto image = [this] {
        return runDirectly(
                   AnalysisData::of(workbench.project(), AnalysisKind::image, workbench.settings()))
            .image.primary()
            .values;
    };
    const auto before = image();
    chosen = path("air.csv");
    get<QPushButton>("useInProject", tool)->click();
    EXPECT_EQ(order(), (QStringList{"air.csv", "haze.csv"}));
    const auto after = image();
    for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_NEAR(after[i], before[i], 1e-5 * std::abs(before[i])) << i;
    }
}

TEST_F(AtmosphereWalkTest, AirOfYourOwn) {
    test::GuideWalk walk("air", "Air of your own");
    openSample();
    window->activateWindow();
    workbench.set("target.altitude", "300");
    workbench.set("camera.range", "4000");
    walk.step("Tools → New atmosphere begins with the report's defaults, File → Open… opens an "
              "AtmosphereSmart file. All its parameters are fields, each with its unit. The field "
              "with the focus is explained below them");
    act("newAir");
    auto* air = page<AtmospherePage>();
    ASSERT_NE(air, nullptr);
    EXPECT_EQ(air->document().parameters(), irsg::AtmosphereSmartParameters());
    auto* visibility = get<QLineEdit>("Visibility", air);
    visibility->setFocus();
    QTest::qWait(20);
    EXPECT_FALSE(get<QLabel>("parameterHelp", air)->text().isEmpty());
    EXPECT_FALSE(isBold(*air, "Visibility"));
    ASSERT_TRUE(settles(*air));
    const double clear = air->plots().spectra().meanTransmittance;
    const int steps = workbench.undoStack().index();
    write(visibility, "2000");
    EXPECT_TRUE(isBold(*air, "Visibility"));

    walk.step(
        "While you type, the plots follow: transmittance and path radiance over the "
        "wavelength along the line of sight, and temperature and humidity over the altitude.");
    ASSERT_TRUE(settles(*air));
    EXPECT_LT(air->plots().spectra().meanTransmittance, clear);
    EXPECT_FALSE(air->plots().column().temperature_C.empty());
    EXPECT_FALSE(get<QLineEdit>("sightRange", air)->isEnabled());
    get<QCheckBox>("sightOfProject", air)->click();
    EXPECT_TRUE(get<QLineEdit>("sightRange", air)->isEnabled());
    const double far = air->plots().spectra().meanTransmittance;
    for (const auto& [name, metres] :
         {std::pair{"sightSensor", "310"}, {"sightTarget", "300"}, {"sightRange", "500"}}) {
        write(get<QLineEdit>(name, air), metres);
    }
    ASSERT_TRUE(settles(*air));
    EXPECT_GT(air->plots().spectra().meanTransmittance, far);
    const auto problems = [&] { return get<QLabel>("airProblems", air)->text(); };
    auto* pressure = get<QLineEdit>("PressureMH", air);
    pressure->setFocus();
    pressure->selectAll();
    QTest::keyClicks(pressure, "700");
    EXPECT_TRUE(problems().contains("PressureMH")) << problems().toStdString();
    visibility->setFocus();
    EXPECT_NE(pressure->text(), "700") << "gone when you leave the field";
    write(get<QLineEdit>("BaseWavelengthMin", air), "8"); // a band that runs backwards
    EXPECT_TRUE(problems().contains("BaseWavelengthMin")) << problems().toStdString();
    chosen = path("wrong.xml");
    act("saveProjectAs");
    EXPECT_FALSE(std::filesystem::exists(folder / "wrong.xml"));
    EXPECT_EQ(told.size(), 1);
    told.clear();
    write(get<QLineEdit>("BaseWavelengthMax", air), "12");
    ASSERT_TRUE(settles(*air));
    EXPECT_EQ(problems(), "");
    EXPECT_EQ(get<QLabel>("airRemarks", air)->text(), "");
    write(get<QLineEdit>("WindSpeed", air), "9"); // a maritime aerosol alone asks for it
    EXPECT_TRUE(get<QLabel>("airRemarks", air)->text().contains("WindSpeed"));

    walk.step(
        "Text typed in one go is one step of Edit → Undo. Save atmosphere (also Ctrl+S, while the "
        "page is shown) writes the file");
    EXPECT_EQ(workbench.undoStack().index(), steps + 4);
    while (workbench.undoStack().index() > steps + 1) {
        act("undo");
    }
    act("saveProjectAs"); // asked for a name
    chosen = path("saved.xml");
    act("saveProjectAs");
    EXPECT_FALSE(air->document().isModified()) << said();
    write(visibility, "2100");
    get<QPushButton>("saveAir", air)->click();
    EXPECT_FALSE(air->document().isModified()) << said();
    EXPECT_NE(content("saved.xml").find("2100"), std::string::npos);
    get<QPushButton>("useAir", air)->click();
    EXPECT_EQ(order().front(), "saved.xml");
    // A fault ends the program.
    write(visibility, "2200");
    air->recovery().writeNow();
    window.reset();
    asked.clear();
    answer = 0;
    makeWindow();
    chosen = path("saved.xml");
    act("openProject");
    EXPECT_TRUE(asked.contains("Recover unsaved changes")) << asked.join(' ').toStdString();
    air = page<AtmospherePage>();
    ASSERT_NE(air, nullptr);
    EXPECT_EQ(air->document().parameters().visibility_m, 2200.0);
    answer = 1;
    act("undo");

    walk.note("In a terminal, with the same files byte for byte:");
    act("newAir");
    auto* own = page<AtmospherePage>();
    ASSERT_NE(own, nullptr);
    write(get<QLineEdit>("Visibility", own), "5000");
    choose(get<QComboBox>("AtmosphereModel", own),
           get<QComboBox>("AtmosphereModel", own)->findData(6));
    chosen = path("own.xml");
    act("saveProjectAs");
    walk.step("smat-batch atmosphere new Visibility=5000 AtmosphereModel=6 --out air.xml");
    terminal("smat-batch atmosphere new Visibility=5000 AtmosphereModel=6 --out air.xml");
    EXPECT_EQ(content("air.xml"), content("own.xml"));
    write(get<QLineEdit>("GroundTemperature", own), "5");
    act("saveProject");
    walk.step("smat-batch atmosphere set air.xml GroundTemperature=5");
    terminal("smat-batch atmosphere set air.xml GroundTemperature=5");
    EXPECT_EQ(content("air.xml"), content("own.xml"));
}

TEST_F(AtmosphereWalkTest, TheAirOfTheProject) {
    test::GuideWalk walk("air", "The air of the project");
    openSample();
    smat::test::write(folder / "haze.csv", haze);
    terminal("smat-batch atmosphere new --out own.xml");
    workbench.set("sensor.band", "3-5, 8-12");
    workbench.set("environment.atmospheres",
                  (folder / "own.xml").string() + ";" + (folder / "haze.csv").string());
    walk.step("Tools → Project atmospheres lists the project's atmospheres in the order in which "
              "they are queried: the first that has a quantity in the whole band provides it. Drag "
              "them, or use Alt+Up and Alt+Down, to order them. Add…, Remove and Edit are each a "
              "step");
    act("projectAir");
    auto* air = page<ProjectAtmospherePage>();
    ASSERT_NE(air, nullptr);
    auto* list = get<QListWidget>("airList", air);
    auto* table = get<QTableWidget>("airAnswers", air);
    const auto answered = [&](const QString& quantity, int band) {
        EXPECT_TRUE(test::waitUntil([&] { return !air->isBusy(); }));
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->verticalHeaderItem(row)->text() == quantity) {
                return table->item(row, band);
            }
        }
        throw std::runtime_error("no such quantity");
    };
    EXPECT_TRUE(answered("transmittance", 0)->text().contains("own.xml"));
    EXPECT_EQ(answered("transmittance", 1)->text(), "haze") << "own.xml has 3 to 5 um alone";
    EXPECT_TRUE(answered("transmittance", 1)->toolTip().contains("own.xml"))
        << answered("transmittance", 1)->toolTip().toStdString();
    EXPECT_EQ(list->dragDropMode(), QAbstractItemView::InternalMove);
    list->setCurrentRow(1);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(order(), (QStringList{"haze.csv", "own.xml"}));
    EXPECT_EQ(answered("transmittance", 0)->text(), "haze");
    QTest::keyClick(list, Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(order(), (QStringList{"own.xml", "haze.csv"}));
    list->setCurrentRow(0);
    get<QPushButton>("airRemove", air)->click();
    EXPECT_EQ(order(), (QStringList{"haze.csv"}));
    chosen = path("own.xml");
    get<QPushButton>("airAdd", air)->click();
    EXPECT_EQ(order().size(), 2);
    act("undo");
    act("undo");
    EXPECT_EQ(order(), (QStringList{"own.xml", "haze.csv"}));
    list->setCurrentRow(0);
    get<QPushButton>("airEdit", air)->click();
    ASSERT_NE(page<AtmospherePage>(), nullptr);
    EXPECT_EQ(page<AtmospherePage>()->document().file(), folder / "own.xml");

    walk.step("smat-batch atmosphere answers own.xml haze.csv --band 3-5 --band 8-12");
    const auto ran =
        terminal("smat-batch atmosphere answers own.xml haze.csv --band 3-5 --band 8-12");
    EXPECT_NE(ran.out.find("own.xml"), std::string::npos);
    EXPECT_NE(ran.out.find("haze", ran.out.find("8 to 12 um")), std::string::npos) << ran.out;
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(AtmosphereWalkTest, ResultsOfModtranAndTemperatureProfile) {
    openHaze();
    {
        test::GuideWalk walk("air", "Results of MODTRAN");
        walk.step(
            "Tools → Import MODTRAN results… reads runs of MODTRAN as they are added with Add "
            "a file… or Add a folder… and shows errors beside each.");
        irsg::SyntheticRun run;
        for (const char* name : {"RUN1", "RUN2"}) {
            std::filesystem::create_directories(folder / name);
            smat::test::write(folder / name / "tape7", irsg::tape7(run));
            run.range_km = 2.0;
            run.depth = [](double) { return 0.2; };
        }
        smat::test::write(folder / "bad-tape7", irsg::tape7(run).substr(0, 700));
        bool isSeen = false;
        onDialog = [&](QDialog& dialog) {
            auto& import = dynamic_cast<ImportAtmosphereDialog&>(dialog);
            const auto add = [&](const QString& file) {
                chosen = file;
                import.findChild<QPushButton*>("addRun")->click();
                ASSERT_TRUE(test::waitUntil([&] { return !import.isBusy(); }));
            };
            EXPECT_NE(import.findChild<QPushButton*>("addRuns"), nullptr);
            auto* files = import.findChild<QTreeWidget*>("importedFiles");
            add(path("bad-tape7"));
            EXPECT_TRUE(files->topLevelItem(0)->text(2).contains("bad-tape7"));
            files->setCurrentItem(files->topLevelItem(0));
            import.findChild<QPushButton*>("removeRun")->click();
            add(path("RUN1/tape7"));
            add(path("RUN2/tape7"));
            EXPECT_TRUE(import.findChild<QLabel*>("importedFamily")->text().startsWith("2 runs"));
            chosen = path("window.smatatm");
            import.findChild<QPushButton*>("saveTable")->click();
            isSeen = true;
        };
        act("importAir");
        onDialog = nullptr;
        EXPECT_TRUE(isSeen);
        EXPECT_EQ(order().front(), "window.smatatm");
        walk.step("smat-batch atmosphere import RUN1/tape7 RUN2/tape7 --out family.smatatm");
        terminal("smat-batch atmosphere import RUN1/tape7 RUN2/tape7 --out family.smatatm");
        EXPECT_EQ(std::filesystem::file_size(folder / "family.smatatm"),
                  std::filesystem::file_size(folder / "window.smatatm"));
    }
    workbench.set("environment.atmospheres", (folder / "haze.csv").string());
    test::GuideWalk walk("air", "Temperature profile");
    walk.step("Tools → Temperature profile… plots the temperature of the atmosphere from a lowest "
              "to a highest altitude.");
    act("temperatureProfile");
    auto* tool = page<TemperatureProfilePage>();
    ASSERT_NE(tool, nullptr);
    write(get<QLineEdit>("min", tool), "250");
    write(get<QLineEdit>("max", tool), "1250");
    compute(*tool);
    const auto& altitudes = tool->table().columns().front().values;
    EXPECT_EQ(altitudes.front(), 250.0);
    EXPECT_EQ(altitudes.back(), 1250.0);
    walk.step("Radiative output and temperature profile show the command that does the same.");
    for (const char* name : {"radiativeOutput", "temperatureProfile"}) {
        act(name);
        auto* same = page<AtmosphereToolPage>();
        compute(*same);
        terminal(get<QLineEdit>("commandLine", same)->text().toStdString());
        const char* file = std::string(name) == "radiativeOutput" ? "radiative.csv" : "profile.csv";
        EXPECT_EQ(ResultTable::load(folder / file).columns(), same->table().columns()) << name;
    }
}

TEST_F(AtmosphereWalkTest, HotGas) {
    test::GuideWalk walk("air", "Hot gas");
    walk.step(
        "Tools → Hot gas… computes spectrum and band radiance of layers of combustion gas, as "
        "smat-batch gas does. It needs no project.");
    act("hotGas");
    auto* tool = page<GasPage>();
    ASSERT_NE(tool, nullptr);
    compute(*tool);
    terminal(get<QLineEdit>("commandLine", tool)->text().toStdString());
    EXPECT_EQ(ResultTable::load(folder / "gas.csv").columns(), tool->table().columns());
    openHaze();
    act("hotGas");
    tool = page<GasPage>();

    walk.step(
        "The list has the layers in order from the sensor, the fields below it the numbers "
        "of the chosen layer. The buttons above the list add a layer behind it, remove it and "
        "move it towards the sensor or away from it. Each edit is a step of Edit → Undo, which "
        "returns to the layer that was edited. What a layer cannot be is marked at its field with "
        "the reason, and discarded when you leave the field.");
    const auto temperatures_K = [&] {
        std::vector<double> all;
        for (const irsg::GasLayer& layer : tool->input().gas.layers) {
            all.push_back(layer.temperature_K);
        }
        return all;
    };
    get<QToolButton>("addLayer", tool)->click();
    auto* temperature = get<QLineEdit>("T_K", tool);
    write(temperature, "400");
    EXPECT_EQ(temperatures_K(), (std::vector{700.0, 400.0}));
    get<QToolButton>("layerUp", tool)->click();
    EXPECT_EQ(temperatures_K(), (std::vector{400.0, 700.0}));
    get<QToolButton>("layerDown", tool)->click();
    get<QToolButton>("removeLayer", tool)->click();
    EXPECT_EQ(temperatures_K(), (std::vector{700.0}));
    act("undo");
    EXPECT_EQ(temperatures_K(), (std::vector{700.0, 400.0}));
    EXPECT_EQ(tool->layers().chosen(), 1U);
    act("redo");
    EXPECT_EQ(temperatures_K(), (std::vector{700.0}));
    temperature->selectAll();
    QTest::keyClicks(temperature, "70");
    EXPECT_TRUE(temperature->toolTip().contains("250 to 3000 K"));
    QTest::keyClick(temperature, Qt::Key_Return);
    EXPECT_EQ(temperatures_K(), (std::vector{700.0}));

    walk.step("Black body behind gives the background a temperature. Atmosphere is none, that of "
              "the project (its files alone, not its sun and bins) or a file; with one, Altitude "
              "and Range give the path, and Sensor "
              "altitude where the sensor is not as high as the gas. Take from the project fills in "
              "band, atmosphere, altitude and range.");
    get<QCheckBox>("hasBackground", tool)->click();
    write(get<QLineEdit>("background", tool), "290");
    EXPECT_EQ(tool->input().gas.background_K, 290.0);
    choose(get<QComboBox>("gasAtmosphere", tool), 0);
    EXPECT_TRUE(tool->input().atmosphere.empty());
    write(get<QLineEdit>("gasBand", tool), "4-5");
    get<QPushButton>("takeFromProject", tool)->click();
    EXPECT_EQ(tool->input().atmosphere.size(), 1U);
    EXPECT_EQ(tool->input().altitude_m, 1000.0);
    EXPECT_EQ(tool->input().range_m, 500.0);
    EXPECT_EQ(tool->input().gas.band.min_um, 3.0);
    get<QCheckBox>("hasSensorAltitude", tool)->click();
    write(get<QLineEdit>("--sensor-altitude", tool), "1100");
    EXPECT_EQ(tool->input().sensorAltitude_m, 1100.0);

    walk.step("Compute plots the spectral radiance with its stated error. Tick What each gas adds, "
              "RADCAL and, with an atmosphere, Product of means to see them in the "
              "same plot, or choose Transmittance. The numbers of the band, and whose tables gave "
              "them, are below the buttons. File → Export… writes the same file as the command.");
    compute(*tool);
    const auto curves = [&] { return tool->plot().plot().cartesian()->data().curves.size(); };
    EXPECT_EQ(curves(), 1U);
    for (const char* one : {"gasParts", "gasRadcal", "gasProduct"}) {
        get<QCheckBox>(one, tool)->click();
    }
    EXPECT_EQ(curves(), 5U); // two gases
    choose(get<QComboBox>("quantity", tool), 1);
    EXPECT_EQ(curves(), 3U);
    EXPECT_TRUE(get<QLabel>("figures", tool)->text().contains("by lines"));
    chosen = path("exported.csv");
    act("exportShown");
    terminal(get<QLineEdit>("commandLine", tool)->text().toStdString());
    EXPECT_EQ(smat::test::withoutCommand(folder / "exported.csv"),
              smat::test::withoutCommand(folder / "gas.csv"));

    walk.step("Add to database… adds the chosen layer to the signature database as a gas zone, a "
              "material and a temperature, or the spectrum of a layer or of all layers as a "
              "user-defined spectrum, with a temperature that emits it and a material of its "
              "transmittance. Free indices are offered; it is one step of Edit → Undo.");
    const irsg::SignatureDatabase before = session().value();
    for (const int what : {0, 1}) {
        onDialog = [&](QDialog& dialog) {
            dialog.findChild<QComboBox*>("gasEntryWhat")->setCurrentIndex(what);
        };
        get<QPushButton>("addToDatabase", tool)->click();
        ASSERT_TRUE(test::waitUntil([&] { return !tool->isAdding(); }));
        EXPECT_EQ(session().value().materials.size(), before.materials.size() + 1) << said();
        EXPECT_EQ(session().value().temperatures.size(), before.temperatures.size() + 1);
        EXPECT_EQ(session().value().spectra.size(),
                  before.spectra.size() + static_cast<std::size_t>(what));
        act("undo");
        EXPECT_TRUE(session().value() == before);
    }
    onDialog = nullptr;
}

} // namespace
} // namespace smat::gui
