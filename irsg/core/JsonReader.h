#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "irsg/core/JsonText.h"

namespace irsg {

/// What a JsonReader does with a value that it refuses.
enum class JsonErrors {
    collect,   ///< notes it and gives a harmless value; for files that people write
    throwFirst ///< throws InputError; for files that programs write, where one fault says enough
};

/// Limits of a number; both may be infinite, the number itself never is.
struct JsonRange {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    bool holds(double number) const { return number >= least && number <= most; }
    /// "a number", "a number of at least 0", "a number from 0 to 1".
    std::string expected() const;
};

/// One value of a JSON text, which knows its key path and line. A value that is asked for is given
/// where it is of the kind and in the range that are asked for. Otherwise it is refused with file,
/// key path and line, what was found and what was expected. A value is refused for its kind once,
/// and nothing beneath it is refused again.
///
/// Members of an object are known once they were asked for; refuseUnknown() and unknown() tell of
/// the others. Copies share the text, its diagnostics and what is known, and cost little.
class JsonReader {
  public:
    using Json = nlohmann::json;

    /// The whole of a text. Throws InputError for a text that is not of that form.
    JsonReader(const std::string& text, const std::string& file, const JsonForm& form,
               JsonErrors errors);

    const std::string& file() const;
    /// False for a member that is missing.
    bool exists() const { return value_ != nullptr; }
    /// The value as it is; null where it is missing.
    const Json& json() const;
    std::string shown() const; ///< as a diagnostic shows it; "nothing" where it is missing

    /// True for an object; refuses any other value.
    bool isObject(const std::string& expected = "an object") const;
    /// Whether an object has a member, which does not make it known.
    bool has(const std::string& key) const;
    /// A member, which is known from now on. One that is missing is refused when its value is asked
    /// for.
    JsonReader at(const std::string& key) const;
    /// A member that counts as known only with what is known in it: a section of settings.
    JsonReader section(const std::string& key) const;
    /// Refuses a member, if there is one. It counts as missing from then on.
    void refuseMember(const std::string& key, const std::string& expected) const;
    /// All members of an object with their keys, which are known from now on.
    std::vector<std::pair<std::string, JsonReader>>
    members(const std::string& expected = "an object") const;
    std::vector<JsonReader> list(const std::string& expected = "a list") const;
    std::vector<JsonReader> listOrNone(const std::string& expected = "a list") const;

    std::string text() const;
    /// One that is empty or missing is refused as nothing; `what` says what it should be.
    std::string filledText(const std::string& what) const;
    /// A text that is one of some words: its place among them, 0 where it is refused.
    std::size_t word(const std::vector<std::string>& words) const;
    bool boolean() const;
    double number(const JsonRange& range = {}) const;
    /// NaN for null, since JSON has no other word for it.
    double numberOrNull() const;
    /// A whole number from 0 on.
    std::size_t count(std::size_t most) const;
    /// A whole number of 32 bits.
    int index(const std::string& expected = "a whole number") const;
    std::vector<std::string> texts(const std::string& expected = "a list") const;
    /// A list of numbers; each that is refused is named by its place and given as NaN.
    std::vector<double> numbers(const std::string& expected = "a list of numbers",
                                const JsonRange& range = {}) const;
    std::vector<double> numbersOrNull() const;
    /// So many numbers of at most that magnitude, refused as a whole.
    std::optional<std::vector<double>> numbers(std::size_t count, double most,
                                               const std::string& expected) const;
    /// Rows of so many numbers, turned into columns; no value where a row is refused.
    std::optional<std::vector<std::vector<double>>> columns(std::size_t count) const;

    /// The same, where a member that is missing is not refused.
    std::string textOr(std::string otherwise) const { return exists() ? text() : otherwise; }
    bool booleanOr(bool otherwise) const { return exists() ? boolean() : otherwise; }
    double numberOr(double otherwise, const JsonRange& range = {}) const {
        return exists() ? number(range) : otherwise;
    }
    std::optional<double> numberIfAny(const JsonRange& range = {}) const {
        return exists() ? std::optional(number(range)) : std::nullopt;
    }
    std::optional<int> indexIfAny(const std::string& expected) const {
        return exists() ? std::optional(index(expected)) : std::nullopt;
    }

    void refuse(const std::string& expected) const { refuse(shown(), expected); }
    /// `where` follows the key path: " at 4 um".
    void refuse(const std::string& found, const std::string& expected,
                const std::string& where = "") const;
    /// Calls what checks values by itself; what it refuses is said of this value, in this file.
    /// False where it refused something.
    bool check(const std::function<void()>& checking) const;

    /// Refuses the members of an object that are not known, and those of its sections. `hint` adds
    /// to what was expected, by the key path.
    void refuseUnknown(const std::function<std::string(const std::string& path)>& hint = {}) const;
    /// An object of the members that are not known, and of what is not known in sections.
    Json unknown() const;

    /// Notes a sentence about the text of which nothing is refused; each is noted once.
    void remark(const std::string& sentence) const;
    const std::vector<std::string>& remarks() const;

    /// Whether anything of the text was refused.
    bool isAnyRefused() const;
    /// Throws InputError with everything that was refused, if anything was.
    void throwRefused() const;

  private:
    struct Document;
    enum class Known { whole, inParts, refused };

    JsonReader(std::shared_ptr<Document> document, const Json* value, std::string path,
               bool isSilent);
    JsonReader member(const std::string& key, Known known) const;
    JsonReader item(std::size_t index) const;
    void refuseKind(const std::string& expected) const;
    template <typename Is>
    bool isKind(Is is, const std::string& expected) const;

    std::shared_ptr<Document> document_;
    const Json* value_; ///< null where there is none
    std::string path_;
    mutable bool isSilent_ = false; ///< it, or what it should stand in, was refused
};

} // namespace irsg
