#pragma once

#include <array>
#include <vector>

#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// Points of (radius, height), m.
using Profile = std::vector<std::array<double, 2>>;

/// A straight profile.
Profile line(double r0, double z0, double r1, double z1, int steps);
/// An arc about (0, z), by the angle from the lowest point.
Profile arc(double radius, double z, double from_rad, double to_rad, int steps);

/// A surface of revolution about z along a profile, its front to the left of the profile as it is
/// gone along with the axis on the left: inside for a rising one.
Triangles revolved(const Profile& profile, int around, IrCodes codes);
/// The same triangles, their fronts on the other side.
Triangles reversed(Triangles mesh);
Triangles disc(double radius, double z, IrCodes codes, bool up = true);
/// A sphere of facets as large as the round one: then its mean shadow, a quarter of its surface
/// (Cauchy), is that of the round one, too.
Triangles sphereOfEqualArea(double radius, int latitudes, IrCodes codes);
Triangles moved(Triangles mesh, const Vec3& by);
/// With faces that are seen from their fronts alone.
Triangles oneSided(Triangles mesh);

double area_m2(const Triangles& mesh);

} // namespace irsg::test
