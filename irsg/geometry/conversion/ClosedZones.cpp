#include "irsg/geometry/conversion/ClosedZones.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <osg/BoundingBox>
#include <osg/Geode>
#include <osg/Geometry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "irsg/geometry/reading/IrCodes.h"

namespace irsg {

namespace {

using Polygon = std::vector<osg::Vec3d>;

/// By codes, what is drawn of these materials, counter-clockwise from the front.
std::map<IrCodes, std::vector<Polygon>>
polygonsOf(osg::Group& graph, const std::set<int>& materials, const std::string& name) {
    std::map<IrCodes, std::vector<Polygon>> found;
    SurfaceMesh unused;
    GeometryCollector collector(unused, {}, name, {.forceTwoSided = true});
    collector.giveTo([&](const DrawnPolygon& polygon) {
        if (!materials.contains(polygon.kind.codes.material))
            return;
        Polygon& places = found[polygon.kind.codes].emplace_back();
        for (const PolygonCorner& corner : polygon.corners)
            places.push_back(corner.position);
    });
    collector.collect(graph);
    return found;
}

/// What lies around each opening, in the sense of the faces that close it.
std::vector<Polygon> openingsOf(const std::vector<Polygon>& polygons, const std::string& name,
                                const IrCodes& codes) {
    osg::BoundingBoxd box;
    for (const Polygon& polygon : polygons)
        for (const osg::Vec3d& place : polygon)
            box.expandBy(place);
    PlaceNumbers numbers(samePlaceOfSize * (box._max - box._min).length());
    Polygon places;                           // by number
    std::map<std::pair<int, int>, int> edges; // how often in one sense less in the other
    for (const Polygon& polygon : polygons) {
        std::vector<int> corners;
        for (const osg::Vec3d& place : polygon) {
            corners.push_back(static_cast<int>(numbers.of({place.x(), place.y(), place.z()})));
            if (corners.back() == static_cast<int>(places.size()))
                places.push_back(place);
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int from = corners[i], to = corners[(i + 1) % corners.size()];
            if (from != to)
                edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    }
    const auto refuse = [&](const std::string& what) {
        throw InputError({name,
                          "material index " + std::to_string(codes.material) +
                              " and temperature index " + std::to_string(codes.temperature),
                          what, "meshes whose faces all look outwards, open where they end"});
    };
    std::multimap<int, int> next;
    for (const auto& [ends, count] : edges)
        if (count == 1)
            next.emplace(ends.second, ends.first);
        else if (count == -1)
            next.emplace(ends.first, ends.second);
        else if (count != 0)
            refuse("neighbouring faces that are turned to opposite sides");
    std::vector<Polygon> openings;
    while (!next.empty()) {
        std::vector<int> opening;
        opening.push_back(next.begin()->first);
        do {
            const auto edge = next.find(opening.back());
            if (edge == next.end())
                break;
            opening.push_back(edge->second);
            next.erase(edge);
        } while (opening.back() != opening.front());
        if (opening.front() != opening.back() || opening.size() < 4)
            refuse("open edges that go around no opening");
        opening.pop_back();
        Polygon& around = openings.emplace_back();
        for (const int number : opening)
            around.push_back(places[static_cast<std::size_t>(number)]);
    }
    return openings;
}

} // namespace

FacesAdded closeMeshes(osg::Group& graph, const std::set<int>& materials, const std::string& name) {
    FacesAdded added;
    double kinds = 0.0;
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (const auto& [codes, polygons] : polygonsOf(graph, materials, name)) {
        osg::ref_ptr<osg::Vec3dArray> places = new osg::Vec3dArray;
        osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
        ++kinds;
        for (const Polygon& opening : openingsOf(polygons, name, codes)) {
            const auto next = [&](std::size_t i) { return opening[(i + 1) % opening.size()]; };
            osg::Vec3d middle, twiceArea;
            for (const osg::Vec3d& place : opening)
                middle += place / static_cast<double>(opening.size());
            for (std::size_t i = 0; i < opening.size(); ++i)
                twiceArea += (opening[i] - middle) ^ (next(i) - middle);
            // Outwards, for each kind by another part of the opening's size: shells of a nest often
            // begin in one plane, and faces in one plane hide each other.
            constexpr double outwards = 2e-3;
            if (const double size = std::sqrt(twiceArea.length()); size > 0.0)
                middle += twiceArea * (outwards * kinds / size);
            for (std::size_t i = 0; i < opening.size(); ++i) {
                osg::Vec3d normal = (opening[i] - middle) ^ (next(i) - middle);
                normal.normalize();
                for (const osg::Vec3d& corner : {middle, opening[i], next(i)}) {
                    places->push_back(corner);
                    normals->push_back(osg::Vec3(normal));
                }
            }
            added[codes] += static_cast<long>(opening.size());
        }
        if (places->empty())
            continue;
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setVertexArray(places);
        geometry->setNormalArray(normals);
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(places->size())));
        setCodes(*geometry, codes);
        geode->addDrawable(geometry);
    }
    if (geode->getNumDrawables() > 0)
        graph.addChild(geode);
    return added;
}

} // namespace irsg
