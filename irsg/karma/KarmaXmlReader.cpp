#include "irsg/karma/KarmaXmlReader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "irsg/core/Wording.h"

namespace irsg::karma {

namespace {

std::string trimmed(std::string text) {
    constexpr const char* blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string::npos
               ? std::string()
               : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string shown(const std::string& text) {
    if (text.empty())
        return "nothing";
    return text.size() <= 60 ? "'" + text + "'" : "'" + text.substr(0, 57) + "...'";
}

/// The encoding that the declaration names, in lower case; "utf-8" where it names none.
std::string encodingOf(const std::string& text) {
    const std::string declaration = lowerCase(text.substr(0, text.find("?>")).substr(0, 200));
    const auto at = declaration.find("encoding=");
    if (!declaration.starts_with("<?xml") || at == std::string::npos ||
        at + 10 > declaration.size())
        return "utf-8";
    const char quote = declaration[at + 9];
    return declaration.substr(at + 10, declaration.find(quote, at + 10) - at - 10);
}

/// ISO-8859-1 to UTF-8. Line ends stay where they are, so lines can still be counted.
std::string utf8FromLatin1(const std::string& text) {
    std::string utf8;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            utf8 += c;
        } else {
            utf8 += static_cast<char>(0xC0 | (code >> 6));
            utf8 += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return utf8;
}

class Reader {
  public:
    Reader(std::string text, std::string file, pugi::xml_document& document)
        : text_(std::move(text)), file_(std::move(file)), document_(document) {}

    Contents read() {
        parse();
        const pugi::xml_node data = document_.document_element();
        readHead(data);
        for (const pugi::xml_node element : data.children("parameter"))
            readParameter(element);
        readComposition(data);
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
        return std::move(contents_);
    }

  private:
    int lineAt(std::ptrdiff_t offset) const {
        return 1 +
               static_cast<int>(std::ranges::lower_bound(lineEnds_, offset) - lineEnds_.begin());
    }
    int lineOf(const pugi::xml_node& node) const { return lineAt(node.offset_debug()); }

    void refuse(const std::string& position, std::string value, std::string expected) {
        diagnostics_.push_back({file_, position, std::move(value), std::move(expected)});
    }
    void refuse(const pugi::xml_node& node, const std::string& whose, std::string value,
                std::string expected) {
        refuse("line " + std::to_string(lineOf(node)) + (whose.empty() ? "" : ", ") + whose,
               std::move(value), std::move(expected));
    }
    [[noreturn]] void give(const std::string& position, std::string value, std::string expected) {
        refuse(position, std::move(value), std::move(expected));
        throw InputError(std::move(diagnostics_));
    }

    /// Only what is well-formed has lines and elements to speak of: diagnostics end the reading
    /// here.
    void parse() {
        if (text_.find('\0') != std::string::npos || text_.starts_with("\xFF\xFE") ||
            text_.starts_with("\xFE\xFF"))
            give("", "bytes that are not UTF-8 text", "an XML file in UTF-8");
        const std::string encoding = encodingOf(text_);
        if (encoding == "iso-8859-1")
            text_ = utf8FromLatin1(text_);
        else if (encoding != "utf-8" && encoding != "us-ascii")
            give("line 1", "encoding '" + encoding + "'", "UTF-8 or ISO-8859-1");

        for (auto at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
            lineEnds_.push_back(static_cast<std::ptrdiff_t>(at));

        const pugi::xml_parse_result result = document_.load_buffer(
            text_.data(), text_.size(), pugi::parse_full | pugi::parse_ws_pcdata_single,
            pugi::encoding_utf8);
        if (!result)
            give("line " + std::to_string(lineAt(result.offset)), result.description(),
                 "well-formed XML");
        const pugi::xml_node root = document_.document_element();
        if (std::string_view(root.name()) != "data")
            give("line " + std::to_string(lineOf(root)),
                 "root element '" + std::string(root.name()) + "'",
                 "a KARMA parameter file with the root 'data'");
        for (pugi::xml_node next = root.next_sibling(); next; next = next.next_sibling())
            if (next.type() == pugi::node_element)
                give("line " + std::to_string(lineOf(next)), "a second root element",
                     "one root element 'data'");
        // The document is written in UTF-8, whatever it came in.
        if (pugi::xml_node declaration = document_.first_child();
            declaration.type() == pugi::node_declaration && encoding == "iso-8859-1")
            declaration.attribute("encoding").set_value("UTF-8");
    }

    void readHead(const pugi::xml_node& data) {
        const pugi::xml_node fileType = data.child("fileType");
        if (!fileType)
            refuse("", "no fileType", "<fileType>Parameters</fileType>");
        else if (trimmedText(fileType) != "Parameters")
            refuse(fileType, "fileType", shown(trimmedText(fileType)), "Parameters");
        if (data.child("type") && trimmedText(data.child("type")).empty())
            refuse(data.child("type"), "type", "nothing", "a type such as /Environment");
        for (const char* once : {"fileType", "type", "composition"})
            if (const pugi::xml_node again = data.child(once).next_sibling(once))
                refuse(again, once, "a second one", "this element once");
    }

    /// The name of a parameter or composite, which no other of its kind has.
    std::optional<std::string> nameOf(const pugi::xml_node& element,
                                      std::map<std::string, int>& names) {
        const std::string what = element.name();
        const std::string name = element.attribute("name").value();
        if (trimmed(name).empty()) {
            refuse(element, what, "no name", "the attribute name=\"...\"");
            return std::nullopt;
        }
        const auto [known, isNew] = names.emplace(name, lineOf(element));
        if (!isNew) {
            refuse(element, what + " " + name, "the same name again",
                   "each " + what + " once, not again after line " + std::to_string(known->second));
            return std::nullopt;
        }
        return name;
    }

    void readParameter(const pugi::xml_node& element) {
        const auto name = nameOf(element, parameterNames_);
        if (!name)
            return;
        const std::string whose = "parameter " + *name;
        KarmaParameter parameter{.name = *name,
                                 .kind = {},
                                 .numbers = {},
                                 .text = {},
                                 .documentation = element.child("documentation").child_value(),
                                 .line = lineOf(element)};
        constexpr const char* kinds = "one value: double, vector, vector3, entityType or string";
        int values = 0;
        for (const pugi::xml_node child : element.children()) {
            const std::string tag = child.name();
            if (child.type() != pugi::node_element || tag == "documentation")
                continue;
            if (!readValue(child, whose, parameter)) {
                refuse(child, whose, "element '" + tag + "'", kinds);
                return;
            }
            ++values;
        }
        if (values != 1)
            refuse(element, whose, values == 0 ? "no value" : std::to_string(values) + " values",
                   kinds);
        contents_.parameters.push_back(std::move(parameter));
    }

    /// False for an element that holds no value of a kind that is known.
    bool readValue(const pugi::xml_node& value, const std::string& whose,
                   KarmaParameter& parameter) {
        for (const KarmaKind kind : {KarmaKind::number, KarmaKind::vector, KarmaKind::vector3,
                                     KarmaKind::entityType, KarmaKind::string}) {
            if (std::string_view(value.name()) != irsg::name(kind))
                continue;
            parameter.kind = kind;
            if (kind == KarmaKind::number)
                readNumber(value, whose, parameter);
            else if (kind == KarmaKind::vector || kind == KarmaKind::vector3)
                readNumbers(value, whose, parameter);
            else
                parameter.text = trimmedText(value);
            return true;
        }
        return false;
    }

    void readNumbers(const pugi::xml_node& vector, const std::string& whose,
                     KarmaParameter& parameter) {
        int count = 0;
        for (const pugi::xml_node child : vector.children()) {
            if (child.type() == pugi::node_element && std::string_view(child.name()) == "double") {
                readNumber(child, whose, parameter);
                ++count;
            } else if (child.type() == pugi::node_element || !trimmed(child.value()).empty()) {
                const bool isText = child.type() != pugi::node_element;
                if (child.type() != pugi::node_comment)
                    refuse(child, whose,
                           isText ? shown(trimmed(child.value()))
                                  : "element '" + std::string(child.name()) + "'",
                           "elements <double> inside a " + std::string(vector.name()));
            }
        }
        if (parameter.kind == KarmaKind::vector3 && count != 3)
            refuse(vector, whose, std::to_string(count) + " numbers", "the three of a vector3");
    }

    void readNumber(const pugi::xml_node& element, const std::string& whose,
                    KarmaParameter& parameter) {
        const std::string text = trimmedText(element);
        double value = 0.0;
        const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
        const char* const end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(begin, end, value);
        if (error != std::errc() || rest != end || !std::isfinite(value))
            refuse(element, whose, shown(text), "a finite number");
        parameter.numbers.push_back(value);
    }

    void readComposition(const pugi::xml_node& data) {
        for (const pugi::xml_node element : data.child("composition").children()) {
            if (element.type() != pugi::node_element)
                continue;
            if (std::string_view(element.name()) != "composite") {
                refuse(element, "composition", "element '" + std::string(element.name()) + "'",
                       "elements <composite>");
                continue;
            }
            if (const auto name = nameOf(element, compositeNames_))
                readComposite(element, *name);
        }
    }

    void readComposite(const pugi::xml_node& element, const std::string& name) {
        const std::string whose = "composite " + name;
        KarmaComposite composite{.name = name,
                                 .component = trimmedText(element.child("component")),
                                 .parameters = trimmedText(element.child("parameters")),
                                 .composition = trimmedText(element.child("composition")),
                                 .priority = 0,
                                 .documentation = element.child("documentation").child_value(),
                                 .line = lineOf(element)};
        if (composite.component.empty())
            refuse(element, whose, "no component", "the name of a component");
        if (composite.parameters.empty())
            refuse(element, whose, "no parameters", "the path of a parameter file");
        if (composite.composition.empty())
            composite.composition = "none";
        if (const pugi::xml_node priority = element.child("priority")) {
            const std::string text = trimmedText(priority);
            const char* const end = text.data() + text.size();
            const auto [rest, error] = std::from_chars(text.data(), end, composite.priority);
            if (error != std::errc() || rest != end)
                refuse(priority, whose + ", priority", shown(text),
                       "an integer; the lowest is asked first");
        }
        contents_.composites.push_back(std::move(composite));
    }

    std::string text_;
    std::string file_;
    std::vector<std::ptrdiff_t> lineEnds_;
    pugi::xml_document& document_;
    Contents contents_;
    std::vector<Diagnostic> diagnostics_;
    std::map<std::string, int> parameterNames_;
    std::map<std::string, int> compositeNames_;
};

} // namespace

Contents load(std::string text, const std::string& file, pugi::xml_document& document) {
    return Reader(std::move(text), file, document).read();
}

std::string trimmedText(const pugi::xml_node& element) {
    return trimmed(element.child_value());
}

} // namespace irsg::karma
