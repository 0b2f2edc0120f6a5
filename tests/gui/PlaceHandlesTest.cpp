#include "gui/view/PlaceHandles.h"

#include <cmath>

#include <gtest/gtest.h>

#include "gui/workbench/OrbitCamera.h"
#include "irsg/radiometry/Units.h"

namespace smat::gui {
namespace {

ViewProjection seenFrom(double azimuth_deg, double elevation_deg, const irsg::Vec3& about) {
    const OrbitCamera camera{azimuth_deg, elevation_deg, 200.0, {}};
    return ViewProjection::of(camera.viewpoint(about, 0.0), QSizeF(800, 600), 0.4);
}

PlaceHandles handlesAt(const irsg::Pose& pose) {
    PlaceHandles handles;
    handles.pose = pose;
    handles.length_m = 20.0;
    return handles;
}

const irsg::Pose somewhere{{30, -20, 50},
                           {irsg::radians(40), irsg::radians(15), irsg::radians(-25)}};

TEST(PlaceHandles, APointOnAnArrowGoesWithTheMouse) {
    const PlaceHandles handles = handlesAt(somewhere);
    const ViewProjection through = seenFrom(35, 25, somewhere.position_m);
    for (const PlaceHandle handle :
         {PlaceHandle::east, PlaceHandle::north, PlaceHandle::altitude}) {
        const irsg::Vec3 along = handles.axis(handle);
        for (const double way_m : {-7.0, 3.5, 11.0}) {
            const auto from = through.toWindow(somewhere.position_m + along * 15.0);
            const auto to = through.toWindow(somewhere.position_m + along * (15.0 + way_m));
            const auto change = handles.dragged(handle, from, to, through);
            ASSERT_TRUE(change);
            EXPECT_NEAR(*change, way_m, 1e-6);
        }
    }
}

/// The model is turned by an angle; a point that is fixed to it, on the ring, is followed.
TEST(PlaceHandles, ARingTurnsTheModelUnderTheMouse) {
    for (const double azimuth_deg : {10.0, 130.0, -70.0}) {
        const ViewProjection through = seenFrom(azimuth_deg, 40, somewhere.position_m);
        const PlaceHandles handles = handlesAt(somewhere);
        for (const PlaceHandle handle :
             {PlaceHandle::heading, PlaceHandle::pitch, PlaceHandle::roll}) {
            const irsg::Vec3 normal = handles.axis(handle);
            if (std::abs(irsg::dot(normal, through.eye.forward())) < 0.4) {
                continue; // edge-on
            }
            // A direction across the axis, in the axes of the model before the last turns.
            irsg::Attitude before = somewhere.attitude, after = before;
            const double change_deg = 20.0;
            double irsg::Attitude::*angle =
                handle == PlaceHandle::heading ? &irsg::Attitude::yaw_rad
                : handle == PlaceHandle::pitch ? &irsg::Attitude::pitch_rad
                                               : &irsg::Attitude::roll_rad;
            after.*angle +=
                irsg::radians(handle == PlaceHandle::heading ? -change_deg : change_deg);
            const irsg::Vec3 any =
                std::abs(normal.z) < 0.9 ? irsg::Vec3{0, 0, 1} : irsg::Vec3{1, 0, 0};
            const irsg::Vec3 arm = irsg::normalized(irsg::cross(any, normal)) * 16.0;
            const irsg::Vec3 inModel = before.rotation().transposed() * arm;
            const irsg::Vec3 turned = after.rotation() * inModel;
            const auto change =
                handles.dragged(handle, through.toWindow(somewhere.position_m + arm),
                                through.toWindow(somewhere.position_m + turned), through);
            ASSERT_TRUE(change) << keyOf(handle) << azimuth_deg;
            EXPECT_NEAR(*change, change_deg, 1e-6) << keyOf(handle) << azimuth_deg;
        }
    }
}

TEST(PlaceHandles, ARingSeenEdgeOnIsDraggedAlongItself) {
    // The camera is level: the ring of the heading is a line.
    irsg::Pose level = somewhere;
    level.attitude = {};
    const PlaceHandles handles = handlesAt(level);
    const ViewProjection through = seenFrom(0, 0, level.position_m);
    const QPointF middle = through.toWindow(level.position_m);
    const double pixelPerMetre = through.focalLength_px / 200.0;
    // Its near side, 16 m before the middle, goes to the right: counter-clockwise from above.
    const auto change = handles.dragged(PlaceHandle::heading, middle,
                                        middle + QPointF(2.0 * pixelPerMetre, 0.0), through);
    ASSERT_TRUE(change);
    EXPECT_NEAR(*change, -irsg::degrees(2.0 * 184.0 / 200.0 / 16.0), 0.2);
}

TEST(PlaceHandles, WhatIsUnderAPointIsTheNearestHandle) {
    const PlaceHandles handles = handlesAt(somewhere);
    const ViewProjection through = seenFrom(35, 25, somewhere.position_m);
    const auto tip = [&](PlaceHandle handle) {
        return through.toWindow(somewhere.position_m + handles.axis(handle) * handles.length_m);
    };
    for (const PlaceHandle handle :
         {PlaceHandle::east, PlaceHandle::north, PlaceHandle::altitude}) {
        EXPECT_EQ(handles.at(tip(handle), through), handle) << keyOf(handle);
    }
    EXPECT_EQ(handles.at(through.toWindow(somewhere.position_m), through), std::nullopt)
        << "where all arrows begin none is taken";
    EXPECT_EQ(handles.at({5, 5}, through), std::nullopt);
    PlaceHandles ofTarget = handles;
    ofTarget.shifts = false;
    EXPECT_NE(ofTarget.at(tip(PlaceHandle::east), through), PlaceHandle::east);
    EXPECT_EQ(ofTarget.at(tip(PlaceHandle::altitude), through), PlaceHandle::altitude);
}

TEST(PlaceHandles, AnArrowThatPointsAtTheEyeIsNotTaken) {
    const PlaceHandles handles = handlesAt(somewhere);
    const ViewProjection through = seenFrom(0, 90, somewhere.position_m);
    EXPECT_EQ(handles.dragged(PlaceHandle::altitude, {400, 300}, {410, 300}, through),
              std::nullopt);
    // And what is behind the eye has no line.
    PlaceHandles behind = handles;
    behind.pose.position_m.z += 1000.0;
    for (const PlaceHandle handle : allPlaceHandles) {
        EXPECT_TRUE(behind.line(handle, through).isEmpty()) << keyOf(handle);
    }
}

} // namespace
} // namespace smat::gui
