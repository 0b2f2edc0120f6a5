// What an object hides of its background at each elevation, where facets lie behind each other and
// where they let light through.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/scene/ObjectSilhouette.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes opaque{1, 1}, pane{1, 2};
constexpr double range_m = 5000.0, reach_m = 15.0, paneOpacity = 0.3;

double opacityOf(const Mesh::Part& part) {
    return part.codes.material == pane.material ? paneOpacity : 1.0;
}

std::vector<SilhouettePart> seen(const Mesh& mesh, const Vec3& towards) {
    return silhouetteOf(mesh, Pose{}, towards * range_m, {}, std::asin(reach_m / range_m),
                        opacityOf);
}

/// Mean altitude of what is hidden, m, from a sensor on the level of the origin.
double meanAltitude_m(const Triangles& mesh) {
    double mean_rad = 0.0, all = 0.0;
    for (const SilhouettePart& part : seen(*modelOf(mesh)->mesh(), {0.0, -1.0, 0.0})) {
        mean_rad += part.weight * part.above_rad;
        all += part.weight;
    }
    EXPECT_NEAR(all, 1.0, 1e-12);
    return mean_rad * range_m;
}

/// 20 m wide and 10 m high, above or below the origin, and so far behind it.
Triangles wall(double middle_m, double behind_m, const IrCodes& codes) {
    return plateMesh({0.0, behind_m, middle_m}, {10.0, 0.0, 0.0}, {0.0, 0.0, 5.0}, codes);
}

Triangles ball(double radius_m, double altitude_m) {
    Triangles mesh = sphereMesh(radius_m, 24, 48, opaque);
    for (Triangle& triangle : mesh) {
        for (Vec3& corner : triangle.vertex) {
            corner.z += altitude_m;
        }
    }
    return mesh;
}

struct Case {
    std::string name;
    Triangles mesh;
    double expected_m;
};
void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class Silhouette : public testing::TestWithParam<Case> {};

} // namespace

TEST_P(Silhouette, HasTheMeanAltitudeOfWhatItHides) {
    EXPECT_NEAR(meanAltitude_m(GetParam().mesh), GetParam().expected_m, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Silhouette,
    testing::Values(
        Case{"Wall", wall(5.0, 0.0, opaque), 5.0}, Case{"Ball", ball(10.0, 0.0), 0.0},
        // Counted twice it would be 0.69 m higher.
        Case{"BallInABall", joined(ball(10.0, 0.0), ball(4.0, 5.0)), 0.0},
        Case{
            "WallBehindAWall",
            joined(joined(wall(-5.0, 0.0, opaque), wall(5.0, 0.0, opaque)), wall(5.0, 2.0, opaque)),
            0.0},
        Case{"PaneOnAWall", joined(wall(-5.0, 0.0, opaque), wall(5.0, 0.0, pane)),
             5.0 * (paneOpacity - 1.0) / (paneOpacity + 1.0)},
        Case{"PaneBeforeAWall",
             joined(joined(wall(-5.0, 0.0, opaque), wall(5.0, 0.0, opaque)), wall(5.0, -2.0, pane)),
             0.0},
        // 1 - 0.7^2 of the upper half, 0.3 of the lower one.
        Case{"PaneBehindAPane",
             joined(joined(wall(-5.0, 0.0, pane), wall(5.0, 0.0, pane)), wall(5.0, 2.0, pane)),
             5.0 * (0.51 - 0.3) / (0.51 + 0.3)}),
    [](const testing::TestParamInfo<Case>& info) { return info.param.name; });

TEST(SilhouetteOfABall, IsExactInEachSlice) {
    // Front and back facets lie behind each other, and hide half of what they cover in all slices.
    const Triangles alone = ball(10.0, 0.0), withCore = joined(alone, ball(2.0, 0.0));
    const auto expected = seen(*modelOf(alone)->mesh(), {0.0, -1.0, 0.0});
    const auto found = seen(*modelOf(withCore)->mesh(), {0.0, -1.0, 0.0});
    ASSERT_EQ(found.size(), expected.size());
    double square = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        square += expected[i].weight * std::pow(expected[i].above_rad * range_m / 10.0, 2);
        EXPECT_NEAR(found[i].weight, expected[i].weight, 2e-4) << i;
    }
    EXPECT_NEAR(square, 0.25, 2e-3); // of a disc of radius 1
}

TEST(SilhouetteOfABall, IsTheSameFromAllSidesAndFromAbove) {
    const std::shared_ptr<const Model> model = modelOf(joined(ball(10.0, 0.0), ball(4.0, 5.0)));
    for (const Vec3& towards : {Vec3{0.0, 1.0, 0.0}, Vec3{0.6, -0.8, 0.0}, Vec3{0.6, 0.0, 0.8},
                                Vec3{0.0, -0.28, -0.96}, Vec3{0.0, 0.0, 1.0}}) {
        double mean_rad = 0.0;
        for (const SilhouettePart& part : seen(*model->mesh(), towards)) {
            EXPECT_GE(part.weight, 0.0);
            mean_rad += part.weight * part.above_rad;
        }
        if (std::abs(towards.z) < 1.0) {
            EXPECT_NEAR(mean_rad * range_m, 0.0, 0.02) << towards.z;
        }
    }
}

TEST(SilhouetteOfOneSide, LacksFacetsThatAreNotSeenFromBehind) {
    const Triangles front =
        oneSidedPlate({0.0, 0.0, 5.0}, {10.0, 0.0, 0.0}, {0.0, 0.0, 5.0}, opaque);
    const std::shared_ptr<const Model> model = modelOf(joined(front, wall(-5.0, 0.0, pane)));
    const auto mean_m = [&](const Vec3& towards) {
        double mean_rad = 0.0;
        for (const SilhouettePart& part : seen(*model->mesh(), towards)) {
            mean_rad += part.weight * part.above_rad;
        }
        return mean_rad * range_m;
    };
    // Its front looks along u x v, to -y.
    EXPECT_NEAR(mean_m({0.0, -1.0, 0.0}), 5.0 * (1.0 - paneOpacity) / (1.0 + paneOpacity), 0.01);
    EXPECT_NEAR(mean_m({0.0, 1.0, 0.0}), -5.0, 0.01);
}
