#include "irsg/signature/CanonicalJson.h"

#include <algorithm>
#include <vector>

#include "irsg/core/CsvTable.h"

namespace irsg {

namespace {

using nlohmann::json;

/// Whole numbers by value, before words; equal values by their text.
bool keyBefore(const std::string& a, const std::string& b) {
    const auto x = parseNumber(a);
    const auto y = parseNumber(b);
    if (x && y && *x != *y)
        return *x < *y;
    if (x.has_value() != y.has_value())
        return x.has_value();
    return a < b;
}

std::vector<std::string> sortedKeys(const json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items())
        keys.push_back(item.key());
    std::ranges::sort(keys, keyBefore);
    return keys;
}

std::string scalarText(const json& value) {
    if (value.is_number_float()) {
        // Adding 0 makes -0 the 0 that it equals.
        return numberText(value.get<double>() + 0.0);
    }
    // Of a draft, whose lint says what is wrong with it, a text may be no UTF-8.
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

class Writer {
  public:
    explicit Writer(bool pretty) : pretty_(pretty) {}

    std::string write(const json& value) {
        append(value, 0);
        return std::move(text_);
    }

  private:
    void newLine(int depth) {
        if (pretty_) {
            text_ += '\n';
            text_.append(static_cast<std::size_t>(depth) * 2, ' ');
        }
    }

    void append(const json& value, int depth) {
        if (value.is_object())
            appendObject(value, depth);
        else if (value.is_array())
            appendArray(value, depth);
        else
            text_ += scalarText(value);
    }

    void appendObject(const json& object, int depth) {
        text_ += '{';
        bool first = true;
        for (const std::string& key : sortedKeys(object)) {
            text_ += first ? "" : ",";
            first = false;
            newLine(depth + 1);
            text_ += scalarText(key) + (pretty_ ? ": " : ":");
            append(object.at(key), depth + 1);
        }
        if (!first)
            newLine(depth);
        text_ += '}';
    }

    void appendArray(const json& array, int depth) {
        const bool plain = std::ranges::none_of(
            array, [](const json& element) { return element.is_structured(); });
        text_ += '[';
        bool first = true;
        for (const json& element : array) {
            text_ += first ? "" : (plain && pretty_ ? ", " : ",");
            first = false;
            if (!plain)
                newLine(depth + 1);
            append(element, depth + 1);
        }
        if (!plain)
            newLine(depth);
        text_ += ']';
    }

    bool pretty_;
    std::string text_;
};

} // namespace

std::string compactJson(const json& value) {
    return Writer(false).write(value);
}

std::string prettyJson(const json& value) {
    return Writer(true).write(value);
}

} // namespace irsg
