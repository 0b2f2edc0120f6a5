#include <charconv>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/DatabaseCommand.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/CopyEntries.h"

namespace smat::batch {

namespace {

struct CopyOptions {
    std::string from, to;
    std::vector<std::string> temperatures, materials, spectra;
    bool renumber = false, replace = false;
};

/// Whole numbers between commas; diagnostics name the option.
std::vector<int> indices(const char* option, const std::vector<std::string>& words,
                         std::vector<irsg::Diagnostic>& diagnostics) {
    std::vector<int> result;
    for (const std::string& word : words) {
        int index = 0;
        const std::string_view text = irsg::trimmed(word);
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, index);
        if (error != std::errc{} || stop != end) {
            diagnostics.push_back({.file = option,
                                   .position = "",
                                   .value = "'" + word + "'",
                                   .expected = "indices between commas: 3,4"});
        } else {
            result.push_back(index);
        }
    }
    return result;
}

irsg::CopyRequest requestOf(const CopyOptions& options) {
    std::vector<irsg::Diagnostic> diagnostics;
    irsg::CopyRequest request;
    request.temperatures = indices("--temperatures", options.temperatures, diagnostics);
    request.materials = indices("--materials", options.materials, diagnostics);
    request.spectra = options.spectra;
    request.onConflict = options.renumber  ? irsg::CopyRequest::OnConflict::renumber
                         : options.replace ? irsg::CopyRequest::OnConflict::replace
                                           : irsg::CopyRequest::OnConflict::refuse;
    if (options.renumber && options.replace) {
        diagnostics.push_back({.file = "--renumber",
                               .position = "",
                               .value = "--replace too",
                               .expected = "one of the two"});
    }
    if (options.temperatures.empty() && options.materials.empty() && options.spectra.empty()) {
        diagnostics.push_back({.file = "db copy",
                               .position = "",
                               .value = "nothing to copy",
                               .expected = "--temperatures, --materials or --spectra"});
    }
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
    return request;
}

template <typename Key>
nlohmann::ordered_json jsonOf(const std::map<Key, Key>& moves) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& [from, to] : moves)
        list.push_back({{"from", from}, {"to", to}});
    return list;
}

template <typename Key>
void print(const char* kind, const std::map<Key, Key>& moves) {
    for (const auto& [from, to] : moves)
        fmt::print("  {} {} as {}\n", kind, from, to);
}

int copy(const CopyOptions& options, Context& context) {
    const irsg::CopyRequest request = requestOf(options);
    const irsg::SignatureDatabase from = loadedDatabase(options.from, false, context);
    const irsg::SignatureDatabase opened = loadedDatabase(options.to, false, context);
    irsg::SignatureDatabase made = opened;
    const irsg::CopyResult result =
        irsg::copyEntries(from, made, request, options.from, options.to);
    irsg::saveSignatureFile(made, options.to, opened);
    if (context.json) {
        fmt::print("{}\n",
                   jsonText(nlohmann::ordered_json{{"file", options.to},
                                                   {"temperatures", jsonOf(result.temperatures)},
                                                   {"materials", jsonOf(result.materials)},
                                                   {"spectra", jsonOf(result.spectra)}}));
        return done;
    }
    fmt::print("{}\n", options.to);
    print("temperature", result.temperatures);
    print("material", result.materials);
    print("spectrum", result.spectra);
    return done;
}

} // namespace

void addDatabaseCopy(CLI::App& database, Context& context) {
    CLI::App* command = database.add_subcommand(
        "copy", "Entries of one database into another, with the spectra they name");
    auto options = std::make_shared<CopyOptions>();
    command->add_option("FROM", options->from, "Signature database (.sigdb)")
        ->required()
        ->type_name("");
    command->add_option("TO", options->to, "The one that gets the copies")
        ->required()
        ->type_name("");
    command->add_option("--temperatures", options->temperatures, "Temperature indices: 3,4")
        ->type_name("INDICES")
        ->expected(1)
        ->delimiter(',')
        ->take_all();
    command->add_option("--materials", options->materials, "Material indices: 3,4")
        ->type_name("INDICES")
        ->expected(1)
        ->delimiter(',')
        ->take_all();
    command->add_option("--spectra", options->spectra, "A spectrum; may be given more than once")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    command->add_flag("--renumber", options->renumber,
                      "Give the next free index to what has its place taken");
    command->add_flag("--replace", options->replace, "Replace existing entries");
    command->callback([&context, options] {
        context.work = [&context, options] { return copy(*options, context); };
    });
}

} // namespace smat::batch
