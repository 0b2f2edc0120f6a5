#include "irsg/geometry/reading/text/StlReader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Wording.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/TextWords.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

namespace {

constexpr std::size_t headSize = 84, facetSize = 50;

/// The facets of one solid.
struct Solid {
    std::string name;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);

    /// A normal that says nothing is made from the corners, counter-clockwise.
    void add(const osg::Vec3& stated, const osg::Vec3* corners) {
        osg::Vec3 normal = stated;
        if (!(normal.length2() > 0.0f))
            normal = (corners[1] - corners[0]) ^ (corners[2] - corners[0]);
        normal.normalize();
        vertices->insert(vertices->end(), corners, corners + 3);
        normals->insert(normals->end(), 3, normal);
    }

    osg::ref_ptr<osg::Node> node() const {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setName(name);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(vertices);
        geometry->setNormalArray(normals);
        osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
        colour->front() = osg::Vec4(1, 1, 1, 1);
        geometry->setColorArray(colour);
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices->size())));
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->setName(name);
        geode->addDrawable(geometry);
        return geode;
    }
};

std::uint32_t countOf(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + headSize - 4, sizeof count);
    return count;
}

Solid readBinary(std::string_view bytes, const std::string& file,
                 std::vector<std::string>& remarks) {
    if (bytes.size() < headSize)
        throw InputError({file, "byte " + std::to_string(bytes.size()),
                          "the end of the file in its head", "84 bytes and facets of 50 bytes"});
    const std::size_t count = countOf(bytes), there = (bytes.size() - headSize) / facetSize;
    if (count > there)
        throw InputError({file, "byte 80", std::to_string(count) + " facets",
                          "at most " + std::to_string(there) + ", for which there are bytes"});
    if (bytes.size() > headSize + facetSize * count)
        remarks.push_back(std::to_string(bytes.size() - headSize - facetSize * count) +
                          " bytes behind the last facet are left out");
    Solid solid;
    solid.vertices->reserve(3 * count);
    solid.normals->reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        float values[12];
        std::memcpy(values, bytes.data() + headSize + facetSize * i, sizeof values);
        const float* wrong = std::find_if_not(values + 3, values + 12,
                                              [](float value) { return std::isfinite(value); });
        if (wrong != values + 12)
            throw InputError(
                {file, "byte " + std::to_string(headSize + facetSize * i + 4 * (wrong - values)),
                 std::isnan(*wrong) ? "not a number" : "an infinite number", "a finite number"});
        osg::Vec3 normal(values[0], values[1], values[2]);
        if (!normal.valid())
            normal = {};
        const osg::Vec3 corners[3] = {{values[3], values[4], values[5]},
                                      {values[6], values[7], values[8]},
                                      {values[9], values[10], values[11]}};
        solid.add(normal, corners);
    }
    return solid;
}

/// The format has its words in any case.
bool isWord(std::string_view word, std::string_view written) {
    return lowerCase(std::string(written)) == word;
}

class TextReader {
  public:
    TextReader(std::string_view text, const std::string& file) : words_(text, file) {}

    std::vector<Solid> read() {
        std::vector<Solid> solids;
        while (next("solid or the end of the file", {"solid"})) {
            solids.emplace_back();
            solids.back().name = words_.rest();
            if (!unit)
                unit = unitInWords(solids.back().name);
            readSolid(solids.back());
        }
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return solids;
    }
    std::optional<UnitInWords> unit; ///< that a name mentions

  private:
    /// The next line, which has to begin with these words; false at the end of the file.
    bool next(const char* expected, std::initializer_list<std::string_view> begin) {
        if (!words_.next())
            return false;
        if (words_.words().size() < begin.size() ||
            !std::equal(begin.begin(), begin.end(), words_.words().begin(), isWord))
            fail(words_.diagnostic(quoted(words_.words()[0]), expected));
        return true;
    }
    void demand(const char* expected, std::initializer_list<std::string_view> begin) {
        if (!next(expected, begin))
            fail(words_.diagnostic("the end of the file behind this line", expected));
    }
    /// What follows a line that is out of place means nothing.
    [[noreturn]] void fail(Diagnostic diagnostic) {
        diagnostics_.push_back(std::move(diagnostic));
        throw InputError(std::move(diagnostics_));
    }
    bool vector(std::size_t from, osg::Vec3& into) {
        double values[3];
        if (!words_.numbers(from, 3, values, diagnostics_)) {
            if (diagnostics_.size() >= mostModelDiagnostics)
                throw InputError(std::move(diagnostics_));
            return false;
        }
        into.set(static_cast<float>(values[0]), static_cast<float>(values[1]),
                 static_cast<float>(values[2]));
        return true;
    }

    void readSolid(Solid& solid) {
        for (;;) {
            if (!words_.next())
                fail(words_.diagnostic("the end of the file behind this line", "endsolid"));
            const auto& words = words_.words();
            if (isWord("endsolid", words[0]))
                return;
            if (!isWord("facet", words[0]))
                fail(words_.diagnostic(quoted(words[0]), "facet or endsolid"));
            readFacet(solid);
        }
    }

    void readFacet(Solid& solid) {
        osg::Vec3 normal, corners[3];
        bool good = words_.words().size() == 1 || vector(2, normal);
        demand("outer loop", {"outer", "loop"});
        for (auto& corner : corners) {
            demand("vertex", {"vertex"});
            good = vector(1, corner) && good;
        }
        demand("endloop: a facet has three corners", {"endloop"});
        demand("endfacet", {"endfacet"});
        if (good)
            solid.add(normal, corners);
    }

    TextWords words_;
    std::vector<Diagnostic> diagnostics_;
};

/// Some binary files begin with the word of the text files; their size tells.
bool isText(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || !isWord("solid", bytes.substr(first, 5)))
        return false;
    if (bytes.size() >= headSize && bytes.size() == headSize + facetSize * countOf(bytes))
        return false;
    return bytes.substr(0, 1024).find('\0') == bytes.npos;
}

} // namespace

LoadedGraph readStl(const std::filesystem::path& file) {
    std::string bytes = readFile(file, largestModel_B);
    LoadedGraph loaded;
    osg::ref_ptr<osg::Group> group = new osg::Group;
    if (hasMark(bytes) || isText(bytes)) {
        bytes = plainText(std::move(bytes), file.string());
        TextReader reader(bytes, file.string());
        for (const Solid& solid : reader.read())
            group->addChild(solid.node());
        loaded.axes.spokenUnit = reader.unit;
    } else {
        group->addChild(readBinary(bytes, file.string(), loaded.remarks).node());
        loaded.axes.spokenUnit = unitInWords(
            std::string_view(bytes).substr(0, std::min(headSize - 4, bytes.find('\0'))));
    }
    loaded.node = group;
    return loaded;
}

} // namespace irsg
