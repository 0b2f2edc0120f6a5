#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "irsg/signature/CanonicalJson.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/JsonReader.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/SignatureFile.h"

namespace irsg {

namespace {

using nlohmann::json;

constexpr const char* formatName = "smat-signature";
const JsonForm jsonForm = {.expected = "a signature database (JSON in UTF-8)", .deepest = 16};

/// What the fields of an entry say in one JSON object.
class FieldReader {
  public:
    FieldReader(JsonObject& object, JsonProblems& problems)
        : object_(object), problems_(problems) {}

    template <typename Entry>
    void read(Entry& entry, std::span<const EntryField<Entry>> fields) {
        for (const EntryField<Entry>& field : fields) {
            required_ = field.isRequired != nullptr && field.isRequired(entry);
            std::visit([&](auto member) { into(entry.*member, field.key); }, field.member);
        }
    }

  private:
    void into(std::string& text, const char* key) { text = object_.text(key, required_); }
    void into(double& number, const char* key) { number = object_.number(key, number, required_); }
    void into(LookupTable& table, const char* key) { table = object_.table(key); }
    void into(Spectrum& spectrum, const char* key) {
        spectrum = object_.spectrum(key, spectrum.values().front(), required_);
    }
    template <typename Choice>
        requires std::is_enum_v<Choice>
    void into(Choice& choice, const char* key) {
        const std::string name = object_.text(key, required_);
        if (const auto known = choiceNamed<Choice>(name))
            choice = *known;
        else if (!name.empty())
            problems_.addText(object_.pathOf(key), "'" + name + "'", choicesExpected<Choice>());
    }
    void into(TemperatureTerms& terms, const char* key) {
        if (const json* const value = object_.find(key, required_))
            readWhole(*value, object_.pathOf(key), terms, termFields());
    }
    void into(ReflectanceTable& table, const char* key) {
        const json* const value = object_.find(key, required_);
        if (value == nullptr)
            return;
        JsonObject own(*value, object_.pathOf(key), problems_);
        const std::string kind = own.text("kind", true);
        const bool isBrdf = kind == "brdf";
        if (!isBrdf && !kind.empty() && kind != "directionalHemispherical")
            problems_.addText(own.pathOf("kind"), "'" + kind + "'",
                              "'brdf' or 'directionalHemispherical'");
        const json* const axis = own.find("wavelengths_um", true);
        std::vector<double> wavelengths_um;
        if (axis != nullptr && axis->is_array() &&
            std::ranges::all_of(*axis, [](const json& one) { return one.is_number(); }))
            wavelengths_um = axis->get<std::vector<double>>();
        else if (axis != nullptr)
            problems_.add(own.pathOf("wavelengths_um"), *axis, "a list [...] of wavelengths in um");
        const std::size_t angles = isBrdf ? 3 : 1;
        const auto columns = own.columns("nodes", angles + wavelengths_um.size());
        own.finish();
        if (!columns || wavelengths_um.empty())
            return;
        std::vector<ReflectanceTable::Row> rows((*columns)[0].size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            rows[i].incidence_deg = (*columns)[0][i];
            if (isBrdf) {
                rows[i].reflection_deg = (*columns)[1][i];
                rows[i].azimuth_deg = (*columns)[2][i];
            }
            for (std::size_t w = 0; w < wavelengths_um.size(); ++w)
                rows[i].values.push_back((*columns)[angles + w][i]);
        }
        try {
            table = ReflectanceTable(isBrdf, std::move(wavelengths_um), std::move(rows));
        } catch (const InputError& error) {
            problems_.add(object_.pathOf(key), error);
        }
    }
    void into(ComponentFactors& factors, const char* key) {
        const json* const value = object_.find(key, required_);
        if (value == nullptr)
            return;
        if (!value->is_array()) {
            problems_.add(object_.pathOf(key), *value, "a list [...] of component factors");
            return;
        }
        for (std::size_t i = 0; i < value->size(); ++i) {
            readWhole((*value)[i], object_.pathOf(key) + "[" + std::to_string(i) + "]",
                      factors.emplace_back(), factorFields());
        }
    }
    template <typename Entry>
    void readWhole(const json& value, const std::string& path, Entry& entry,
                   std::span<const EntryField<Entry>> fields) {
        JsonObject object(value, path, problems_);
        FieldReader(object, problems_).read(entry, fields);
        object.finish();
    }

    JsonObject& object_;
    JsonProblems& problems_;
    bool required_ = false;
};

TemperatureEntry readTemperature(const json& value, const std::string& path,
                                 JsonProblems& problems) {
    JsonObject object(value, path, problems);
    TemperatureEntry entry;
    FieldReader(object, problems).read(entry, temperatureFields());
    object.finish();
    return entry;
}

/// A stated reflectivity is checked, not kept: it follows from the other two.
void checkReflectivity(const Material& material, const Spectrum& reflectivity,
                       const std::string& path, JsonProblems& problems) {
    std::vector<double> nodes_um = {1.0};
    for (const Spectrum* const each :
         {&material.emissivity, &material.transmissivity, &reflectivity}) {
        nodes_um.insert(nodes_um.end(), each->wavelengths_um().begin(),
                        each->wavelengths_um().end());
    }
    for (const double node_um : nodes_um) {
        const double derived = material.reflectivityAt(node_um);
        if (std::abs(reflectivity.at(node_um) - derived) > closureTolerance) {
            problems.addText(path + " at " + numberText(node_um) + " um",
                             numberText(reflectivity.at(node_um)),
                             "1 - emissivity - transmissivity = " + numberText(derived));
            return;
        }
    }
}

Material readMaterial(const json& value, const std::string& path, JsonProblems& problems) {
    JsonObject object(value, path, problems);
    Material material;
    FieldReader(object, problems).read(material, materialFields());
    if (object.find("reflectivity") != nullptr) {
        checkReflectivity(material, object.spectrum("reflectivity", 0.0),
                          object.pathOf("reflectivity"), problems);
    }
    object.finish();
    return material;
}

UserSpectrum readSpectrum(const json& value, const std::string& name, const std::string& path,
                          JsonProblems& problems) {
    JsonObject object(value, path, problems);
    UserSpectrum spectrum;
    spectrum.name = name;
    FieldReader(object, problems).read(spectrum, spectrumFields());

    const json* const names = object.find("components", true);
    std::vector<std::string> components;
    if (names != nullptr && names->is_array()) {
        for (std::size_t i = 0; i < names->size(); ++i) {
            if ((*names)[i].is_string()) {
                components.push_back((*names)[i].get<std::string>());
            } else {
                problems.add(object.pathOf("components") + "[" + std::to_string(i) + "]",
                             (*names)[i], "text in quotes");
            }
        }
    } else if (names != nullptr) {
        problems.add(object.pathOf("components"), *names, "a list [...] of component names");
    }

    // The axis is checked once, by the first component.
    const auto columns = object.columns("radiance_W_m2_sr_um", components.size() + 1);
    object.finish();
    if (!columns)
        return spectrum;
    try {
        for (std::size_t i = 0; i < components.size(); ++i) {
            spectrum.components.push_back(
                {components[i], {(*columns)[0], (*columns)[i + 1], Spectrum::Outside::zero}});
        }
    } catch (const InputError& error) {
        problems.add(object.pathOf("radiance_W_m2_sr_um"), error);
    }
    return spectrum;
}

std::optional<int> canonicalIndex(const std::string& key) {
    int index = 0;
    const char* const end = key.data() + key.size();
    const auto result = std::from_chars(key.data(), end, index);
    const bool whole = result.ec == std::errc{} && result.ptr == end;
    return whole && std::to_string(index) == key ? std::optional(index) : std::nullopt;
}

template <typename Entry, typename Read>
void readIndexed(JsonObject& root, const std::string& key, std::map<int, Entry>& into,
                 JsonProblems& problems, Read read) {
    const json* const entries = root.find(key, true);
    if (entries == nullptr)
        return;
    if (!entries->is_object()) {
        problems.add(key, *entries, "an object {...} of entries by index");
        return;
    }
    for (const auto& item : entries->items()) {
        const std::string path = key + "." + item.key();
        if (const auto index = canonicalIndex(item.key()))
            into[*index] = read(item.value(), path, problems);
        else
            problems.addText(path, "'" + item.key() + "'", "a whole number of 32 bits as index");
    }
}

} // namespace

std::string signatureToJson(const SignatureDatabase& database) {
    throwOnLintErrors(database, database.title.empty() ? "signature database" : database.title);
    return draftToJson(database);
}

std::string draftToJson(const SignatureDatabase& database) {
    json root = {{"format", formatName},           {"version", formatVersionOf(database)},
                 {"title", database.title},        {"notes", database.notes},
                 {"temperatures", json::object()}, {"materials", json::object()},
                 {"spectra", json::object()}};
    for (const auto& [index, entry] : database.temperatures)
        root["temperatures"][std::to_string(index)] = entryJson(entry);
    for (const auto& [index, material] : database.materials)
        root["materials"][std::to_string(index)] = entryJson(material);
    for (const auto& [name, spectrum] : database.spectra)
        root["spectra"][name] = entryJson(spectrum);
    return prettyJson(root) + "\n";
}

SignatureDatabase signatureFromJson(const std::string& text, const std::string& fileName,
                                    LintErrors errors) {
    const json parsed = parseJson(text, fileName, jsonForm);
    JsonProblems problems(fileName, text);
    JsonObject root(parsed, "", problems);

    const std::string format = root.text("format", true);
    if (!format.empty() && format != formatName)
        problems.addText("format", "'" + format + "'", std::string("'") + formatName + "'");
    const double version = root.number("version", newestFormatVersion(), true);
    if (version != std::clamp(std::round(version), 1.0, double(newestFormatVersion())))
        problems.addText("version", numberText(version), signatureVersionsExpected());

    SignatureDatabase database;
    database.title = root.text("title");
    database.notes = root.text("notes");
    readIndexed(root, "temperatures", database.temperatures, problems, readTemperature);
    readIndexed(root, "materials", database.materials, problems, readMaterial);
    if (const json* const spectra = root.find("spectra")) {
        if (!spectra->is_object()) {
            problems.add("spectra", *spectra, "an object {...} of spectra by name");
        } else {
            for (const auto& item : spectra->items()) {
                database.spectra[item.key()] =
                    readSpectrum(item.value(), item.key(), spectrumPath(item.key()), problems);
            }
        }
    }
    root.finish();
    problems.throwIfAny();
    if (errors == LintErrors::refuse)
        throwOnLintErrors(database, fileName);
    return database;
}

} // namespace irsg
