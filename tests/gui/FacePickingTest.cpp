#include <cmath>

#include <QSignalSpy>
#include <QTreeWidget>

#include "gui/MainWindow.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/widgets/Theme.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "tests/gui/ViewFixture.h"

namespace smat::gui {
namespace {

using test::apart;

class FacePickingTest : public test::ViewFixture {
  protected:
    /// Planes of indices from the renderer itself, for the same camera.
    irsg::RadianceImage truth() {
        project.settings.set("image.truthLayers", "true");
        project.settings.set("render.antialiasing", 0);
        SceneBuilder builder;
        AnalysisGenerator generator(openRenderDoor(), [&](const Project& p, const Settings& s) {
            return builder.build(p, s);
        });
        AnalysisData data = AnalysisData::of(project, AnalysisKind::image);
        generator.run(data);
        return data.image;
    }
    void click(const QPoint& at) {
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        QTest::qWait(20);
    }
};

TEST_F(FacePickingTest, NamesTheIndicesThatTheRendererSees) {
    for (const auto* name : {"turboprop4", "ship"}) {
        Project shown = sample(name);
        shown.settings.set("target.yaw", 20);
        shown.settings.set("target.roll", 10);
        ASSERT_NO_FATAL_FAILURE(show(shown));
        const irsg::RadianceImage image = truth();
        const auto& temperature = image.find("temperature_index")->values;
        const auto& material = image.find("material_index")->values;
        const auto& range = image.find("range")->values;
        long on = 0, wrong = 0;
        for (int y = 2; y < image.height(); y += 5) {
            for (int x = 2; x < image.width(); x += 5) {
                const auto i = image.offset(x, y);
                const auto hits = view.facesAt(QPointF(x + 0.5, y + 0.5) / pixelRatio());
                if (std::isnan(range[i]) || hits.empty()) {
                    wrong += std::isnan(range[i]) != hits.empty();
                    continue;
                }
                ++on;
                const FaceHit& hit = hits.front();
                // Subfaces lie in the plane of the face below and are drawn over it.
                const bool found = std::any_of(hits.begin(), hits.end(), [&](const FaceHit& h) {
                    return h.distance_m < hit.distance_m + 0.02 &&
                           h.codes.temperature == static_cast<int>(temperature[i]) &&
                           h.codes.material == static_cast<int>(material[i]);
                });
                wrong += !found || std::abs(hit.distance_m - static_cast<double>(range[i])) > 0.2;
            }
        }
        EXPECT_GT(on, 60) << name;
        EXPECT_LE(wrong, on / 25) << name << " of " << on;
    }
}

TEST_F(FacePickingTest, AClickPicksAndADragDoesNot) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    QSignalSpy picked(&view, &SceneView::facePicked);
    QSignalSpy nothing(&view, &SceneView::nothingPicked);
    const auto hits = view.facesAt({200.0, 150.0});
    ASSERT_FALSE(hits.empty());
    click({200, 150});
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked.front().at(0).toInt(), hits.front().codes.temperature);
    EXPECT_EQ(picked.front().at(1).toInt(), hits.front().codes.material);
    EXPECT_EQ(picked.front().at(2).toInt(), 0);
    const auto point = picked.front().at(3).value<irsg::Vec3>();
    EXPECT_LT(QLineF(view.projection().toWindow(point), {200.0, 150.0}).length(), 1.0);
    EXPECT_TRUE(view.highlighted().holds(0, hits.front().codes));

    // Again: something else behind, or the same where there is nothing.
    click({200, 150});
    ASSERT_EQ(picked.count(), 2);
    const bool hasOther = std::any_of(hits.begin(), hits.end(), [&](const FaceHit& hit) {
        return hit.codes != hits.front().codes;
    });
    EXPECT_EQ(picked.at(1).mid(0, 2) != picked.at(0).mid(0, 2), hasOther);

    click({3, 3});
    EXPECT_EQ(picked.count(), 2);
    EXPECT_EQ(nothing.count(), 1);
    EXPECT_TRUE(view.highlighted().empty());

    const OrbitCamera before = view.camera();
    QTest::mousePress(&view, Qt::LeftButton, {}, {200, 150});
    QTest::mouseMove(&view, {203, 151}); // a hand that trembles
    EXPECT_EQ(view.camera(), before);
    QTest::mouseMove(&view, {260, 170});
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {260, 170});
    EXPECT_EQ(picked.count(), 2);
    EXPECT_NE(view.camera(), before);
}

TEST_F(FacePickingTest, TheReadOutTellsValueAndIndices) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    const auto hit = view.facesAt({200, 150}).front();
    const QString indices = view.readoutAt({200, 150});
    EXPECT_TRUE(indices.contains(QString("temperature %1").arg(hit.codes.temperature)))
        << indices.toStdString();
    EXPECT_TRUE(indices.contains(QString("material %1").arg(hit.codes.material)));
    EXPECT_FALSE(indices.contains("Radiance"));
    ASSERT_TRUE(showInfrared());
    const double value =
        static_cast<double>(view.shownPicture()->image->at(pixels(200), pixels(150)));
    const QPointF middle = QPointF(200.0, 150.0) + QPointF(0.5, 0.5) / pixelRatio();
    EXPECT_TRUE(view.readoutAt(middle).startsWith(
        QString("Radiance %1 W").arg(QString::number(value, 'g', 6))))
        << view.readoutAt(middle).toStdString();
    EXPECT_FALSE(view.readoutAt({2, 2}).contains("temperature"));
}

TEST_F(FacePickingTest, MarksExactlyTheFacesOfAnIndexInBothDisplays) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    const auto codes = view.facesAt({200, 150}).front().codes;
    for (const bool infrared : {false, true}) {
        if (infrared) {
            ASSERT_TRUE(showInfrared());
        }
        for (const FaceSelection& selection :
             {FaceSelection{codes.temperature, {}, {}}, FaceSelection{{}, codes.material, {}},
              FaceSelection{codes.temperature, codes.material, 0}}) {
            view.setHighlighted({});
            QTest::qWait(20);
            const QImage plain = view.grabFramebuffer();
            view.setHighlighted(selection);
            QTest::qWait(20);
            const QImage marked = view.grabFramebuffer();
            long wrong = 0, on = 0;
            for (int y = 4; y < 300; y += 4) {
                for (int x = 4; x < 400; x += 4) {
                    // Outlines are a few pixels wide: only places well inside count.
                    const auto insideAt = [&](double dx, double dy) {
                        const auto hits = view.facesAt({x + 0.5 + dx, y + 0.5 + dy});
                        return !hits.empty() && selection.holds(0, hits.front().codes);
                    };
                    const bool inside = insideAt(0, 0);
                    bool isEdge = false;
                    for (int k = -6; k <= 6; k += 2) {
                        for (int l = -6; l <= 6; l += 2) {
                            isEdge = isEdge || insideAt(k, l) != inside;
                        }
                    }
                    if (isEdge) {
                        continue;
                    }
                    on += inside;
                    const bool tinted = apart(test::colorAt(plain, QPointF(x, y)),
                                              test::colorAt(marked, QPointF(x, y))) > 60;
                    wrong += tinted != inside;
                }
            }
            EXPECT_GT(on, 10);
            // Edges that something hides shine through.
            EXPECT_LE(wrong, on / 3) << (infrared ? "infrared" : "visible");
        }
        view.setHighlighted({});
    }
}

TEST_F(FacePickingTest, AnotherModelsFacesStayUnmarked) {
    const FaceSelection ofSecond{3, {}, 1};
    EXPECT_FALSE(ofSecond.holds(0, {3, 7}));
    EXPECT_TRUE(ofSecond.holds(1, {3, 7}));
    EXPECT_FALSE(FaceSelection{}.holds(0, {3, 7}));
    EXPECT_FALSE((FaceSelection{3, 8, {}}.holds(0, {3, 7})));
}

TEST_F(FacePickingTest, TheSceneTreeAndTheViewNameTheSameFaces) {
    Workbench workbench;
    MainWindow window(workbench);
    window.resize(1000, 700);
    window.show();
    ASSERT_TRUE(window.open(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.smat"));
    auto* tree = window.findChild<SceneTreeDock*>();
    SceneView& seen = *window.sceneView();
    ASSERT_TRUE(test::waitUntil([&] { return !tree->isLoading() && !window.isLoadingModel(); }));
    emit tree->indexSelected(IndexKind::material, 2, 0);
    EXPECT_EQ(seen.highlighted(), (FaceSelection{{}, 2, 0}));
    emit tree->nothingSelected();
    EXPECT_TRUE(seen.highlighted().empty());

    seen.showWholeModel();
    QTest::qWait(50);
    const QPoint middle = seen.rect().center();
    const auto hits = seen.facesAt(middle);
    ASSERT_FALSE(hits.empty());
    QTest::mouseClick(&seen, Qt::LeftButton, {}, middle);
    const auto* list = tree->findChild<QTreeWidget*>();
    ASSERT_NE(list->currentItem(), nullptr);
    EXPECT_TRUE(
        list->currentItem()->text(0).contains(QString::number(hits.front().codes.temperature)))
        << list->currentItem()->text(0).toStdString();
    workbench.cancel();
}

} // namespace
} // namespace smat::gui
