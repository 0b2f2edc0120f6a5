#include "gui/database/DatabaseEdits.h"

#include <algorithm>
#include <map>

#include "irsg/signature/EntryPath.h"

namespace smat::gui {
namespace {

using irsg::SignatureDatabase;

template <typename Map, typename Key>
bool copyWithin(Map& map, const Key& from, const Key& to) {
    const auto found = map.find(from);
    if (found == map.end() || map.contains(to))
        return false;
    auto copy = found->second;
    map.emplace(to, std::move(copy));
    return true;
}

template <typename Map, typename Key>
bool copyBetween(const Map& source, const Key& from, Map& into, const Key& to, bool replace) {
    const auto found = source.find(from);
    if (found == source.end() || (!replace && into.contains(to)))
        return false;
    into.insert_or_assign(to, found->second);
    return true;
}

} // namespace

bool contains(const SignatureDatabase& database, const EntryKey& key) {
    switch (key.kind) {
    case EntryKind::material:
        return database.materials.contains(key.index);
    case EntryKind::temperature:
        return database.temperatures.contains(key.index);
    case EntryKind::spectrum:
        return database.spectra.contains(key.name);
    }
    return false;
}

std::string placeOf(const EntryKey& key) {
    switch (key.kind) {
    case EntryKind::material:
        return irsg::materialPath(key.index);
    case EntryKind::temperature:
        return irsg::temperaturePath(key.index);
    case EntryKind::spectrum:
        return irsg::spectrumPath(key.name);
    }
    return {};
}

std::optional<EntryKey> entryAt(const SignatureDatabase& database, const std::string& place) {
    // Names may hold dots and blanks: the longest entry whose place the text begins with.
    std::optional<EntryKey> found;
    std::size_t longest = 0;
    const auto look = [&](const EntryKey& key) {
        const std::string path = placeOf(key);
        const bool inside =
            place.starts_with(path) &&
            (place.size() == path.size() || place[path.size()] == '.' || place[path.size()] == ' ');
        if (inside && path.size() > longest) {
            longest = path.size();
            found = key;
        }
    };
    for (const auto& [index, material] : database.materials)
        look({EntryKind::material, index});
    for (const auto& [index, entry] : database.temperatures)
        look({EntryKind::temperature, index});
    for (const auto& [name, spectrum] : database.spectra)
        look({EntryKind::spectrum, 0, name});
    return found;
}

int freeIndex(const SignatureDatabase& database, EntryKind kind, int from) {
    while (contains(database, {kind, from}))
        ++from;
    return from;
}

std::string freeSpectrumName(const SignatureDatabase& database, const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; database.spectra.contains(name); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

bool removeEntry(SignatureDatabase& database, const EntryKey& key) {
    switch (key.kind) {
    case EntryKind::material:
        return database.materials.erase(key.index) > 0;
    case EntryKind::temperature:
        return database.temperatures.erase(key.index) > 0;
    case EntryKind::spectrum:
        return database.spectra.erase(key.name) > 0;
    }
    return false;
}

bool duplicateEntry(SignatureDatabase& database, const EntryKey& from, const EntryKey& to) {
    switch (from.kind) {
    case EntryKind::material:
        return copyWithin(database.materials, from.index, to.index);
    case EntryKind::temperature:
        return copyWithin(database.temperatures, from.index, to.index);
    case EntryKind::spectrum:
        if (!copyWithin(database.spectra, from.name, to.name))
            return false;
        database.spectra[to.name].name = to.name;
        return true;
    }
    return false;
}

bool renumberEntry(SignatureDatabase& database, const EntryKey& from, const EntryKey& to) {
    if (!duplicateEntry(database, from, to))
        return false;
    removeEntry(database, from);
    if (from.kind == EntryKind::spectrum)
        for (const int index : usersOfSpectrum(database, from.name))
            database.temperatures[index].userSpectrum = to.name;
    return true;
}

std::vector<int> usersOfSpectrum(const SignatureDatabase& database, const std::string& name) {
    std::vector<int> users;
    for (const auto& [index, entry] : database.temperatures)
        if (entry.userSpectrum == name)
            users.push_back(index);
    return users;
}

int copyEntries(const SignatureDatabase& source, const std::vector<EntryCopy>& copies,
                SignatureDatabase& into) {
    // Spectra first: temperatures have to know what they are called here.
    int count = 0;
    std::map<std::string, std::string> names;
    for (const auto& copy : copies) {
        if (copy.from.kind != EntryKind::spectrum ||
            !copyBetween(source.spectra, copy.from.name, into.spectra, copy.to.name, copy.replace))
            continue;
        into.spectra[copy.to.name].name = copy.to.name;
        names[copy.from.name] = copy.to.name;
        ++count;
    }
    for (const auto& copy : copies) {
        if (copy.from.kind == EntryKind::material) {
            count += copyBetween(source.materials, copy.from.index, into.materials, copy.to.index,
                                 copy.replace);
        } else if (copy.from.kind == EntryKind::temperature &&
                   copyBetween(source.temperatures, copy.from.index, into.temperatures,
                               copy.to.index, copy.replace)) {
            ++count;
            std::string& spectrum = into.temperatures[copy.to.index].userSpectrum;
            const auto renamed = names.find(spectrum);
            if (renamed != names.end())
                spectrum = renamed->second;
            else if (const auto needed = source.spectra.find(spectrum);
                     needed != source.spectra.end())
                into.spectra.insert(*needed);
        }
    }
    return count;
}

} // namespace smat::gui
