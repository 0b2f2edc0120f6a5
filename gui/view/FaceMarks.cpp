#include "gui/view/FaceMarks.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <unordered_map>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/LineWidth>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>
#include <osg/TriangleIndexFunctor>

namespace smat::gui {
namespace {

constexpr double creaseCosine = 0.77; // 40 degrees

struct PlaceHash {
    std::size_t operator()(const osg::Vec3& v) const {
        std::size_t hash = 17;
        for (int i = 0; i < 3; ++i)
            hash = hash * 1000003U + std::hash<float>()(v[i]);
        return hash;
    }
};

/// Edges of triangles by where they are: vertices are split where normals or colours change, so
/// that places count and not numbers.
class Edges {
  public:
    void add(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c) {
        osg::Vec3 normal = (b - a) ^ (c - a);
        normal.normalize();
        const std::array<unsigned int, 3> at{place(a), place(b), place(c)};
        for (std::size_t i = 0; i < 3; ++i) {
            const unsigned int from = at[i];
            const unsigned int to = at[(i + 1) % 3];
            sides_.push_back({std::min(from, to), std::max(from, to), normal});
        }
    }
    /// Ends of the edges where the marked part ends or bends, two by two.
    osg::ref_ptr<osg::Vec3Array> outline() {
        std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
            return std::tie(x.from, x.to) < std::tie(y.from, y.to);
        });
        osg::ref_ptr<osg::Vec3Array> ends = new osg::Vec3Array;
        for (std::size_t i = 0; i < sides_.size();) {
            std::size_t next = i + 1;
            bool bends = false;
            while (next < sides_.size() && sides_[next].from == sides_[i].from &&
                   sides_[next].to == sides_[i].to) {
                bends = bends || std::abs(sides_[next].normal * sides_[i].normal) < creaseCosine;
                ++next;
            }
            if (next == i + 1 || bends) {
                ends->push_back(places_[sides_[i].from]);
                ends->push_back(places_[sides_[i].to]);
            }
            i = next;
        }
        return ends;
    }

  private:
    struct Side {
        unsigned int from, to;
        osg::Vec3 normal;
    };
    unsigned int place(const osg::Vec3& v) {
        const auto [found, isNew] =
            known_.try_emplace(v, static_cast<unsigned int>(places_.size()));
        if (isNew)
            places_.push_back(v);
        return found->second;
    }
    std::unordered_map<osg::Vec3, unsigned int, PlaceHash> known_;
    std::vector<osg::Vec3> places_;
    std::vector<Side> sides_;
};

osg::ref_ptr<osg::Geometry> sheet(osg::Array* vertices, const osg::Vec4& color) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->setColorArray(new osg::Vec4Array(1, &color), osg::Array::BIND_OVERALL);
    return geometry;
}

void plain(osg::StateSet& state) {
    constexpr auto off = osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED;
    constexpr auto on = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;
    state.setMode(GL_LIGHTING, off);
    state.setMode(GL_CULL_FACE, off);
    state.setMode(GL_BLEND, on);
    state.setAttribute(new osg::BlendFunc, osg::StateAttribute::PROTECTED);
    state.setAttribute(new osg::PolygonMode, osg::StateAttribute::PROTECTED);
}

osg::ref_ptr<osg::Geode> lines(osg::Vec3Array* ends, const osg::Vec4& color, double width_px,
                               osg::Depth::Function test, int bin) {
    auto geometry = sheet(ends, color);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<int>(ends->size())));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    auto* state = geode->getOrCreateStateSet();
    plain(*state);
    // A little nearer than the faces they lie on.
    state->setAttributeAndModes(new osg::Depth(test, 0.0, 0.9998, false));
    state->setAttribute(new osg::LineWidth(static_cast<float>(width_px)));
    state->setRenderBinDetails(bin, "RenderBin");
    return geode;
}

/// The faces again in one colour, on their own arrays.
osg::ref_ptr<osg::Geode> filled(const std::vector<const osg::Geometry*>& faces,
                                const osg::Vec4& color) {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (const osg::Geometry* face : faces) {
        auto geometry = sheet(const_cast<osg::Array*>(face->getVertexArray()), color);
        for (unsigned int i = 0; i < face->getNumPrimitiveSets(); ++i)
            geometry->addPrimitiveSet(const_cast<osg::PrimitiveSet*>(face->getPrimitiveSet(i)));
        geode->addDrawable(geometry);
    }
    return geode;
}

} // namespace

osg::ref_ptr<osg::Group> makeFaceMarks(const std::vector<const osg::Geometry*>& faces,
                                       double devicePixelRatio) {
    const osg::Vec4 tint(0.0F, 0.84F, 1.0F, 0.38F);
    const osg::Vec4 bright(0.1F, 0.92F, 1.0F, 1.0F);
    const osg::Vec4 faint(0.1F, 0.92F, 1.0F, 0.3F);
    const osg::Vec4 seam(0.0F, 0.16F, 0.22F, 1.0F);

    const auto fill = filled(faces, tint);
    Edges edges;
    for (const osg::Geometry* face : faces) {
        struct Collect {
            const osg::Vec3Array* vertices = nullptr;
            Edges* edges = nullptr;
            void operator()(unsigned int a, unsigned int b, unsigned int c) {
                edges->add((*vertices)[a], (*vertices)[b], (*vertices)[c]);
            }
        };
        osg::TriangleIndexFunctor<Collect> collect;
        collect.vertices = static_cast<const osg::Vec3Array*>(face->getVertexArray());
        collect.edges = &edges;
        face->accept(collect);
    }
    auto* state = fill->getOrCreateStateSet();
    plain(*state);
    state->setAttributeAndModes(new osg::PolygonOffset(-1.0F, -1.0F));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setRenderBinDetails(20, "RenderBin");

    osg::ref_ptr<osg::Group> marks = new osg::Group;
    marks->addChild(fill);
    const auto ends = edges.outline();
    const double px = devicePixelRatio;
    marks->addChild(lines(ends, faint, 1.5 * px, osg::Depth::ALWAYS, 21));
    marks->addChild(lines(ends, seam, 4.5 * px, osg::Depth::LEQUAL, 22));
    marks->addChild(lines(ends, bright, 2.0 * px, osg::Depth::LEQUAL, 23));
    return marks;
}

osg::ref_ptr<osg::Group> makeWireframe(const std::vector<const osg::Geometry*>& faces,
                                       const osg::Vec4& color, double devicePixelRatio) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(filled(faces, color));
    auto* state = group->getOrCreateStateSet();
    plain(*state);
    state->setAttribute(
        new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE),
        osg::StateAttribute::PROTECTED);
    state->setAttribute(new osg::LineWidth(static_cast<float>(devicePixelRatio)));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    state->setRenderBinDetails(15, "RenderBin");
    return group;
}

} // namespace smat::gui
