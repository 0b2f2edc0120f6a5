#include "irsg/geometry/reading/text/PlyHead.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/text/TextWords.h"

namespace irsg {

namespace {

using Type = PlyHead::Type;

constexpr std::pair<std::string_view, Type> types[] = {
    {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
    {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
    {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
    {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
    {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
    {"float64", Type::float64}};

class HeadReader {
  public:
    HeadReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {
        if (bytes_.starts_with("\xEF\xBB\xBF"))
            at_ = 3;
    }

    PlyHead read() {
        if (!next() || words_.size() != 1 || words_[0] != "ply")
            refuse(words_.empty() ? "nothing" : quoted(words_[0]), "ply");
        bool hasForm = false;
        for (;;) {
            if (!next())
                refuse("the end of the file in its head", "end_header");
            if (words_.empty())
                continue;
            if (words_[0] == "end_header")
                break;
            if (words_[0] == "comment" || words_[0] == "obj_info") {
                head_.comments.emplace_back(line_.substr(words_[0].size()));
            } else if (words_[0] == "format") {
                hasForm = true;
                head_.form = formOf();
            } else if (words_[0] == "element") {
                addElement();
            } else if (words_[0] == "property") {
                addProperty();
            } else {
                refuse(quoted(words_[0]),
                       "format, comment, obj_info, element, property or end_header");
            }
        }
        if (!hasForm)
            refuse("a head without a format", "format ascii, binary_little_endian or "
                                              "binary_big_endian");
        head_.size_B = at_;
        return std::move(head_);
    }

  private:
    [[noreturn]] void refuse(std::string value, std::string expected) const {
        throw InputError({file_, "line " + std::to_string(std::max<std::size_t>(1, head_.lines)),
                          std::move(value), std::move(expected)});
    }

    /// The next line and its words; false at the end of the file.
    bool next() {
        words_.clear();
        if (at_ >= bytes_.size())
            return false;
        const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
        line_ = bytes_.substr(at_, end - at_);
        at_ = end + (bytes_.substr(std::min(end, bytes_.size())).starts_with("\r\n") ? 2 : 1);
        at_ = std::min(at_, bytes_.size());
        ++head_.lines;
        constexpr std::string_view blanks = " \t";
        for (std::size_t begin = line_.find_first_not_of(blanks); begin != line_.npos;) {
            const std::size_t stop = std::min(line_.find_first_of(blanks, begin), line_.size());
            words_.push_back(line_.substr(begin, stop - begin));
            begin = line_.find_first_not_of(blanks, stop);
        }
        return true;
    }

    PlyHead::Form formOf() const {
        if (words_.size() >= 3 && words_[2] == "1.0") {
            if (words_[1] == "ascii")
                return PlyHead::Form::text;
            if (words_[1] == "binary_little_endian")
                return PlyHead::Form::littleEndian;
            if (words_[1] == "binary_big_endian")
                return PlyHead::Form::bigEndian;
        }
        refuse(quoted(line_), "format ascii, binary_little_endian or binary_big_endian, 1.0");
    }

    void addElement() {
        PlyHead::Element element;
        const std::string_view count = words_.size() == 3 ? words_[2] : "";
        const auto [stop, error] =
            std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (words_.size() != 3 || error != std::errc{} || stop != count.data() + count.size())
            refuse(quoted(line_), "element, a name and a number");
        element.name = words_[1];
        head_.elements.push_back(std::move(element));
    }

    Type typeOf(std::string_view word) const {
        const auto* type =
            std::ranges::find(types, word, &std::pair<std::string_view, Type>::first);
        if (type == std::end(types))
            refuse(quoted(word), "a type of number such as float or uchar");
        return type->second;
    }

    void addProperty() {
        const bool list = words_.size() == 5 && words_[1] == "list";
        if (head_.elements.empty() || (!list && words_.size() != 3))
            refuse(quoted(line_), "behind an element: property, a type and a name, or property "
                                  "list, two types and a name");
        PlyHead::Property property;
        property.isList = list;
        property.name = words_.back();
        property.type = typeOf(words_[words_.size() - 2]);
        if (list) {
            property.count = typeOf(words_[2]);
            if (property.count == Type::float32 || property.count == Type::float64)
                refuse(quoted(words_[2]), "a type of whole numbers for the length of a list");
        }
        head_.elements.back().properties.push_back(std::move(property));
    }

    std::string_view bytes_;
    const std::string& file_;
    PlyHead head_;
    std::size_t at_ = 0;
    std::string_view line_;
    std::vector<std::string_view> words_;
};

} // namespace

PlyHead readPlyHead(std::string_view bytes, const std::string& file) {
    return HeadReader(bytes, file).read();
}

std::size_t sizeOf(PlyHead::Type type) {
    switch (type) {
    case Type::int8:
    case Type::uint8:
        return 1;
    case Type::int16:
    case Type::uint16:
        return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
        return 4;
    case Type::float64:
        return 8;
    }
    return 8;
}

} // namespace irsg
