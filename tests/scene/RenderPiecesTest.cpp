#include "irsg/geometry/model/RenderPieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <osg/TriangleIndexFunctor>

#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

struct Corners {
    std::vector<std::array<unsigned, 3>> all;
    void operator()(unsigned a, unsigned b, unsigned c) { all.push_back({a, b, c}); }
};

using Place = std::array<float, 3>;
using Face = std::pair<IrCodes, std::array<Place, 3>>;

/// Every triangle with its codes, beginning at its least corner.
std::map<Face, int> facesOf(const std::vector<RenderItem>& items) {
    std::map<Face, int> faces;
    for (const RenderItem& item : items) {
        const auto& vertices =
            dynamic_cast<const osg::Vec3Array&>(*item.geometry->getVertexArray());
        osg::TriangleIndexFunctor<Corners> corners;
        item.geometry->accept(corners);
        for (const auto& triangle : corners.all) {
            std::array<Place, 3> places;
            for (std::size_t i = 0; i < 3; ++i) {
                const osg::Vec3& v = vertices[triangle[i]];
                places[i] = {v.x(), v.y(), v.z()};
            }
            std::ranges::rotate(places, std::ranges::min_element(places));
            ++faces[{item.codes, places}];
        }
    }
    return faces;
}

} // namespace

TEST(RenderPieces, HoldEveryTriangleOnceWithItsCodes) {
    const auto model = modelOf(joined(sphereMesh(1.0, 60, 120, {1, 1}),
                                      boxMesh({3, 2, 1}, std::vector<IrCodes>(6, {2, 2}))));
    const std::vector<RenderItem> items = collectRenderItems(*model);
    const std::vector<RenderItem> pieces = inRenderPieces(items);
    EXPECT_GT(pieces.size(), items.size());
    EXPECT_EQ(facesOf(pieces), facesOf(items));
    std::size_t all = 0;
    for (const RenderItem& item : items) {
        osg::TriangleIndexFunctor<Corners> corners;
        item.geometry->accept(corners);
        all += corners.all.size();
    }
    for (const RenderItem& piece : pieces) {
        osg::TriangleIndexFunctor<Corners> corners;
        piece.geometry->accept(corners);
        EXPECT_LE(corners.all.size(), std::max(mostTriangles, all / 100 + 1));
        EXPECT_FALSE(corners.all.empty());
    }
}

// A window that shows a part of a model leaves out the pieces beside it, and shows the same.
TEST(RenderPieces, ThatATileCannotShowAreNotMissed) {
    InteractiveRenderer irsg;
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings;
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
