// Facets that are known to be lit without a ray, against rays.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "irsg/geometry/view/Pose.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/render/rays/SunlitFacets.h"
#include "tests/support/RaysTest.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

class SunlitFacetsTest : public RaysTest {};

/// A mesh for rays; surfaces of a material let light through.
struct Body {
    std::shared_ptr<const Mesh> shape;
    std::shared_ptr<const RayMesh> mesh;
    PieceUses uses{0};

    explicit Body(const Triangles& of, int transparent = 0) {
        shape = modelOf(of)->mesh();
        uses = PieceUses(shape->pieces.size());
        for (std::size_t i = 0; i < shape->pieces.size(); ++i) {
            const Mesh::Part& part = shape->partOf(shape->pieces[i]);
            uses.set(i, {true, part.codes.material == transparent, part.culled, 0});
        }
        mesh = RayMesh::of(shape);
    }
    int codeOf(std::size_t piece) const {
        return shape->partOf(shape->pieces[piece]).codes.material;
    }
};

/// The place of weights on a side of a facet, as it is met from there.
RayHit hitOn(const Body& body, int piece, unsigned number, bool isFront, double u, double v,
             Ray& ray) {
    const auto& c = body.mesh->facet(static_cast<std::size_t>(piece), number).corners_m;
    const RayHit facet{.piece = piece, .facet = number};
    const Vec3 normal = body.mesh->planeNormal(facet) * (isFront ? 1.0 : -1.0);
    const Vec3 at = c[0] * (1.0 - u - v) + c[1] * u + c[2] * v;
    ray = {at + normal, normal * -1.0};
    return body.mesh->onPlaneOf(facet, ray);
}

struct Counts {
    int saidLit = 0, lit = 0, falselyLit = 0;
};

/// Both sides of all facets that face a source, with rays from many places of each.
Counts against(const Body& body, const Vec3& towards, double radius_rad, std::mt19937& random) {
    const SunlitFacets known(body.mesh, body.uses, towards, radius_rad);
    std::uniform_real_distribution<double> even(0.0, 1.0), both(-1.0, 1.0);
    Counts counts;
    std::vector<int> through;
    for (std::size_t piece = 0; piece < body.mesh->pieces(); ++piece) {
        for (unsigned f = 0; f < body.mesh->facetsOf(piece); ++f) {
            for (const bool isFront : {true, false}) {
                Ray ray;
                const RayHit middle =
                    hitOn(body, static_cast<int>(piece), f, isFront, 0.3, 0.3, ray);
                if (dot(ray.direction, towards) > -0.01) {
                    continue;
                }
                bool isLit = true;
                for (int i = 0; i < 24 && isLit; ++i) {
                    double u = even(random), v = even(random);
                    if (u + v > 1.0) {
                        u = 1.0 - u;
                        v = 1.0 - v;
                    }
                    const RayHit hit = hitOn(body, static_cast<int>(piece), f, isFront, u, v, ray);
                    const Vec3 off =
                        Vec3{both(random), both(random), both(random)} * (0.55 * radius_rad);
                    const Ray light{body.mesh->lifted(hit, ray), normalized(towards + off)};
                    through.clear();
                    isLit = body.mesh->letsPass(light, body.uses, &hit, through) && through.empty();
                }
                const bool isSaid = known.isLit(middle);
                counts.saidLit += isSaid;
                counts.lit += isLit;
                counts.falselyLit += isSaid && !isLit;
            }
        }
    }
    return counts;
}

Triangles randomTriangles(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> place(-2.0, 2.0), edge(-0.7, 0.7);
    Triangles mesh;
    for (int i = 0; i < count; ++i) {
        Triangle& triangle = mesh.emplace_back();
        const Vec3 at{place(random), place(random), place(random)};
        for (Vec3& vertex : triangle.vertex) {
            vertex = at + Vec3{edge(random), edge(random), edge(random)};
        }
        const Vec3 normal = normalized(cross(triangle.vertex[1] - triangle.vertex[0],
                                             triangle.vertex[2] - triangle.vertex[0]));
        for (Vec3& own : triangle.normal) {
            own = normal;
        }
        triangle.codes = {1, 1};
        triangle.cullsBackFaces = i % 3 == 0;
    }
    return mesh;
}

Triangles moved(Triangles mesh, const Vec3& by) {
    for (Triangle& triangle : mesh) {
        for (Vec3& vertex : triangle.vertex) {
            vertex = vertex + by;
        }
    }
    return mesh;
}

} // namespace

TEST_F(SunlitFacetsTest, SaysOnlyWhatRaysFind) {
    std::mt19937 random(7);
    std::vector<Body> bodies;
    bodies.emplace_back(randomTriangles(80, random));
    bodies.emplace_back(randomTriangles(400, random));
    for (const bool isSmooth : {true, false}) {
        bodies.emplace_back(
            joined(joined(sphereMesh(1.0, 12, 24, {1, 1}, isSmooth),
                          moved(sphereMesh(0.3, 8, 16, {1, 1}, isSmooth), {0.9, 0.9, 1.1})),
                   plateMesh({0, 0, -1.2}, {3, 0, 0}, {0, 3, 0}, {1, 1})));
    }
    // One facet over many.
    bodies.emplace_back(joined(sphereMesh(1.0, 24, 48, {1, 1}),
                               plateMesh({0, 0, 1.5}, {1.5, 0, 0}, {0, 1.5, 0}, {1, 1})));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        for (const double radius_rad : {0.0, SunShadows::discRadius_rad}) {
            Counts all;
            for (int i = 0; i < 12; ++i) {
                const Counts counts =
                    against(bodies[b], direction(0.55 * i, 0.15 + 0.11 * i), radius_rad, random);
                all.saidLit += counts.saidLit;
                all.lit += counts.lit;
                all.falselyLit += counts.falselyLit;
            }
            EXPECT_EQ(all.falselyLit, 0) << "body " << b << ", radius " << radius_rad;
            // And it is worth asking: of triangles that cut each other least.
            EXPECT_GT(all.saidLit, (b < 2 ? 0.2 : 0.6) * all.lit)
                << "body " << b << ", radius " << radius_rad;
            EXPECT_GT(all.lit, 100);
        }
    }
}

TEST_F(SunlitFacetsTest, KnowsConvexBodies) {
    std::mt19937 random(8);
    for (const bool isSmooth : {true, false}) {
        const Body sphere(sphereMesh(2.0, 16, 32, {1, 1}, isSmooth));
        const Counts counts = against(sphere, direction(1.0, 0.4), 0.0, random);
        EXPECT_EQ(counts.falselyLit, 0);
        EXPECT_GT(counts.lit, 400);
        EXPECT_GT(counts.saidLit, 0.98 * counts.lit);
    }
}

TEST_F(SunlitFacetsTest, LeavesWhatGlassCoversToRays) {
    // A pane over one of two plates, and one that is seen from above alone, from below.
    const Triangles plates = joined(plateMesh({-2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1}),
                                    plateMesh({2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2}));
    const Body glazed(joined(plates, plateMesh({-2, 0, 1}, {0.2, 0, 0}, {0, 0.2, 0}, {3, 3})), 3);
    const Body backs(joined(plates, oneSidedPlate({-2, 0, 1}, {0, 0.2, 0}, {0.2, 0, 0}, {3, 3})));
    const Vec3 up{0, 0, 1};
    const SunlitFacets underGlass(glazed.mesh, glazed.uses, up, 0.0),
        underBack(backs.mesh, backs.uses, up, 0.0);
    int plain = 0, covered = 0;
    for (const auto* body : {&glazed, &backs}) {
        for (std::size_t piece = 0; piece < body->mesh->pieces(); ++piece) {
            for (unsigned f = 0; f < body->mesh->facetsOf(piece) && body->codeOf(piece) < 3; ++f) {
                const SunlitFacets& known = body == &glazed ? underGlass : underBack;
                Ray ray;
                const RayHit hit = hitOn(*body, static_cast<int>(piece), f, true, 0.3, 0.3, ray);
                const bool isUnder = body == &glazed && body->codeOf(piece) == 1;
                EXPECT_EQ(known.isLit(hit), !isUnder);
                (isUnder ? covered : plain) += 1;
            }
        }
    }
    EXPECT_EQ(covered, 2);
    EXPECT_EQ(plain, 6);
}
