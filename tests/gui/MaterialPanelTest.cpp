// How materials reflect, in the editor.
#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <gtest/gtest.h>

#include "gui/database/AngleCurve.h"
#include "gui/database/LitBallView.h"
#include "gui/database/NodeEditor.h"
#include "gui/widgets/Theme.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/gui/DatabaseEditorFixture.h"

namespace smat::gui {
namespace {

using test::DatabaseEditorTest;

TEST_F(DatabaseEditorTest, ChoosesHowAMaterialReflectsInStepsThatAreUndone) {
    const irsg::Material before = session().value().materials.at(1);
    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "Surface");
    auto* model = find<QComboBox>("surfaceModel");
    EXPECT_EQ(model->currentIndex(), 0);
    EXPECT_FALSE(find<QWidget>("roughness")->isVisible()) << "Lambertian surfaces have none";
    const QImage lambertian = find<LitBallView>("litBall")->picture();
    EXPECT_FALSE(lambertian.isNull());

    model->setCurrentIndex(model->findData("ggx"));
    emit model->activated(model->currentIndex());
    EXPECT_EQ(session().value().materials.at(1).surfaceModel, "ggx");
    EXPECT_TRUE(find<QWidget>("roughness")->isVisible());
    EXPECT_FALSE(find<QWidget>("grazingFactor")->isVisible());
    const QImage rough = find<LitBallView>("litBall")->picture();
    EXPECT_NE(rough, lambertian);
    type("roughness", "0.15");
    EXPECT_EQ(session().value().materials.at(1).roughness, 0.15);
    EXPECT_NE(find<LitBallView>("litBall")->picture(), rough) << "it follows as one types";
    test::keepScreenshot(*window, "editor-surface-ggx");

    workbench.undoStack().undo();
    EXPECT_EQ(session().value().materials.at(1).roughness, before.roughness);
    workbench.undoStack().undo();
    EXPECT_EQ(session().value().materials.at(1), before);
    EXPECT_EQ(model->currentIndex(), 0);
}

TEST_F(DatabaseEditorTest, ShowsEveryModelWithTheNumbersThatItTakes) {
    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "Surface");
    auto* model = find<QComboBox>("surfaceModel");
    for (const ThemeMode mode : {ThemeMode::light, ThemeMode::dark}) {
        applyTheme(*qApp, mode);
        for (const std::string& name : irsg::surfaceModelNames()) {
            model->setCurrentIndex(model->findData(QString::fromStdString(name)));
            ASSERT_GT(model->currentIndex(), 0) << name;
            emit model->activated(model->currentIndex());
            EXPECT_EQ(session().value().materials.at(1).surfaceModel, name);
            const auto& taken = irsg::fieldsOfSurfaceModel(name);
            for (const char* key :
                 {"roughness", "grazingFactor", "shadowTau_deg", "shadowOmega_deg"}) {
                EXPECT_EQ(find<QWidget>(key)->isVisible(),
                          std::ranges::find(taken, std::string(key)) != taken.end())
                    << name << " " << key;
            }
            for (const char* key : {"refractiveIndexForm", "extinctionForm",
                                    "diffuseReflectivityForm", "volumeReflectivityForm"}) {
                EXPECT_EQ(find<QWidget>(key)->isVisible(),
                          std::ranges::find(taken, QString(key).chopped(4).toStdString()) !=
                              taken.end())
                    << name << " " << key;
            }
            // What lacks n and k or a table has no ball, and says so.
            const bool lacks = name == "shellTarget" || name == "tabulated";
            EXPECT_EQ(find<LitBallView>("litBall")->picture().isNull(), lacks) << name;
            EXPECT_EQ(find<AngleCurve>("reflectanceOverAngle")->whyEmpty().isEmpty(), !lacks)
                << name;
            QTest::qWait(30);
            test::keepScreenshot(*window, "editor-surface-" + name +
                                              (mode == ThemeMode::dark ? "-dark" : "-light"));
        }
    }
    applyTheme(*qApp, ThemeMode::light);
}

TEST_F(DatabaseEditorTest, TakesIndexAndReflectivitiesOfShellsModelAsOneTypes) {
    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "Surface");
    const auto material = [&]() -> const irsg::Material& {
        return session().value().materials.at(1);
    };
    auto* model = find<QComboBox>("surfaceModel");
    model->setCurrentIndex(model->findData("shellTarget"));
    emit model->activated(model->currentIndex());
    auto* curve = find<AngleCurve>("reflectanceOverAngle");
    EXPECT_TRUE(curve->whyEmpty().contains("refractive index")) << curve->whyEmpty().toStdString();
    type("refractiveIndex", "2.5");
    EXPECT_EQ(material().refractiveIndex, irsg::Spectrum::constant(2.5));
    EXPECT_TRUE(curve->whyEmpty().isEmpty());
    // Each of the fields changes the ball, and undo brings it back.
    for (const auto& [key, text, member] :
         {std::tuple{"extinction", "3.5", &irsg::Material::extinction},
          std::tuple{"diffuseReflectivity", "0.1", &irsg::Material::diffuseReflectivity},
          std::tuple{"volumeReflectivity", "0.05", &irsg::Material::volumeReflectivity}}) {
        const QImage before = find<LitBallView>("litBall")->picture();
        EXPECT_FALSE(before.isNull()) << key;
        type(key, text);
        EXPECT_EQ(material().*member, irsg::Spectrum::constant(QString(text).toDouble())) << key;
        EXPECT_NE(find<LitBallView>("litBall")->picture(), before) << key;
    }
    workbench.undoStack().undo();
    EXPECT_EQ(material().volumeReflectivity, irsg::Spectrum());
    EXPECT_TRUE(find<QLineEdit>("volumeReflectivity")->text().startsWith("0"));
    // Over wavelength: nodes open, are edited, and the mean of the band is what is left of them.
    auto* form = find<QComboBox>("extinctionForm");
    form->setCurrentIndex(1);
    emit form->activated(1);
    auto* nodes = find<NodeEditor>("surfaceNodes");
    EXPECT_TRUE(nodes->isVisible());
    EXPECT_FALSE(find<QWidget>("extinction")->isVisible());
    EXPECT_FALSE(find<QWidget>("diffuseReflectivityForm")->isVisible()) << "nodes take its room";
    const QImage grey = find<LitBallView>("litBall")->picture();
    Nodes edited = nodes->nodes();
    ASSERT_EQ(edited.size(), 3u);
    edited[0].y = 0.1;
    fill(nodes, edited);
    EXPECT_EQ(material().extinction.at(edited[0].x), 0.1);
    EXPECT_EQ(material().extinction.at(edited[2].x), 3.5);
    EXPECT_NE(find<LitBallView>("litBall")->picture(), grey) << "it follows the nodes";
    for (const ThemeMode mode : {ThemeMode::light, ThemeMode::dark}) {
        applyTheme(*qApp, mode);
        QTest::qWait(60);
        test::keepScreenshot(*window, mode == ThemeMode::dark ? "editor-surface-spectral-dark"
                                                              : "editor-surface-spectral-light");
    }
    applyTheme(*qApp, ThemeMode::light);
    find<QPushButton>("extinctionNodes")->click();
    EXPECT_FALSE(nodes->isVisible());
    form->setCurrentIndex(0);
    emit form->activated(0);
    EXPECT_TRUE(material().extinction.isConstant());
    EXPECT_TRUE(find<QWidget>("extinction")->isVisible());
    // A number that cannot be is refused in the field.
    type("refractiveIndex", "-1");
    EXPECT_EQ(material().refractiveIndex, irsg::Spectrum::constant(2.5));
}

TEST_F(DatabaseEditorTest, EditsATableOfReflectanceFromTheEmissivityOn) {
    dock().select({EntryKind::material, 1});
    chooseTab("materialTabs", "Surface");
    const auto material = [&]() -> const irsg::Material& {
        return session().value().materials.at(1);
    };
    auto* model = find<QComboBox>("surfaceModel");
    model->setCurrentIndex(model->findData("tabulated"));
    emit model->activated(model->currentIndex());
    auto* curve = find<AngleCurve>("reflectanceOverAngle");
    EXPECT_TRUE(curve->whyEmpty().contains("no table yet")) << curve->whyEmpty().toStdString();
    find<QPushButton>("beginReflectance")->click();
    const irsg::ReflectanceTable begun = material().reflectanceTable;
    ASSERT_FALSE(begun.empty());
    EXPECT_FALSE(begun.isBrdf());
    EXPECT_NEAR(begun.at(0, 45.0), material().reflectivityAt(begun.wavelengths_um()[0]), 1e-6);
    const QImage before = find<LitBallView>("litBall")->picture();
    EXPECT_FALSE(before.isNull());

    auto* view = find<QTableView>("reflectanceTable");
    const int last = view->model()->rowCount() - 1;
    EXPECT_TRUE(view->model()->setData(view->model()->index(last, 1), "0.8", Qt::EditRole));
    EXPECT_NEAR(material().reflectanceTable.at(0, 85.0), 0.8, 1e-12);
    EXPECT_NE(find<LitBallView>("litBall")->picture(), before);
    EXPECT_FALSE(view->model()->setData(view->model()->index(0, 1), "1.2", Qt::EditRole))
        << "more than all light";
    EXPECT_FALSE(view->model()->setData(view->model()->index(0, 0), "85", Qt::EditRole))
        << "an angle that is there";
    view->setCurrentIndex(view->model()->index(last, 0));
    find<QToolButton>("insertReflectance")->click();
    EXPECT_EQ(material().reflectanceTable.rows().size(), begun.rows().size() + 1);
    EXPECT_EQ(material().reflectanceTable.rows().back().incidence_deg, 87.5);
    for (const ThemeMode mode : {ThemeMode::light, ThemeMode::dark}) {
        applyTheme(*qApp, mode);
        QTest::qWait(60);
        test::keepScreenshot(*window, mode == ThemeMode::dark ? "editor-surface-table-dark"
                                                              : "editor-surface-table-light");
    }
    applyTheme(*qApp, ThemeMode::light);
    // As every table of numbers by keys, too.
    view->setCurrentIndex(view->model()->index(0, 1));
    QApplication::clipboard()->setText("0.5\n0.6\n");
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_NEAR(material().reflectanceTable.rows()[0].values[0], 0.5, 1e-12);
    EXPECT_NEAR(material().reflectanceTable.rows()[1].values[0], 0.6, 1e-12);
    view->selectionModel()->select({view->model()->index(0, 0), view->model()->index(1, 1)},
                                   QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), "0\t0.5\n20\t0.6\n");
    QApplication::clipboard()->setText("1.2\n");
    view->setCurrentIndex(view->model()->index(0, 1));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_NEAR(material().reflectanceTable.rows()[0].values[0], 0.5, 1e-12);
    EXPECT_FALSE(find<QLabel>("reflectanceMessage")->styleSheet().isEmpty())
        << "more than all light";
    workbench.undoStack().undo();
    view->selectionModel()->select(view->model()->index(last + 1, 0),
                                   QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    find<QToolButton>("removeReflectance")->click();
    EXPECT_EQ(material().reflectanceTable.rows().size(), begun.rows().size());
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_EQ(material().reflectanceTable, begun);
}

} // namespace
} // namespace smat::gui
