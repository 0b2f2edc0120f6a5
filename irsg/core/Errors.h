#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace irsg {

/// Our own fault: a broken promise between two pieces of this program.
class LogicError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// One thing that is wrong with what the world gave us, in the words a user can act on.
struct Diagnostic {
    std::string file; ///< path, or the name of the object when there is no file
    std::string
        position;      ///< "line 7", "byte 1204", "materials.3.emissivity", "" when it is the whole
    std::string value; ///< what was found
    std::string expected; ///< what would have been right

    /// "FILE: POSITION: found VALUE, expected EXPECTED", without the parts that are empty.
    std::string message() const;
};

/// The world's fault: a file, a value or a combination that cannot be used. Loaders collect every
/// diagnostic of a file before they throw, so that one run shows them all.
class InputError : public std::runtime_error {
  public:
    explicit InputError(Diagnostic diagnostic);
    /// `diagnostics` must not be empty (LogicError). Of each file the first 100 are kept, and how
    /// many more there are.
    explicit InputError(std::vector<Diagnostic> diagnostics);

    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    struct Bounded {
        std::vector<Diagnostic> list;
    };
    explicit InputError(Bounded diagnostics);

    std::vector<Diagnostic> diagnostics_;
};

/// The shortest decimal text that reads back as `value`, whatever the locale: "3.5", "nan".
std::string numberText(double value);

} // namespace irsg
