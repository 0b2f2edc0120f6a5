#pragma once

#include <string>
#include <vector>

#include "benchmarks/antialiasing/Study.h"
#include "tests/support/SceneFixtures.h"

/// What the study of antialiasing looks at and compares with.
namespace irsg::study {

inline constexpr double pixel_rad = 1e-4;

/// A grey body without transparent parts.
struct Body {
    std::string name;
    test::Triangles mesh;
    double size_m = 1.0; ///< what its size in pixels is counted by
    Attitude attitude;
    double azimuth_rad = 0.0, elevation_rad = 0.0; ///< that it is seen from
    /// No point of the image is seen through two of its front faces: solid angles add.
    bool facesAdd = true;
};

/// Sphere, L-shaped plate upright and turned by 7 degrees, winged body seen at 30 degrees.
std::vector<Body> bodies();
/// Those of them that the options name; all where they name none.
std::vector<Body> chosenBodies(const Options& options);

/// Solid angle of the body's outline as the camera sees it, sr: the sum of Van Oosterom and
/// Strackee's formula over the faces where they add, else the outline cut into lines, exact along
/// each.
double solidAngle_sr(const Body& body, const Viewpoint& camera, const Pose& pose);

/// The second way of the two, for any body; good to 1e-6 of its value.
double solidAngleByLines_sr(const test::Triangles& mesh, const Viewpoint& camera, const Pose& pose);

/// Radiance of the material of every body, 3-5 um.
double greyRadiance_W_m2_sr();
Entity greyEntity(const test::Triangles& mesh);

/// A shift by parts of a pixel, another for every step, irrational to any lattice of samples.
Vec3 phaseShift_m(const Viewpoint& camera, double pixel_m, int step);

/// Two specks in opposite corners of a frame that looks at the origin: a model that holds them is
/// drawn over the whole frame.
test::Triangles cornerMarks(const Viewpoint& camera, const Vec3& origin_m, int width_px,
                            int height_px);

} // namespace irsg::study
