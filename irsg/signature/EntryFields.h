#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "irsg/signature/EntityState.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// What a number may be. Outside of `least` to `most`, or not finite, it is an error; outside of
/// `likelyLeast` to `likelyMost` a warning.
struct NumberRules {
    static constexpr double none = std::numeric_limits<double>::infinity();

    const char* expected = "a finite number"; ///< of the error
    double least = -none;
    double most = none;
    const char* likely = ""; ///< of the warning: what it was likely meant to be
    double likelyLeast = -none;
    double likelyMost = none;
    /// Up to here, a number above `likelyMost` is a percentage; 0 where it never is.
    double mostPercent = 0.0;
    double step = 1.0;       ///< of the arrow keys in a form
    bool isFraction = false; ///< a part of a whole: a CSV may give it from 0 to 1
};

/// What an axis that ends between `low` and `high` was likely meant to be.
struct AxisSuspicion {
    double low = 0.0;
    double high = 0.0;
    const char* expected = "";
    const char* remedy = "";
    /// What makes of the axis what it was meant to be: times, and plus.
    double factor = 1.0;
    double offset = 0.0;
};

/// What a lookup table is over and what it may hold.
struct TableRules {
    const char* axis = "";  ///< "time", as forms name it
    const char* unit = "";  ///< of the axis
    const char* value = ""; ///< what its values are, as forms name it
    /// Where on the axis an entity is in a state.
    double (*position)(const EntityState& state) = nullptr;
    bool mayLoop = false;
    double leastValue = -NumberRules::none;
    double leastPosition = -NumberRules::none;
    double mostPosition = NumberRules::none;
    AxisSuspicion suspicion = {};
    double step = 1.0;       ///< of a new node along the axis
    double firstValue = 0.0; ///< of a new table
};

/// One field of an entry of a signature database: the one description from which both forms of the
/// file, the hash, the checks of ranges, the editor, the CSV of a material and `db info` know of
/// it. A new field is a member of the struct and a row here.
template <typename Entry>
struct EntryField {
    using Member =
        std::variant<std::string Entry::*, double Entry::*, Spectrum Entry::*, LookupTable Entry::*,
                     EmissionMode Entry::*, FactorSelection Entry::*, TemperatureTerms Entry::*,
                     ComponentFactors Entry::*, ReflectanceTable Entry::*>;

    const char* key; ///< in JSON and in places of findings: "ambientOffset_K"
    /// In SQLite and in `db info`: "ambient_offset_K". Of a table or a spectrum, what tells its
    /// nodes from those of others.
    const char* column;
    Member member;
    const char* label = ""; ///< in a form: "ΔT"
    const char* word = "";  ///< in the name of a step that can be undone: "delta T"
    const char* unit = "";  ///< of the value
    const char* help = "";
    const char* page = ""; ///< of the entry's form, where not its first: "surface"
    const char* csv = "";  ///< in a CSV of spectra, where not as its column: "n"
    NumberRules number = {};
    TableRules table = {};
    /// What a text may be beside empty; null where it may be anything.
    const std::vector<std::string>& (*words)() = nullptr;
    /// Whether a JSON file has to say it; null where it never has to.
    bool (*isRequired)(const Entry& entry) = nullptr;
    /// The version of the file's format that brought it. What is of a later version than 1 is
    /// written only where it says something, so that files and hashes of before stay what they are.
    int since = 1;

    /// The member where it is of this kind, else null.
    template <typename Value>
    Value Entry::*as() const {
        const auto* const found = std::get_if<Value Entry::*>(&member);
        return found == nullptr ? nullptr : *found;
    }
    bool saysSomething(const Entry& entry) const {
        static const Entry silent;
        return std::visit([&](auto of) { return !(entry.*of == silent.*of); }, member);
    }
};

/// The rows, in the order of forms and columns.
std::span<const EntryField<TemperatureTerms>> termFields();
std::span<const EntryField<ComponentFactor>> geometryBuffers();
std::span<const EntryField<TemperatureEntry>> temperatureFields();
std::span<const EntryField<Material>> materialFields();
std::span<const EntryField<UserSpectrum>> spectrumFields();

/// Calls `use(field, member)` for each field whose member is of this kind.
template <typename Value, typename Entry, typename Use>
void forEachField(std::span<const EntryField<Entry>> fields, Use use) {
    for (const EntryField<Entry>& field : fields)
        if (const auto member = field.template as<Value>())
            use(field, member);
}

/// The least version of the file's format that holds all that the database says.
int formatVersionOf(const SignatureDatabase& database);
/// The version that brought the last field: the newest that is read.
int newestFormatVersion();

/// A value that is one of a few, as both forms of the file name it.
template <typename Choice>
struct NamedChoice {
    Choice value;
    const char* name;
};
/// "temperature" and "userSpectrum", "table" and "constant".
std::span<const NamedChoice<EmissionMode>> choicesOf(EmissionMode any);
std::span<const NamedChoice<FactorSelection>> choicesOf(FactorSelection any);

template <typename Choice>
    requires std::is_enum_v<Choice>
const char* nameOf(Choice choice) {
    const auto all = choicesOf(choice);
    return std::ranges::find(all, choice, &NamedChoice<Choice>::value)->name;
}
/// No value where no choice has this name.
template <typename Choice>
std::optional<Choice> choiceNamed(const std::string& name) {
    for (const NamedChoice<Choice>& one : choicesOf(Choice()))
        if (name == one.name)
            return one.value;
    return std::nullopt;
}
/// "'temperature' or 'userSpectrum'".
template <typename Choice>
std::string choicesExpected() {
    std::string text;
    for (const NamedChoice<Choice>& one : choicesOf(Choice()))
        text += (text.empty() ? "'" : " or '") + std::string(one.name) + "'";
    return text;
}

} // namespace irsg
