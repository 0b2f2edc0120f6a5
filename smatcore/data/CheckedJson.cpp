#include "smatcore/data/CheckedJson.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/JsonText.h"
#include "irsg/core/Wording.h"

namespace smat {

using Json = nlohmann::json;

struct CheckedJson::Document {
    Document(const std::string& text, const std::string& name, const std::string& kind)
        : file(name), root(irsg::parseJson(text, name, {.expected = kind})), places(text) {}

    std::string file;
    Json root;
    irsg::JsonPlaces places;
};

CheckedJson::CheckedJson(const std::string& text, const std::string& file, const std::string& kind)
    : document_(std::make_shared<const Document>(text, file, kind)), value_(&document_->root) {
    if (!value_->is_object())
        refuse("an object");
}

CheckedJson::CheckedJson(std::shared_ptr<const Document> document, const Json* value,
                         std::string path)
    : document_(std::move(document)), value_(value), path_(std::move(path)) {}

CheckedJson CheckedJson::child(const Json* value, const std::string& key) const {
    return {document_, value, irsg::joinedKeyPath(path_, key)};
}

void CheckedJson::refuse(const std::string& expected) const {
    refuse(value_ ? irsg::shownJson(*value_) : "nothing", expected);
}

void CheckedJson::refuse(const std::string& value, const std::string& expected) const {
    throw irsg::InputError({document_->file, document_->places.position(path_), value, expected});
}

void CheckedJson::check(const std::function<void()>& checking) const {
    try {
        checking();
    } catch (const irsg::InputError& error) {
        std::vector<irsg::Diagnostic> placed = error.diagnostics();
        for (irsg::Diagnostic& one : placed) {
            one.file = document_->file;
            one.position = document_->places.position(irsg::joinedKeyPath(path_, one.position));
        }
        throw irsg::InputError(std::move(placed));
    }
}

bool CheckedJson::has(const char* key) const {
    return value_ && value_->is_object() && value_->contains(key);
}

CheckedJson CheckedJson::at(const char* key) const {
    if (!value_ || !value_->is_object())
        refuse("an object");
    const auto found = value_->find(key);
    return child(found == value_->end() ? nullptr : &*found, key);
}

const Json& CheckedJson::array(const char* expected) const {
    if (!value_ || !value_->is_array())
        refuse(expected);
    return *value_;
}

std::vector<CheckedJson> CheckedJson::list() const {
    std::vector<CheckedJson> members;
    for (const Json& one : array("a list"))
        members.push_back(child(&one, std::to_string(members.size())));
    return members;
}

std::string CheckedJson::text() const {
    if (!value_ || !value_->is_string())
        refuse("a text");
    return value_->get<std::string>();
}

std::size_t CheckedJson::word(const std::vector<std::string>& words) const {
    const auto found = std::ranges::find(words, text());
    if (found == words.end())
        refuse(irsg::alternatives(words));
    return static_cast<std::size_t>(found - words.begin());
}

bool CheckedJson::boolean() const {
    if (!value_ || !value_->is_boolean())
        refuse("true or false");
    return value_->get<bool>();
}

bool CheckedJson::isNumber() const {
    return value_ && value_->is_number();
}

double CheckedJson::number() const {
    if (!isNumber())
        refuse("a number");
    return value_->get<double>();
}

std::size_t CheckedJson::count(std::size_t most) const {
    if (!value_ || !value_->is_number_unsigned() || value_->get<std::size_t>() > most)
        refuse(fmt::format("a whole number from 0 to {}", most));
    return value_->get<std::size_t>();
}

int CheckedJson::index() const {
    constexpr double most = std::numeric_limits<int>::max();
    if (!value_ || !value_->is_number_integer() || value_->get<double>() > most ||
        value_->get<double>() < -most) {
        refuse("a whole number");
    }
    return value_->get<int>();
}

std::vector<double> CheckedJson::numbers() const {
    std::vector<double> numbers;
    for (const Json& one : array("a list of numbers")) {
        if (!one.is_number())
            child(&one, std::to_string(numbers.size())).refuse("a number");
        numbers.push_back(one.get<double>());
    }
    return numbers;
}

std::vector<std::string> CheckedJson::texts() const {
    std::vector<std::string> texts;
    for (const CheckedJson& one : list())
        texts.push_back(one.text());
    return texts;
}

double CheckedJson::numberOrNull() const {
    if (value_ && value_->is_null())
        return std::numeric_limits<double>::quiet_NaN();
    if (!isNumber())
        refuse("a number or null");
    return value_->get<double>();
}

std::vector<double> CheckedJson::numbersOrNull() const {
    std::vector<double> numbers;
    for (const Json& one : array("a list")) {
        if (!one.is_number() && !one.is_null())
            child(&one, std::to_string(numbers.size())).refuse("a number or null");
        numbers.push_back(one.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                        : one.get<double>());
    }
    return numbers;
}

} // namespace smat
