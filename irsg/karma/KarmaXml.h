#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"

namespace pugi {
class xml_document;
}

namespace irsg {

/// Full and quarter turns that were written with four decimals are still such.
inline constexpr double mostFullTurn_rad = 6.2832, mostQuarterTurn_rad = 1.5708;

/// The value element of a parameter.
enum class KarmaKind { number, vector, vector3, entityType, string };
/// "double", "vector": the element's name.
const char* name(KarmaKind kind);

struct KarmaParameter {
    std::string name;
    KarmaKind kind = KarmaKind::number;
    std::vector<double> numbers; ///< one for a number, three for a vector3; all finite
    std::string text;            ///< of an entityType or a string
    std::string documentation;
    int line = 0; ///< where it was read; 0 where the program made it

    /// The same but for the line.
    bool operator==(const KarmaParameter& other) const;
};

/// An entry of a composition: a component with its own file of parameters.
struct KarmaComposite {
    std::string name;
    std::string component;
    std::string parameters; ///< path as written, see resolveKarmaPath
    std::string composition = "none";
    int priority = 0; ///< the lowest is asked first
    std::string documentation;
    int line = 0;

    bool operator==(const KarmaComposite& other) const;
};

/// A parameter file in the KARMA dialect of XML (report, annex A):
/// data / fileType, type, Object_Model_Identification_Table, documentation,
/// parameter name="..." / double | vector | vector3 | entityType | string, documentation, and
/// composition / composite name="..." / component, parameters, composition, priority,
/// documentation.
///
/// The document stays as it was read: elements, attributes and comments that nobody here knows are
/// written back, values that were not changed keep their digits ("5.0"). Text is UTF-8; a file that
/// declares ISO-8859-1 is converted.
class KarmaXml {
  public:
    /// Throws InputError naming every diagnostic with its line: a file that cannot be read, is
    /// larger than 16 MiB or not well-formed; a root other than `data`; a fileType other than
    /// `Parameters`; parameters and composites without a name, with a name that was there before,
    /// without a value or with two; numbers that are none or not finite.
    static KarmaXml read(const std::filesystem::path& file);
    /// The same from memory; `file` stands for the file in diagnostics.
    static KarmaXml parse(std::string text, std::string file);
    /// A new document of a type ("/Environment/Root/Environment") without parameters.
    explicit KarmaXml(const std::string& type, const std::string& documentation);

    KarmaXml(const KarmaXml& other);
    KarmaXml& operator=(const KarmaXml& other);
    KarmaXml(KarmaXml&&) noexcept;
    KarmaXml& operator=(KarmaXml&&) noexcept;
    ~KarmaXml();

    const std::string& file() const { return file_; }
    std::string type() const; ///< empty where there is none
    /// The last word of the type: "AtmosphereSmart".
    std::string typeName() const;
    std::string documentation() const;
    const std::vector<KarmaParameter>& parameters() const { return parameters_; }
    const KarmaParameter* find(std::string_view name) const;
    /// In the order of the file.
    const std::vector<KarmaComposite>& composites() const { return composites_; }

    /// Adds a parameter or gives it a new value; an empty documentation keeps the one that is
    /// there. LogicError for a parameter without name, a number of numbers that does not fit its
    /// kind, and numbers that are not finite.
    void set(const KarmaParameter& parameter);
    void remove(std::string_view name);
    /// Replaces the composition, keeping what else stands in composites of the same name.
    void setComposites(const std::vector<KarmaComposite>& composites);

    std::string text() const;
    /// Throws InputError where the file cannot be written.
    void write(const std::filesystem::path& file) const;

    /// "FILE: line 7, parameter Visibility: found VALUE, expected EXPECTED".
    Diagnostic diagnostic(const KarmaParameter& parameter, std::string value,
                          std::string expected) const;
    Diagnostic diagnostic(const KarmaComposite& composite, std::string value,
                          std::string expected) const;
    /// About a parameter that is not there, or the whole file where `position` is empty.
    Diagnostic diagnostic(std::string position, std::string value, std::string expected) const;

  private:
    KarmaXml();

    std::unique_ptr<pugi::xml_document> document_;
    std::string file_;
    std::vector<KarmaParameter> parameters_;
    std::vector<KarmaComposite> composites_;
};

/// True where the first character of a file that is no blank is `<`; false where it cannot be read.
bool isXml(const std::filesystem::path& file);

/// The file that a path in a KARMA file means. Backslashes separate folders; `$(KARMA_ROOT)` and
/// `%KARMA_ROOT%` stand for the environment variable KARMA_ROOT or, where it is not set or empty,
/// for the folder of `file`; other paths are relative to that folder. Where there is no such file,
/// one of the same name beside `file` is taken. Throws InputError naming the places that were
/// searched, and KARMA_ROOT where it would have been needed and is not set; `position` is where
/// `file` has the path.
std::filesystem::path resolveKarmaPath(const std::string& path, const std::filesystem::path& file,
                                       const std::string& position = "");

} // namespace irsg
