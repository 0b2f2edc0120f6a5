#include "gui/database/DatabaseChange.h"

#include "irsg/signature/EntryPath.h"

namespace smat::gui {
namespace {

std::map<std::string, std::string> textsOf(const irsg::SignatureDatabase& database) {
    return {{"title", database.title}, {"notes", database.notes}};
}

} // namespace

template <typename Key, typename Value>
DatabaseChange::Differences<Key, Value> DatabaseChange::compare(const std::map<Key, Value>& before,
                                                                const std::map<Key, Value>& after) {
    Differences<Key, Value> differences;
    for (const auto& [key, value] : before) {
        const auto kept = after.find(key);
        if (kept == after.end())
            differences[key] = {value, std::nullopt};
        else if (!(kept->second == value))
            differences[key] = {value, kept->second};
    }
    for (const auto& [key, value] : after)
        if (!before.contains(key))
            differences[key] = {std::nullopt, value};
    return differences;
}

template <typename Key, typename Value>
void DatabaseChange::put(const Differences<Key, Value>& differences, bool after,
                         std::map<Key, Value>& into) {
    for (const auto& [key, difference] : differences) {
        const auto& value = after ? difference.after : difference.before;
        if (value)
            into.insert_or_assign(key, *value);
        else
            into.erase(key);
    }
}

template <typename Key, typename Value>
void DatabaseChange::join(Differences<Key, Value>& first, const Differences<Key, Value>& next) {
    for (const auto& [key, difference] : next) {
        const auto [known, isNew] = first.try_emplace(key, difference);
        if (!isNew)
            known->second.after = difference.after;
        if (known->second.before == known->second.after)
            first.erase(known);
    }
}

DatabaseChange DatabaseChange::between(const irsg::SignatureDatabase& before,
                                       const irsg::SignatureDatabase& after) {
    DatabaseChange change;
    change.texts_ = compare(textsOf(before), textsOf(after));
    change.temperatures_ = compare(before.temperatures, after.temperatures);
    change.materials_ = compare(before.materials, after.materials);
    change.spectra_ = compare(before.spectra, after.spectra);
    return change;
}

bool DatabaseChange::isEmpty() const {
    return texts_.empty() && temperatures_.empty() && materials_.empty() && spectra_.empty();
}

QStringList DatabaseChange::places() const {
    QStringList places;
    for (const auto& [key, difference] : texts_)
        places << QString::fromStdString(key);
    for (const auto& [index, difference] : temperatures_)
        places << QString::fromStdString(irsg::temperaturePath(index));
    for (const auto& [index, difference] : materials_)
        places << QString::fromStdString(irsg::materialPath(index));
    for (const auto& [name, difference] : spectra_)
        places << QString::fromStdString(irsg::spectrumPath(name));
    return places;
}

void DatabaseChange::apply(irsg::SignatureDatabase& database, bool after) const {
    auto texts = textsOf(database);
    put(texts_, after, texts);
    database.title = texts["title"];
    database.notes = texts["notes"];
    put(temperatures_, after, database.temperatures);
    put(materials_, after, database.materials);
    put(spectra_, after, database.spectra);
}

void DatabaseChange::redo(irsg::SignatureDatabase& database) const {
    apply(database, true);
}

void DatabaseChange::undo(irsg::SignatureDatabase& database) const {
    apply(database, false);
}

void DatabaseChange::append(const DatabaseChange& next) {
    join(texts_, next.texts_);
    join(temperatures_, next.temperatures_);
    join(materials_, next.materials_);
    join(spectra_, next.spectra_);
}

} // namespace smat::gui
