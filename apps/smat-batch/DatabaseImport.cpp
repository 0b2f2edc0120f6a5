#include <algorithm>

#include <fmt/format.h>

#include "apps/smat-batch/DatabaseCommand.h"
#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/support/TextFile.h"

namespace smat::batch {

namespace {

struct ImportOptions {
    std::string in, file, kind = "spectrum", unit, name, model;
    std::optional<double> referenceDistance_m;
    std::optional<int> temperature, material;
    bool loop = false, replace = false;
};

/// A user-defined spectrum from CSV into the database; one of the same name is replaced. The
/// distance is the one that is given, else that of the file.
void importSpectrum(const ImportOptions& options, irsg::SignatureDatabase& database) {
    std::optional<irsg::SpectralRadianceUnit> unit;
    if (!options.unit.empty())
        unit = irsg::SpectralRadianceUnit::parse(options.unit);
    irsg::UserSpectrum spectrum =
        irsg::readSpectrumCsv(options.in, unit, options.referenceDistance_m);
    if (!options.name.empty())
        spectrum.name = options.name;
    const std::string spectrumName = spectrum.name;
    database.spectra[spectrumName] = std::move(spectrum);
}

/// An option that this kind of CSV needs.
int needed(const char* option, const std::optional<int>& value, const ImportOptions& options) {
    if (!value) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = option,
                             .position = "",
                             .value = "nothing",
                             .expected = "the index that the " + options.kind + " table is for"});
    }
    return *value;
}

/// Spectra of emissivity, transmissivity and reflectivity into one material, made where absent.
void importMaterial(const ImportOptions& options, irsg::SignatureDatabase& database) {
    const int index = needed("--material", options.material, options);
    database.materials[index] = irsg::importedMaterial(options.in, database, index, options.name);
}

/// A table of its reflectance over directions into one material.
void importReflectance(const ImportOptions& options, irsg::SignatureDatabase& database) {
    const int index = needed("--material", options.material, options);
    database.materials[index] =
        irsg::importedReflectance(options.in, database, index, options.name);
}

/// A table of time or angle factors into the factors of one temperature entry.
void importFactors(const ImportOptions& options, irsg::SignatureDatabase& database) {
    const int index = needed("--temperature", options.temperature, options);
    const auto entry = database.temperatures.find(index);
    const std::string place = fmt::format("temperatures.{}", index);
    if (entry == database.temperatures.end()) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = options.file,
                             .position = place,
                             .value = "no entry",
                             .expected = "an entry with a user-defined spectrum"});
    }
    const auto spectrum = database.spectra.find(entry->second.userSpectrum);
    if (spectrum == database.spectra.end()) {
        throw irsg::InputError(
            irsg::Diagnostic{.file = options.file,
                             .position = place,
                             .value = "an entry without a user-defined spectrum",
                             .expected = "one whose components the factors are of"});
    }
    irsg::readFactorCsv(
        options.in, options.kind == "time" ? irsg::FactorAxis::time_s : irsg::FactorAxis::angle_deg,
        options.loop, spectrum->second, entry->second.factors);
}

/// What lint has to say since the import, on standard error.
void warnOfNew(const std::vector<irsg::Finding>& before, const irsg::SignatureDatabase& database,
               const std::string& file) {
    for (const irsg::Finding& finding : irsg::lint(database)) {
        const bool known = std::ranges::any_of(before, [&](const irsg::Finding& old) {
            return old.place == finding.place && old.value == finding.value;
        });
        // Errors are said by the save, which refuses them.
        if (!known && !finding.isError()) {
            warn(fmt::format("{}: {}: found {}, {}{}", file, finding.place, finding.value,
                             finding.reason,
                             finding.remedy.empty() ? "" : " (" + finding.remedy + ")"));
        }
    }
}

/// The two scaling files of a model, where they are not there.
void createScalings(const irsg::SignatureDatabase& database, const ImportOptions& options) {
    if (!options.model.empty())
        irsg::createScalingFiles(options.model, database);
}

/// What took its time to make is not lost to a whole database from elsewhere.
void createNew(const irsg::SignatureDatabase& database, const std::string& file) {
    std::error_code failure;
    if (std::filesystem::exists(file, failure)) {
        throw irsg::InputError({.file = file,
                                .position = "",
                                .value = "a file that exists already",
                                .expected = "a new name, or --replace"});
    }
    irsg::createSignatureFile(database, file);
}

int import(const ImportOptions& options, Context& context) {
    const StageTimer::Scope scope(&context.timer, "import");
    if (std::filesystem::path(options.in).extension() == ".json") {
        const irsg::SignatureDatabase database =
            irsg::signatureFromJson(readTextFile(options.in), options.in);
        if (options.replace)
            irsg::saveSignatureFile(database, options.file);
        else
            createNew(database, options.file);
        createScalings(database, options);
        warnOfNew({}, database, options.file);
        return done;
    }
    const irsg::SignatureDatabase opened = loadedDatabase(options.file, false, context);
    irsg::SignatureDatabase database = opened;
    if (options.kind == "spectrum")
        importSpectrum(options, database);
    else if (options.kind == "material")
        importMaterial(options, database);
    else if (options.kind == "reflectance")
        importReflectance(options, database);
    else
        importFactors(options, database);
    irsg::saveSignatureFile(database, options.file, opened);
    createScalings(database, options);
    warnOfNew(irsg::lint(opened), database, options.file);
    return done;
}

} // namespace

void addDatabaseImport(CLI::App& database, Context& context) {
    CLI::App* command = database.add_subcommand(
        "import",
        "A whole database from JSON, or a CSV of spectra, factors or a material into one");
    auto options = std::make_shared<ImportOptions>();
    command->add_option("IN", options->in, "JSON or CSV file")->required()->type_name("");
    command->add_option("FILE", options->file, "Signature database (.sigdb)")
        ->required()
        ->type_name("");
    command
        ->add_option("--as", options->kind,
                     "What a CSV holds: spectrum (user-defined), time or angle factors, material "
                     "(emissivity, transmissivity, reflectivity, n, k; also a file of ECOSTRESS, "
                     "ASTER, USGS, JCAMP-DX, refractiveindex.info or DIRSIG), reflectance (a table "
                     "over directions, or a Zemax BSDF file)")
        ->check(CLI::IsMember({"spectrum", "time", "angle", "material", "reflectance"}))
        ->type_name("KIND");
    command->add_option("--unit", options->unit,
                        "Unit of the radiance, such as \"W cm-2 sr-1 (cm-1)-1\"");
    command->add_option("--name", options->name,
                        "Name of the spectrum or of the material; the file's by default");
    command
        ->add_option("--reference-distance", options->referenceDistance_m,
                     "Distance of the measurement, m; by default that of the file")
        ->check(CLI::Range(0.0, 1e9));
    command->add_option("--temperature", options->temperature,
                        "Temperature index whose factors are set");
    command->add_option("--material", options->material,
                        "Material index whose spectra are set; a new one is made");
    command->add_option("--model", options->model,
                        "Model whose two scaling files are written where they are not there");
    command->add_flag("--loop", options->loop, "Time factors repeat");
    command->add_flag("--replace", options->replace,
                      "JSON takes the place of a database that exists");
    command->callback([&context, options] {
        context.work = [&context, options] { return import(*options, context); };
    });
}

} // namespace smat::batch
