// View factors between surfaces against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "irsg/radiance/exchange/BodyLight.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/PreparedEntities.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class ViewGeometryTest : public RaysTest {};

/// View factors between the surfaces of a mesh by the material of their codes.
class Factors {
  public:
    Factors(const Triangles& mesh, double error, int transparent = 0, bool isPane = false) {
        mesh_ = modelOf(mesh)->mesh();
        PieceUses uses(mesh_->pieces.size());
        for (std::size_t i = 0; i < mesh_->pieces.size(); ++i) {
            const bool isTransparent = codeOfPiece(i) == transparent;
            uses.set(i, {true, isTransparent, !isTransparent, 0, isTransparent && isPane ? 1 : 0});
        }
        const ExchangeResolution resolution;
        light_ = std::make_unique<BodyLight>(
            std::make_shared<const ExchangeNodes>(
                std::make_shared<const ExchangeMesh>(RayMesh::of(mesh_), uses, resolution),
                resolution),
            uses, error);
    }

    int codeOf(std::uint32_t receiver) const {
        return codeOfPiece(static_cast<std::size_t>(light_->nodes().pieceOf(receiver)));
    }
    int codeOfSender(std::uint32_t sender) const {
        const std::vector<std::uint32_t>& senders = light_->nodes().senderOfAll();
        return codeOf(
            static_cast<std::uint32_t>(std::ranges::find(senders, sender) - senders.begin()));
    }
    double areaOf_m2(std::uint32_t receiver) const { return light_->nodes().areaOf_m2(receiver); }
    /// From the fronts of one to the fronts of another.
    double between(int from, int to, int passage = 0) const {
        double sum_m2 = 0.0, area_m2 = 0.0;
        for (std::uint32_t r = 0; r < light_->nodes().nodes(); ++r) {
            if (codeOf(r) != from) {
                continue;
            }
            const double own_m2 = areaOf_m2(r);
            area_m2 += own_m2;
            const auto [pair, end] = light_->balance(passage).pairs->of(r);
            for (const LightPair* p = pair; p != end; ++p) {
                if (codeOfSender(p->sender) == to) {
                    sum_m2 += own_m2 * static_cast<double>(p->factor);
                }
            }
        }
        return sum_m2 / area_m2;
    }
    double areaOfCode_m2(int code) const {
        double area_m2 = 0.0;
        for (std::uint32_t r = 0; r < light_->nodes().nodes(); ++r) {
            if (codeOf(r) == code) {
                area_m2 += areaOf_m2(r);
            }
        }
        return area_m2;
    }
    const BodyLight& light() const { return *light_; }

  private:
    int codeOfPiece(std::size_t piece) const {
        return mesh_->partOf(mesh_->pieces[piece]).codes.material;
    }

    std::shared_ptr<const Mesh> mesh_;
    std::unique_ptr<const BodyLight> light_;
};

/// Howell, A Catalog of Radiation Heat Transfer Configuration Factors, 3rd edition.
double opposedRectangles(double a, double b, double c) { // C-11
    const double x = a / c, y = b / c;
    const double s = 1.0 + x * x, t = 1.0 + y * y;
    return 2.0 / (pi * x * y) *
           (std::log(std::sqrt(s * t / (s + y * y))) +
            x * std::sqrt(t) * std::atan(x / std::sqrt(t)) +
            y * std::sqrt(s) * std::atan(y / std::sqrt(s)) - x * std::atan(x) - y * std::atan(y));
}
double rectanglesAtRightAngle(double h, double w) { // C-14, per common edge
    const double h2 = h * h, w2 = w * w, r = std::sqrt(h2 + w2);
    const double logs = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                        w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                        h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)));
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - r * std::atan(1 / r) + 0.25 * logs) /
           (pi * w);
}
double coaxialDiscs(double r1, double r2, double h) { // C-41
    const double a = r1 / h, b = r2 / h, x = 1.0 + (1.0 + b * b) / (a * a);
    return 0.5 * (x - std::sqrt(x * x - 4.0 * (b / a) * (b / a)));
}

} // namespace

TEST_F(ViewGeometryTest, AreThoseOfTheCatalogue) {
    struct Pair {
        const char* name;
        int from, to;
        double expected;
    };
    /// A mesh, the error that its rays are sent for, and what is known of it.
    struct Case {
        Triangles mesh;
        std::vector<Pair> pairs;
        double error = 0.0003;
    };
    constexpr double inCavities = 0.002; // of thousands of patches, whose errors average
    const IrCodes one{1, 1}, two{2, 2}, three{3, 3};
    const double root = std::sqrt(2.0);
    const double ends = coaxialDiscs(1, 1, 2), whole = 1.0 - ends;
    const Triangles above = moved(sphereOfEqualArea(0.5, 48, one), {0, 0, 1.5});
    const Triangles inner = sphereMesh(0.5, 24, 48, one);
    const Triangles outer = revolved(arc(1, 0, 0, pi, 24), 48, two);
    const std::vector<Case> cases = {
        {joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, one),
                plateMesh({0, 0, 1}, {0, 0.5, 0}, {0.5, 0, 0}, two)),
         {{"C-11 opposed squares", 1, 2, opposedRectangles(1, 1, 1)}}},
        {joined(plateMesh({}, {1, 0, 0}, {0, 0.5, 0}, one),
                plateMesh({0, 0, 0.5}, {0, 0.5, 0}, {1, 0, 0}, two)),
         {{"C-11 opposed rectangles 2 x 1 at 0.5", 1, 2, opposedRectangles(2, 1, 0.5)}}},
        {joined(plateMesh({0.5, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, one),
                plateMesh({0, 0, 0.5}, {0, 0.5, 0}, {0, 0, 0.5}, two)),
         {{"C-14 squares at a right angle", 1, 2, rectanglesAtRightAngle(1, 1)}}},
        {joined(plateMesh({0.5, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, one),
                plateMesh({0, 0, 1}, {0, 0.5, 0}, {0, 0, 1}, two)),
         {{"C-14 rectangles at a right angle, 2 high", 1, 2, rectanglesAtRightAngle(2, 1)}},
         0.0001},
        {joined(disc(1, 0, one), disc(0.5, 1, two, false)),
         {{"C-41 coaxial discs", 1, 2, coaxialDiscs(1, 0.5, 1)}}},
        {joined(joined(disc(1.0, 0.0, one), disc(1.0, 2.0, two, false)),
                revolved(line(1, 0, 1, 2, 4), 128, three)),
         {{"C-78 cylinder, end to wall", 1, 3, whole},
          {"C-79 cylinder, wall to end", 3, 1, whole / 4},
          {"C-80 cylinder, wall to itself", 3, 3, 1 - whole / 2}},
         inCavities},
        {joined(revolved(line(0, 0, 1, 1, 4), 128, one), disc(1.0, 1.0, two, false)),
         {{"C-110 cone to its base", 1, 2, 1 / root}, {"C-111 cone to itself", 1, 1, 1 - 1 / root}},
         inCavities},
        {joined(revolved(arc(1, 0, 0, pi / 2, 24), 96, one), disc(1.0, 0.0, two, false)),
         {{"C-135 hemisphere to itself", 1, 1, 0.5}},
         inCavities},
        // Exact for any convex body in any other: that of all facets.
        {joined(inner, outer),
         {{"C-140 concentric spheres, outer to inner", 2, 1, area_m2(inner) / area_m2(outer)}},
         inCavities},
        {joined(above, disc(1.0, 0.0, two)),
         {{"C-121 sphere to disc", 2, 1, 0.5 * (1 - 1 / std::sqrt(1 + 1 / 2.25))}}},
        {joined(above, plateMesh({0.75, 0.5, 0}, {0.75, 0, 0}, {0, 0.5, 0}, two)),
         {{"C-119 sphere to rectangle below", 2, 1,
           pi / 1.5 * std::atan(1 / std::sqrt(1.0 + 2.25 + 1.0 * 2.25)) / (4 * pi)}}},
    };
    for (const Case& known : cases) {
        const Factors factors(known.mesh, known.error);
        for (const Pair& pair : known.pairs) {
            const double found = factors.between(pair.from, pair.to);
            std::printf("  %-42s %.6f, expected %.6f: %+.3f %%, %zu rays\n", pair.name, found,
                        pair.expected, 100 * (found / pair.expected - 1),
                        factors.light().raysSent());
            EXPECT_NEAR(found / pair.expected, 1.0, 1e-3) << pair.name;
        }
    }
}

TEST_F(ViewGeometryTest, AreReciprocal) {
    const Triangles walls = joined(plateMesh({}, {1, 0, 0}, {0, 1, 0}, {1, 1}),
                                   plateMesh({-1, 0, 0.7}, {0, 1, 0}, {0, 0, 0.7}, {2, 2}));
    const Triangles ball = moved(sphereMesh(0.3, 48, 96, {3, 3}), {0.2, 0.1, 0.6});
    const Factors factors(joined(walls, ball), 0.0005);
    for (const auto& [a, b] : {std::pair{1, 2}, std::pair{1, 3}, std::pair{2, 3}}) {
        const double there = factors.between(a, b) * factors.areaOfCode_m2(a);
        const double back = factors.between(b, a) * factors.areaOfCode_m2(b);
        EXPECT_NEAR(there / back, 1.0, 1e-3) << a << " to " << b;
        std::printf("  %d to %d: A F %.5f and %.5f m2\n", a, b, there, back);
    }
}

TEST_F(ViewGeometryTest, ASmallSenderIsKnownByItsOwnRays) {
    // A disc of 0.02 m over the middle of a plate of 1 m2, at the error that models have: of the
    // plate's rays at most a few meet it. The disc sees of the plate what its
    // middle does: four corners, each of an element before the corner of a rectangle.
    const Triangles mesh = joined(moved(disc(0.02, 0.0, {1, 1}, false), {0, 0, 0.5}),
                                  plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {2, 2}));
    const Factors factors(mesh, 0.005);
    const double side = 1.0 / std::sqrt(2.0);
    const double expected = 4.0 / pi * side * std::atan(side);
    const double area_m2 = factors.areaOfCode_m2(1);
    EXPECT_NEAR(factors.between(1, 2) / expected, 1.0, 0.01);
    EXPECT_NEAR(factors.between(2, 1) / (expected * area_m2), 1.0, 0.01);
    std::printf("  plate to disc %.3e, expected %.3e\n", factors.between(2, 1), expected * area_m2);
}

TEST_F(ViewGeometryTest, GasGetsLightAndStandsInNobodysWay) {
    const Triangles plates = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                                    plateMesh({0, 0, 1}, {0, 0.5, 0}, {0.5, 0, 0}, {2, 2}));
    const Factors clear(plates, 0.001);
    const Factors gas(joined(plates, reversed(boxMesh({2, 2, 3}, std::vector<IrCodes>(6, {3, 3})))),
                      0.001, 3);
    EXPECT_NEAR(gas.between(1, 2) / clear.between(1, 2), 1.0, 5e-3);
    EXPECT_NEAR(gas.between(2, 1) / clear.between(2, 1), 1.0, 5e-3);
    EXPECT_GT(gas.between(3, 1), 0.001);
    EXPECT_EQ(gas.between(1, 3), 0.0);
}

TEST_F(ViewGeometryTest, PanesAreSeenAndSeenThrough) {
    const Triangles plates = joined(plateMesh({}, {0.5, 0, 0}, {0, 0.5, 0}, {1, 1}),
                                    plateMesh({0, 0, 1}, {0, 0.5, 0}, {0.5, 0, 0}, {2, 2}));
    const Factors clear(plates, 0.001);
    const Factors pane(joined(plates, plateMesh({0, 0, 0.5}, {0.5, 0, 0}, {0, 0.5, 0}, {3, 3})),
                       0.001, 3, true);
    EXPECT_EQ(pane.between(1, 2), 0.0);
    EXPECT_NEAR(pane.between(1, 2, 1) / clear.between(1, 2), 1.0, 5e-3);
    EXPECT_NEAR(pane.between(1, 3), 0.41525, 2e-3);
}

TEST_F(ViewGeometryTest, NobodyGetsLightOfWhatLiesInsideOfABody) {
    // The plate in the box looks out through the backs of its sides, which nobody sees; of it, the
    // plate outside sees the side of the box.
    const Triangles mesh = joined(joined(plateMesh({}, {0, 0.3, 0}, {0, 0, 0.3}, {1, 1}),
                                         boxMesh({1, 1, 1}, std::vector<IrCodes>(6, {2, 2}))),
                                  plateMesh({2, 0, 0}, {0, 0, 0.3}, {0, 0.3, 0}, {3, 3}));
    const Factors factors(mesh, 0.001);
    EXPECT_GT(factors.between(1, 3), 0.01);
    EXPECT_EQ(factors.between(3, 1), 0.0);
    EXPECT_GT(factors.between(3, 2), 0.1);
}

TEST_F(ViewGeometryTest, AreFoundOnceWhileAnyRendererHoldsThem) {
    const Triangles walls = joined(plateMesh({}, {1, 0, 0}, {0, 1, 0}, {1, 1}),
                                   plateMesh({-1, 0, 0.7}, {0, 1, 0}, {0, 0, 0.7}, {2, 2}));
    // Each renderer has models, pieces and meshes of its own.
    const auto lightOf = [](PreparedEntities& prepared, const Triangles& mesh, double error) {
        const Entity entity = entityOf(modelOf(mesh), greyDatabase(0.5, 300.0));
        prepared.keep({entity});
        PreparedModel& model = prepared.of(entity);
        PieceUses uses(model.mesh().pieces.size());
        for (std::size_t i = 0; i < model.mesh().pieces.size(); ++i) {
            uses.set(i, {true, false, true, 0});
        }
        return model.lightBetween(uses, error, BodyPlace::alone);
    };
    PreparedEntities one, other;
    const auto first = lightOf(one, walls, 0.02);
    EXPECT_EQ(lightOf(other, walls, 0.02), first);
    EXPECT_NE(lightOf(other, walls, 0.01), first);
    EXPECT_NE(lightOf(other, moved(walls, {0, 0, 1e-3}), 0.02), first);
    // It goes with those who hold it.
    const std::weak_ptr<const BodyLight> last = lightOf(other, moved(walls, {1, 0, 0}), 0.02);
    EXPECT_FALSE(last.expired());
    other.keep({});
    EXPECT_TRUE(last.expired());
}

TEST_F(ViewGeometryTest, OfConvexBodiesTakeNoRays) {
    EXPECT_EQ(Factors(sphereMesh(1.0, 40, 80, {1, 1}), 0.01).light().raysSent(), 0u);
    EXPECT_EQ(Factors(boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1})), 0.01).light().raysSent(),
              0u);
}
