#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include "gui/tools/RadiativePage.h"
#include "gui/tools/TemperatureProfilePage.h"
#include "gui/widgets/Theme.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/SharedMaterial.h"

namespace smat::gui {
namespace {

const std::string haze = "# name: haze\n# air_temperature [K]: 290\n# ground_temperature [K]: 300\n"
                         "# sky_temperature [K]: 230\nwavelength [um],extinction [km-1]\n"
                         "2.5,1\n4,3\n6,2\n13,4\n";

class AtmosphereToolsTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (IsSkipped()) {
            return;
        }
        openSample();
        smat::test::write(folder / "haze.csv", haze);
        workbench.set("environment.atmospheres", (folder / "haze.csv").string());
        workbench.set("target.altitude", "1000");
        workbench.set("camera.range", "500");
    }
    template <typename Page>
    Page* opened(const char* action) {
        window->findChild<QAction*>(action)->trigger();
        QTest::qWait(20);
        auto* tabs = window->findChild<QTabWidget*>("tabs");
        return dynamic_cast<Page*>(tabs->currentWidget());
    }
    void compute(AtmosphereToolPage& page) {
        page.findChild<QPushButton*>("compute")->click();
        ASSERT_TRUE(test::waitUntil([&] { return !page.isRunning(); }, 60.0));
        QTest::qWait(20);
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    /// The table that the shown command writes.
    ResultTable fromTerminal(const AtmosphereToolPage& page, const std::string& file) {
        std::istringstream words(page.findChild<QLineEdit*>("commandLine")->text().toStdString());
        std::vector<std::string> list;
        for (std::string word; words >> word;) {
            list.push_back(word);
        }
        EXPECT_GT(list.size(), 3U);
        if (list.size() < 2) {
            return {};
        }
        list.erase(list.begin());
        const auto ran = smat::test::smatBatch(list, folder);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / file);
    }
    AnalysisData image() {
        return runDirectly(
            AnalysisData::of(workbench.project(), AnalysisKind::image, workbench.settings()));
    }
};

TEST_F(AtmosphereToolsTest, AreInTheMenuAsTheRegistryHasThem) {
    QStringList expected, shown;
    for (const AnalysisKind kind : allTools()) {
        // That of a scenario is run on its page.
        if (kind != AnalysisKind::simulation) {
            expected << kind->title;
        }
    }
    const auto* menu =
        dynamic_cast<const QMenu*>(window->findChild<QAction*>("radiativeOutput")->parent());
    ASSERT_NE(menu, nullptr);
    for (const QAction* action : menu->actions()) {
        const QString title = action->text().remove('&').remove(QStringLiteral("…"));
        if (expected.contains(title)) {
            shown << title;
            EXPECT_FALSE(action->icon().isNull()) << title.toStdString();
            EXPECT_FALSE(action->toolTip().isEmpty()) << title.toStdString();
        }
    }
    EXPECT_EQ(shown, expected);
    EXPECT_EQ(shown.size(), 7);
}

TEST_F(AtmosphereToolsTest, RadiativeOutputEqualsTheCommandLine) {
    auto* page = opened<RadiativePage>("radiativeOutput");
    ASSERT_NE(page, nullptr);
    compute(*page);
    const ResultTable& shown = page->table();
    EXPECT_EQ(shown.columns().size(), 2U + 7U);
    EXPECT_EQ(shown.columns(), fromTerminal(*page, "radiative.csv").columns());
    EXPECT_EQ(shown.provenance.value("range [m]"), "500");
    EXPECT_TRUE(page->findChild<QLabel*>("figures")->text().contains("transmittance"));
    test::keepScreenshot(*window, "radiative-output");

    // One spectrum of another place of the viewer.
    for (const char* name : {"path", "background", "sun", "up", "down", "scattering"}) {
        page->findChild<QCheckBox*>(name)->setChecked(false);
    }
    auto* range = page->findChild<QLineEdit*>("camera.range");
    range->selectAll();
    QTest::keyClicks(range, "2000");
    compute(*page);
    EXPECT_EQ(page->table().columns().size(), 3U);
    EXPECT_EQ(page->table().columns(), fromTerminal(*page, "radiative.csv").columns());
    EXPECT_EQ(page->table().provenance.value("range [m]"), "2000");
    EXPECT_EQ(workbench.settings().text("camera.range"), "500");
}

TEST_F(AtmosphereToolsTest, TheCommandLineFollowsTheFormBeforeAnythingIsComputed) {
    auto* page = opened<RadiativePage>("radiativeOutput");
    auto* command = page->findChild<QLineEdit*>("commandLine");
    ASSERT_TRUE(test::waitUntil([&] { return command->text().startsWith("smat-batch"); }));
    for (const char* text : {"2000", "750"}) {
        auto* range = page->findChild<QLineEdit*>("camera.range");
        range->selectAll();
        QTest::keyClicks(range, text);
        EXPECT_TRUE(command->text().contains(QString("--range=") + text))
            << command->text().toStdString();
    }
    page->findChild<QCheckBox*>("sun")->setChecked(false);
    const QString before = command->text();
    const ResultTable ofTerminal = fromTerminal(*page, "radiative.csv");
    compute(*page);
    EXPECT_EQ(command->text(), before);
    EXPECT_EQ(page->table().columns(), ofTerminal.columns());
    EXPECT_EQ(page->table().provenance.value("range [m]"), "750");
}

TEST_F(AtmosphereToolsTest, SeveralAtmospheresHaveACommandOfTheSameSpectra) {
    smat::test::write(folder / "near.csv", "# name: near\n# air_temperature [K]: 270\n"
                                           "wavelength [um],extinction [km-1]\n3,0\n5,0\n");
    workbench.set("environment.atmospheres",
                  (folder / "near.csv").string() + ";" + (folder / "haze.csv").string());
    auto* radiative = opened<RadiativePage>("radiativeOutput");
    compute(*radiative);
    EXPECT_EQ(radiative->table().columns(), fromTerminal(*radiative, "radiative.csv").columns());
    auto* profile = opened<TemperatureProfilePage>("temperatureProfile");
    compute(*profile);
    EXPECT_EQ(profile->table().columns(), fromTerminal(*profile, "profile.csv").columns());
    EXPECT_EQ(profile->table().find("temperature")->values.front(), 270.0);
}

TEST_F(AtmosphereToolsTest, TheProjectLooksTheSameInItsOwnExportedAir) {
    // So thin that it is one slice of air along the model, since what is exported holds one path.
    smat::test::write(folder / "thin.csv", "# name: thin\n# air_temperature [K]: 270\n"
                                           "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    workbench.set("environment.atmospheres", (folder / "thin.csv").string());
    const AnalysisData before = image();
    auto* page = opened<RadiativePage>("radiativeOutput");
    compute(*page);
    chosen = QString::fromStdString((folder / "air.csv").string());
    page->findChild<QPushButton*>("useInProject")->click();
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(workbench.settings().text("environment.atmospheres"),
              chosen.toStdString() + ";" + (folder / "thin.csv").string());
    const AnalysisData after = image();
    const auto& a = before.image.primary().values;
    const auto& b = after.image.primary().values;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_NEAR(b[i], a[i], 1e-6 * std::abs(a[i])) << i;
    }
    EXPECT_NE(after.table.provenance.value("answered by").find("spectra of air.csv"),
              std::string::npos);
    // The air takes part: without any the image is another one.
    workbench.set("environment.atmospheres", "none");
    EXPECT_GT(std::abs(image().image.at(32, 24) - before.image.at(32, 24)),
              0.01 * before.image.at(32, 24));
    // One step takes it back.
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.settings().text("environment.atmospheres"), (folder / "thin.csv").string());
}

TEST_F(AtmosphereToolsTest, KeepsItsAnswerAmongTheResults) {
    auto* page = opened<RadiativePage>("radiativeOutput");
    EXPECT_FALSE(page->findChild<QPushButton*>("keepResult")->isEnabled());
    compute(*page);
    page->findChild<QPushButton*>("keepResult")->click();
    ASSERT_EQ(workbench.results().size(), 1U);
    EXPECT_EQ(workbench.results()[0].data->table, page->table());
    EXPECT_EQ(workbench.results()[0].origin, ResultEntry::Origin::tool);
    page->exportTo(folder / "kept.json");
    EXPECT_EQ(loadResult(folder / "kept.json").table, page->table());
    page->exportTo(folder / "kept.svg");
}

TEST_F(AtmosphereToolsTest, SaysWhatIsWrongAsOneTypesAndWhatTheAirRefuses) {
    auto* page = opened<RadiativePage>("radiativeOutput");
    auto* range = page->findChild<QLineEdit*>("camera.range");
    range->selectAll();
    QTest::keyClicks(range, "far");
    EXPECT_FALSE(page->findChild<QPushButton*>("compute")->isEnabled());
    EXPECT_TRUE(page->findChild<QLabel*>("problems")->text().contains("Range"));
    range->selectAll();
    QTest::keyClicks(range, "500");
    auto* band = page->findChild<QLineEdit*>("sensor.band");
    band->selectAll();
    QTest::keyClicks(band, "20-30");
    // All spectra that the air has there: none.
    page->findChild<QPushButton*>("compute")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !page->isRunning(); }));
    EXPECT_FALSE(told.isEmpty());
    EXPECT_TRUE(page->table().empty());
}

TEST_F(AtmosphereToolsTest, TemperatureProfileEqualsTheCommandLine) {
    auto* page = opened<TemperatureProfilePage>("temperatureProfile");
    ASSERT_NE(page, nullptr);
    for (const auto& [name, text] :
         {std::pair("min", "250"), std::pair("max", "1250"), std::pair("step", "12.5")}) {
        auto* field = page->findChild<QLineEdit*>(name);
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    compute(*page);
    EXPECT_EQ(page->table().rowCount(), 81U);
    EXPECT_EQ(page->table().columns(), fromTerminal(*page, "profile.csv").columns());
    test::keepScreenshot(*window, "temperature-profile");

    auto* step = page->findChild<QLineEdit*>("step");
    for (const char* wrong : {"0", "-5", "x", ""}) {
        step->setText(wrong);
        EXPECT_FALSE(page->findChild<QPushButton*>("compute")->isEnabled()) << wrong;
        EXPECT_FALSE(page->findChild<QLabel*>("problems")->text().isEmpty()) << wrong;
    }
    // Air without a temperature is refused by name.
    workbench.set("environment.atmospheres", "none");
    step->setText("100");
    page->findChild<QPushButton*>("compute")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !page->isRunning(); }));
    EXPECT_EQ(told.size(), 1);
}

TEST_F(AtmosphereToolsTest, AComputedAtmosphereShowsItsProfileAndSpectra) {
    const auto smart = smat::test::sharedMaterial("data/karma/AtmosphereSmart.xml");
    if (smart.empty()) {
        GTEST_SKIP() << "the shared folder with AtmosphereSmart.xml is not here";
    }
    applyTheme(*qApp, ThemeMode::dark);
    window.reset();
    makeWindow();
    openSample();
    workbench.set("environment.atmospheres", smart.string());
    workbench.set("target.altitude", "1000");
    auto* profile = opened<TemperatureProfilePage>("temperatureProfile");
    compute(*profile);
    EXPECT_GT(profile->table().find("temperature")->values.front(), 250.0);
    test::keepScreenshot(*window, "temperature-profile-dark");
    auto* page = opened<RadiativePage>("radiativeOutput");
    compute(*page);
    test::keepScreenshot(*window, "radiative-output-dark");
    applyTheme(*qApp, ThemeMode::light);
    EXPECT_GT(page->table().rowCount(), 50U);
}

TEST_F(AtmosphereToolsTest, ClosesWhileItComputes) {
    auto* page = opened<RadiativePage>("radiativeOutput");
    page->findChild<QPushButton*>("compute")->click();
    EXPECT_TRUE(page->isRunning());
    delete page;
    page = opened<RadiativePage>("radiativeOutput");
    page->findChild<QPushButton*>("compute")->click();
    page->findChild<QPushButton*>("cancel")->click();
    EXPECT_FALSE(page->isRunning());
    EXPECT_TRUE(page->findChild<QPushButton*>("compute")->isEnabled());
    compute(*page); // the next answer is its own
    EXPECT_FALSE(page->table().empty());
    page->findChild<QPushButton*>("compute")->click();
    window.reset();
}

} // namespace
} // namespace smat::gui
