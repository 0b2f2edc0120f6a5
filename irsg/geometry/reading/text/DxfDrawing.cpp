#include "irsg/geometry/reading/text/DxfDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/reading/text/DxfPairs.h"
#include "irsg/geometry/reading/text/TextWords.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

namespace {

struct DrawingUnit {
    double unit_m;
    const char* name;
};
/// By the number of $INSUNITS; 0 states none.
constexpr DrawingUnit units[] = {{0.0, "none"},
                                 {0.0254, "inches"},
                                 {0.3048, "feet"},
                                 {1609.344, "miles"},
                                 {0.001, "millimetres"},
                                 {0.01, "centimetres"},
                                 {1.0, "metres"},
                                 {1000.0, "kilometres"},
                                 {2.54e-8, "microinches"},
                                 {2.54e-5, "mils"},
                                 {0.9144, "yards"},
                                 {1e-10, "angstroms"},
                                 {1e-9, "nanometres"},
                                 {1e-6, "microns"},
                                 {0.1, "decimetres"},
                                 {10.0, "decametres"},
                                 {100.0, "hectometres"},
                                 {1e9, "gigametres"},
                                 {1.495978707e11, "astronomical units"},
                                 {9.4607304725808e15, "light years"},
                                 {3.0856775814913673e16, "parsecs"},
                                 {1200.0 / 3937.0, "US survey feet"},
                                 {100.0 / 3937.0, "US survey inches"},
                                 {3600.0 / 3937.0, "US survey yards"},
                                 {5280.0 * 1200.0 / 3937.0, "US survey miles"}};

/// What hides its faces in the language of a solid modeller, or needs a subdivision.
constexpr std::string_view otherSurfaces[] = {"3DSOLID",
                                              "BODY",
                                              "REGION",
                                              "SURFACE",
                                              "PLANESURFACE",
                                              "EXTRUDEDSURFACE",
                                              "REVOLVEDSURFACE",
                                              "LOFTEDSURFACE",
                                              "SWEPTSURFACE",
                                              "MESH",
                                              "HATCH"};

/// The values of an entity, as far as surfaces need them.
struct Entity {
    std::string kind, layer, name;
    std::array<osg::Vec3d, 4> corners; ///< codes 10 to 13 with 20 and 30
    std::array<bool, 4> given{};       ///< which of them
    osg::Vec3d extrusion{0, 0, 1};     ///< 210
    std::array<double, 10> reals{};    ///< codes 40 to 49
    std::array<bool, 10> hasReal{};
    double angle_deg = 0.0;       ///< 50
    double thickness = 0.0;       ///< 39
    std::array<int, 10> wholes{}; ///< codes 70 to 79
    bool invisible = false, onPaper = false;
};

/// From the coordinates of a flat entity to those of the drawing, by its extrusion (the arbitrary
/// axis algorithm of the format's reference).
osg::Matrixd planeOf(osg::Vec3d z) {
    if (!(z.length() > 0.0))
        return {};
    z.normalize();
    constexpr double near = 1.0 / 64.0;
    osg::Vec3d x = (std::abs(z.x()) < near && std::abs(z.y()) < near ? osg::Vec3d(0, 1, 0)
                                                                     : osg::Vec3d(0, 0, 1)) ^
                   z;
    x.normalize();
    const osg::Vec3d y = z ^ x;
    return {x.x(), x.y(), x.z(), 0, y.x(), y.y(), y.z(), 0, z.x(), z.y(), z.z(), 0, 0, 0, 0, 1};
}

class DrawingReader {
  public:
    DrawingReader(std::string_view text, const std::string& file)
        : pairs_(text, file), file_(file) {}

    DxfDrawing read() {
        advance();
        while (!pairs_.is(0, "EOF")) {
            if (!pairs_.is(0, "SECTION")) {
                advance();
                continue;
            }
            advance();
            const std::string section(pairs_.value());
            advance();
            if (section == "HEADER")
                readHeader();
            else if (section == "TABLES")
                readLayers();
            else if (section == "BLOCKS")
                readBlocks();
            else if (section == "ENTITIES")
                readEntities(drawing_.model);
        }
        tell();
        return std::move(drawing_);
    }

  private:
    void advance() {
        do {
            if (!pairs_.next())
                pairs_.refuse("the end of the file", "EOF, which ends a drawing");
            if (pairs_.code() == 999 && !drawing_.axes.spokenUnit)
                drawing_.axes.spokenUnit = unitInWords(pairs_.value());
        } while (pairs_.code() == 999);
    }
    bool atEnd(std::string_view end) const { return pairs_.is(0, end) || pairs_.is(0, "EOF"); }

    void readHeader() {
        std::string variable;
        for (; !atEnd("ENDSEC"); advance())
            if (pairs_.code() == 9)
                variable = pairs_.value();
            else if (variable == "$INSUNITS" && pairs_.code() == 70)
                takeUnit(pairs_.whole());
    }

    void takeUnit(int number) {
        if (number == 0)
            return;
        if (number < 0 || number >= static_cast<int>(std::size(units))) {
            drawing_.remarks.push_back("$INSUNITS " + std::to_string(number) +
                                       " is no unit of the format and is left out");
            return;
        }
        const DrawingUnit& unit = units[number];
        const std::string said = "$INSUNITS " + std::to_string(number) + " (" + unit.name + ")";
        if (unit.unit_m < 1e-6 || unit.unit_m > 1e6) {
            drawing_.remarks.push_back(said + " is no unit for a model and is left out");
            return;
        }
        drawing_.axes.unit_m = unit.unit_m;
        drawing_.axes.reason = "the file's header: " + said;
        drawing_.remarks.push_back("the file states its unit: " + said);
    }

    /// Those that are frozen or off: by a flag, and by a colour below 0.
    void readLayers() {
        std::string name;
        bool isLayer = false;
        for (; !atEnd("ENDSEC"); advance())
            if (pairs_.code() == 0)
                isLayer = pairs_.is(0, "LAYER");
            else if (isLayer && pairs_.code() == 2)
                name = pairs_.value();
            else if (isLayer && ((pairs_.code() == 70 && pairs_.whole() % 2 != 0) ||
                                 (pairs_.code() == 62 && pairs_.whole() < 0)))
                notShown_.insert(name);
    }

    void readBlocks() {
        while (!atEnd("ENDSEC")) {
            if (!pairs_.is(0, "BLOCK")) {
                advance();
                continue;
            }
            std::string name;
            osg::Vec3d base;
            for (advance(); pairs_.code() != 0; advance())
                if (pairs_.code() == 2)
                    name = lowerCase(std::string(pairs_.value()));
                else if (pairs_.code() == 1 && !pairs_.value().empty())
                    drawing_.remarks.push_back("the block " + name + " is another file, " +
                                               std::string(pairs_.value()) +
                                               ", which is not opened");
                else if (pairs_.code() == 10 || pairs_.code() == 20 || pairs_.code() == 30)
                    base[pairs_.code() / 10 - 1] = pairs_.number();
            DxfDrawing::Block& block = drawing_.blocks[name];
            readEntities(block);
            for (DxfDrawing::Face& face : block.faces)
                for (osg::Vec3d& corner : face.corners)
                    corner -= base;
            for (DxfDrawing::Insertion& insertion : block.insertions)
                insertion.matrix.postMultTranslate(-base);
        }
    }

    /// Up to the end of the section or of the block.
    void readEntities(DxfDrawing::Block& into) {
        while (!atEnd("ENDSEC") && !pairs_.is(0, "ENDBLK")) {
            if (pairs_.code() != 0) {
                advance();
                continue;
            }
            const Entity entity = readEntity();
            if (entity.kind == "POLYLINE")
                readPolyline(entity, into);
            else if (entity.onPaper)
                ++onPaper_;
            else if (entity.invisible)
                ++hidden_;
            else
                add(entity, into);
        }
    }

    Entity readEntity() {
        Entity entity;
        entity.kind = pairs_.value();
        for (advance(); pairs_.code() != 0; advance()) {
            const int code = pairs_.code();
            if (code == 8)
                entity.layer = pairs_.value();
            else if (code == 2)
                entity.name = lowerCase(std::string(pairs_.value()));
            else if (code == 60)
                entity.invisible = pairs_.whole() == 1;
            else if (code == 67)
                entity.onPaper = pairs_.whole() == 1;
            else if (reads(entity.kind))
                take(entity, code);
        }
        return entity;
    }
    static bool reads(std::string_view kind) {
        return kind == "3DFACE" || kind == "SOLID" || kind == "TRACE" || kind == "POLYLINE" ||
               kind == "VERTEX" || kind == "INSERT";
    }
    void take(Entity& entity, int code) const {
        const int tens = code / 10, ones = code % 10;
        if (tens >= 1 && tens <= 3 && ones < 4) {
            entity.corners[static_cast<std::size_t>(ones)][tens - 1] = pairs_.number();
            entity.given[static_cast<std::size_t>(ones)] = true;
        } else if (code == 210 || code == 220 || code == 230) {
            entity.extrusion[code / 10 - 21] = pairs_.number();
        } else if (tens == 4) {
            entity.reals[static_cast<std::size_t>(ones)] = pairs_.number();
            entity.hasReal[static_cast<std::size_t>(ones)] = true;
        } else if (code == 50) {
            entity.angle_deg = pairs_.number();
        } else if (code == 39) {
            entity.thickness = pairs_.number();
        } else if (tens == 7) {
            entity.wholes[static_cast<std::size_t>(ones)] = pairs_.whole();
        }
    }

    void add(const Entity& entity, DxfDrawing::Block& into) {
        onHiddenLayers_ += notShown_.contains(entity.layer) ? 1 : 0;
        const auto& c = entity.corners;
        if (entity.kind == "3DFACE") {
            addFace(into, entity.layer, {c[0], c[1], c[2], entity.given[3] ? c[3] : c[2]});
        } else if (entity.kind == "SOLID" || entity.kind == "TRACE") {
            // Their corners run to and fro; two sides of a prism are left to the remark.
            thick_ += entity.thickness != 0.0;
            const osg::Matrixd plane = planeOf(entity.extrusion);
            const osg::Vec3d last = entity.given[3] ? c[3] : c[2];
            addFace(into, entity.layer, {c[0] * plane, c[1] * plane, last * plane, c[2] * plane});
        } else if (entity.kind == "INSERT") {
            addInsertions(entity, into);
        } else if (entity.kind != "SEQEND" && entity.kind != "ATTRIB") {
            ++leftOut_[entity.kind];
        }
    }

    static void addFace(DxfDrawing::Block& into, const std::string& layer,
                        std::vector<osg::Vec3d> corners) {
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        if (corners.size() > 3 && corners.front() == corners.back())
            corners.pop_back();
        if (corners.size() >= 3)
            into.faces.push_back({layer, std::move(corners)});
    }

    void addInsertions(const Entity& entity, DxfDrawing::Block& into) {
        const auto scale = [&](std::size_t i) { return entity.hasReal[i] ? entity.reals[i] : 1.0; };
        const auto copies = [&](std::size_t i) { return std::max(1, entity.wholes[i]); };
        const double columns = copies(0), rows = copies(1);
        if (columns * rows > 1e6)
            pairs_.refuse("a block in " + numberText(columns * rows) + " places",
                          "at most a million");
        const osg::Matrixd turned =
            osg::Matrixd::rotate(entity.angle_deg * osg::PI / 180.0, osg::Vec3d(0, 0, 1));
        const osg::Matrixd plane = planeOf(entity.extrusion);
        for (int row = 0; row < copies(1); ++row)
            for (int column = 0; column < copies(0); ++column)
                into.insertions.push_back(
                    {entity.name, osg::Matrixd::scale(scale(1), scale(2), scale(3)) *
                                      osg::Matrixd::translate(column * entity.reals[4],
                                                              row * entity.reals[5], 0.0) *
                                      turned * osg::Matrixd::translate(entity.corners[0]) * plane});
    }

    /// A polyline with its vertices, up to SEQEND.
    void readPolyline(const Entity& line, DxfDrawing::Block& into) {
        std::vector<Entity> vertices;
        while (pairs_.is(0, "VERTEX"))
            vertices.push_back(readEntity());
        if (pairs_.is(0, "SEQEND"))
            readEntity();
        const int flags = line.wholes[0];
        onHiddenLayers_ += notShown_.contains(line.layer) ? 1 : 0;
        if (line.onPaper)
            ++onPaper_;
        else if (line.invisible)
            ++hidden_;
        else if (flags & 64)
            addPolyface(line, vertices, into);
        else if (flags & 16)
            addGrid(line, vertices, into);
        else
            ++leftOut_[line.kind];
    }

    void addPolyface(const Entity& line, const std::vector<Entity>& vertices,
                     DxfDrawing::Block& into) {
        std::vector<osg::Vec3d> places;
        for (const Entity& vertex : vertices)
            if (vertex.wholes[0] & 64)
                places.push_back(vertex.corners[0]);
        for (const Entity& vertex : vertices) {
            if ((vertex.wholes[0] & 64) || !(vertex.wholes[0] & 128))
                continue;
            std::vector<osg::Vec3d> corners;
            // Minus signs hide edges.
            for (std::size_t i = 1; i <= 4; ++i)
                if (const int number = std::abs(vertex.wholes[i]); number != 0) {
                    if (static_cast<std::size_t>(number) > places.size())
                        pairs_.refuse("a face with vertex " + std::to_string(number) +
                                          " in the POLYLINE above",
                                      "at most " + std::to_string(places.size()));
                    corners.push_back(places[static_cast<std::size_t>(number - 1)]);
                }
            addFace(into, vertex.layer.empty() ? line.layer : vertex.layer, std::move(corners));
        }
    }

    void addGrid(const Entity& line, const std::vector<Entity>& vertices, DxfDrawing::Block& into) {
        // Of a smoothed surface the smooth vertices, not those that steer it.
        const bool smooth = line.wholes[0] & 4;
        std::vector<osg::Vec3d> places;
        for (const Entity& vertex : vertices)
            if (!(smooth && (vertex.wholes[0] & 16)))
                places.push_back(vertex.corners[0]);
        const int rows = line.wholes[smooth ? 3 : 1], columns = line.wholes[smooth ? 4 : 2];
        if (rows < 1 || columns < 1 ||
            static_cast<double>(rows) * columns != static_cast<double>(places.size()))
            pairs_.refuse("a mesh of " + std::to_string(rows) + " × " + std::to_string(columns) +
                              " vertices with " + std::to_string(places.size()) +
                              " in the POLYLINE above",
                          "as many as it states");
        const bool closedRows = line.wholes[0] & 1, closedColumns = line.wholes[0] & 32;
        const auto at = [&](int row, int column) {
            return places[static_cast<std::size_t>(row % rows * columns + column % columns)];
        };
        for (int row = 0; row < rows - (closedRows ? 0 : 1); ++row)
            for (int column = 0; column < columns - (closedColumns ? 0 : 1); ++column)
                addFace(into, line.layer,
                        {at(row, column), at(row, column + 1), at(row + 1, column + 1),
                         at(row + 1, column)});
    }

    void tell() {
        std::string lines, surfaces;
        for (const auto& [kind, count] : leftOut_) {
            std::string& list = std::ranges::find(otherSurfaces, kind) == std::end(otherSurfaces)
                                    ? lines
                                    : surfaces;
            list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
        }
        const auto say = [&](const std::string& what, const char* why) {
            if (!what.empty())
                drawing_.remarks.push_back(what + why);
        };
        say(surfaces, " are left out: their faces are not in the file as polygons; exported as "
                      "3DFACE they are read");
        say(lines, " have no faces and are left out");
        say(thick_ > 0 ? std::to_string(thick_) : "",
            " SOLID or TRACE have a thickness and are read as flat");
        say(onPaper_ > 0 ? std::to_string(onPaper_) : "",
            " entities lie on a sheet of paper and are left out");
        say(hidden_ > 0 ? std::to_string(hidden_) : "", " invisible entities are left out");
        say(onHiddenLayers_ > 0 ? std::to_string(onHiddenLayers_) : "",
            " entities lie on layers that the drawing does not show (frozen or off) and are read "
            "nevertheless");
    }

    DxfPairs pairs_;
    const std::string& file_;
    DxfDrawing drawing_;
    std::map<std::string, long> leftOut_; ///< by kind
    std::set<std::string> notShown_;      ///< layers
    long thick_ = 0, onPaper_ = 0, hidden_ = 0, onHiddenLayers_ = 0;
};

} // namespace

DxfDrawing readDxfDrawing(std::string_view text, const std::string& file) {
    return DrawingReader(text, file).read();
}

} // namespace irsg
