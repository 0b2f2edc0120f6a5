// Models of a scene placed by numbers and by handles, chosen by a click, and fitted into the view.
#include <cmath>

#include "gui/view/PlaceMouse.h"
#include "gui/view/ViewOverlay.h"
#include "irsg/radiometry/Units.h"
#include "tests/gui/SeveralModelsFixture.h"

namespace smat::gui {
namespace {

class PlacedModelsTest : public test::SeveralModelsFixture {};

TEST_F(PlacedModelsTest, ArePlacedByNumbers) {
    openThree();
    workbench.chooseModel(1);
    const Project before = workbench.editedProject();
    const long readings = workbench.models()->readings();
    struct Typed {
        const char* name;
        const char* text;
        const char* step;
    };
    const Typed all[] = {{"east", "320.5", "Set east of box to 320.5 m"},
                         {"north", "-40", "Set north of box to -40 m"},
                         {"altitude", "250", "Set altitude of box to 250 m"},
                         {"heading", "-90", "Set heading of box to 270°"},
                         {"pitch", "12", "Set pitch of box to 12°"},
                         {"roll", "-30", "Set roll of box to -30°"},
                         {"power", "0.75", "Set engine power of box to 0.75"},
                         {"mach", "0.4", "Set mach number of box to 0.4"},
                         {"timeOffset", "3", "Set time offset of box to 3 s"}};
    const int steps = workbench.undoStack().index();
    for (const Typed& typed : all) {
        type(typed.name, typed.text);
        EXPECT_EQ(next(), typed.step);
    }
    EXPECT_EQ(workbench.undoStack().index(), steps + static_cast<int>(std::size(all)));
    EXPECT_EQ(model(1).pose.position_m, irsg::Vec3(320.5, -40, 250));
    EXPECT_NEAR(irsg::degrees(model(1).pose.attitude.yaw_rad), 90, 1e-9);
    EXPECT_EQ(model(1).own, (StateOverride{0.75, 0.4, 3.0}));
    EXPECT_EQ(view()->scene().models[1].pose, model(1).pose) << "the view follows";
    EXPECT_EQ(workbench.models()->readings(), readings) << "nothing is read for it";
    const Project after = workbench.editedProject();

    // No number, and none that can be, has any effect.
    type("pitch", "120");
    type("mach", "fast");
    EXPECT_EQ(workbench.editedProject(), after);
    EXPECT_EQ(field("pitch")->text(), "12");
    type("power", ""); // as the target again
    EXPECT_EQ(model(1).own.power, std::nullopt);
    trigger("undo");
    for (std::size_t i = 0; i < std::size(all); ++i) {
        trigger("undo");
    }
    EXPECT_EQ(workbench.editedProject(), before);
    EXPECT_EQ(field("east")->text().toStdString(),
              smat::textOf(before, 1, *findModelField("east")));
    // The others' fields are their own.
    workbench.chooseModel(2);
    EXPECT_EQ(field("east")->text().toStdString(),
              smat::textOf(before, 2, *findModelField("east")));
}

TEST_F(PlacedModelsTest, ArePlacedByHandles) {
    openThree();
    workbench.set("camera.range", "600");
    workbench.set("camera.elevation", "35");
    workbench.set("sensor.fov", "30");
    workbench.chooseModel(1);
    QTest::qWait(50);
    const ProjectModel before = model(1);
    const Project whole = workbench.editedProject();
    for (const PlaceHandle handle : allPlaceHandles) {
        const PlaceHandles handles = view()->handles();
        const ViewProjection through = view()->projection();
        const QPolygonF line = handles.line(handle, through);
        ASSERT_GE(line.size(), 2) << keyOf(handle);
        const bool isRing = PlaceHandles::isRing(handle);
        // A ring is taken where nothing else is near; an arrow near its tip.
        std::optional<QPointF> from;
        for (qsizetype i = line.size() - 1; i > 0 && !from; --i) {
            if (const QPointF point = isRing ? line[i] : line[0] + 0.9 * (line[1] - line[0]);
                handles.at(point.toPoint(), through) == handle) {
                from = point;
            }
        }
        ASSERT_TRUE(from) << keyOf(handle);
        const QPointF middle = through.toWindow(handles.pose.position_m);
        const QPointF to = isRing
                               ? *from + QPointF(-(*from - middle).y(), (*from - middle).x()) * 0.4
                               : *from + (line[1] - line[0]) * 0.5;
        const auto change = handles.dragged(handle, from->toPoint(), to.toPoint(), through);
        ASSERT_TRUE(change) << keyOf(handle);
        EXPECT_GT(std::abs(*change), isRing ? 3.0 : 0.2 * handles.length_m) << keyOf(handle);
        const int steps = workbench.undoStack().index();
        drag(*from, to);
        EXPECT_EQ(workbench.undoStack().index(), steps + 1) << keyOf(handle) << " is one step";
        EXPECT_EQ(next(), isRing ? "Turn box" : "Move box");
        // What it changes, it changes by that; nothing else moves.
        for (const ModelField& field : modelFields()) {
            const double was = QString::fromStdString(field.text(before)).toDouble();
            const double is = QString::fromStdString(field.text(model(1))).toDouble();
            if (field.key == keyOf(handle)) {
                const double off =
                    isRing ? std::remainder(is - was - *change, 360.0) : is - was - *change;
                EXPECT_NEAR(off, 0.0, isRing ? 3.0 : 0.05 * std::abs(*change)) << field.key;
            } else if (field.key != "yaw" || handle != PlaceHandle::heading) {
                EXPECT_EQ(is, was) << field.key << " by " << keyOf(handle);
            }
        }
        trigger("undo");
        EXPECT_EQ(workbench.editedProject(), whole);
    }
    // The target is the origin of east and north: it has arrows up alone.
    workbench.chooseModel(0);
    EXPECT_TRUE(view()->handles().line(PlaceHandle::east, view()->projection()).isEmpty());
    EXPECT_FALSE(view()->handles().line(PlaceHandle::altitude, view()->projection()).isEmpty());
    // Beside the handles the mouse looks around as ever.
    drag({30, 300}, {80, 320});
    EXPECT_EQ(workbench.editedProject(), whole);
    workbench.chooseModel(1);
    view()->navigation().showCamera(ViewCamera::sensor);
    QTest::qWait(50);
    test::keepScreenshot(*window, "scene-handles");
}

TEST_F(PlacedModelsTest, AClickInTheViewSaysWhichOneIsMeant) {
    openThree();
    workbench.set("camera.range", "300");
    workbench.set("camera.elevation", "35");
    workbench.set("sensor.fov", "40");
    trigger("placeHandles"); // away, so that clicks are for faces
    for (const std::size_t number : {2U, 1U, 0U}) {
        const auto& shown = view()->scene().models.at(number);
        const QPointF at = view()->projection().toWindow(shown.pose.toWorld(shown.centre_m));
        const auto hits = view()->facesAt(at.toPoint());
        ASSERT_FALSE(hits.empty()) << number;
        QTest::mouseClick(view(), Qt::LeftButton, {}, at.toPoint());
        EXPECT_EQ(workbench.chosenModel(), number);
        EXPECT_EQ(workbench.database().file(),
                  std::filesystem::absolute(workbench.project().resolve(model(number).database))
                      .lexically_normal());
    }
}

TEST_F(PlacedModelsTest, FitTheViewAllOfThemOrTheChosenOne) {
    openSample();
    EXPECT_FALSE(window->findChild<QAction*>("fitChosenModel")->isEnabled());
    EXPECT_FALSE(window->findChild<QAction*>("showWholeScene")->isEnabled());
    addModel(copyOf("box/box.flt", "box/box.sigdb"));
    addModel(copyOf("sphere/sphere.flt", "sphere/sphere.sigdb"));
    workbench.chooseModel(1);
    type("east", "900");
    type("altitude", "260");
    const QRectF frame(view()->rect());
    /// Of the corners of a model's bounding box, in the window.
    const auto seen = [&](std::size_t number) {
        const irsg::BoundingBox box = view()->scene().models.at(number).faces->bounds();
        QRectF rect;
        for (int corner = 0; corner < 8; ++corner) {
            const irsg::Vec3 point{corner & 1 ? box.max.x : box.min.x,
                                   corner & 2 ? box.max.y : box.min.y,
                                   corner & 4 ? box.max.z : box.min.z};
            const QPointF at = view()->projection().toWindow(
                view()->scene().models.at(number).pose.toWorld(point));
            rect =
                corner == 0
                    ? QRectF(at, at)
                    : QRectF(
                          QPointF(std::min(rect.left(), at.x()), std::min(rect.top(), at.y())),
                          QPointF(std::max(rect.right(), at.x()), std::max(rect.bottom(), at.y())));
        }
        return rect;
    };
    for (const char* side : {"lookAtFront", "lookAtPort", "lookAtTop"}) {
        trigger(side);
        trigger("fitModel");
        QRectF all;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_TRUE(frame.contains(seen(i))) << side << ' ' << model(i).shownName();
            all = i == 0 ? seen(0) : all.united(seen(i));
        }
        // From port they lie behind one another.
        if (side != std::string("lookAtPort")) {
            EXPECT_GT(std::max(all.width() / frame.width(), all.height() / frame.height()), 0.5)
                << side;
        }
        const double before_px = seen(1).width();
        trigger("fitChosenModel");
        EXPECT_TRUE(frame.contains(seen(1))) << side;
        EXPECT_GT(seen(1).width(), std::max(10.0 * before_px, 0.1 * frame.width())) << side;
        EXPECT_LT(QLineF(seen(1).center(), frame.center()).length(), 0.05 * frame.width()) << side;
    }
    test::keepScreenshot(*window, "scene-fit-chosen");
    EXPECT_EQ(view()->cameras().sensor().range_m, workbench.camera().range_m) << "where it was";

    // The sensor looks at the target, from farther away.
    trigger("showWholeModel");
    const double ofTarget_m = workbench.camera().range_m;
    EXPECT_FALSE(frame.contains(seen(1)));
    trigger("showWholeScene");
    EXPECT_GT(workbench.camera().range_m, 5.0 * ofTarget_m);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(frame.contains(seen(i))) << model(i).shownName();
    }
    test::keepScreenshot(*window, "scene-whole");
}

} // namespace
} // namespace smat::gui
