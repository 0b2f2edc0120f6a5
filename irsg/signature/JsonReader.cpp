#include "irsg/signature/JsonReader.h"

#include <utility>

namespace irsg {

using nlohmann::json;

void JsonProblems::add(const std::string& path, const json& value, std::string expected) {
    addText(path, shownJson(value), std::move(expected));
}

void JsonProblems::addText(const std::string& path, std::string value, std::string expected) {
    diagnostics_.push_back(
        {fileName_, places_.position(path), std::move(value), std::move(expected)});
}

void JsonProblems::add(const std::string& path, const InputError& error) {
    for (const Diagnostic& diagnostic : error.diagnostics()) {
        const std::string within = diagnostic.position.empty() ? "" : ", " + diagnostic.position;
        addText(path + within, diagnostic.value, diagnostic.expected);
    }
}

void JsonProblems::throwIfAny() const {
    if (!diagnostics_.empty())
        throw InputError(diagnostics_);
}

JsonObject::JsonObject(const json& value, std::string path, JsonProblems& problems)
    : path_(std::move(path)), problems_(&problems) {
    if (value.is_object())
        object_ = &value;
    else
        problems.add(path_, value, "an object {...}");
}

std::string JsonObject::pathOf(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
}

const json* JsonObject::find(const std::string& key, bool required) {
    known_.insert(key);
    if (object_ == nullptr)
        return nullptr;
    const auto found = object_->find(key);
    if (found == object_->end()) {
        if (required)
            problems_->addText(pathOf(key), "nothing", "a value: this key is required");
        return nullptr;
    }
    return &*found;
}

std::string JsonObject::text(const std::string& key, bool required) {
    const json* const value = find(key, required);
    if (value != nullptr && !value->is_string()) {
        problems_->add(pathOf(key), *value, "text in quotes");
        return "";
    }
    return value == nullptr ? "" : value->get<std::string>();
}

double JsonObject::number(const std::string& key, double otherwise, bool required) {
    const json* const value = find(key, required);
    if (value != nullptr && !value->is_number()) {
        problems_->add(pathOf(key), *value, "a number");
        return otherwise;
    }
    return value == nullptr ? otherwise : value->get<double>();
}

bool JsonObject::flag(const std::string& key, bool otherwise) {
    const json* const value = find(key);
    if (value != nullptr && !value->is_boolean()) {
        problems_->add(pathOf(key), *value, "true or false");
        return otherwise;
    }
    return value == nullptr ? otherwise : value->get<bool>();
}

std::optional<std::vector<std::vector<double>>> JsonObject::columns(const std::string& key,
                                                                    std::size_t columns) {
    const json* const rows = find(key, true);
    if (rows == nullptr)
        return std::nullopt;
    const std::string expected = "rows of " + std::to_string(columns) + " numbers";
    if (!rows->is_array()) {
        problems_->add(pathOf(key), *rows, expected);
        return std::nullopt;
    }

    std::vector<std::vector<double>> result(columns);
    bool good = true;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const json& row = (*rows)[i];
        bool fits = row.is_array() && row.size() == columns;
        for (std::size_t j = 0; fits && j < columns; ++j) {
            fits = row[j].is_number();
            if (fits)
                result[j].push_back(row[j].get<double>());
        }
        if (!fits) {
            problems_->add(pathOf(key) + "[" + std::to_string(i) + "]", row, expected);
            good = false;
        }
    }
    return good ? std::optional(std::move(result)) : std::nullopt;
}

LookupTable JsonObject::table(const std::string& key) {
    const json* const value = find(key);
    if (value == nullptr)
        return {};
    JsonObject object(*value, pathOf(key), *problems_);
    const bool loop = object.flag("loop", false);
    const auto nodes = object.columns("nodes", 2);
    object.finish();
    if (!nodes)
        return {};
    try {
        return {(*nodes)[0], (*nodes)[1], loop};
    } catch (const InputError& error) {
        problems_->add(object.pathOf("nodes"), error);
        return {};
    }
}

Spectrum JsonObject::spectrum(const std::string& key, double otherwise, bool required) {
    const json* const value = find(key, required);
    if (value == nullptr)
        return Spectrum::constant(otherwise);
    if (value->is_number())
        return Spectrum::constant(value->get<double>());
    if (!value->is_array()) {
        problems_->add(pathOf(key), *value, "a number, or rows of wavelength in um and value");
        return Spectrum::constant(otherwise);
    }
    const auto nodes = columns(key, 2);
    if (!nodes)
        return Spectrum::constant(otherwise);
    try {
        return {(*nodes)[0], (*nodes)[1]};
    } catch (const InputError& error) {
        problems_->add(pathOf(key), error);
        return Spectrum::constant(otherwise);
    }
}

void JsonObject::finish() {
    if (object_ == nullptr)
        return;
    std::string keys;
    for (const std::string& key : known_)
        keys += (keys.empty() ? "" : ", ") + key;
    for (const auto& item : object_->items())
        if (!known_.contains(item.key()))
            problems_->addText(pathOf(item.key()), "an unknown key", "one of " + keys);
}

} // namespace irsg
