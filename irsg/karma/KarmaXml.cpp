#include "irsg/karma/KarmaXml.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/karma/KarmaXmlReader.h"

namespace irsg {

namespace {

constexpr std::uint64_t mostBytes = 16u << 20;

/// The child of that name, made where it is missing: before the documentation, which is last.
pugi::xml_node childOf(pugi::xml_node parent, const char* name) {
    if (pugi::xml_node child = parent.child(name))
        return child;
    const pugi::xml_node documentation = parent.child("documentation");
    return documentation ? parent.insert_child_before(name, documentation)
                         : parent.append_child(name);
}

void setText(pugi::xml_node element, const std::string& text) {
    if (karma::trimmedText(element) != text)
        element.text().set(text.c_str());
}

void setDocumentation(pugi::xml_node element, const std::string& documentation) {
    if (!documentation.empty() && documentation != element.child_value("documentation"))
        childOf(element, "documentation").text().set(documentation.c_str());
}

void setNumbers(pugi::xml_node value, const KarmaParameter& parameter) {
    if (parameter.kind == KarmaKind::number) {
        value.text().set(numberText(parameter.numbers.front()).c_str());
        return;
    }
    value.remove_children();
    for (const double number : parameter.numbers)
        value.append_child("double").text().set(numberText(number).c_str());
}

void check(const KarmaParameter& parameter) {
    const bool isText =
        parameter.kind == KarmaKind::entityType || parameter.kind == KarmaKind::string;
    const std::size_t count = parameter.numbers.size();
    if (parameter.name.empty() || (parameter.kind == KarmaKind::number && count != 1) ||
        (parameter.kind == KarmaKind::vector3 && count != 3) || (isText && count != 0) ||
        !std::ranges::all_of(parameter.numbers, [](double x) { return std::isfinite(x); }))
        throw LogicError("the parameter '" + parameter.name + "' cannot be a " +
                         name(parameter.kind));
}

std::string place(int line, const std::string& what) {
    return (line > 0 ? "line " + std::to_string(line) + ", " : "") + what;
}

} // namespace

const char* name(KarmaKind kind) {
    switch (kind) {
    case KarmaKind::number:
        return "double";
    case KarmaKind::vector:
        return "vector";
    case KarmaKind::vector3:
        return "vector3";
    case KarmaKind::entityType:
        return "entityType";
    case KarmaKind::string:
        return "string";
    }
    throw LogicError("unknown kind of KARMA parameter");
}

bool KarmaParameter::operator==(const KarmaParameter& other) const {
    return name == other.name && kind == other.kind && numbers == other.numbers &&
           text == other.text && documentation == other.documentation;
}

bool KarmaComposite::operator==(const KarmaComposite& other) const {
    return name == other.name && component == other.component && parameters == other.parameters &&
           composition == other.composition && priority == other.priority &&
           documentation == other.documentation;
}

KarmaXml::KarmaXml() : document_(std::make_unique<pugi::xml_document>()) {}

KarmaXml::KarmaXml(const std::string& type, const std::string& documentation) : KarmaXml() {
    pugi::xml_node declaration = document_->append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    declaration.append_attribute("standalone") = "no";
    pugi::xml_node data = document_->append_child("data");
    data.append_child("fileType").text().set("Parameters");
    data.append_child("type").text().set(type.c_str());
    pugi::xml_node table = data.append_child("Object_Model_Identification_Table");
    for (const char* field : {"Name", "Version", "Date", "Purpose", "Application_Domain", "Sponsor",
                              "POC", "POC_Organization", "POC_Telephone", "POC_Email"})
        table.append_child(field);
    data.append_child("documentation").text().set(documentation.c_str());
}

KarmaXml::KarmaXml(const KarmaXml& other) : KarmaXml() {
    *this = other;
}

KarmaXml& KarmaXml::operator=(const KarmaXml& other) {
    if (this == &other)
        return *this;
    if (!document_)
        document_ = std::make_unique<pugi::xml_document>();
    document_->reset(*other.document_);
    file_ = other.file_;
    parameters_ = other.parameters_;
    composites_ = other.composites_;
    return *this;
}

KarmaXml::KarmaXml(KarmaXml&&) noexcept = default;
KarmaXml& KarmaXml::operator=(KarmaXml&&) noexcept = default;
KarmaXml::~KarmaXml() = default;

KarmaXml KarmaXml::read(const std::filesystem::path& file) {
    return parse(readFile(file, mostBytes), file.string());
}

KarmaXml KarmaXml::parse(std::string text, std::string file) {
    KarmaXml result;
    result.file_ = std::move(file);
    karma::Contents contents = karma::load(std::move(text), result.file_, *result.document_);
    result.parameters_ = std::move(contents.parameters);
    result.composites_ = std::move(contents.composites);
    return result;
}

std::string KarmaXml::type() const {
    return karma::trimmedText(document_->document_element().child("type"));
}

std::string KarmaXml::typeName() const {
    const std::string all = type();
    return all.substr(all.rfind('/') + 1);
}

std::string KarmaXml::documentation() const {
    return document_->document_element().child_value("documentation");
}

const KarmaParameter* KarmaXml::find(std::string_view name) const {
    const auto found = std::ranges::find(parameters_, name, &KarmaParameter::name);
    return found == parameters_.end() ? nullptr : &*found;
}

void KarmaXml::set(const KarmaParameter& parameter) {
    check(parameter);
    pugi::xml_node data = document_->document_element();
    pugi::xml_node element =
        data.find_child_by_attribute("parameter", "name", parameter.name.c_str());
    const auto known = std::ranges::find(parameters_, parameter.name, &KarmaParameter::name);
    const bool isNew = known == parameters_.end();
    if (isNew) {
        const pugi::xml_node composition = data.child("composition");
        element = composition ? data.insert_child_before("parameter", composition)
                              : data.append_child("parameter");
        element.append_attribute("name") = parameter.name.c_str();
    } else if (known->kind != parameter.kind) {
        element.remove_child(name(known->kind));
    }

    // A value that is the same keeps the digits in which it was written.
    pugi::xml_node value = childOf(element, name(parameter.kind));
    if (isNew || known->kind != parameter.kind || known->numbers != parameter.numbers ||
        known->text != parameter.text) {
        if (parameter.kind == KarmaKind::entityType || parameter.kind == KarmaKind::string)
            setText(value, parameter.text);
        else
            setNumbers(value, parameter);
    }
    setDocumentation(element, parameter.documentation);

    KarmaParameter& kept = isNew ? parameters_.emplace_back() : *known;
    const int line = kept.line;
    std::string documentation =
        parameter.documentation.empty() ? kept.documentation : parameter.documentation;
    kept = parameter;
    kept.line = line;
    kept.documentation = std::move(documentation);
}

void KarmaXml::remove(std::string_view name) {
    pugi::xml_node data = document_->document_element();
    data.remove_child(data.find_child_by_attribute("parameter", "name", std::string(name).c_str()));
    std::erase_if(parameters_, [&](const KarmaParameter& one) { return one.name == name; });
}

void KarmaXml::setComposites(const std::vector<KarmaComposite>& composites) {
    pugi::xml_node data = document_->document_element();
    pugi::xml_node composition = data.child("composition");
    if (!composition)
        composition = data.append_child("composition");
    for (const KarmaComposite& old : composites_)
        if (std::ranges::find(composites, old.name, &KarmaComposite::name) == composites.end())
            composition.remove_child(
                composition.find_child_by_attribute("composite", "name", old.name.c_str()));

    for (const KarmaComposite& one : composites) {
        pugi::xml_node element =
            composition.find_child_by_attribute("composite", "name", one.name.c_str());
        if (element)
            element = composition.append_move(element);
        else
            (element = composition.append_child("composite")).append_attribute("name") =
                one.name.c_str();
        setText(childOf(element, "component"), one.component);
        setText(childOf(element, "parameters"), one.parameters);
        setText(childOf(element, "composition"), one.composition);
        setText(childOf(element, "priority"), std::to_string(one.priority));
        setDocumentation(element, one.documentation);
    }
    composites_ = composites;
}

std::string KarmaXml::text() const {
    std::ostringstream stream;
    document_->save(stream, "  ", pugi::format_indent, pugi::encoding_utf8);
    return std::move(stream).str();
}

void KarmaXml::write(const std::filesystem::path& file) const {
    writeFileDurably(file, text());
}

Diagnostic KarmaXml::diagnostic(const KarmaParameter& parameter, std::string value,
                                std::string expected) const {
    return {file_, place(parameter.line, "parameter " + parameter.name), std::move(value),
            std::move(expected)};
}

Diagnostic KarmaXml::diagnostic(const KarmaComposite& composite, std::string value,
                                std::string expected) const {
    return {file_, place(composite.line, "composite " + composite.name), std::move(value),
            std::move(expected)};
}

Diagnostic KarmaXml::diagnostic(std::string position, std::string value,
                                std::string expected) const {
    return {file_, std::move(position), std::move(value), std::move(expected)};
}

bool isXml(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure))
        return false;
    std::istringstream stream(readFileBeginning(file, std::size_t{64} << 10));
    for (const char expected : std::string_view("\xEF\xBB\xBF"))
        if (stream.peek() == static_cast<unsigned char>(expected))
            stream.get();
    char first = '\0';
    return (stream >> first) && first == '<';
}

} // namespace irsg
