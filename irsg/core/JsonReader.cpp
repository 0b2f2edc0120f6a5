#include "irsg/core/JsonReader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Diagnostics.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace irsg {

using Json = JsonReader::Json;

struct JsonReader::Document {
    Document(const std::string& text, const std::string& name, const JsonForm& form,
             JsonErrors policy)
        : file(name),
          root(parseJson(text, name, form)),
          places(text, form.mayComment),
          errors(policy),
          indexInBrackets(form.indexInBrackets) {}

    std::string file;
    Json root;
    JsonPlaces places;
    JsonErrors errors;
    bool indexInBrackets;
    std::vector<Diagnostic> diagnostics;
    std::vector<std::string> remarks;
    /// What was asked for of objects, there or not.
    std::unordered_map<const Json*, std::map<std::string, Known, std::less<>>> known;

    void add(std::vector<Diagnostic> refused) {
        if (errors == JsonErrors::throwFirst)
            throw InputError(std::move(refused));
        std::ranges::move(refused, std::back_inserter(diagnostics));
        keepFirstDiagnostics(diagnostics);
    }
};

std::string JsonRange::expected() const {
    if (std::isinf(least) && std::isinf(most))
        return "a number";
    if (std::isinf(most))
        return "a number of at least " + numberText(least);
    if (std::isinf(least))
        return "a number of at most " + numberText(most);
    return "a number from " + numberText(least) + " to " + numberText(most);
}

JsonReader::JsonReader(const std::string& text, const std::string& file, const JsonForm& form,
                       JsonErrors errors)
    : document_(std::make_shared<Document>(text, file, form, errors)), value_(&document_->root) {}

JsonReader::JsonReader(std::shared_ptr<Document> document, const Json* value, std::string path,
                       bool isSilent)
    : document_(std::move(document)), value_(value), path_(std::move(path)), isSilent_(isSilent) {}

const std::string& JsonReader::file() const {
    return document_->file;
}

const Json& JsonReader::json() const {
    static const Json none;
    return value_ ? *value_ : none;
}

std::string JsonReader::shown() const {
    return value_ ? shownJson(*value_) : "nothing";
}

void JsonReader::refuse(const std::string& found, const std::string& expected,
                        const std::string& where) const {
    if (!isSilent_)
        document_->add(
            {{document_->file, document_->places.position(path_ + where), found, expected}});
}

void JsonReader::refuseKind(const std::string& expected) const {
    refuse(expected);
    isSilent_ = true;
}

template <typename Is>
bool JsonReader::isKind(Is is, const std::string& expected) const {
    const bool isRight = value_ && (value_->*is)();
    if (!isRight)
        refuseKind(expected);
    return isRight;
}

bool JsonReader::check(const std::function<void()>& checking) const {
    try {
        checking();
        return true;
    } catch (const InputError& error) {
        if (isSilent_)
            return false;
        std::vector<Diagnostic> placed = error.diagnostics();
        for (Diagnostic& one : placed) {
            one.file = document_->file;
            const bool isMember = path_.empty() || has(one.position);
            const std::string path = isMember               ? joinedKeyPath(path_, one.position)
                                     : one.position.empty() ? path_
                                                            : path_ + ", " + one.position;
            one.position = document_->places.position(path);
        }
        document_->add(std::move(placed));
        return false;
    }
}

bool JsonReader::isObject(const std::string& expected) const {
    return isKind(&Json::is_object, expected);
}

bool JsonReader::has(const std::string& key) const {
    if (!value_ || !value_->is_object() || !value_->contains(key))
        return false;
    const auto object = document_->known.find(value_);
    if (object == document_->known.end())
        return true;
    const auto known = object->second.find(key);
    return known == object->second.end() || known->second != Known::refused;
}

JsonReader JsonReader::member(const std::string& key, Known known) const {
    std::string path = joinedKeyPath(path_, key);
    if (!isObject())
        return {document_, nullptr, std::move(path), true};
    const Known& is = document_->known[value_].emplace(key, known).first->second;
    const auto found = value_->find(key);
    const bool isThere = found != value_->end() && is != Known::refused;
    return {document_, isThere ? &*found : nullptr, std::move(path), false};
}

JsonReader JsonReader::at(const std::string& key) const {
    return member(key, Known::whole);
}

JsonReader JsonReader::section(const std::string& key) const {
    return member(key, Known::inParts);
}

void JsonReader::refuseMember(const std::string& key, const std::string& expected) const {
    if (!has(key))
        return;
    at(key).refuse(expected);
    document_->known[value_][key] = Known::refused;
}

std::vector<std::pair<std::string, JsonReader>>
JsonReader::members(const std::string& expected) const {
    std::vector<std::pair<std::string, JsonReader>> all;
    if (isObject(expected))
        for (const auto& [key, value] : value_->items())
            all.emplace_back(key, at(key));
    return all;
}

JsonReader JsonReader::item(std::size_t index) const {
    std::string number = std::to_string(index);
    return {document_, &(*value_)[index],
            document_->indexInBrackets ? path_ + "[" + number + "]" : joinedKeyPath(path_, number),
            false};
}

std::vector<JsonReader> JsonReader::list(const std::string& expected) const {
    std::vector<JsonReader> items;
    if (isKind(&Json::is_array, expected))
        for (std::size_t i = 0; i < value_->size(); ++i)
            items.push_back(item(i));
    return items;
}

std::vector<JsonReader> JsonReader::listOrNone(const std::string& expected) const {
    return exists() ? list(expected) : std::vector<JsonReader>();
}

std::string JsonReader::text() const {
    return isKind(&Json::is_string, "a text") ? value_->get<std::string>() : "";
}

std::string JsonReader::filledText(const std::string& what) const {
    std::string filled = textOr("");
    if (filled.empty()) {
        refuse("nothing", what);
        isSilent_ = true;
    }
    return filled;
}

std::size_t JsonReader::word(const std::vector<std::string>& words) const {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (value_ && *value_ == words[i])
            return i;
    refuseKind(alternatives(words));
    return 0;
}

bool JsonReader::boolean() const {
    return isKind(&Json::is_boolean, "true or false") && value_->get<bool>();
}

double JsonReader::number(const JsonRange& range) const {
    if (value_ && value_->is_number() && range.holds(value_->get<double>()))
        return value_->get<double>();
    refuseKind(range.expected());
    return 0.0;
}

double JsonReader::numberOrNull() const {
    if (value_ && value_->is_number())
        return value_->get<double>();
    if (!value_ || !value_->is_null())
        refuseKind("a number or null");
    return std::numeric_limits<double>::quiet_NaN();
}

std::size_t JsonReader::count(std::size_t most) const {
    if (value_ && value_->is_number_unsigned() && value_->get<std::size_t>() <= most)
        return value_->get<std::size_t>();
    refuseKind("a whole number from 0 to " + std::to_string(most));
    return 0;
}

int JsonReader::index(const std::string& expected) const {
    constexpr double most = std::numeric_limits<int>::max();
    if (value_ && value_->is_number_integer() && std::abs(value_->get<double>()) <= most)
        return value_->get<int>();
    refuseKind(expected);
    return 0;
}

std::vector<std::string> JsonReader::texts(const std::string& expected) const {
    std::vector<std::string> all;
    for (const JsonReader& one : list(expected))
        all.push_back(one.text());
    return all;
}

std::vector<double> JsonReader::numbers(const std::string& expected, const JsonRange& range) const {
    std::vector<double> all;
    if (!isKind(&Json::is_array, expected))
        return all;
    for (const Json& one : *value_) {
        const bool isRight = one.is_number() && range.holds(one.get<double>());
        if (!isRight)
            item(all.size()).refuse(range.expected());
        all.push_back(isRight ? one.get<double>() : std::numeric_limits<double>::quiet_NaN());
    }
    return all;
}

std::vector<double> JsonReader::numbersOrNull() const {
    std::vector<double> all;
    if (!isKind(&Json::is_array, "a list"))
        return all;
    for (const Json& one : *value_)
        all.push_back(one.is_number() ? one.get<double>() : item(all.size()).numberOrNull());
    return all;
}

std::optional<std::vector<double>> JsonReader::numbers(std::size_t count, double most,
                                                       const std::string& expected) const {
    const bool isRight = value_ && value_->is_array() && value_->size() == count &&
                         std::ranges::all_of(*value_, [&](const Json& one) {
                             return one.is_number() && std::abs(one.get<double>()) <= most;
                         });
    if (isRight)
        return value_->get<std::vector<double>>();
    refuseKind(expected);
    return std::nullopt;
}

std::optional<std::vector<std::vector<double>>> JsonReader::columns(std::size_t count) const {
    const std::string expected = "rows of " + std::to_string(count) + " numbers";
    if (!isKind(&Json::is_array, expected))
        return std::nullopt;
    std::vector<std::vector<double>> columns(count);
    bool isRight = true;
    for (std::size_t i = 0; i < value_->size(); ++i) {
        const Json& row = (*value_)[i];
        if (!row.is_array() || row.size() != count ||
            !std::ranges::all_of(row, [](const Json& one) { return one.is_number(); })) {
            item(i).refuse(expected);
            isRight = false;
            continue;
        }
        for (std::size_t k = 0; k < count; ++k)
            columns[k].push_back(row[k].get<double>());
    }
    return isRight ? std::optional(std::move(columns)) : std::nullopt;
}

void JsonReader::refuseUnknown(
    const std::function<std::string(const std::string& path)>& hint) const {
    if (!value_ || !value_->is_object())
        return;
    const auto& known = document_->known[value_];
    std::string keys;
    for (const auto& [key, how] : known)
        if (how != Known::refused)
            keys += (keys.empty() ? "" : ", ") + key;
    for (const auto& [key, value] : value_->items()) {
        const auto found = known.find(key);
        const JsonReader one(document_, &value, joinedKeyPath(path_, key), false);
        if (found == known.end())
            one.refuse("an unknown key with " + one.shown(),
                       (keys.empty() ? "none here" : "one of " + keys) +
                           (hint ? hint(one.path_) : ""));
        else if (found->second == Known::inParts)
            one.refuseUnknown(hint);
    }
}

Json JsonReader::unknown() const {
    Json rest = Json::object();
    if (!value_ || !value_->is_object())
        return rest;
    const auto& known = document_->known[value_];
    for (const auto& [key, value] : value_->items()) {
        const auto found = known.find(key);
        if (found == known.end())
            rest[key] = value;
        else if (found->second == Known::inParts)
            if (Json inside = JsonReader(document_, &value, "", false).unknown(); !inside.empty())
                rest[key] = std::move(inside);
    }
    return rest;
}

void JsonReader::remark(const std::string& sentence) const {
    appendUnique(document_->remarks, {sentence});
}

const std::vector<std::string>& JsonReader::remarks() const {
    return document_->remarks;
}

bool JsonReader::isAnyRefused() const {
    return !document_->diagnostics.empty();
}

void JsonReader::throwRefused() const {
    if (isAnyRefused())
        throw InputError(document_->diagnostics);
}

} // namespace irsg
