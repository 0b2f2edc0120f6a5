#include <QApplication>
#include <QClipboard>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QTreeWidget>

#include "gui/database/AngleCurve.h"
#include "gui/database/CopyEntriesDialog.h"
#include "gui/database/DatabaseBanner.h"
#include "gui/database/FindingsPanel.h"
#include "gui/database/LitBallView.h"
#include "gui/database/NodePlot.h"
#include "irsg/signature/MaterialLibrary.h"
#include "irsg/signature/ScalingXml.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class DatabaseWalkTest : public test::GuideFixture {
  protected:
    void SetUp() override {
        GuideFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("turboprop4", {{"render.bounces", "0"},
                                    {"sensor.width", "64"},
                                    {"sensor.height", "48"},
                                    {"sensor.fov", "3"},
                                    {"camera.azimuth", "60"},
                                    {"camera.elevation", "12"},
                                    {"camera.range", "900"},
                                    {"target.altitude", "1500"},
                                    {"render.antialiasing", "0"},
                                    {"state.power", "0.7"},
                                    {"state.mach", "0.4"}});
        }
    }
    const irsg::Material& material(int index = 1) { return session().value().materials.at(index); }
    const irsg::TemperatureEntry& temperature(int index) {
        return session().value().temperatures.at(index);
    }
    QImage ball() { return find<LitBallView>("litBall")->picture(); }
    void chooseModel(const char* name) {
        auto* model = find<QComboBox>("surfaceModel");
        choose(model, model->findData(name));
    }
    QWidget* panel(const char* name) { return find<QWidget>(name); }
};

TEST_F(DatabaseWalkTest, SelectAndSee) {
    test::GuideWalk walk("database", "");
    walk.step(
        "It is edited in a dock of its own (View → Signature database), and the view shows every "
        "edit at once.");
    EXPECT_TRUE(dock().isVisible());
    SceneView& view = *window->sceneView();
    view.showWholeModel();
    act("infraredDisplay");
    const auto sum = [&] { return sumOfPicture(view); };
    const double before = sum();
    session().edit("Set emissivity", [](irsg::SignatureDatabase& database) {
        database.materials.at(1).emissivity = irsg::Spectrum::constant(0.3);
    });
    EXPECT_NE(sum(), before);
    act("undo");

    walk.step("Click on a face in the view: its entries are selected. Select an entry: its faces "
              "are highlighted. Every edit is a step of undo with a name. The number of faces that "
              "carry an index is shown beside it, also when it is renumbered or deleted.");
    QPoint at;
    std::optional<int> clicked;
    for (int y = 10; y < view.height() && !clicked; y += 7) {
        for (int x = 10; x < view.width() && !clicked; x += 7) {
            const auto hits = view.facesAt(QPointF(x, y));
            if (!hits.empty() && hits.front().codes.material == 1) {
                clicked = hits.front().codes.temperature;
                at = {x, y};
            }
        }
    }
    ASSERT_TRUE(clicked);
    dock().select({EntryKind::material, 2});
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    dock().tabs()->setCurrentIndex(0);
    EXPECT_EQ(*dock().current(), (EntryKey{EntryKind::material, 1}));
    dock().tabs()->setCurrentIndex(1);
    EXPECT_EQ(*dock().current(), (EntryKey{EntryKind::temperature, *clicked}));
    dock().tabs()->setCurrentIndex(0);
    QApplication::setActiveWindow(window.get());
    auto* table = find<QTableView>("entryTable", dock().tabs()->widget(0));
    table->setFocus();
    ASSERT_TRUE(test::waitUntil([&] { return QApplication::focusWidget() == table; }, 5.0));
    QTest::keyClick(table, Qt::Key_Down);
    EXPECT_EQ(view.highlighted(), (FaceSelection{{}, 2, 0}));
    dock().select({EntryKind::material, 1});
    type("entryName", "primer", panel("materialPanel"));
    EXPECT_EQ(workbench.undoStack().undoText(), "Rename material 1");
    EXPECT_TRUE(find<QLabel>("entryCaption", panel("materialPanel"))->text().contains("faces"));
    QString said;
    accept = false;
    onDialog = [&](QDialog& dialog) {
        if (auto* key = dialog.findChild<QLineEdit*>("newKey")) {
            key->setText("77");
        }
        for (const char* name : {"consequence", "question"}) {
            if (const auto* label = dialog.findChild<QLabel*>(name)) {
                said = label->text();
            }
        }
    };
    for (const char* button : {"renumberEntry", "removeEntry"}) {
        said.clear();
        find<QToolButton>(button, dock().tabs()->widget(0))->click();
        EXPECT_TRUE(said.contains("faces")) << button << said.toStdString();
    }
    accept = true;
    onDialog = nullptr;
    session().discard();
}

TEST_F(DatabaseWalkTest, Material) {
    test::GuideWalk walk("database", "Material");
    test::keepClipboard();
    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "Emissivity");
    auto* emissivity = panel("emissivity");
    walk.step("Emissivity and transmissivity, grey or spectral, as a table beside its plot; "
              "reflectivity is the remainder to 1 and is shown with them.");
    auto* table = emissivity->findChild<NodeTable*>();
    auto* plot = emissivity->findChild<NodePlot*>();
    ASSERT_TRUE(table->model()->setData(table->model()->index(0, 1), "0.5", Qt::EditRole));
    EXPECT_EQ(material().emissivity.values().front(), 0.5);
    EXPECT_FALSE(find<QLabel>("reflectivity", emissivity)->text().isEmpty());
    EXPECT_FALSE(table->model()->setData(table->model()->index(0, 1), "1.5", Qt::EditRole));
    const auto paste = [&](const char* cells) {
        QApplication::clipboard()->setText(cells);
        table->setFocus();
        table->setCurrentIndex(table->model()->index(0, 0));
        QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
    };
    paste("1.4\t1.5\n");
    const QString refused = find<QLabel>("nodeMessage", emissivity)->text();
    EXPECT_TRUE(refused.contains("row 1, column 2") && refused.contains("1.5"))
        << refused.toStdString();
    const auto nodes = plot->nodes().size();
    const QPointF node = plot->positionOf(2);
    drag(plot->canvas(), Qt::LeftButton, node, {0, 12});
    EXPECT_LT(material().emissivity.values()[2], 0.92);
    const double x = material().emissivity.wavelengths_um()[2];
    drag(plot->canvas(), Qt::LeftButton, plot->positionOf(2), {15, 8}, Qt::ShiftModifier);
    EXPECT_EQ(material().emissivity.wavelengths_um()[2], x) << "Shift: only its value";
    const QPointF between = (plot->positionOf(7) + plot->positionOf(8)) / 2.0;
    QTest::mouseDClick(plot->canvas(), Qt::LeftButton, {}, between.toPoint());
    EXPECT_EQ(material().emissivity.values().size(), nodes + 1);
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_Delete);
    EXPECT_EQ(material().emissivity.values().size(), nodes);
    paste("1.4\t0.61\n2.2\t0.62\n");
    EXPECT_EQ(material().emissivity.values().front(), 0.61)
        << find<QLabel>("nodeMessage", emissivity)->text().toStdString();
    choose(find<QComboBox>("form", emissivity), 0);
    type("greyValue", "0.6", emissivity);
    EXPECT_EQ(material().emissivity, irsg::Spectrum::constant(0.6));
    chooseTab("materialTabs", "N angle factor");
    type("nAngleFactor", "1.5");
    EXPECT_EQ(material().nAngleFactor, 1.5);

    walk.step("The page Surface sets how the material reflects over directions. Lambertian is "
              "equal in all; the facets suit metals and glossy coats (roughness 0.02 is a polished "
              "sheet, 0.1 to 0.3 gloss or untreated metal, 0.5 and more matt)");
    type("nAngleFactor", "0");
    chooseTab("materialTabs", "Surface");
    const QImage matt = ball();
    chooseModel("ggx");
    type("roughness", "0.02");
    const QImage polished = ball();
    EXPECT_NE(polished, matt);
    type("roughness", "0.5");
    EXPECT_NE(ball(), polished) << "it follows as one types";
    chooseModel("shellTarget");
    auto* curve = find<AngleCurve>("reflectanceOverAngle");
    EXPECT_TRUE(curve->whyEmpty().contains("refractive index")) << "the plot says what is lacking";
    type("refractiveIndex", "2.5");
    type("extinction", "3.5");
    EXPECT_TRUE(curve->whyEmpty().isEmpty());
    choose(find<QComboBox>("extinctionForm"), 1); // Spectral
    EXPECT_TRUE(find<QWidget>("surfaceNodes")->isVisible());
    choose(find<QComboBox>("extinctionForm"), 0);
    chooseModel("tabulated");
    find<QPushButton>("beginReflectance")->click();
    EXPECT_FALSE(material().reflectanceTable.empty());
    auto* cells = find<QTableView>("reflectanceTable")->model();
    EXPECT_TRUE(cells->setData(cells->index(cells->rowCount() - 1, 1), "0.8", Qt::EditRole));
    const auto import = [&](const char* name, const std::string& text) {
        smat::test::write(folder / name, text);
        chosen = path(name);
        find<QPushButton>("importSurface")->click();
    };
    dock().select({EntryKind::material, 3});
    session().edit("Lambertian again", [](irsg::SignatureDatabase& database) {
        database.materials.at(3).surfaceModel = "ggx";
    });
    trigger("saveDatabase");
    ASSERT_TRUE(told.isEmpty()) << said();
    std::filesystem::copy_file(folder / "turboprop4.sigdb", folder / "model.sigdb");
    walk.step("smat-batch db import n-and-k.csv model.sigdb --as material --material 3");
    import("n-and-k.csv", "wl,n\n3,2\n5,3\n\nwl,k\n3,20\n5,30\n");
    terminal("smat-batch db import n-and-k.csv model.sigdb --as material --material 3");
    const auto ofTerminal = [this] {
        return irsg::loadSignatureFile(folder / "model.sigdb").database.materials.at(3);
    };
    EXPECT_EQ(ofTerminal(), material(3));
    walk.step("smat-batch db import coat.bsdf model.sigdb --as reflectance --material 3");
    const std::string tableText = "incidence_deg,3,5\n0,0.2,0.4\n90,1,1\n";
    import("table.csv", tableText);
    terminal("smat-batch db import table.csv model.sigdb --as reflectance --material 3");
    EXPECT_EQ(ofTerminal(), material(3));
    EXPECT_EQ(material(3).surfaceModel, "tabulated");

    walk.step(
        "Import material…, in the menu of the database and beside the list, reads emissivity, "
        "transmissivity, reflectivity, n and k from a CSV file whose first cell is um or cm-1");
    smat::test::write(folder / "paint.csv",
                      "um,emissivity,reflectivity\n3,0.9,0.1\n4,0.8,0.2\n5,0.7,0.3\n");
    chosen = path("paint.csv");
    int index = 0;
    onDialog = [&](QDialog& dialog) {
        index = dialog.findChild<QLineEdit*>("materialIndex")->text().toInt();
        EXPECT_TRUE(dialog.findChild<QLabel*>("outcome")->text().contains(
            "Emissivity: 3 nodes from 3 to 5"));
    };
    find<QToolButton>("importMaterial")->click();
    EXPECT_TRUE(session().value().materials.contains(index));
    smat::test::write(folder / "paint.csv", "um,emissivity\n3,0.9\n4,abc\n5,1.7\n");
    onDialog = [&](QDialog& dialog) {
        const QString words = dialog.findChild<QLabel*>("outcome")->text();
        EXPECT_TRUE(words.contains("line 3")) << words.toStdString();
    };
    accept = false;
    find<QAction>("menuImportMaterial")->trigger();
    accept = true;

    walk.step("Add from library… has common paints, metals and grounds with the origin of their "
              "values. Copy from another database… copies entries, and first shows what happens to "
              "equal indices.");
    onDialog = [&](QDialog& dialog) {
        auto& copy = dynamic_cast<CopyEntriesDialog&>(dialog);
        copy.choose({EntryKind::material, 1});
        EXPECT_FALSE(copy.findChild<QPlainTextEdit*>("copyNotes") == nullptr &&
                     copy.findChild<QLabel*>("copyNotes") == nullptr);
        auto* list = copy.findChild<QTreeWidget*>("copyList");
        auto* clash = static_cast<QComboBox*>(list->itemWidget(list->topLevelItem(0)->child(0), 3));
        EXPECT_FALSE(clash->isHidden()) << "1 is taken";
        clash->setCurrentIndex(1);
    };
    find<QToolButton>("addFromLibrary")->click();
    EXPECT_EQ(material(1), irsg::materialLibrary().materials.at(1));
    EXPECT_FALSE(material(1).notes.empty());
    chosen = QString(SMAT_SOURCE_DIR) + "/samples/box/box.sigdb";
    const auto count = session().value().temperatures.size();
    onDialog = [](QDialog& dialog) {
        dynamic_cast<CopyEntriesDialog&>(dialog).choose({EntryKind::temperature, 2});
    };
    find<QAction>("copyFromDatabase")->trigger();
    onDialog = nullptr;
    EXPECT_EQ(session().value().temperatures.size(), count + 1);
    session().discard();
}

TEST_F(DatabaseWalkTest, Temperature) {
    test::GuideWalk walk("database", "Temperature");
    walk.step("Use temperature: the surface temperature of the report's equation 7. In the tab of "
              "its terms are T_0, the share of the ambient temperature, the recovery term 0.2 r "
              "M², ΔT, and tables over time, engine power, altitude, Mach number and the ambient "
              "temperature. The result for the present state is shown below.");
    dock().select({EntryKind::temperature, 1});
    chooseTab("temperatureTabs", "Equation terms");
    for (const auto& [field, text] : {std::pair{"base_K", "10"},
                                      {"ambientFactor", "0.9"},
                                      {"recoveryFactor", "0.85"},
                                      {"ambientOffset_K", "5"}}) {
        type(field, text);
    }
    const irsg::TemperatureTerms& terms = temperature(1).terms;
    EXPECT_EQ(terms.base_K, 10.0);
    EXPECT_EQ(terms.ambientFactor, 0.9);
    EXPECT_EQ(terms.recoveryFactor, 0.85);
    EXPECT_EQ(terms.ambientOffset_K, 5.0);
    auto* tables = find<QTabBar>("termTables");
    EXPECT_EQ(tables->count(), 5);
    tables->setCurrentIndex(1);
    fill(panel("termsPanel"), {{0, 0}, {1, 100}});
    EXPECT_EQ(temperature(1).terms.power.at(0.7), 70.0);
    // By hand: T_amb from what the program says of the state.
    chooseTab("temperatureTabs", "Result");
    const QString result = find<QLabel>("resultingTemperature")->text();
    const double air_K = 288.15; // as the project has no air
    const double wanted_K =
        10.0 + 0.9 * air_K * (1.0 + 0.2 * 0.85 * 0.4 * 0.4 + 5.0 / air_K) + 70.0;
    const QRegularExpression number(R"((\d+(\.\d+)?)\s*K)");
    const auto match = number.match(result);
    ASSERT_TRUE(match.hasMatch()) << result.toStdString();
    EXPECT_NEAR(match.captured(1).toDouble(), wanted_K, 0.2) << result.toStdString();

    walk.step("User-defined spectrum: the sum of components, each with a constant factor or tables "
              "over time (which may repeat) and angle. Both are stored; Tables or Constant alone "
              "chooses.");
    int plume = 0;
    for (const auto& [index, entry] : session().value().temperatures) {
        plume = entry.mode == irsg::EmissionMode::userSpectrum && plume == 0 ? index : plume;
    }
    dock().select({EntryKind::temperature, plume});
    chooseTab("temperatureTabs", "Factors");
    auto* factors = panel("factorsPanel");
    type("factorConstant", "0.5", factors);
    const auto factor = [&]() -> const irsg::ComponentFactor& {
        return temperature(plume).factors.front();
    };
    EXPECT_EQ(factor().constant, 0.5);
    auto* selection = find<QComboBox>("factorSelection", factors);
    EXPECT_EQ(selection->findText("Tables") >= 0 && selection->findText("Constant alone") >= 0,
              true);
    choose(selection, selection->findText("Constant alone"));
    EXPECT_EQ(factor().selection, irsg::FactorSelection::constant);
    choose(selection, selection->findText("Tables"));
    EXPECT_EQ(factor().constant, 0.5) << "both are kept";
    session().discard();
}

TEST_F(DatabaseWalkTest, SpectrumFindingsAndSafety) {
    {
        test::GuideWalk walk("database", "Spectrum");
        walk.step(
            "Measured or computed radiance, component by component, imported from CSV with um or "
            "cm-1 in its first cell. Up to its reference distance the atmosphere is part of the "
            "measurement");
        dock().tabs()->setCurrentIndex(2);
        smat::test::write(folder / "gas.csv", "um,CO2,H2O\n3,1,2\n4,3,2\n5,1,2\n");
        chosen = path("gas.csv");
        onDialog = [](QDialog& dialog) {
            dialog.findChild<QComboBox*>("radianceUnit")->setCurrentText("W m-2 sr-1 um-1");
            dialog.findChild<QLineEdit*>("importDistance")->setText("12");
        };
        find<QToolButton>("importSpectrum")->click();
        onDialog = nullptr;
        const auto& gas = session().value().spectra.at("gas");
        EXPECT_EQ(gas.components.size(), 2U);
        EXPECT_EQ(gas.referenceDistance_m, 12.0);
    }
    {
        test::GuideWalk walk("database", "Findings");
        walk.step(
            "The editor checks the physics as you type: sums of emissivity and transmissivity, "
            "spectra that do not cover the band, impossible units, tables that do not ascend, "
            "temperatures out of range, indices without entries, entries without faces, and the "
            "scaling files beside the model.");
        dock().findings()->look();
        const int before = dock().findings()->errors();
        session().edit("Spoil it", [](irsg::SignatureDatabase& database) {
            database.materials.at(1).emissivity = irsg::Spectrum::constant(92.0);
        });
        ASSERT_TRUE(test::waitUntil([&] { return dock().findings()->errors() == before + 1; }))
            << "by itself, a moment after the edit";
        dock().tabs()->setCurrentIndex(3);
        auto* findings = find<QTreeWidget>("findings");
        QTreeWidgetItem* item = nullptr;
        for (int i = 0; i < findings->topLevelItemCount(); ++i) {
            if (findings->topLevelItem(i)->text(0).startsWith("materials.1")) {
                item = findings->topLevelItem(i);
            }
        }
        ASSERT_NE(item, nullptr);
        emit findings->itemActivated(item, 0);
        EXPECT_EQ(*dock().current(), (EntryKey{EntryKind::material, 1})) << "goes to the place";
        // A database with errors cannot be saved.
        act("saveDatabase");
        EXPECT_TRUE(session().isDirty());
        told.clear();
        irsg::SignatureDatabase spoilt = session().value();
        spoilt.materials.at(1).emissivity = irsg::Spectrum::constant(0.5);
        std::string text = irsg::signatureToJson(spoilt);
        const std::string right = "\"emissivity\": 0.5";
        ASSERT_NE(text.find(right), std::string::npos);
        smat::test::write(folder / "spoilt.json",
                          text.replace(text.find(right), right.size(), "\"emissivity\": 92"));
        EXPECT_NE(terminal("smat-batch db lint spoilt.json", 2).out.find("materials.1"),
                  std::string::npos);
        dock().tabs()->setCurrentIndex(3);
        dock().findings()->look();
        for (int i = 0; i < findings->topLevelItemCount(); ++i) {
            if (findings->topLevelItem(i)->text(0).startsWith("materials.1")) {
                item = findings->topLevelItem(i);
            }
        }
        auto* repair = qobject_cast<QPushButton*>(findings->itemWidget(item, 3));
        ASSERT_NE(repair, nullptr);
        EXPECT_EQ(repair->text(), "Repair");
        repair->click();
        EXPECT_EQ(material().emissivity, irsg::Spectrum::constant(0.92));
    }
    test::GuideWalk walk("database", "Nothing is lost");
    walk.step("A save is one transaction: a crash leaves the old state or the new one. Unsaved "
              "edits are in a recovery copy beside the file and are offered the next time");
    session().writeRecoveryNow();
    const auto recovery = session().recoveryFile();
    ASSERT_TRUE(std::filesystem::exists(recovery));
    std::filesystem::copy_file(recovery, folder / "copy");
    session().discard();
    std::filesystem::copy_file(folder / "copy", recovery);
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    QTest::qWait(20);
    ASSERT_TRUE(dock().banner()->isVisible());
    find<QPushButton>("recover")->click();
    EXPECT_EQ(material().emissivity, irsg::Spectrum::constant(0.92));
    chosen = path("elsewhere.sigdb");
    act("saveDatabaseAs");
    EXPECT_TRUE(std::filesystem::exists(folder / "elsewhere.sigdb")) << said();
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
