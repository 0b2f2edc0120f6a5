#include "irsg/signature/CopyEntries.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/signature/EntryPath.h"

namespace irsg {

namespace {

using OnConflict = CopyRequest::OnConflict;

/// Upwards, and from 1 again past the highest.
int nextFree(const auto& entries, int index) {
    while (entries.contains(index))
        index = index == std::numeric_limits<int>::max() ? 1 : index + 1;
    return index;
}

std::string nextFree(const std::map<std::string, UserSpectrum>& entries, const std::string& name) {
    std::string free = name;
    for (int i = 2; entries.contains(free); ++i)
        free = name + " " + std::to_string(i);
    return free;
}

template <typename Key>
std::string pathOf(const char* table, const Key& key) {
    if constexpr (std::is_same_v<Key, std::string>)
        return spectrumPath(key);
    else
        return std::string(table) + "." + std::to_string(key);
}

/// Puts one entry into its table and says under which key.
template <typename Key, typename Entry>
Key place(std::map<Key, Entry>& table, const char* name, const Key& wanted, Entry entry,
          OnConflict onConflict, const std::string& toName, std::vector<Diagnostic>& diagnostics) {
    const auto there = table.find(wanted);
    if (there == table.end() || onConflict == OnConflict::replace) {
        table[wanted] = std::move(entry);
        return wanted;
    }
    if (there->second == entry)
        return wanted;
    if (onConflict == OnConflict::refuse) {
        diagnostics.push_back({toName, pathOf(name, wanted), "another entry",
                               "a free place, or leave to renumber or to replace"});
        return wanted;
    }
    const Key free = nextFree(table, wanted);
    if constexpr (std::is_same_v<Entry, UserSpectrum>)
        entry.name = free;
    table[free] = std::move(entry);
    return free;
}

} // namespace

CopyResult copyEntries(const SignatureDatabase& from, SignatureDatabase& to,
                       const CopyRequest& request, const std::string& fromName,
                       const std::string& toName) {
    std::vector<Diagnostic> diagnostics;
    SignatureDatabase made = to;
    CopyResult result;
    const auto absent = [&](const std::string& path) {
        diagnostics.push_back({fromName, path, "no entry", "an entry that exists"});
    };

    // Spectra first, so that temperatures can name the copies.
    const auto copySpectrum = [&](const std::string& name) {
        const auto spectrum = from.spectra.find(name);
        if (spectrum == from.spectra.end()) {
            absent(spectrumPath(name));
        } else if (!result.spectra.contains(name)) {
            result.spectra[name] = place(made.spectra, "spectra", name, spectrum->second,
                                         request.onConflict, toName, diagnostics);
        }
    };
    std::ranges::for_each(request.spectra, copySpectrum);

    for (const int index : request.temperatures) {
        const auto entry = from.temperatures.find(index);
        if (entry == from.temperatures.end()) {
            absent(temperaturePath(index));
            continue;
        }
        TemperatureEntry copy = entry->second;
        if (from.spectra.contains(copy.userSpectrum)) {
            copySpectrum(copy.userSpectrum);
            copy.userSpectrum = result.spectra.at(copy.userSpectrum);
        }
        result.temperatures[index] =
            place(made.temperatures, "temperatures", index, std::move(copy), request.onConflict,
                  toName, diagnostics);
    }
    for (const int index : request.materials) {
        const auto material = from.materials.find(index);
        if (material == from.materials.end()) {
            absent(materialPath(index));
            continue;
        }
        result.materials[index] = place(made.materials, "materials", index, material->second,
                                        request.onConflict, toName, diagnostics);
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    to = std::move(made);
    return result;
}

} // namespace irsg
