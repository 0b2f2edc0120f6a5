#include "irsg/geometry/reading/text/PlyReader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include <osg/Geode>
#include <osg/MatrixTransform>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/FaceDrawable.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/PlyHead.h"
#include "irsg/geometry/reading/text/TextWords.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

namespace {

using Type = PlyHead::Type;

/// The numbers behind the head, one by one.
class Numbers {
  public:
    Numbers(std::string_view bytes, const PlyHead& head, const std::string& file)
        : bytes_(bytes), file_(file), form_(head.form), at_(head.size_B), line_(head.lines + 1) {}

    double next(Type type) { return form_ == PlyHead::Form::text ? word() : binary(type); }
    std::size_t left_B() const { return bytes_.size() - at_; }
    bool isText() const { return form_ == PlyHead::Form::text; }
    [[noreturn]] void refuse(std::string value, std::string expected) const {
        throw InputError(
            {file_, isText() ? "line " + std::to_string(line_) : "byte " + std::to_string(at_),
             std::move(value), std::move(expected)});
    }

  private:
    double word() {
        while (at_ < bytes_.size() && isBlank(bytes_[at_]))
            line_ += bytes_[at_++] == '\n';
        const std::size_t begin = at_;
        while (at_ < bytes_.size() && !isBlank(bytes_[at_]))
            ++at_;
        const std::string_view text = bytes_.substr(begin, at_ - begin);
        if (text.empty())
            refuse("the end of the file", "a number of an element that its head counts");
        double value = 0.0;
        const char* const first = text.data() + (text.front() == '+' ? 1 : 0);
        const auto [stop, error] = std::from_chars(first, text.data() + text.size(), value);
        if (error == std::errc{} && stop == text.data() + text.size())
            return value;
        const auto number = modelNumber(text);
        if (!number)
            refuse(quoted(text), "a number");
        return *number;
    }
    static bool isBlank(char c) {
        return c == ' ' || c == '\n' || c == '\t' || c == '\v' || c == '\f';
    }

    template <typename Number>
    double as(const std::array<char, 8>& bytes) const {
        Number value;
        std::memcpy(&value, bytes.data(), sizeof value);
        return static_cast<double>(value);
    }
    double binary(Type type) {
        const std::size_t size = sizeOf(type);
        if (left_B() < size)
            refuse("the end of the file", "a number of an element that its head counts");
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), bytes_.data() + at_, size);
        if ((form_ == PlyHead::Form::bigEndian) != (std::endian::native == std::endian::big))
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        at_ += size;
        switch (type) {
        case Type::int8:
            return as<std::int8_t>(bytes);
        case Type::uint8:
            return as<std::uint8_t>(bytes);
        case Type::int16:
            return as<std::int16_t>(bytes);
        case Type::uint16:
            return as<std::uint16_t>(bytes);
        case Type::int32:
            return as<std::int32_t>(bytes);
        case Type::uint32:
            return as<std::uint32_t>(bytes);
        case Type::float32:
            return as<float>(bytes);
        case Type::float64:
            return as<double>(bytes);
        }
        return 0.0;
    }

    std::string_view bytes_;
    const std::string& file_;
    PlyHead::Form form_;
    std::size_t at_, line_;
};

/// Names that writers give to what a vertex can have, in the order of VertexValue.
enum VertexValue { x, y, z, nx, ny, nz, red, green, blue, alpha, u, v, valueCount };
constexpr std::array<std::string_view, 4> valueNames[valueCount] = {
    {"x"},
    {"y"},
    {"z"},
    {"nx", "normal_x"},
    {"ny", "normal_y"},
    {"nz", "normal_z"},
    {"red", "diffuse_red", "r"},
    {"green", "diffuse_green", "g"},
    {"blue", "diffuse_blue", "b"},
    {"alpha", "diffuse_alpha", "a"},
    {"u", "s", "texture_u", "texture_s"},
    {"v", "t", "texture_v", "texture_t"}};

int valueOf(const std::string& name) {
    for (int i = 0; i < valueCount; ++i)
        if (std::ranges::find(valueNames[i], name) != std::end(valueNames[i]))
            return i;
    return -1;
}

class PlyFile {
  public:
    PlyFile(std::string_view bytes, const PlyHead& head, const std::string& file)
        : head_(head), file_(file), numbers_(bytes, head, file) {}

    LoadedGraph read() {
        if (std::ranges::none_of(head_.elements, [](const auto& e) { return e.name == "vertex"; }))
            throw InputError({file_, "line " + std::to_string(head_.lines),
                              "a head without vertices", "element vertex with x, y and z"});
        for (const PlyHead::Element& element : head_.elements)
            read(element);
        check();
        return finish();
    }

  private:
    void read(const PlyHead::Element& element) {
        // A count that no file of this size can hold: each number takes a byte or more.
        if (!element.properties.empty() &&
            element.count > numbers_.left_B() / element.properties.size())
            numbers_.refuse("the end of the file before " + std::to_string(element.count) +
                                " elements " + irsg::quoted(element.name),
                            "as many as its head counts");
        if (element.name == "vertex")
            readVertices(element);
        else if (element.name == "face" || element.name == "tristrips")
            readFaces(element);
        else
            skip(element);
    }

    void skip(const PlyHead::Element& element) {
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyHead::Property& property : element.properties)
                list(property);
        if (element.count > 0)
            remarks_.push_back(std::to_string(element.count) + " elements " +
                               irsg::quoted(element.name) + " are left out: they are no faces");
    }

    /// The numbers of a property, which is a list or one number.
    const std::vector<double>& list(const PlyHead::Property& property) {
        list_.clear();
        const double count = property.isList ? numbers_.next(property.count) : 1.0;
        if (!(count >= 0.0 && count == std::floor(count) &&
              count <= static_cast<double>(numbers_.left_B())))
            numbers_.refuse("a list of " + numberText(count) + " numbers",
                            "a whole number, and no more than the file has");
        while (static_cast<double>(list_.size()) < count)
            list_.push_back(numbers_.next(property.type));
        return list_;
    }

    void readVertices(const PlyHead::Element& element) {
        if (!shape_.vertices.empty())
            numbers_.refuse("a second list of vertices", "one");
        std::vector<int> values;
        std::array<bool, valueCount> has{};
        for (const PlyHead::Property& property : element.properties) {
            values.push_back(property.isList ? -1 : valueOf(property.name));
            if (values.back() >= 0)
                has[static_cast<std::size_t>(values.back())] = true;
            else
                leftOut("vertex", property.name);
        }
        if (!has[x] || !has[y] || !has[z])
            throw InputError({file_, "line " + std::to_string(head_.lines),
                              "vertices without x, y or z", "properties x, y and z"});
        const bool normals = has[nx] && has[ny] && has[nz], places = has[u] && has[v];
        const bool colours = has[red] && has[green] && has[blue];
        std::array<double, valueCount> value{};
        value[alpha] = 1.0;
        shape_.vertices.reserve(element.count);
        for (std::size_t i = 0; i < element.count; ++i) {
            for (std::size_t k = 0; k < values.size(); ++k) {
                const PlyHead::Property& property = element.properties[k];
                const auto& numbers = list(property);
                if (values[k] >= 0)
                    value[static_cast<std::size_t>(values[k])] =
                        numbers[0] * scaleOf(values[k], property.type);
            }
            for (const VertexValue axis : {x, y, z})
                if (!std::isfinite(value[axis]))
                    numbers_.refuse(numberText(value[axis]) + " as the position of vertex " +
                                        std::to_string(i),
                                    "a finite number");
            shape_.vertices.emplace_back(value[x], value[y], value[z]);
            if (normals)
                shape_.normals.emplace_back(value[nx], value[ny], value[nz]);
            if (places)
                shape_.places.emplace_back(value[u], value[v]);
            if (colours)
                shape_.colours.emplace_back(value[red], value[green], value[blue], value[alpha]);
        }
    }

    /// Colours in whole numbers are parts of the greatest one.
    static double scaleOf(int value, Type type) {
        if (value < red || value > alpha)
            return 1.0;
        return type == Type::uint8 ? 1.0 / 255.0 : type == Type::uint16 ? 1.0 / 65535.0 : 1.0;
    }

    void leftOut(const std::string& element, const std::string& property) {
        appendUnique(remarks_,
                     "property " + irsg::quoted(property) + " of each " + element + " is left out");
    }

    void readFaces(const PlyHead::Element& element) {
        const bool strips = element.name == "tristrips";
        const PlyHead::Property* indices = nullptr;
        for (const PlyHead::Property& property : element.properties)
            if (property.isList &&
                (property.name == "vertex_indices" || property.name == "vertex_index"))
                indices = &property;
        if (!indices && element.count > 0)
            throw InputError({file_, "line " + std::to_string(head_.lines), "faces without corners",
                              "property list ... vertex_indices"});
        for (const PlyHead::Property& property : element.properties)
            if (&property != indices)
                leftOut(element.name, property.name);
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyHead::Property& property : element.properties) {
                const auto& numbers = list(property);
                if (&property == indices)
                    strips ? addStrip(std::vector(numbers)) : addFace(numbers);
            }
    }

    /// Vertices may follow their faces.
    void addFace(const std::vector<double>& numbers) {
        if (numbers.size() < 3) {
            ++thin_;
            return;
        }
        for (const double number : numbers) {
            if (!(number >= 0.0 && number <= 2147483647.0 && number == std::floor(number)))
                numbers_.refuse("a face with vertex " + numberText(number),
                                "the number of a vertex, from 0");
            corners_.push_back(static_cast<int>(number));
        }
        lengths_.push_back(static_cast<unsigned int>(numbers.size()));
    }

    /// Triangles of three numbers that follow each other, every second one turned; -1 ends a strip.
    void addStrip(const std::vector<double>& numbers) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] == -1.0) {
                begin = i + 1;
            } else if (i >= begin + 2) {
                const bool turned = (i - begin) % 2 == 1;
                addFace({numbers[i - (turned ? 1 : 2)], numbers[i - (turned ? 2 : 1)], numbers[i]});
            }
        }
    }

    void check() const {
        for (const int corner : corners_)
            if (static_cast<std::size_t>(corner) >= shape_.vertices.size())
                throw InputError({file_, "", "a face with vertex " + std::to_string(corner),
                                  "numbers below that of the vertices, " +
                                      std::to_string(shape_.vertices.size())});
    }

    LoadedGraph finish() {
        FaceDrawable drawable(shape_);
        std::size_t at = 0;
        std::vector<FaceCorner> face;
        for (const unsigned int length : lengths_) {
            face.clear();
            for (unsigned int i = 0; i < length; ++i) {
                const int vertex = corners_[at++];
                face.push_back({vertex, shape_.places.empty() ? -1 : vertex,
                                shape_.normals.empty() ? -1 : vertex});
            }
            drawable.add(face);
        }
        corners_ = {};
        osg::BoundingBoxd bounds;
        for (const osg::Vec3d& vertex : shape_.vertices)
            bounds.expandBy(vertex);
        const auto far = farOriginOf(bounds);
        const osg::Vec3d origin = far.value_or(osg::Vec3d());
        osg::ref_ptr<osg::Group> root =
            far ? new osg::MatrixTransform(osg::Matrixd::translate(origin)) : new osg::Group;
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(drawable.make(origin));
        root->addChild(geode);

        LoadedGraph loaded;
        loaded.node = root;
        if (thin_ > 0)
            remarks_.push_back(std::to_string(thin_) +
                               " faces of fewer than three corners are left out");
        readComments(loaded.axes);
        loaded.remarks = std::move(remarks_);
        return loaded;
    }

    void readComments(FileAxes& axes) {
        for (const std::string& comment : head_.comments) {
            if (const auto unit = unitInWords(comment); unit && !axes.spokenUnit)
                axes.spokenUnit = unit;
            if (comment.find("TextureFile") != comment.npos)
                remarks_.push_back("a comment names a picture, which is left out:" + comment);
        }
    }

    const PlyHead& head_;
    const std::string& file_;
    Numbers numbers_;
    FaceShape shape_;
    std::vector<double> list_;
    std::vector<int> corners_;
    std::vector<unsigned int> lengths_; ///< of the faces in `corners_`
    std::vector<std::string> remarks_;
    long thin_ = 0;
};

} // namespace

LoadedGraph readPly(const std::filesystem::path& file) {
    std::string bytes = readFile(file, largestModel_B);
    const std::string name = file.string();
    if (hasMark(bytes))
        bytes = plainText(std::move(bytes), name);
    PlyHead head = readPlyHead(bytes, name);
    if (head.form == PlyHead::Form::text) {
        bytes = plainText(std::move(bytes), name);
        head = readPlyHead(bytes, name);
    }
    return PlyFile(bytes, head, name).read();
}

} // namespace irsg
