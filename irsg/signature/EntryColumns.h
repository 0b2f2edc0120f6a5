#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "irsg/signature/EntryFields.h"

namespace irsg {

/// Fields in SQLite: texts, numbers, modes and spectra have a column in the row of their entry; so
/// have the terms of a temperature, in their place. Tables and lists have tables of their own.

/// Calls `use(column, value)` for each column of a version of the format, in order. `entry` may be
/// const.
template <typename Entry, typename Use>
void forEachColumn(Entry& entry, std::span<const EntryField<std::remove_const_t<Entry>>> fields,
                   int version, const Use& use) {
    for (const auto& field : fields) {
        if (field.since > version)
            continue;
        std::visit(
            [&](auto member) {
                auto& value = entry.*member;
                using Value = std::remove_cvref_t<decltype(value)>;
                if constexpr (std::is_same_v<Value, TemperatureTerms>) {
                    forEachColumn(value, termFields(), version, use);
                } else if constexpr (!std::is_same_v<Value, LookupTable> &&
                                     !std::is_same_v<Value, ComponentFactors> &&
                                     !std::is_same_v<Value, ReflectanceTable>) {
                    use(field.column, value);
                }
            },
            field.member);
    }
}

/// What tells the nodes of these members from each other, of a version of the format: 'time_s',
/// 'power', ...
template <typename Value, typename Entry>
std::vector<std::string> nodeNames(std::span<const EntryField<Entry>> fields, int version) {
    std::vector<std::string> names;
    forEachField<Value>(fields, [&](const EntryField<Entry>& field, auto /*member*/) {
        if (field.since <= version)
            names.emplace_back(field.column);
    });
    return names;
}

/// The member whose nodes have this name, or null.
template <typename Value, typename Entry>
Value Entry::*memberOfNodes(std::span<const EntryField<Entry>> fields, const std::string& name) {
    Value Entry::*found = nullptr;
    forEachField<Value>(fields, [&](const EntryField<Entry>& field, auto member) {
        if (name == field.column)
            found = member;
    });
    return found;
}

} // namespace irsg
