#include "irsg/geometry/conversion/CodedGraph.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Transform>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/PaintedGrid.h"
#include "irsg/geometry/reading/DrawablePolygons.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/MaterialNames.h"
#include "irsg/geometry/reading/PolygonPlace.h"

namespace irsg {
namespace {

std::string materialNamed(const osg::StateSet* state) {
    return state ? materialNameOf(*state) : std::string();
}

/// Walks over all drawables, hidden ones and unused levels of detail too, with what stands over
/// them.
class NamedVisitor : public osg::NodeVisitor {
  public:
    using Visit = std::function<void(osg::Geometry&, const FaceNames&, const osg::Matrixd&)>;

    explicit NamedVisitor(Visit visit)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), visit_(std::move(visit)) {
        setNodeMaskOverride(~0u);
    }
    void apply(osg::Transform& transform) override {
        const osg::Matrixd before = matrix_;
        transform.computeLocalToWorldMatrix(matrix_, nullptr);
        traverse(transform);
        matrix_ = before;
    }
    void apply(osg::Drawable& drawable) override {
        if (auto* geometry = drawable.asGeometry()) {
            const auto& path = getNodePath();
            visit_(*geometry, namesOver(drawable, {path.begin(), path.end() - 1}), matrix_);
        }
    }

  private:
    Visit visit_;
    osg::Matrixd matrix_;
};

bool isPerSet(const osg::Array* array) {
    return array && array->getBinding() == osg::Array::BIND_PER_PRIMITIVE_SET;
}

/// Makes of one geometry several, one for each pair of codes.
class GeometryCut {
  public:
    explicit GeometryCut(const osg::Geometry& whole) : whole_(whole) {}

    void add(const IrCodes& codes, const std::vector<PolygonCorner>& corners) {
        auto& piece = pieces_[codes];
        if (!piece) {
            piece = osg::clone(&whole_, osg::CopyOp::SHALLOW_COPY);
            piece->getPrimitiveSetList().clear();
            setCodes(*piece, codes);
        }
        const GLenum mode = corners.size() == 3   ? GL_TRIANGLES
                            : corners.size() == 4 ? GL_QUADS
                                                  : GL_POLYGON;
        auto* set = piece->getNumPrimitiveSets() == 0
                        ? nullptr
                        : static_cast<osg::DrawElementsUInt*>(
                              piece->getPrimitiveSet(piece->getNumPrimitiveSets() - 1));
        if (!set || set->getMode() != mode || mode == GL_POLYGON) {
            set = new osg::DrawElementsUInt(mode);
            piece->addPrimitiveSet(set);
        }
        for (const PolygonCorner& corner : corners)
            set->push_back(corner.vertex);
    }
    void replace(osg::Geometry& geometry) const {
        // Copies: a parent that loses its last child may be gone.
        const auto parents = geometry.getParents();
        const osg::ref_ptr<osg::Geometry> keep = &geometry;
        for (osg::Group* parent : parents) {
            const unsigned int at = parent->getChildIndex(&geometry);
            unsigned int next = at;
            for (const auto& [codes, piece] : pieces_)
                parent->insertChild(next++, piece);
            parent->removeChild(&geometry);
        }
    }

  private:
    const osg::Geometry& whole_;
    std::map<IrCodes, osg::ref_ptr<osg::Geometry>> pieces_;
};

class CodeGiver {
  public:
    CodeGiver(const ModelCodes& codes, const std::string& name)
        : codes_(codes),
          name_(name),
          grid_(codes.painted),
          met_(codes.rules.size()),
          taken_(codes.painted.size()) {}

    void give(osg::ref_ptr<osg::Node>& graph) {
        // Of a node at several places, each has names and places of its own.
        graph = osg::clone(graph.get(), osg::CopyOp(osg::CopyOp::DEEP_COPY_NODES |
                                                    osg::CopyOp::DEEP_COPY_DRAWABLES));
        std::vector<std::pair<osg::ref_ptr<osg::Geometry>, GeometryCut>> cuts;
        NamedVisitor visitor(
            [&](osg::Geometry& geometry, const FaceNames& names, const osg::Matrixd& matrix) {
                const auto& path = visitor_->getNodePath();
                IrCodes codes = codesOf(geometry, {path.begin(), path.end() - 1});
                for (std::size_t i = 0; i < codes_.rules.size(); ++i)
                    if (fits(codes_.rules[i], names)) {
                        codes = codes_.rules[i].codes.over(codes);
                        met_[i] = true;
                    }
                if (auto cut = cutOf(geometry, matrix, codes))
                    cuts.emplace_back(&geometry, std::move(*cut));
                else
                    setCodes(geometry, codes);
            });
        visitor_ = &visitor;
        graph->accept(visitor);
        for (const auto& [geometry, cut] : cuts)
            cut.replace(*geometry);
    }

    std::vector<std::string> remarks() const {
        std::vector<std::string> remarks;
        for (std::size_t i = 0; i < met_.size(); ++i)
            if (!met_[i])
                remarks.push_back(codesName() + ": nothing is called " + describe(codes_.rules[i]));
        const PaintedGrid taken(taken_);
        for (std::size_t s = 0; s < codes_.painted.size(); ++s) {
            const auto& triangles = codes_.painted[s].triangles;
            long lost = 0;
            double area = 0.0, lostArea = 0.0;
            for (const auto& c : triangles) {
                const osg::Vec3d a(c[0], c[1], c[2]), b(c[3], c[4], c[5]), d(c[6], c[7], c[8]);
                osg::Vec3d normal = (b - a) ^ (d - a);
                const double own = normal.normalize() / 2.0;
                area += own;
                if (taken.find((a + b + d) / 3.0, normal) < 0) {
                    ++lost;
                    lostArea += own;
                }
            }
            if (lost > 0) {
                char share[32];
                std::snprintf(share, sizeof share, "%.3g %%", 100.0 * lostArea / area);
                remarks.push_back(codesName() + ": of painted surface " + std::to_string(s + 1) +
                                  " " + std::to_string(lost) + " of " +
                                  std::to_string(triangles.size()) + " triangles (" + share +
                                  " of its area) lie on no face of this model");
            }
        }
        return remarks;
    }

  private:
    std::string codesName() const { return codesFileOf(name_).filename().string(); }
    static std::string describe(const CodeRule& rule) {
        return codeRuleNames()[static_cast<std::size_t>(rule.of)] + " \"" + rule.pattern + "\"";
    }

    /// The pieces of a drawable where painted surfaces give its faces different codes. Where they
    /// give all of them the same, `codes` are these.
    std::optional<GeometryCut> cutOf(const osg::Geometry& geometry, const osg::Matrixd& matrix,
                                     IrCodes& codes) {
        if (grid_.empty())
            return std::nullopt;
        const bool hasSets =
            isPerSet(geometry.getNormalArray()) || isPerSet(geometry.getColorArray());
        const bool mirrored = mirrors(matrix);
        std::set<IrCodes> all;
        const auto each = [&](const auto& use) {
            forEachPolygon(geometry, name_, [&](std::vector<PolygonCorner>& corners) {
                auto placed = corners;
                for (PolygonCorner& corner : placed)
                    corner.position = corner.position * matrix;
                if (mirrored)
                    std::ranges::reverse(placed);
                const PolygonPlace face = placeOf(placed);
                const int surface =
                    face.cut.triangles.empty() ? -1 : grid_.find(face.point, face.normal);
                const IrCodes given =
                    surface < 0
                        ? codes
                        : codes_.painted[static_cast<std::size_t>(surface)].codes.over(codes);
                use(given, corners, placed, face, surface);
            });
        };
        each([&](const IrCodes& given, const auto&, const auto& placed, const PolygonPlace& face,
                 int surface) {
            all.insert(given);
            if (surface >= 0)
                for (const auto& triangle : face.cut.triangles)
                    take(static_cast<std::size_t>(surface), placed, triangle);
        });
        if (all.size() == 1)
            codes = *all.begin();
        if (all.size() < 2)
            return std::nullopt;
        if (hasSets)
            throw InputError(
                {name_, "",
                 "a painted drawable with a normal or a colour for each of its "
                 "primitive sets",
                 "normals and colours for vertices; conversion by another program makes them"});
        GeometryCut cut(geometry);
        each([&](const IrCodes& given, const auto& corners, const auto&, const PolygonPlace&, int) {
            cut.add(given, corners);
        });
        return cut;
    }

    void take(std::size_t surface, const std::vector<PolygonCorner>& corners,
              const std::array<std::size_t, 3>& triangle) {
        std::array<double, 9> places{};
        for (std::size_t k = 0; k < 9; ++k)
            places[k] = corners[triangle[k / 3]].position[static_cast<int>(k % 3)];
        taken_[surface].triangles.push_back(places);
    }

    const ModelCodes& codes_;
    const std::string& name_;
    PaintedGrid grid_;
    std::vector<bool> met_;
    std::vector<PaintedSurface> taken_; ///< what of the model took which surface
    NamedVisitor* visitor_ = nullptr;
};

} // namespace

FaceNames namesOver(const osg::Drawable& drawable, const std::vector<osg::Node*>& path) {
    FaceNames names;
    names.material = materialNamed(drawable.getStateSet());
    names.object = drawable.getName();
    for (auto node = path.rbegin(); node != path.rend(); ++node) {
        if (names.material.empty())
            names.material = materialNamed((*node)->getStateSet());
        if (names.object.empty())
            names.object = (*node)->getName();
        if (!(*node)->getName().empty())
            names.groups.insert(names.groups.begin(), (*node)->getName());
    }
    return names;
}

bool fits(const CodeRule& rule, const FaceNames& names) {
    switch (rule.of) {
    case CodeRule::Of::material:
        return fitsPattern(names.material, rule.pattern);
    case CodeRule::Of::object:
        return fitsPattern(names.object, rule.pattern);
    case CodeRule::Of::group:
        return std::ranges::any_of(names.groups, [&](const std::string& group) {
            return fitsPattern(group, rule.pattern);
        });
    }
    return false;
}

std::vector<std::string> giveCodes(osg::ref_ptr<osg::Node>& graph, const ModelCodes& codes,
                                   const std::string& name) {
    CodeGiver giver(codes, name);
    giver.give(graph);
    return giver.remarks();
}

NamesOfKinds namesIn(osg::Node& graph, const std::string& name, NamedParts* parts) {
    NamesOfKinds found(codeRuleNames().size());
    NamedVisitor* walking = nullptr;
    NamedVisitor visitor(
        [&](osg::Geometry& geometry, const FaceNames& names, const osg::Matrixd& matrix) {
            NamedFaces faces;
            const auto& path = walking->getNodePath();
            const IrCodes codes = codesOf(geometry, {path.begin(), path.end() - 1});
            forEachPolygon(geometry, name, [&](std::vector<PolygonCorner>& corners) {
                for (PolygonCorner& corner : corners)
                    corner.position = corner.position * matrix;
                faces.area += placeOf(corners).area;
                ++faces.polygons;
            });
            if (parts != nullptr) {
                NamedExtent& part = (*parts)[names];
                part.polygons += faces.polygons;
                part.area += faces.area;
            }
            const auto add = [&](CodeRule::Of of, const std::string& called) {
                NamedFaces& sum = found[static_cast<std::size_t>(of)][called];
                sum.polygons += faces.polygons;
                sum.area += faces.area;
                sum.codes[codes] += faces.polygons;
            };
            add(CodeRule::Of::material, names.material);
            add(CodeRule::Of::object, names.object);
            for (const std::string& group : std::set(names.groups.begin(), names.groups.end()))
                add(CodeRule::Of::group, group);
        });
    walking = &visitor;
    graph.accept(visitor);
    return found;
}

} // namespace irsg
