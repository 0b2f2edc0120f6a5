#include "irsg/geometry/reading/text/ObjReader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>

#include <osg/Geode>
#include <osg/Group>
#include <osg/MatrixTransform>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/FaceDrawable.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/ObjMaterials.h"
#include "irsg/geometry/reading/text/TextWords.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

namespace {

constexpr std::string_view libraryWord = "mtllib";

/// Words of the format that no surface of facets comes of.
constexpr std::string_view otherWords[] = {
    "l",          "p",         "s",    "mg",     "vp",     "deg",   "bmat",  "step",     "cstype",
    "curv",       "curv2",     "surf", "parm",   "trim",   "hole",  "scrv",  "sp",       "end",
    "con",        "bevel",     "lod",  "maplib", "usemap", "ctech", "stech", "c_interp", "d_interp",
    "shadow_obj", "trace_obj", "call", "csh",    "bzp",    "bsp",   "res",   "cdc"};

class ObjText {
  public:
    ObjText(std::string_view text, const std::filesystem::path& file, const PictureReading& picture)
        : words_(text, file.string()), materials_(file.parent_path(), picture) {}

    LoadedGraph read() {
        while (words_.next()) {
            const std::string_view word = words_.words()[0];
            if (word[0] == '#') {
                if (!unit_)
                    unit_ = unitInWords(words_.line());
                continue;
            }
            readLine(word);
            if (diagnostics_.size() >= mostModelDiagnostics)
                break;
        }
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return finish();
    }

  private:
    void readLine(std::string_view word) {
        double values[3];
        if (word == "v") {
            if (words_.numbers(1, 3, values, diagnostics_))
                // y is up in the file.
                shape_.vertices.emplace_back(values[0], -values[2], values[1]);
            else
                shape_.vertices.emplace_back();
        } else if (word == "vn") {
            if (words_.numbers(1, 3, values, diagnostics_))
                shape_.normals.emplace_back(values[0], -values[2], values[1]);
            else
                shape_.normals.emplace_back();
        } else if (word == "vt") {
            values[1] = 0.0;
            if (words_.numbers(1, words_.words().size() > 2 ? 2 : 1, values, diagnostics_))
                shape_.places.emplace_back(values[0], values[1]);
            else
                shape_.places.emplace_back();
        } else if (word == "f" || word == "fo") {
            readFace();
        } else if (word == "o") {
            // Its groups begin anew.
            object_ = words_.rest();
            group_.clear();
            drawable_ = nullptr;
        } else if (word == "g") {
            group_ = words_.rest();
            drawable_ = nullptr;
        } else if (word == "usemtl") {
            material_ = words_.rest();
            drawable_ = nullptr;
        } else if (word == libraryWord) {
            materials_.read(words_.rest(), remarks_);
        } else if (std::ranges::find(otherWords, word) == std::end(otherWords)) {
            if (unknown_++ == 0)
                firstUnknown_ = words_.diagnostic(quoted(word), "").message();
        } else if (word == "lod") {
            appendUnique(remarks_,
                         "levels of detail (lod) are not chosen: the faces of all are read");
        } else if (word != "s" && word != "mg") {
            ++others_;
        }
    }

    /// A number of a vertex from 1 on, or from the last one backwards below 0; -1 where it is none.
    int place(std::string_view text, std::size_t count, const char* what) {
        long long number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const auto last = static_cast<long long>(count);
        const long long index = number > 0 ? number - 1 : last + number;
        if (error != std::errc{} || stop != text.data() + text.size() || number == 0 || index < 0 ||
            index >= last) {
            diagnostics_.push_back(
                words_.diagnostic(quoted(text), std::string("the number of a ") + what + ", 1 to " +
                                                    std::to_string(count) + " or -" +
                                                    std::to_string(count) + " to -1"));
            return -1;
        }
        return static_cast<int>(index);
    }

    bool readCorner(std::string_view word, FaceCorner& corner) {
        std::string_view parts[3];
        for (auto& part : parts) {
            const auto slash = std::min(word.find('/'), word.size());
            part = word.substr(0, slash);
            word.remove_prefix(std::min(slash + 1, word.size()));
        }
        corner.vertex = place(parts[0], shape_.vertices.size(), "vertex");
        bool good = corner.vertex >= 0 && word.empty();
        if (good && !parts[1].empty()) {
            corner.place = place(parts[1], shape_.places.size(), "texture coordinate");
            good = corner.place >= 0;
        }
        if (good && !parts[2].empty()) {
            corner.normal = place(parts[2], shape_.normals.size(), "normal");
            good = corner.normal >= 0;
        }
        return good;
    }

    void readFace() {
        const auto& words = words_.words();
        if (words.size() < 4) {
            diagnostics_.push_back(words_.diagnostic(
                "a face of " + std::to_string(words.size() - 1) + " corners", "3 or more"));
            return;
        }
        face_.clear();
        for (std::size_t i = 1; i < words.size() && words[i][0] != '#'; ++i) {
            FaceCorner corner;
            if (!readCorner(words[i], corner))
                return;
            face_.push_back(corner);
        }
        if (face_.size() < 3)
            return;
        drawable().add(face_);
        ++faces_;
        used_.resize(shape_.vertices.size(), false);
        for (const FaceCorner& corner : face_)
            used_[static_cast<std::size_t>(corner.vertex)] = true;
    }

    FaceDrawable& drawable() {
        if (!drawable_) {
            const auto [at, added] = drawables_.try_emplace({object_, group_, material_}, shape_);
            drawable_ = &at->second;
            if (added)
                order_.push_back(at);
        }
        return *drawable_;
    }

    LoadedGraph finish() {
        LoadedGraph loaded;
        // Positions far from zero are counted from near themselves, in double.
        osg::BoundingBoxd bounds;
        for (const osg::Vec3d& vertex : shape_.vertices)
            bounds.expandBy(vertex);
        const auto far = farOriginOf(bounds);
        const osg::Vec3d origin = far.value_or(osg::Vec3d());
        osg::ref_ptr<osg::Group> root =
            far ? new osg::MatrixTransform(osg::Matrixd::translate(origin)) : new osg::Group;
        std::map<std::string, osg::Group*> objects;
        for (const auto& at : order_) {
            const auto& [object, group, material] = at->first;
            osg::ref_ptr<osg::Geode> geode = new osg::Geode;
            geode->setName(group.empty() ? object : group);
            const auto geometry = at->second.make(origin);
            geometry->setStateSet(materials_.state(material));
            geode->addDrawable(geometry);
            // A level of its own only where both have names.
            if (object.empty() || group.empty()) {
                root->addChild(geode);
                continue;
            }
            osg::Group*& parent = objects[object];
            if (!parent) {
                parent = new osg::Group;
                parent->setName(object);
                root->addChild(parent);
            }
            parent->addChild(geode);
        }
        const auto unused = std::ranges::count(used_, false) +
                            static_cast<std::ptrdiff_t>(shape_.vertices.size() - used_.size());
        remarks_.push_back(
            std::to_string(shape_.vertices.size()) + " vertices and " + std::to_string(faces_) +
            " faces were read to the end of the file, " +
            (unused > 0 ? std::to_string(unused) + " vertices belong to no face, " : "") +
            "and the format cannot tell whether it is whole");
        if (others_ > 0)
            remarks_.push_back(std::to_string(others_) +
                               " lines, points and free forms have no facets and are left out");
        if (unknown_ > 0)
            remarks_.push_back(firstUnknown_ + ", which the format does not have (" +
                               std::to_string(unknown_) + " lines like this are left out)");
        loaded.node = root;
        loaded.axes = {std::nullopt, ModelAxis::plusZ, std::nullopt,
                       "the custom of .obj: y up, turned to z on reading", unit_};
        loaded.remarks = std::move(remarks_);
        return loaded;
    }

    TextWords words_;
    ObjMaterials materials_;
    FaceShape shape_;
    /// By object, group and material.
    std::map<std::tuple<std::string, std::string, std::string>, FaceDrawable> drawables_;
    std::vector<decltype(drawables_)::iterator> order_;
    FaceDrawable* drawable_ = nullptr; ///< of these names
    std::string object_, group_, material_;
    std::vector<FaceCorner> face_;
    std::vector<Diagnostic> diagnostics_;
    std::vector<std::string> remarks_;
    std::vector<bool> used_; ///< vertices by faces
    long faces_ = 0, others_ = 0, unknown_ = 0;
    std::string firstUnknown_;
    std::optional<UnitInWords> unit_; ///< that a comment mentions
};

} // namespace

ObjFiles filesOfObj(const std::filesystem::path& file) {
    ObjFiles files;
    ObjMaterials materials(file.parent_path(), [&](const std::filesystem::path& picture) {
        files.pictures.push_back(picture);
        return osg::ref_ptr<osg::Image>(new osg::Image);
    });
    try {
        const std::string text = plainText(readFile(file, largestModel_B), file.string());
        std::vector<std::string> unused;
        for (auto at = text.find(libraryWord); at != text.npos;
             at = text.find(libraryWord, at + 1)) {
            // Words that stand elsewhere in a line are passed over.
            const auto line = std::string_view(text).substr(0, at);
            const auto before = line.find_last_not_of(" \t\r\v\f");
            if (before != line.npos && line[before] != '\n')
                continue;
            TextWords words(std::string_view(text).substr(at), file.string());
            if (words.next() && words.words()[0] == libraryWord)
                materials.read(words.rest(), unused);
        }
    } catch (const InputError&) {
    }
    files.libraries = materials.libraries();
    return files;
}

LoadedGraph readObj(const std::filesystem::path& file, const PictureReading& picture) {
    const std::string text = plainText(readFile(file, largestModel_B), file.string());
    if (const auto at = text.find('\0'); at != text.npos)
        throw InputError({file.string(), "byte " + std::to_string(at), "a zero byte",
                          "a Wavefront object, which is a text"});
    return ObjText(text, file, picture).read();
}

} // namespace irsg
