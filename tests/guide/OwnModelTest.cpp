// The guide's chapter "Your own aircraft": a model without codes, in centimetres, from its file to
// a polar plot.
#include <algorithm>
#include <fstream>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTreeWidget>

#include "gui/paint/FacePainter.h"
#include "gui/paint/PaintDock.h"
#include "gui/project/FirstSignatureDialog.h"
#include "gui/project/PlacingFields.h"
#include "gui/widgets/NumberField.h"
#include "irsg/geometry/model/PlacingGuess.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class OwnModelTest : public test::GuideFixture {
  protected:
    void SetUp() override {
        GuideFixture::SetUp();
        try {
            irsg::placingGuess(copyOfSample());
        } catch (const irsg::InputError& error) {
            if (std::string(error.what()).find("Assimp") != std::string::npos) {
                GTEST_SKIP() << "built without what reads glTF";
            }
        }
    }
    std::filesystem::path copyOfSample() {
        auto file = folder / "helicopter.gltf";
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
    /// The paragraph about painting, word by word.
    void paint(SceneView& view) {
        get<QAction>("infraredDisplay")->setChecked(false);
        EXPECT_EQ(get<QAction>("paintCodes")->shortcut(), QKeySequence(Qt::Key_F4));
        if (!window->findChild<PaintDock*>()->isVisible()) {
            act("paintCodes");
        }
        auto& painter = *window->findChild<FacePainter*>();
        ASSERT_TRUE(test::waitUntil([&] { return painter.isReady(); }, 20.0));
        act("lookAtPort");
        act("fitModel");
        QTest::qWait(50);
        auto* pick = get<QComboBox>("pickBy");
        for (const char* words : {"Single faces", "Connected part", "All of one material",
                                  "Smooth surface", "Box in the view"}) {
            EXPECT_GE(pick->findText(words), 0) << words;
        }
        EXPECT_NE(get<QWidget>("pickAngle"), nullptr);
        EXPECT_NE(get<QCheckBox>("pickHidden"), nullptr);
        const auto count = [&] { return painter.chosen().size(); };
        QPoint hull;
        for (int x = 0; x < view.width() / 2 && hull.isNull(); x += 5) {
            for (const int side : {1, -1}) {
                const QPoint at = view.rect().center() + QPoint(side * x, 0);
                hull = view.facesAt(at).empty() ? hull : at;
            }
        }
        ASSERT_FALSE(hull.isNull());
        choose(pick, pick->findText("Single faces"));
        QTest::mouseClick(&view, Qt::LeftButton, {}, hull);
        EXPECT_EQ(count(), 1U);
        choose(pick, pick->findText("All of one material"));
        QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, hull);
        const auto more = count();
        EXPECT_GT(more, 1U) << "Shift adds";
        choose(pick, pick->findText("Single faces"));
        QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, hull);
        EXPECT_EQ(count(), more - 1) << "Ctrl takes away";
        // A material of the database for them; the empty field leaves their temperatures.
        auto* material = get<QComboBox>("paintMaterial");
        EXPECT_TRUE(material->itemText(material->count() - 1).contains("New entry"));
        choose(material, 1);
        const int steps = workbench.undoStack().index();
        get<QPushButton>("paintFaces")->click();
        EXPECT_EQ(workbench.undoStack().index(), steps + 1);
        get<QPushButton>("eraseFaces")->click();
        act("undo");
        act("undo");
        EXPECT_EQ(workbench.undoStack().index(), steps);
        act("redo");
        choose(get<QComboBox>("codesShown"), 2);
        QTest::qWait(50);
        auto* legend = get<QTreeWidget>("codeLegend");
        ASSERT_GT(legend->topLevelItemCount(), 3);
        EXPECT_GT(legend->topLevelItem(0)->text(2).toInt(), 0) << "faces";
        emit legend->itemActivated(legend->topLevelItem(0), 0);
        // Faces without an area are chosen and not listed.
        EXPECT_NEAR(static_cast<double>(count()), legend->topLevelItem(0)->text(2).toDouble(), 2.0);
        test::keepScreenshot(*window, "own-aircraft-paint");
    }
    static bool isReady(const QDialog& dialog) {
        const auto* create = dialog.findChild<QPushButton*>("create");
        const auto* placing = dialog.findChild<PlacingFields*>();
        return test::waitUntil([&] { return create->isEnabled() && placing->guess() != nullptr; });
    }
};

TEST_F(OwnModelTest, FromAFileWithoutCodesToAPolarPlot) {
    test::GuideWalk walk("own-aircraft");
    walk.note(
        "A model of your own has no infrared codes: nothing says which face is paint and which "
        "is an exhaust.");
    walk.step(
        "Open it. File → Open model… (Ctrl+Shift+O), and choose "
        "samples/helicopter/helicopter.gltf; glTF, FBX, COLLADA, OBJ, 3DS, AC, PLY, STL and "
        "OpenFlight are read. The signature database at the side says that this model has none "
        "yet.");
    EXPECT_EQ(get<QAction>("openModel")->shortcut(), QKeySequence("Ctrl+Shift+O"));
    chosen = QString::fromStdString(copyOfSample().string());
    act("openModel");
    ASSERT_TRUE(waitForModel());
    ASSERT_TRUE(told.isEmpty()) << said();
    EXPECT_FALSE(workbench.database().isOpen());
    dock().raise();
    QTest::qWait(30);
    EXPECT_TRUE(get<QLabel>("bannerText")->isVisible()) << "it has none yet";
    walk.step("Name what it is made of. File → First signature from names…, or the button for it "
              "in the database. Each row is a name in the file, of a material, an object or a "
              "group, with its suggestion: Exhaust_Pipe is oxidised nickel alloy, 400 K warmer "
              "than the air");
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
        walk.step(
            "Place it. The tab Placing says how the file's axes and unit are interpreted, and "
            "shows the model with a man beside it. By its standard glTF is in metres; this "
            "helicopter would then be 1.2 km long, so centimetres are proposed. If a guess is "
            "wrong, choose up, nose, unit or origin by hand; Guess from the model restores the "
            "proposal.");
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

    walk.step(
        "See it. Create writes helicopter.codes.json and helicopter.sigdb beside the model and "
        "names both in the project. View → Infrared display (Ctrl+Shift+I) shows it: the pipes "
        "shine");
    EXPECT_EQ(workbench.project().models.front().database.filename(), "helicopter.sigdb");
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

    walk.step("Paint what has no name. View → Paint codes (F4) takes faces by hand. Pick sets what "
              "a click in the view selects: Single faces, a Connected part, All of one material, a "
              "Smooth surface, which ends where it bends by more than the angle, or a Box in the "
              "view, with Also hidden faces on demand. Shift adds to the selection, Ctrl takes "
              "away.");
    paint(*view);

    walk.step("Plot it. Analysis → New polar analysis… (Ctrl+3), Run. Save the project (Ctrl+S)");
    workbench.set("polar.step", "45");
    runAnalysis("polar");
    const auto polar = workbench.results().back().data->table;
    chosen = QString::fromStdString((folder / "helicopter.smat").string());
    trigger("saveProject");
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();

    const Project saved = loadProject(folder / "helicopter.smat");
    EXPECT_EQ(saved.models.front().options.placing.unit_m, 0.01);
    AnalysisData data = AnalysisData::of(saved, AnalysisKind::polar, workbench.settings());
    const ResultTable direct = runDirectly(data).table;
    for (std::size_t i = 0; i < polar.rowCount(); ++i) {
        const double wanted = polar.find("intensity")->values[i];
        // Painted faces are grouped as they are read: light between them is as exact as is asked,
        // here to 0.02 of what a surface sees.
        EXPECT_NEAR(direct.find("intensity")->values[i], wanted, 1e-2 * std::abs(wanted)) << i;
    }

    walk.step("The file with the codes has a rule for each name. It stays valid when the model is "
              "exported anew");
    EXPECT_NE(smat::test::contentOf(folder / "helicopter.codes.json").find("Exhaust_Pipe"),
              std::string::npos);
    const auto alone = folder / "alone";
    std::filesystem::create_directories(alone);
    std::filesystem::copy_file(folder / "helicopter.gltf", alone / "helicopter.gltf");
    folder = alone;
    walk.step("smat-batch model codes helicopter.gltf --suggest --database helicopter.sigdb");
    terminal("smat-batch model codes helicopter.gltf --suggest --database helicopter.sigdb");
    walk.step("smat-batch polar helicopter.gltf --unit cm --range 1000 --out polar.csv");
    terminal("smat-batch polar helicopter.gltf --unit cm --range 1000 --out polar.csv --step 90 "
             "--bounces 0 --antialiasing 0");
    EXPECT_EQ(ResultTable::load(folder / "polar.csv").rowCount(), 4U);
    walk.note("and single rules are written as");
    walk.step("smat-batch model codes helicopter.gltf --rule \"material:Paint_*=1,1\" --rule "
              "\"object:Engine=2,5\"");
    terminal("smat-batch model codes helicopter.gltf --rule material:Paint_*=1,1 --rule "
             "object:Engine=2,5");
    EXPECT_NE(smat::test::contentOf(folder / "helicopter.codes.json").find("Paint_*"),
              std::string::npos);
    walk.note("See models for how files are placed and what is in the file with the codes.");
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
