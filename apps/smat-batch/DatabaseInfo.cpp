#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/DatabaseCommand.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace smat::batch {

namespace {

using irsg::LookupTable;
using irsg::Spectrum;
using nlohmann::ordered_json;

struct InfoOptions {
    std::string file;
    bool acceptChanges = false;
};

bool usesSpectrum(const irsg::TemperatureEntry& entry) {
    return entry.mode == irsg::EmissionMode::userSpectrum;
}

/// The tables of an entry that are not empty, by the names of the JSON form.
std::vector<std::string> tablesOf(const irsg::TemperatureEntry& entry) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const LookupTable& table) {
        if (!table.empty())
            names.push_back(name + (table.loop() ? " (loop)" : ""));
    };
    irsg::forEachField<LookupTable>(irsg::termFields(), [&](const auto& field, auto member) {
        add(field.key, entry.terms.*member);
    });
    for (const irsg::ComponentFactor& factor : entry.factors) {
        const bool isKept = factor.selection == irsg::FactorSelection::constant;
        irsg::forEachField<LookupTable>(
            irsg::geometryBuffers(), [&](const auto& field, auto member) {
                add(factor.component + "." + field.key + (isKept ? " (kept, not used)" : ""),
                    factor.*member);
            });
    }
    return names;
}

ordered_json jsonOf(const Spectrum& spectrum) {
    ordered_json json{{"minimum", spectrum.minimum()}, {"maximum", spectrum.maximum()}};
    if (!spectrum.isConstant()) {
        json["nodes"] = spectrum.size();
        json["axis_um"] = {spectrum.wavelengths_um().front(), spectrum.wavelengths_um().back()};
    }
    return json;
}

/// Adds the texts, numbers and spectra of an entry, by the names of their columns, without a text
/// that is told otherwise.
template <typename Entry>
void addFields(ordered_json& json, const Entry& entry,
               std::span<const irsg::EntryField<Entry>> fields,
               std::string Entry::*toldOtherwise = nullptr) {
    for (const auto& field : fields) {
        if (std::string_view(field.page) == "gas" && !field.saysSomething(entry))
            continue; // few materials are one
        if (const auto text = field.template as<std::string>()) {
            if (text != toldOtherwise)
                json[field.column] = entry.*text;
        } else if (const auto number = field.template as<double>())
            json[field.column] = entry.*number;
        else if (const auto spectrum = field.template as<Spectrum>())
            json[field.column] = jsonOf(entry.*spectrum);
    }
}

ordered_json jsonOf(const irsg::SignatureDatabase& database) {
    ordered_json temperatures = ordered_json::array();
    for (const auto& [index, entry] : database.temperatures) {
        ordered_json one{{"index", index},
                         {"name", entry.name},
                         {"mode", usesSpectrum(entry) ? "user spectrum" : "temperature equation"}};
        if (usesSpectrum(entry))
            one["spectrum"] = entry.userSpectrum;
        else
            one["at_rest_K"] = irsg::surfaceTemperature_K(entry.terms, {});
        one["tables"] = tablesOf(entry);
        // Its spectrum is told above, where it is used.
        addFields(one, entry, irsg::temperatureFields(), &irsg::TemperatureEntry::userSpectrum);
        temperatures.push_back(std::move(one));
    }
    ordered_json materials = ordered_json::array();
    for (const auto& [index, material] : database.materials) {
        ordered_json one{
            {"index", index}, {"name", material.name}, {"opaque", material.isOpaque()}};
        addFields(one, material, irsg::materialFields());
        materials.push_back(std::move(one));
    }
    ordered_json spectra = ordered_json::array();
    for (const auto& [name, spectrum] : database.spectra) {
        std::vector<std::string> components;
        for (const irsg::SpectrumComponent& component : spectrum.components)
            components.push_back(component.name);
        const auto& axis_um = spectrum.components.front().radiance.wavelengths_um();
        ordered_json one{{"name", name},
                         {"components", components},
                         {"nodes", axis_um.size()},
                         {"axis_um", {axis_um.front(), axis_um.back()}}};
        addFields(one, spectrum, irsg::spectrumFields());
        spectra.push_back(std::move(one));
    }
    return {{"title", database.title},
            {"notes", database.notes},
            {"temperatures", std::move(temperatures)},
            {"materials", std::move(materials)},
            {"spectra", std::move(spectra)}};
}

/// "0.9", or "0.85 to 0.94 (12 nodes, 2 to 14 um)".
std::string textOf(const Spectrum& spectrum) {
    if (spectrum.isConstant())
        return irsg::numberText(spectrum.values().front());
    return fmt::format("{:.4g} to {:.4g} ({} nodes, {:.4g} to {:.4g} um)", spectrum.minimum(),
                       spectrum.maximum(), spectrum.size(), spectrum.wavelengths_um().front(),
                       spectrum.wavelengths_um().back());
}

void print(const irsg::SignatureDatabase& database) {
    for (const auto& [index, entry] : database.temperatures) {
        fmt::print("  temperature {:>6}  {}: ", index, entry.name);
        if (usesSpectrum(entry))
            fmt::print("spectrum {}", entry.userSpectrum);
        else
            fmt::print("{:.2f} K at rest", irsg::surfaceTemperature_K(entry.terms, {}));
        for (const std::string& table : tablesOf(entry))
            fmt::print(", table {}", table);
        fmt::print("\n");
    }
    for (const auto& [index, material] : database.materials) {
        fmt::print("  material    {:>6}  {}: emissivity {}", index, material.name,
                   textOf(material.emissivity));
        if (!material.isOpaque())
            fmt::print(", transmissivity {}", textOf(material.transmissivity));
        irsg::forEachField<double>(irsg::materialFields(),
                                   [&of = material](const auto& field, auto member) {
                                       if (field.saysSomething(of))
                                           fmt::print(", {} {:.4g}", field.label, of.*member);
                                   });
        fmt::print("\n");
    }
    for (const auto& [name, spectrum] : database.spectra) {
        const Spectrum& first = spectrum.components.front().radiance;
        fmt::print("  spectrum    {}: {} components, {} nodes, {:.4g} to {:.4g} um, reference "
                   "distance {} m\n",
                   name, spectrum.components.size(), first.size(), first.wavelengths_um().front(),
                   first.wavelengths_um().back(), irsg::numberText(spectrum.referenceDistance_m));
    }
}

int databaseInfo(const InfoOptions& options, Context& context) {
    const irsg::SignatureDatabase database =
        loadedDatabase(options.file, options.acceptChanges, context);
    if (context.json) {
        ordered_json json{{"file", options.file}};
        json.update(jsonOf(database));
        fmt::print("{}\n", jsonText(json));
        return done;
    }
    fmt::print("{}: {}\n", options.file, database.title);
    print(database);
    return done;
}

} // namespace

void addDatabaseInfo(CLI::App& database, Context& context) {
    CLI::App* command = database.add_subcommand(
        "info", "Temperatures, materials and spectra, with the numbers that tell them apart");
    auto options = std::make_shared<InfoOptions>();
    command->add_option("FILE", options->file, "Signature database (.sigdb)")
        ->required()
        ->type_name("");
    command->add_flag("--accept-changes", options->acceptChanges,
                      "Take entries that were changed outside this program");
    command->callback([&context, options] {
        context.work = [&context, options] { return databaseInfo(*options, context); };
    });
}

} // namespace smat::batch
