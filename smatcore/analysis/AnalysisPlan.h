#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "irsg/core/Quantity.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/signature/EntityState.h"
#include "smatcore/analysis/ErrorColumns.h"
#include "smatcore/analysis/PartColumns.h"
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
    /// Of every entity without its own; as the scene has them where not set.
    std::optional<double> power, mach;
    std::optional<double> altitude_m; ///< of the target's origin; the same
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
    /// What an entity does in this case, by what it does in the scene and does by itself.
    irsg::EntityState state(irsg::EntityState inScene, const StateOverride& own) const;
};

/// What an adaptive sweep puts more cases into: the places along one of its axes.
struct RefinedAxis {
    irsg::Quantity quantity = irsg::Quantity::dimensionless;
    std::vector<double> places; ///< ascending
    bool isTurn = false;        ///< of 360 deg, whose end is its beginning
    double leastStep = 0.0;     ///< no two places come closer
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
    bool withSource = false; ///< asks for the intensity without air, too
    ErrorColumns errors = ErrorColumns::none;
    PartsBy parts = PartsBy::none;          ///< of a sweep
    std::vector<double> wavenumbers_per_cm; ///< of a spectrum, ascending
    /// Of an adaptive sweep: what is refined, and the cases at all places of these axes, in the
    /// order of the result; empty of one with fixed steps.
    std::vector<RefinedAxis> refined;
    std::function<std::vector<AnalysisCase>(const std::vector<RefinedAxis>&)> casesAt;
    double largestBend = 0.0; ///< of the curve between its cases, as a part: see AdaptiveSweep
    /// So many in all, where they bend most; of several axes without this bound.
    std::optional<std::size_t> mostRefined;

    /// "polar: 36 cases, angle 0 to 350 deg, 640 x 512 px".
    std::string description;

    /// Where a case is on the axis: "500 m", or on several: "azimuth 30 deg, elevation 5 deg".
    std::string place(const AnalysisCase& one) const;
};

/// Whether the cases of a plot follow its curves: where its `steps` say so, or are `auto` while
/// AnalysisDefinition::step, which would fix them, is so, too. Never of other analyses.
bool isAdaptivePlot(AnalysisKind kind, const Settings& settings);
/// These settings, with fixed steps where they leave it open: for what has to know all cases before
/// the first one.
Settings withFixedSteps(AnalysisKind kind, Settings settings);

/// The target and the camera as the settings place them: the case every sweep starts from.
AnalysisCase startingCase(const Settings& settings);

/// Throws InputError naming every setting that does not fit the others: a reversed sweep, a range
/// of 0 on a logarithmic axis, more than 1e6 cases, several bands of an image or a spectrum, the
/// published zoom in anything but an image (its samples do not add to pixels one to one, so that
/// the projected factors of sums never come from it).
AnalysisPlan planAnalysis(AnalysisKind kind, const Project& project, const Settings& settings);

} // namespace smat
