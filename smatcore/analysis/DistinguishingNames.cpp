#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "irsg/signature/EntryFields.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/SettingWords.h"
#include "smatcore/settings/AnalysisSections.h"

namespace smat {

namespace {

using Results = std::vector<const AnalysisData*>;
using Database = std::shared_ptr<const irsg::SignatureDatabase>;

/// More than so many differences are not said one by one.
constexpr std::size_t mostParts = 3;

/// Something that differs: what each result has of it.
struct Difference {
    std::string entry; ///< of a signature database; empty for a setting
    std::vector<std::string> texts;
};

bool differs(const std::vector<std::string>& texts) {
    return std::ranges::any_of(texts, [&](const std::string& text) { return text != texts[0]; });
}

void addSettings(const Results& results, std::vector<Difference>& list) {
    std::vector<Settings> settings;
    for (const AnalysisData* data : results)
        settings.push_back(settingsOf(data->table));
    const std::string analysis = results.front()->table.provenance.value("analysis");
    for (const SettingInfo& info : settingTable()) {
        if (info.section() == "display" || !concerns(info, analysis))
            continue;
        std::vector<std::string> texts;
        for (const Settings& one : settings)
            texts.push_back(settingWords(one, info.key));
        if (differs(texts))
            list.push_back({"", std::move(texts)});
    }
}

std::string rangeWords(std::vector<double> values) {
    if (values.empty())
        return "none";
    const auto [least, most] = std::ranges::minmax(values);
    return least == most ? fmt::format("{:.4g}", least) : fmt::format("{:.4g}-{:.4g}", least, most);
}

std::string words(double value) {
    return fmt::format("{:.6g}", value);
}
std::string words(const std::string& text) {
    return text;
}
std::string words(const irsg::Spectrum& spectrum) {
    return rangeWords(spectrum.values());
}
std::string words(const irsg::LookupTable& table) {
    return rangeWords(table.y());
}
template <typename Choice>
    requires std::is_enum_v<Choice>
std::string words(Choice choice) {
    return irsg::nameOf(choice);
}

std::string words(const irsg::ReflectanceTable& table) {
    return std::to_string(table.rows().size()) + " directions";
}

/// The sign of a quantity where the field has one.
std::string signOf(const char* label) {
    const std::string text = label;
    return text == "Emissivity" ? "ε" : text == "Transmissivity" ? "τ" : text;
}

template <typename Entry>
void addFields(std::span<const irsg::EntryField<Entry>> fields, const std::string& name,
               const std::vector<const Entry*>& entries, std::vector<Difference>& list);

template <typename Entry, typename Value>
void addMember(const irsg::EntryField<Entry>& field, Value Entry::*member, const std::string& name,
               const std::vector<const Entry*>& entries, std::vector<Difference>& list) {
    if constexpr (std::is_same_v<Value, irsg::TemperatureTerms>) {
        std::vector<const irsg::TemperatureTerms*> terms;
        for (const Entry* entry : entries)
            terms.push_back(&(entry->*member));
        addFields(irsg::termFields(), name, terms, list);
    } else if constexpr (!std::is_same_v<Value, irsg::ComponentFactors>) {
        std::vector<std::string> texts;
        bool same = true;
        for (const Entry* entry : entries) {
            same = same && entry->*member == entries.front()->*member;
            const std::string unit =
                std::string(field.unit).empty() ? "" : " " + std::string(field.unit);
            texts.push_back(signOf(field.label) + " " + words(entry->*member) + unit);
        }
        if (!same && std::string(field.key) != "notes" && std::string(field.key) != "name")
            list.push_back({name, std::move(texts)});
    }
}

template <typename Entry>
void addFields(std::span<const irsg::EntryField<Entry>> fields, const std::string& name,
               const std::vector<const Entry*>& entries, std::vector<Difference>& list) {
    for (const irsg::EntryField<Entry>& field : fields) {
        std::visit([&](auto member) { addMember(field, member, name, entries, list); },
                   field.member);
    }
}

template <typename Entry>
void addEntries(std::span<const irsg::EntryField<Entry>> fields,
                const std::vector<const std::map<int, Entry>*>& maps, const char* kind,
                std::vector<Difference>& list) {
    std::set<int> indices;
    for (const auto* map : maps)
        for (const auto& [index, entry] : *map)
            indices.insert(index);
    for (const int index : indices) {
        std::vector<const Entry*> entries;
        std::vector<std::string> there;
        std::string name;
        for (const auto* map : maps) {
            const auto found = map->find(index);
            entries.push_back(found == map->end() ? nullptr : &found->second);
            name = name.empty() && entries.back() != nullptr ? entries.back()->name : name;
        }
        name = name.empty() ? fmt::format("{} {}", kind, index) : name;
        for (const Entry* entry : entries)
            there.push_back((entry == nullptr ? "without " : "with ") + name);
        if (differs(there))
            list.push_back({"", std::move(there)});
        else
            addFields(fields, name, entries, list);
    }
}

void addDatabases(const std::vector<Database>& databases, std::vector<Difference>& list) {
    const bool known =
        std::ranges::all_of(databases, [](const Database& one) { return one != nullptr; });
    if (!known)
        return;
    std::vector<const std::map<int, irsg::Material>*> materials;
    std::vector<const std::map<int, irsg::TemperatureEntry>*> temperatures;
    for (const Database& database : databases) {
        materials.push_back(&database->materials);
        temperatures.push_back(&database->temperatures);
    }
    addEntries(irsg::temperatureFields(), temperatures, "temperature", list);
    addEntries(irsg::materialFields(), materials, "material", list);
}

void addModels(const Results& results, std::vector<Difference>& list) {
    std::size_t models = results.front()->databases.size();
    for (const AnalysisData* data : results)
        models = std::min(models, data->databases.size());
    for (std::size_t i = 0; i < models; ++i) {
        std::vector<Database> databases;
        for (const AnalysisData* data : results)
            databases.push_back(data->databases[i]);
        addDatabases(databases, list);
    }
}

void addFiles(const Results& results, std::vector<Difference>& list) {
    for (const char* key : {"model", "database"}) {
        std::vector<std::string> texts;
        for (const AnalysisData* data : results)
            texts.push_back(data->table.provenance.value(key));
        if (differs(texts))
            list.push_back({"", std::move(texts)});
    }
}

} // namespace

std::vector<std::string> distinguishingNames(const Results& results) {
    std::vector<std::string> names(results.size());
    // Results of several kinds are told apart by their kinds, Monte Carlo by what it repeats.
    const auto isOther = [&](const AnalysisData* data) {
        const AnalysisData& first = *results.front();
        return data->kind != first.kind || (data->kind == AnalysisKind::monteCarlo &&
                                            data->table.provenance.value("analysis") !=
                                                first.table.provenance.value("analysis"));
    };
    if (results.size() < 2 || std::ranges::any_of(results, isOther))
        return names;
    std::vector<Difference> list;
    addSettings(results, list);
    addModels(results, list);
    if (list.empty())
        addFiles(results, list);
    std::set<std::string> entries;
    for (const Difference& difference : list)
        if (!difference.entry.empty())
            entries.insert(difference.entry);
    for (std::size_t i = 0; i < std::min(list.size(), mostParts); ++i) {
        // One entry alone needs no name: its values tell.
        const std::string whose =
            entries.size() > 1 && !list[i].entry.empty() ? list[i].entry + " " : "";
        for (std::size_t k = 0; k < names.size(); ++k)
            names[k] += (names[k].empty() ? "" : ", ") + whose + list[i].texts[k];
    }
    return names;
}

} // namespace smat
