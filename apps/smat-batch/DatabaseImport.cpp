#include <fmt/format.h>

#include "apps/smat-batch/DatabaseCommand.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/support/TextFile.h"

namespace smat::batch {

namespace {

struct ImportOptions {
    std::string in, file, kind = "spectrum", unit, name;
    double referenceDistance_m = 0.0;
    int temperature = 0;
    bool loop = false;
};

/// A user-defined spectrum from CSV into the database; one of the same name is replaced.
void importSpectrum(const ImportOptions& options, irsg::SignatureDatabase& database) {
    std::optional<irsg::SpectralRadianceUnit> unit;
    if (!options.unit.empty()) {
        unit = irsg::SpectralRadianceUnit::parse(options.unit);
    }
    irsg::UserSpectrum spectrum =
        irsg::readSpectrumCsv(options.in, unit, options.referenceDistance_m);
    if (!options.name.empty()) {
        spectrum.name = options.name;
    }
    const std::string spectrumName = spectrum.name;
    database.spectra[spectrumName] = std::move(spectrum);
}

/// A table of time or angle factors into the factors of one temperature entry.
void importFactors(const ImportOptions& options, irsg::SignatureDatabase& database) {
    const auto entry = database.temperatures.find(options.temperature);
    const std::string place = fmt::format("temperatures.{}", options.temperature);
    if (entry == database.temperatures.end()) {
        throw irsg::InputError(irsg::Offence{.file = options.file,
                                             .position = place,
                                             .value = "no entry",
                                             .expected = "an entry with a user-defined spectrum"});
    }
    const auto spectrum = database.spectra.find(entry->second.userSpectrum);
    if (spectrum == database.spectra.end()) {
        throw irsg::InputError(
            irsg::Offence{.file = options.file,
                          .position = place,
                          .value = "an entry without a user-defined spectrum",
                          .expected = "one whose components the factors are of"});
    }
    irsg::readFactorCsv(
        options.in, options.kind == "time" ? irsg::FactorAxis::time_s : irsg::FactorAxis::angle_deg,
        options.loop, spectrum->second, entry->second.factors);
}

int import(const ImportOptions& options, Context& context) {
    const StageTimer::Scope scope(&context.timer, "import");
    if (std::filesystem::path(options.in).extension() == ".json") {
        irsg::saveSignatureFile(irsg::signatureFromJson(readTextFile(options.in), options.in),
                                options.file);
        return done;
    }
    irsg::SignatureDatabase database = irsg::loadSignatureFile(options.file).database;
    if (options.kind == "spectrum") {
        importSpectrum(options, database);
    } else {
        importFactors(options, database);
    }
    irsg::saveSignatureFile(database, options.file);
    return done;
}

} // namespace

void addDatabaseImport(CLI::App& database, Context& context) {
    CLI::App* command = database.add_subcommand(
        "import", "A whole database from JSON, or a CSV of spectra or factors into one");
    auto options = std::make_shared<ImportOptions>();
    command->add_option("IN", options->in, "JSON or CSV file")->required()->type_name("");
    command->add_option("FILE", options->file, "Signature database (.sigdb)")
        ->required()
        ->type_name("");
    command->add_option("--as", options->kind, "What a CSV holds: spectrum, time or angle factors")
        ->check(CLI::IsMember({"spectrum", "time", "angle"}))
        ->type_name("KIND");
    command->add_option("--unit", options->unit,
                        "Unit of the radiance, such as \"W cm-2 sr-1 (cm-1)-1\"");
    command->add_option("--name", options->name, "Name of the spectrum; the file's by default");
    command
        ->add_option("--reference-distance", options->referenceDistance_m,
                     "Distance of the measurement, m")
        ->check(CLI::Range(0.0, 1e9));
    command->add_option("--temperature", options->temperature,
                        "Temperature index whose factors are set");
    command->add_flag("--loop", options->loop, "Time factors repeat");
    command->callback([&context, options] {
        context.work = [&context, options] { return import(*options, context); };
    });
}

} // namespace smat::batch
