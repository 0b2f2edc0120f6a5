#include "irsg/geometry/model/ModelConverter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <osg/MatrixTransform>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/conversion/ClosedZones.h"
#include "irsg/geometry/conversion/CodeSafeMerge.h"
#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/model/ModelPlacing.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/NoFaces.h"
#include "irsg/geometry/reading/OsgNotices.h"
#include "irsg/geometry/reading/OwnPlugins.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

/// Kinds of one plug-in that are told from each other by a word, where there is no file name.
const char* fileType(const std::string& extension) {
    return extension == "osgt"   ? "Ascii"
           : extension == "osgx" ? "XML"
           : extension == "osgb" ? "Binary"
                                 : "";
}

std::string checkedExtension(const fs::path& in, const fs::path& out) {
    const auto extension = osgDB::getLowerCaseFileExtension(out.string());
    static const std::vector<std::string> known = {"osgt", "osgb", "ive", "osg", "osgx"};
    if (std::find(known.begin(), known.end(), extension) == known.end())
        throw InputError({out.string(), "", "output of type \"." + extension + "\"",
                          extension == "flt" ? ".osgt, .osgb, .ive, .osg or .osgx: OpenSceneGraph "
                                               "writes OpenFlight without its infrared codes"
                                             : ".osgt, .osgb, .ive, .osg or .osgx"});
    std::error_code ignored;
    if (fs::equivalent(in, out, ignored))
        throw InputError({out.string(), "", "the input itself as output", "another file"});
    const auto folder = out.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, ignored))
        throw InputError({folder.string(), "", "no such folder", "a folder to write to"});
    return extension;
}

std::string axisName(const std::optional<ModelAxis>& axis) {
    return modelAxisNames()[static_cast<std::size_t>(*axis)];
}

/// What neither the file nor who converts it has said, and what was taken for it; "" for nothing.
std::string remarkOfOpen(const ModelPlacing& given, const FileAxes& axes,
                         const ModelPlacing& taken) {
    std::vector<std::string> open;
    std::string instead;
    const auto leave = [&](const char* what, const std::string& value) {
        open.emplace_back(what);
        instead += (instead.empty() ? "" : ", ") + value;
    };
    if (!given.unit_m && !axes.unit_m)
        leave("unit", "metres");
    if (!given.up && !axes.up)
        leave("up axis", "up " + axisName(taken.up));
    // A nose along +y is what everybody expects where the rest is stated.
    const bool isToldNose = given.nose || axes.front || axes.usualFront;
    if (!isToldNose && (!open.empty() || taken.nose != ModelAxis::plusY))
        leave("nose axis", "nose " + axisName(taken.nose));
    return open.empty()
               ? ""
               : "the file does not state its " + alternatives(open) + ": taken as " + instead;
}

/// Brings a graph to metres and the axes of a model, below a transformation where it has others.
void place(osg::ref_ptr<osg::Node>& graph, const FileAxes& axes, const ModelPlacing& given,
           const fs::path& in, const std::string& extension, ConversionReport& report) {
    if (given.origin)
        throw LogicError("a conversion that moves the origin");
    const ModelPlacing& taken = report.placing = completed(given, axes, in.string());
    if (auto open = remarkOfOpen(given, axes, taken); !open.empty())
        report.remarks.push_back(std::move(open));
    const Matrix4 matrix = turnAndScale(taken);
    if (matrix == Matrix4())
        return;
    osg::ref_ptr<osg::MatrixTransform> root = new osg::MatrixTransform(toOsg(matrix));
    // Normals keep their length in viewers.
    root->getOrCreateStateSet()->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    root->addChild(graph);
    graph = root;
    report.remarks.push_back("written in metres, y to the nose and z up, for ." + extension +
                             " states neither unit nor axes; as read it is in " +
                             unitName(*taken.unit_m) + ", up " + axisName(taken.up) + ", nose " +
                             axisName(taken.nose) +
                             (axes.reason.empty() ? "" : " (" + axes.reason + ")"));
}

std::map<IrCodes, double> areas(osg::Node& graph, const std::string& name) {
    SurfaceMesh mesh;
    GeometryCollector(mesh, {}, name, {.forceTwoSided = true}).collect(graph);
    std::map<IrCodes, double> areas;
    for (const auto& [kind, part] : mesh.parts())
        areas[kind.codes] += part.area_m2;
    return areas;
}

/// Single precision and another cut through the same polygon are all that may differ.
bool sameAreas(const std::map<IrCodes, double>& a, const std::map<IrCodes, double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.first == y.first && std::abs(x.second - y.second) <= 1e-4 * x.second;
    });
}

/// Corners of all polygons that are drawn, in the order of the graph, in double.
std::vector<osg::Vec3d> placesOf(osg::Node& graph, const std::string& name) {
    SurfaceMesh unused;
    GeometryCollector collector(unused, {}, name, {.forceTwoSided = true});
    std::vector<osg::Vec3d> places;
    collector.giveTo([&](const DrawnPolygon& polygon) {
        for (const PolygonCorner& corner : polygon.corners)
            places.push_back(corner.position);
    });
    collector.collect(graph);
    return places;
}

/// Throws InputError where a graph that was read back has its corners elsewhere than the one that
/// was written, by more than 1e-7 of the extent of all.
void checkPlaces(osg::Node& written, osg::Node& back, const fs::path& out) {
    constexpr double mayMove = 1e-7;
    const std::vector<osg::Vec3d> before = placesOf(written, out.string()),
                                  after = placesOf(back, out.string());
    osg::BoundingBoxd bounds;
    for (const osg::Vec3d& place : before)
        bounds.expandBy(place);
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
        most = std::max(most, (after[i] - before[i]).length());
    const double extent = bounds.valid() ? (bounds._max - bounds._min).length() : 0.0;
    if (before.size() != after.size() || !(most <= mayMove * extent))
        throw InputError({out.string(), "",
                          before.size() != after.size()
                              ? "a file with " + std::to_string(after.size()) + " corners for " +
                                    std::to_string(before.size())
                              : "a file that moves corners by " + numberText(most) + " units of " +
                                    numberText(extent) + ", which the model is wide",
                          "at most 1e-7 of it; .osgb and .ive keep all digits"});
}

std::string bytesOf(const osg::Node& graph, const fs::path& out, const std::string& extension) {
    const std::scoped_lock lock(osgRegistryMutex());
    OsgNotices notices;
    preferOwnPlugins();
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
    const std::string type = fileType(extension);
    // Texts have all digits of a double: six, as the plug-ins write otherwise, move parts of a
    // scene that lies far from zero by metres. Each of them asks for the number in its own way.
    const std::string digits = std::to_string(std::numeric_limits<double>::max_digits10);
    std::string wanted = "PRECISION " + digits;
    if (!type.empty()) {
        // Textures go into the file where its kind can hold them.
        wanted += " WriteImageHint=IncludeFile";
        options->setPluginStringData("fileType", type);
    }
    options->setPluginStringData("Precision", digits);
    options->setOptionString(wanted);
    std::ostringstream stream;
    stream.precision(std::numeric_limits<double>::max_digits10);
    bool written = false;
    std::string complaint;
    try {
        auto* writer = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
        written = writer && writer->writeNode(graph, stream, options).success() && stream;
    } catch (const std::exception& error) {
        complaint = error.what();
    }
    for (const auto& line : notices.take())
        complaint += (complaint.empty() ? "" : "; ") + line;
    if (!written)
        throw InputError({out.string(), "", "a graph that cannot be written (" + complaint + ")",
                          "another kind of output"});
    return std::move(stream).str();
}

} // namespace

ConversionReport convertModel(const fs::path& in, const fs::path& out, const std::stop_token& stop,
                              const ConversionOptions& options) {
    const auto extension = checkedExtension(in, out);
    auto loaded = loadGraph(in, LoadPurpose::visible);
    if (stop.stop_requested())
        return {};
    const bool flight = !loaded.faces.empty();
    ConversionReport report;
    report.remarks = std::move(loaded.remarks);
    place(loaded.node, loaded.axes, options.placing, in, extension, report);
    osg::ref_ptr<osg::Group> graph = new osg::Group;
    graph->addChild(loaded.node);

    report.polygonsRead = polygonCounts(*graph);
    if (report.polygonsRead.empty())
        refuseWithoutFaces(in.string(), report.remarks);
    if (!options.closed.empty()) {
        osg::ref_ptr<osg::Group> whole = new osg::Group;
        whole->addChild(loaded.node);
        report.facesThatClose = closeMeshes(*whole, options.closed, in.string());
        if (!report.facesThatClose.empty())
            graph->setChild(0, whole);
    }
    const auto areasRead = areas(*graph, in.string());
    int misfits = 0;
    const auto counts = mergeKeepingCodes(*graph, flight, misfits);
    report.drawablesRead = counts.before;
    report.drawablesWritten = counts.after;
    report.polygonsWritten = polygonCounts(*graph);
    if (misfits > 0)
        report.remarks.push_back(
            std::to_string(misfits) +
            " drawables had normals, colours or texture coordinates for some of "
            "their vertices only: removed");

    if (stop.stop_requested())
        return {};

    const std::string bytes = bytesOf(*graph->getChild(0), out, extension);
    if (stop.stop_requested())
        return {};

    // What is written is worth what can be read from it.
    const auto back = loadWritten(bytes, out);
    if (polygonCounts(*back.node) != report.polygonsWritten ||
        !sameAreas(areas(*back.node, out.string()), areasRead))
        throw InputError({out.string(), "", "a file that lost codes or faces of " + in.string(),
                          "codes and areas as read; another kind of output may keep them"});
    checkPlaces(*graph->getChild(0), *back.node, out);
    if (stop.stop_requested())
        return {};
    writeFileDurably(out, bytes);
    return report;
}

} // namespace irsg
