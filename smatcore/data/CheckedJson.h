#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace smat {

/// A value of a JSON file that a program wrote, with its place in it. What is asked of it is given
/// where it is of that kind and refused where it is not: InputError with file, key path and line,
/// the value and what was expected. (Readers of files that people write collect what is wrong, by
/// JsonFields.)
class CheckedJson {
  public:
    /// The whole of a text, an object; `kind` says what the file should be: "a result table
    /// (JSON)".
    CheckedJson(const std::string& text, const std::string& file, const std::string& kind);

    bool has(const char* key) const;
    /// The member of an object; one that is missing is refused when it is asked for its value.
    CheckedJson at(const char* key) const;
    /// The members of a list.
    std::vector<CheckedJson> list() const;
    std::string text() const;
    /// A text that is one of some words: its place among them.
    std::size_t word(const std::vector<std::string>& words) const;
    bool boolean() const;
    double number() const;
    /// A whole number.
    std::size_t count(std::size_t most) const;
    int index() const;
    std::vector<double> numbers() const;
    std::vector<std::string> texts() const;
    /// NaN for null, since JSON has no other word for it.
    double numberOrNull() const;
    std::vector<double> numbersOrNull() const;

    /// Calls what checks values by themselves; what it refuses is said of this place.
    void check(const std::function<void()>& checking) const;
    [[noreturn]] void refuse(const std::string& expected) const;
    [[noreturn]] void refuse(const std::string& value, const std::string& expected) const;

  private:
    struct Document;
    CheckedJson(std::shared_ptr<const Document> document, const nlohmann::json* value,
                std::string path);
    CheckedJson child(const nlohmann::json* value, const std::string& key) const;
    const nlohmann::json& array(const char* expected) const;
    bool isNumber() const;

    std::shared_ptr<const Document> document_;
    const nlohmann::json* value_; ///< null where there is none
    std::string path_;
};

} // namespace smat
