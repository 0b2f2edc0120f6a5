// Painting codes in the window: by click and box, undone, saved with the project, kept over a crash
// and a new export, and equal to what smat-batch counts.
#include <algorithm>
#include <fstream>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "gui/database/DatabaseDock.h"
#include "gui/paint/FacePainter.h"
#include "gui/project/SceneTreeDock.h"
#include "irsg/geometry/model/Painting.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/gui/FacePainterFixture.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;
using test::FacePainterTest;

TEST_F(FacePainterTest, APartIsPaintedByAClickSavedUndoneAndThereAgain) {
    openCubes();
    EXPECT_EQ(painter().mesh()->faces().size(), 24U);
    pickBy(PickBy::part);
    clickFace(seenFace(0));
    EXPECT_EQ(painter().chosen().size(), 12U);
    EXPECT_EQ(field<QLabel>("paintChosen")->text(), "12 faces, 24 m²");
    EXPECT_FALSE(field<QPushButton>("paintFaces")->isEnabled()) << "no index is given yet";
    give("1", "");
    const long readings = workbench.models()->readings();
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 12}, {{1, 0}, 12}}));
    EXPECT_EQ(workbench.models()->readings(), readings) << "the file was not read again";
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_FALSE(fs::exists(codesFile())) << "not before it is saved";
    ASSERT_TRUE(test::waitUntil([&] {
        return !window->tree().isLoading() && !window->tree().index().empty() &&
               window->tree().index().front().temperatures.contains(1);
    }));
    EXPECT_EQ(window->tree().index().front().temperatures.at(1).faces, 12);

    ASSERT_TRUE(saveProject()) << told.join('\n').toStdString();
    EXPECT_FALSE(window->isWindowModified());
    const auto saved = irsg::readModelCodes(file);
    ASSERT_EQ(saved.painted.size(), 1U);
    EXPECT_EQ(saved.painted[0].codes, (irsg::GivenCodes{1, std::nullopt}));
    EXPECT_EQ(saved.painted[0].triangles.size(), 12U);
    EXPECT_EQ(countsOfBatch(), counts());

    trigger("undo");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 24}}));
    EXPECT_TRUE(window->isWindowModified());
    trigger("redo");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 12}, {{1, 0}, 12}}));
    EXPECT_FALSE(window->isWindowModified()) << "as it is saved";

    ASSERT_TRUE(opens(folder / "cubes.smat"));
    showPainter();
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 12}, {{1, 0}, 12}}));
    EXPECT_EQ(irsg::readModelCodes(file), saved);

    // Erased and saved, no file is left.
    showCodes(CodesShown::temperature);
    emit field<QTreeWidget>("codeLegend")
        ->itemActivated(field<QTreeWidget>("codeLegend")->topLevelItem(1), 0);
    EXPECT_EQ(painter().chosen().size(), 12U);
    press("eraseFaces");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 24}}));
    ASSERT_TRUE(saveProject()) << told.join('\n').toStdString();
    EXPECT_FALSE(fs::exists(codesFile()));
}

TEST_F(FacePainterTest, ShiftAddsCtrlTakesAwayAndEscapeClears) {
    openCubes();
    const unsigned int first = seenFace(0), second = seenFace(12);
    clickFace(first);
    EXPECT_EQ(painter().chosen(), irsg::FaceNumbers{first});
    clickFace(second, Qt::ShiftModifier);
    EXPECT_EQ(painter().chosen(), (irsg::FaceNumbers{first, second}));
    clickFace(first, Qt::ControlModifier);
    EXPECT_EQ(painter().chosen(), irsg::FaceNumbers{second});
    pickBy(PickBy::angle);
    clickFace(first);
    EXPECT_EQ(painter().chosen().size(), 2U) << "the top of the cube";
    field<QDoubleSpinBox>("pickAngle")->setValue(95.0);
    clickFace(first);
    EXPECT_EQ(painter().chosen().size(), 12U);
    pickBy(PickBy::material);
    clickFace(second);
    EXPECT_EQ(painter().chosen().size(), 12U);
    EXPECT_EQ(painter().chosen().front(), 12U);
    QTest::keyClick(window->sceneView(), Qt::Key_Escape);
    EXPECT_TRUE(painter().chosen().empty());
    // Away from the painter a click picks an index, as ever.
    trigger("paintCodes");
    QTest::qWait(50);
    clickFace(first);
    EXPECT_TRUE(painter().chosen().empty());
    EXPECT_FALSE(window->sceneView()->highlighted().empty());
}

TEST_F(FacePainterTest, ABoxInTheViewTakesWhatIsSeenAndOnDemandTheRest) {
    openCubes();
    pickBy(PickBy::box);
    SceneView* view = window->sceneView();
    const auto before = view->camera();
    const auto draw = [&](Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(view, Qt::LeftButton, modifiers, {10, 40});
        QTest::mouseMove(view, {200, 200});
        QTest::mouseMove(view, {view->width() - 10, view->height() - 10});
        QTest::mouseRelease(view, Qt::LeftButton, modifiers,
                            {view->width() - 10, view->height() - 10});
    };
    draw(Qt::NoModifier);
    EXPECT_EQ(view->camera(), before) << "the camera stays";
    EXPECT_EQ(painter().chosen().size(), 12U) << "three sides of each";
    field<QCheckBox>("pickHidden")->setChecked(true);
    draw(Qt::NoModifier);
    EXPECT_EQ(painter().chosen().size(), 24U);
    draw(Qt::ControlModifier);
    EXPECT_TRUE(painter().chosen().empty());
}

TEST_F(FacePainterTest, TheInfraredPictureFollowsAtOnceAndAnalysesToo) {
    openCubes();
    workbench.set("environment.atmospheres", ""); // whose tables depend on what was asked before
    workbench.set("sensor.band", "3-5");
    workbench.set("render.antialiasing", "1");
    SceneView* view = window->sceneView();
    trigger("infraredDisplay");
    const auto hottest = [&] {
        const bool isThere = test::waitUntil(
            [&] {
                const auto* picture = view->shownPicture();
                return painter().isReady() && picture != nullptr && !picture->coarse &&
                       view->isUpToDate();
            },
            30.0);
        EXPECT_TRUE(isThere);
        return std::ranges::max(view->shownPicture()->plane().values);
    };
    const float cold = hottest();
    pickBy(PickBy::part);
    clickFace(seenFace(0));
    give("1", "1");
    press("paintFaces");
    const float hot = hottest();
    EXPECT_GT(hot, 10.0F * cold);
    test::keepScreenshot(*window, "paint-codes-infrared");
    runAnalysis("image");
    EXPECT_GT(std::ranges::max(workbench.results().back().data->image.primary().values),
              10.0F * cold);
    window->findChild<PageTabs*>()->setCurrentIndex(0);
    trigger("undo");
    EXPECT_NEAR(hottest(), cold, 1e-5F * cold);
}

TEST_F(FacePainterTest, ANewEntryIsOneStepAndOpenInTheEditor) {
    openCubes();
    const int steps = workbench.undoStack().count();
    onDialog = [](QDialog& dialog) {
        ASSERT_EQ(dialog.objectName(), "newEntryDialog");
        test::keepScreenshot(dialog, "paint-new-entry");
        dialog.findChild<QLineEdit*>("entryName")->setText("nozzle");
    };
    auto* box = field<IndexBox>("paintTemperature");
    emit box->activated(box->count() - 1);
    EXPECT_EQ(workbench.undoStack().count(), steps + 1);
    ASSERT_TRUE(workbench.database().value().temperatures.contains(2));
    EXPECT_EQ(workbench.database().value().temperatures.at(2).name, "nozzle");
    EXPECT_EQ(box->index(), 2);
    EXPECT_EQ(box->currentText(), "2  nozzle");
    EXPECT_EQ(window->databaseEditor().current(), (EntryKey{EntryKind::temperature, 2}));
    EXPECT_TRUE(window->databaseEditor().isVisible());
    clickFace(seenFace(0));
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 23}, {{2, 0}, 1}}));
    trigger("undo");
    trigger("undo");
    EXPECT_FALSE(workbench.database().value().temperatures.contains(2));
}

TEST_F(FacePainterTest, WhatIsNoIndexIsNotPainted) {
    openCubes();
    clickFace(seenFace(0));
    give("hot", "");
    EXPECT_FALSE(field<QPushButton>("paintFaces")->isEnabled());
    give("-7", "900");
    EXPECT_TRUE(field<QPushButton>("paintFaces")->isEnabled());
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(counts(), (Counts{{{-7, 900}, 1}, {{0, 0}, 23}}));
}

TEST_F(FacePainterTest, QuittingAsksAndNothingIsLost) {
    openCubes();
    clickFace(seenFace(0));
    give("1", "");
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    answer = -1;
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked.back(), "Unsaved changes");
    answers = {0};
    chosen = QString::fromStdString((folder / "cubes.smat").string());
    EXPECT_TRUE(window->close());
    EXPECT_EQ(irsg::readModelCodes(file).painted.size(), 1U);
}

TEST_F(FacePainterTest, AGivenUpPaintingIsGone) {
    openCubes();
    clickFace(seenFace(0));
    give("1", "");
    press("paintFaces");
    workbench.painted().writeRecoveryNow();
    EXPECT_TRUE(PaintedModels::leftBehind(folder / "other.obj") == std::nullopt);
    EXPECT_TRUE(fs::exists(folder / "cubes.codes.json.recovery"));
    answers = {1};
    ASSERT_TRUE(opens(file));
    EXPECT_FALSE(fs::exists(folder / "cubes.codes.json.recovery"));
    EXPECT_FALSE(workbench.painted().isDirty());
    showPainter();
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 24}}));
}

TEST_F(FacePainterTest, ACrashLeavesWhatWasPainted) {
    openCubes();
    {
        Workbench other;
        other.open(file);
        auto surfaces = irsg::painted({}, *painter().mesh(), {0, 1, 2}, {1, 1});
        other.painted().edit(fs::absolute(file), surfaces, "Paint");
        other.painted().writeRecoveryNow();
        EXPECT_FALSE(PaintedModels::leftBehind(file)) << "its window is still there";
        // It ends without being asked.
    }
    ASSERT_TRUE(PaintedModels::leftBehind(file));
    answers = {1, 0}; // the camera of this window was moved, too
    ASSERT_TRUE(opens(file));
    EXPECT_EQ(asked.back(), "Recover unsaved changes");
    showPainter();
    EXPECT_EQ(counts(), (Counts{{{0, 0}, 21}, {{1, 1}, 3}}));
    EXPECT_TRUE(window->isWindowModified());
    ASSERT_TRUE(saveProject());
    EXPECT_FALSE(PaintedModels::leftBehind(file));
    EXPECT_EQ(countsOfBatch(), counts());
}

TEST_F(FacePainterTest, RulesOfOthersStayAndPaintOfOthersIsAskedAbout) {
    openCubes();
    clickFace(seenFace(0));
    give("1", "");
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    // Another program writes rules: they are kept.
    irsg::ModelCodes others{{{irsg::CodeRule::Of::material, "Steel", {7, 7}}}, {}};
    irsg::saveModelCodes(others, file);
    ASSERT_TRUE(saveProject()) << told.join('\n').toStdString();
    EXPECT_EQ(irsg::readModelCodes(file).rules, others.rules);
    EXPECT_EQ(irsg::readModelCodes(file).painted.size(), 1U);
    // Another program paints, too.
    clickFace(seenFace(12));
    press("paintFaces");
    others.painted = irsg::painted({}, *painter().mesh(), {5}, {9, 9});
    irsg::saveModelCodes(others, file);
    answer = -1;
    saveProject();
    EXPECT_EQ(asked.back(), "Changed by another program");
    EXPECT_EQ(irsg::readModelCodes(file), others) << "as it was";
    EXPECT_TRUE(workbench.painted().isDirty());
    answer = 0;
    ASSERT_TRUE(saveProject());
    EXPECT_EQ(irsg::readModelCodes(file).painted.size(), 1U);
    EXPECT_EQ(irsg::readModelCodes(file).painted[0].triangles.size(), 2U);
    EXPECT_FALSE(workbench.painted().isDirty());
}

TEST_F(FacePainterTest, ADamagedFileOfCodesIsRefusedByNameAndLine) {
    openCubes();
    clickFace(seenFace(0));
    give("1", "");
    std::ofstream(codesFile()) << "{\"format\": \"smat-codes\", \"version\": 1,\n\"painted\": 7}";
    press("paintFaces");
    ASSERT_FALSE(told.isEmpty());
    EXPECT_TRUE(told.join(' ').contains("cubes.codes.json")) << told.join(' ').toStdString();
    EXPECT_TRUE(told.join(' ').contains("line 2")) << told.join(' ').toStdString();
    EXPECT_FALSE(workbench.painted().isDirty());
}

TEST_F(FacePainterTest, ANewExportKeepsWhatLiesWhereItLayAndTellsTheRest) {
    // Ten cubes, all painted; the export has one of them higher, the others are equal.
    openCubes(10);
    irsg::FaceNumbers all(120);
    for (unsigned int f = 0; f < all.size(); ++f) {
        all[f] = f;
    }
    painter().choose(all);
    give("1", "1");
    press("paintFaces");
    ASSERT_TRUE(waitForPainter());
    ASSERT_TRUE(saveProject());
    std::vector<double> high(10, 2.0);
    high[4] = 3.0;
    writeCubes(file, high);
    ASSERT_TRUE(opens(folder / "cubes.smat"));
    showPainter();
    // Of the higher one the bottom still lies there, and the sides that cover the old ones.
    const auto now = counts();
    EXPECT_GE(now.at({1, 1}), 108 + 2);
    EXPECT_GE(now.at({0, 0}), 2);
    EXPECT_EQ(now.at({1, 1}) + now.at({0, 0}), 120);
    EXPECT_EQ(countsOfBatch(), now);
    QString remarks;
    for (const auto& remark : window->sceneView()->scene().loaded.begin()->second->remarks()) {
        remarks += QString::fromStdString(remark) + '\n';
    }
    EXPECT_TRUE(remarks.contains("lie on no face of this model")) << remarks.toStdString();
    // What is new is painted over the old lists, which do not grow without end.
    painter().choose(all);
    for (int i = 0; i < 3; ++i) {
        give(QString::number(1 + i), "1");
        press("paintFaces");
        ASSERT_TRUE(waitForPainter());
    }
    EXPECT_EQ(counts(), (Counts{{{3, 1}, 120}}));
    const auto painted = workbench.painted().of(fs::absolute(file));
    std::size_t triangles = 0;
    for (const auto& surface : *painted) {
        triangles += surface.triangles.size();
    }
    EXPECT_LE(triangles, 120U + 2U);
}

TEST_F(FacePainterTest, AHelicopterOfAnotherProgramIsPaintedInColours) {
    file = folder / "helicopter.gltf";
    fs::copy_file(fs::path(SMAT_SOURCE_DIR) / "samples/helicopter/helicopter.gltf", file,
                  fs::copy_options::overwrite_existing);
    const fs::path project = folder / "helicopter.smat";
    std::ofstream(project)
        << R"({"version": 1, "models": [{"file": "helicopter.gltf", "unit_m": 0.01}]})";
    if (!opens(project)) {
        GTEST_SKIP() << "built without what reads glTF";
    }
    workbench.set("camera.azimuth", "120");
    workbench.set("camera.elevation", "20");
    trigger("showWholeModel");
    showPainter();
    const auto total = painter().mesh()->faces().size();
    ASSERT_GT(total, 100U);
    // Every material of the file by itself, by one of its faces.
    int index = 0;
    for (unsigned int f = 0; f < total; ++f) {
        const auto same = irsg::sameMaterialAs(*painter().mesh(), f);
        if (same.front() != f) {
            continue;
        }
        painter().choose(same);
        ++index;
        give(QString::number(index), QString::number(1 + index % 4));
        press("paintFaces");
    }
    ASSERT_TRUE(waitForPainter());
    EXPECT_EQ(index, 9);
    for (const auto shown : {CodesShown::temperature, CodesShown::material}) {
        showCodes(shown);
        const auto* legend = field<QTreeWidget>("codeLegend");
        EXPECT_EQ(legend->topLevelItemCount(), shown == CodesShown::material ? 4 : 9);
        long faces = 0;
        for (int row = 0; row < legend->topLevelItemCount(); ++row) {
            faces += legend->topLevelItem(row)->text(2).toInt();
        }
        EXPECT_EQ(faces, static_cast<long>(total));
    }
    showCodes(CodesShown::temperature);
    painter().choose(irsg::partOf(*painter().mesh(), 0));
    QTest::qWait(100);
    test::keepScreenshot(*window, "own-aircraft-paint");
    const auto counted = counts();
    trigger("saveProject");
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(countsOfBatch(), counted);
}

} // namespace
} // namespace smat::gui
