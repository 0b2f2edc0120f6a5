#include "irsg/geometry/mesh/MeshPieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

using Face = std::pair<IrCodes, std::array<Float3, 3>>;

/// Every triangle of the pieces with its codes, beginning at its least corner.
std::map<Face, int> facesOf(const Mesh& mesh) {
    std::map<Face, int> faces;
    for (const Mesh::Piece& piece : mesh.pieces) {
        const Mesh::Part& part = mesh.partOf(piece);
        const auto triangles = mesh.trianglesOf(piece);
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            std::array<Float3, 3> places;
            for (std::size_t k = 0; k < 3; ++k) {
                places[k] = part.vertices[triangles[i + k]];
            }
            std::ranges::rotate(places, std::ranges::min_element(places));
            ++faces[{part.codes, places}];
        }
    }
    return faces;
}

} // namespace

TEST(MeshPieces, HoldEveryTriangleOnceWithItsCodes) {
    const auto model = modelOf(joined(sphereMesh(1.0, 60, 120, {1, 1}),
                                      boxMesh({3, 2, 1}, std::vector<IrCodes>(6, {2, 2}))));
    const Mesh whole = meshOf(model->mesh()->parts);
    Mesh cut = whole;
    cutIntoPieces(cut);
    EXPECT_EQ(whole.pieces.size(), whole.parts.size());
    EXPECT_GT(cut.pieces.size(), whole.pieces.size());
    EXPECT_EQ(model->mesh()->pieces.size(), cut.pieces.size());
    EXPECT_EQ(facesOf(cut), facesOf(whole));
    for (const Mesh::Piece& piece : cut.pieces) {
        EXPECT_LE(piece.count / 3, std::max(mostTriangles, whole.facets() / 100 + 1));
        EXPECT_GT(piece.count, 0u);
        for (const unsigned corner : cut.trianglesOf(piece)) {
            BoundingBox with = piece.bounds;
            with.include(toVec3(cut.partOf(piece).vertices[corner]));
            EXPECT_EQ(with, piece.bounds);
        }
    }
}

// Rows of facets at equal places along an axis: the order is that of sorting again and again.
TEST(MeshPieces, AreInTheOrderOfStableSortsAlongTheLongestSides) {
    Mesh cut = meshOf(modelOf(sphereMesh(1.0, 40, 120, {1, 1}))->mesh()->parts);
    ASSERT_EQ(cut.parts.size(), 1u);
    using Corners = std::array<unsigned, 3>;
    const auto middleOf = [&](const Corners& corners, std::size_t axis) {
        const std::vector<Float3>& v = cut.parts[0].vertices;
        return (v[corners[0]][axis] + v[corners[1]][axis] + v[corners[2]][axis]) / 3.0f;
    };
    std::vector<Corners> all;
    for (std::size_t i = 0; i < cut.parts[0].triangles.size(); i += 3) {
        all.push_back({cut.parts[0].triangles[i], cut.parts[0].triangles[i + 1],
                       cut.parts[0].triangles[i + 2]});
    }
    std::vector<std::size_t> sizes;
    const std::size_t most = std::max(mostTriangles, all.size() / 128);
    const auto halve = [&](auto& self, std::span<Corners> some) -> void {
        if (some.size() <= most) {
            sizes.push_back(some.size());
            return;
        }
        std::array<float, 3> sides{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::ranges::minmax(
                some, {}, [&](const Corners& corners) { return middleOf(corners, axis); });
            sides[axis] = middleOf(high, axis) - middleOf(low, axis);
        }
        const auto axis = static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin());
        std::ranges::stable_sort(some, {},
                                 [&](const Corners& corners) { return middleOf(corners, axis); });
        self(self, some.first(some.size() / 2));
        self(self, some.subspan(some.size() / 2));
    };
    halve(halve, std::span(all));
    ASSERT_GT(sizes.size(), 4u);
    cutIntoPieces(cut);
    ASSERT_EQ(cut.pieces.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        EXPECT_EQ(cut.pieces[i].count, 3 * sizes[i]);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_EQ(cut.parts[0].triangles[3 * i + k], all[i][k]) << i;
        }
    }
}

// A window that shows a part of a model leaves out the pieces beside it, and shows the same.
TEST(MeshPieces, ThatATileCannotShowAreNotMissed) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    SignatureDatabase database = greyDatabase(0.9, 320.0, 1.0);
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 60, 120, {1, 1})), database)};
    const View whole{
        .range_m = 20.0, .width_px = 60, .height_px = 60, .fieldOfView_rad = 2.0 * std::atan(0.06)};
    look(irsg, whole);
    const RadianceImage all = irsg.imageWithReport().image;
    // The middle half of the same image plane.
    View middle = whole;
    middle.width_px = middle.height_px = 30;
    middle.fieldOfView_rad = 2.0 * std::atan(0.03);
    look(irsg, middle);
    const RadianceImage part = irsg.imageWithReport().image;
    const float least = 0.1f * all.primary().values[all.offset(30, 30)];
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 30; ++x) {
            EXPECT_GT(part.primary().values[part.offset(x, y)], least) << x << ' ' << y;
            EXPECT_NEAR(part.primary().values[part.offset(x, y)],
                        all.primary().values[all.offset(x + 15, y + 15)],
                        1e-5f * all.primary().values[all.offset(30, 30)])
                << x << ' ' << y;
        }
    }
}
