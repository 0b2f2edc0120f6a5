#pragma once

#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json_fwd.hpp>

namespace irsg {

/// What a text in JSON is to be.
struct JsonForm {
    std::string expected;    ///< as a sentence names it: "a project file (JSON)"
    int deepest = 100;       ///< levels of lists and objects
    bool mayComment = false; ///< comments as in C++ between the values
    /// A JsonReader names the members of a list "runs[3]", otherwise "runs.3".
    bool indexInBrackets = false;
};

/// The value of a JSON text. Throws InputError with line and column for text that is not JSON in
/// UTF-8, for a zero byte (the library takes it for the end and says nothing of what follows), for
/// more levels than `form` has and for a number beyond double precision; and, with its key path and
/// line, for each key that stands twice in one object, of which the library would keep the last in
/// silence.
nlohmann::json parseJson(const std::string& text, const std::string& file, const JsonForm& form);

/// A value as an error shows it, cut where it is long.
std::string shownJson(const nlohmann::json& value);

/// "models" + "0" -> "models.0"; an empty part adds nothing.
std::string joinedKeyPath(const std::string& path, const std::string& key);

/// Where the values of a JSON text that was parsed stand. The text is searched when the first place
/// is asked for: a file without a fault costs nothing.
class JsonPlaces {
  public:
    explicit JsonPlaces(std::string text, bool mayComment = false)
        : text_(std::move(text)), mayComment_(mayComment) {}

    /// The line of the value at a key path, "models.0.file" or "models[0].file", from 1; 0 where
    /// there is none. Throws LogicError where the text is no JSON.
    int line(const std::string& path) const;
    /// A key path as an error names it: "models.0.file, line 3". What follows the path ("..., node
    /// 2") stays; the line of a value that is missing is that of what should hold it. A text of one
    /// line has no lines to name.
    std::string position(const std::string& path) const;

  private:
    struct Tree;
    const Tree& tree() const;

    std::string text_;
    bool mayComment_;
    mutable std::shared_ptr<const Tree> tree_;
};

} // namespace irsg
