#pragma once

#include <optional>
#include <string>
#include <vector>

#include "irsg/radiometry/Quantity.h"
#include "irsg/scene/view/Pose.h"
#include "irsg/signature/EntityState.h"
#include "smatcore/project/Project.h"

namespace smat {

/// One drawing of a sweep, in terms that need no scene: attitude and state of the target and where
/// the camera is about its reference point.
struct AnalysisCase {
    enum class CameraPath {
        about,     ///< Viewpoint::about with `cameraYaw`, `azimuth`, `elevation`
        pitchPlane ///< Viewpoint::aroundPitchPlane with `angle`, in the model's own frame
    };

    double coordinate = 0.0; ///< angle, range or time in the plan's unit: the first column
    double time_s = 0.0;
    std::optional<double> power, mach; ///< of every entity; as the scene has them where not set
    std::optional<double> altitude_m;  ///< of the target's origin; the same
    irsg::Attitude attitude;
    CameraPath path = CameraPath::about;
    double cameraYaw_rad = 0.0; ///< yaw of the horizontal frame the camera's azimuth is counted in
    double azimuth_rad = 0.0;   ///< of the camera in that frame
    double elevation_rad = 0.0;
    double angle_rad = 0.0;
    double range_m = 0.0;

    // What the table says, deg: azimuth and elevation about the target at its attitude of this
    // case.
    double shownAzimuth_deg = 0.0;
    double shownElevation_deg = 0.0;
    double shownYaw_deg = 0.0;

    /// What a column of the table says of this case: an angle it shows, its range, or else its
    /// coordinate.
    double value(irsg::Quantity quantity) const;
    irsg::Viewpoint viewpoint(const irsg::Vec3& referencePoint) const;
    /// Where the target stands in this case before it turns, by its pose in the scene.
    irsg::Pose standing(const irsg::Pose& inScene) const;
    /// The target of standing() turned about its reference point, so that the camera keeps its
    /// range.
    irsg::Pose pose(const irsg::Pose& standing, const irsg::Vec3& referencePointInModel) const;
    /// What an entity does in this case, by what it does in the scene.
    irsg::EntityState state(irsg::EntityState inScene) const;
};

/// A sweep, expanded to its cases before anything is drawn.
struct AnalysisPlan {
    AnalysisKind kind = AnalysisKind::image;
    irsg::Quantity coordinate = irsg::Quantity::dimensionless;
    std::vector<irsg::Quantity> columns; ///< that say where a case is, the coordinate among them
    /// That tell one case from the others; none: the coordinate alone.
    std::vector<irsg::Quantity> axes;
    std::vector<AnalysisCase> cases;
    /// Many cases differ in nothing but the range, so that few drawings serve them all.
    bool isAlongRange = false;
    bool withSource = false;                ///< asks for the intensity without air, too
    std::vector<double> wavenumbers_per_cm; ///< of a spectrum, ascending

    /// "polar: 36 cases, angle 0 to 350 deg, 640 x 512 px".
    std::string description;

    /// Where a case is on the axis: "500 m", or on several: "azimuth 30 deg, elevation 5 deg".
    std::string place(const AnalysisCase& one) const;
};

/// The target and the camera as the settings place them: the case every sweep starts from.
AnalysisCase standingCase(const Settings& settings);

/// Throws InputError naming every setting that does not fit the others: a reversed sweep, a range
/// of 0 on a logarithmic axis, more than 1e6 cases, several bands of an image or a spectrum, the
/// published zoom in anything but an image (its samples do not add to pixels one to one, so that
/// the projected factors of sums never come from it).
AnalysisPlan planAnalysis(AnalysisKind kind, const Project& project, const Settings& settings);

} // namespace smat
