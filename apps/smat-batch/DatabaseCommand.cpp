#include "apps/smat-batch/DatabaseCommand.h"

#include <fmt/format.h>

#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/geometry/model/IndexNames.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SpectrumCsv.h"

namespace smat::batch {

namespace {

struct CreateOptions {
    std::string file, model, title;
};

/// A database with an entry for each code of a model, named as the model names those faces, or for
/// index 0 alone.
int create(const CreateOptions& options, Context&) {
    std::filesystem::path named = options.file;
    std::map<irsg::IrCodes, irsg::CodeUse> codes = {{{}, {}}};
    irsg::IndexNames names;
    if (!options.model.empty()) {
        const auto model = irsg::Model::load(options.model);
        codes = model->codes();
        names = irsg::IndexNames(irsg::namesOf(options.model, *model->codesBeside()).names);
        named = options.model;
    }
    const irsg::SignatureDatabase database = irsg::blackDatabase(
        codes, names, options.title.empty() ? named.stem().string() : options.title);
    irsg::createSignatureFile(database, options.file);
    if (!options.model.empty())
        irsg::createScalingFiles(options.model, database);
    fmt::print("{}: {} temperatures, {} materials\n", options.file, database.temperatures.size(),
               database.materials.size());
    return done;
}

struct ExportOptions {
    std::string file, out, spectrum;
    std::optional<int> material, reflectance;
    bool acceptChanges = false;
};

irsg::InputError absent(const ExportOptions& options, const std::string& entry) {
    return irsg::InputError({.file = options.file,
                             .position = entry,
                             .value = "no entry",
                             .expected = "an entry that exists"});
}

const irsg::Material& materialIn(const irsg::SignatureDatabase& database, int index,
                                 const ExportOptions& options) {
    const auto material = database.materials.find(index);
    if (material == database.materials.end())
        throw absent(options, fmt::format("materials.{}", index));
    return material->second;
}

/// All of it as JSON, or one spectrum, material or table of reflectance as CSV.
int exportText(const ExportOptions& options, Context& context) {
    const irsg::SignatureDatabase database =
        loadedDatabase(options.file, options.acceptChanges, context);
    const bool part = !options.spectrum.empty() || options.material || options.reflectance;
    if (part && options.out.empty()) {
        throw irsg::InputError({.file = "OUT",
                                .position = "",
                                .value = "nothing",
                                .expected = "the name of a CSV file"});
    }
    if (!options.spectrum.empty()) {
        const auto spectrum = database.spectra.find(options.spectrum);
        if (spectrum == database.spectra.end())
            throw absent(options, "spectra." + options.spectrum);
        irsg::writeSpectrumCsv(spectrum->second, options.out);
    } else if (options.material) {
        irsg::writeMaterialCsv(materialIn(database, *options.material, options), options.out);
    } else if (options.reflectance) {
        const irsg::Material& material = materialIn(database, *options.reflectance, options);
        if (material.reflectanceTable.empty())
            throw absent(options,
                         fmt::format("materials.{}.reflectanceTable", *options.reflectance));
        irsg::writeReflectanceCsv(material.reflectanceTable, options.out);
    } else if (options.out.empty()) {
        fmt::print("{}", irsg::signatureToJson(database));
    } else {
        irsg::writeFileDurably(options.out, irsg::signatureToJson(database));
    }
    return done;
}

void addCreate(CLI::App& database, Context& context) {
    CLI::App* command =
        database.add_subcommand("create", "A new database: black surfaces at ambient temperature");
    auto options = std::make_shared<CreateOptions>();
    command->add_option("FILE", options->file, "New signature database (.sigdb)")
        ->required()
        ->type_name("");
    command
        ->add_option("--model", options->model,
                     "With an entry for each code of this model, and the two scaling files "
                     "beside it where they are not there")
        ->type_name("MODEL");
    command->add_option("--title", options->title, "Title; the name of the file by default")
        ->type_name("TEXT");
    command->callback([&context, options] {
        context.work = [&context, options] { return create(*options, context); };
    });
}

void addExport(CLI::App& database, Context& context) {
    CLI::App* command = database.add_subcommand(
        "export", "Sorted JSON, to review and to compare; or one spectrum or material as CSV");
    auto options = std::make_shared<ExportOptions>();
    command->add_option("FILE", options->file, "Signature database (.sigdb)")
        ->required()
        ->type_name("");
    command
        ->add_option("OUT", options->out,
                     "File to write; without one JSON goes to standard output. CSV needs one")
        ->type_name("");
    command->add_option("--spectrum", options->spectrum, "This user-defined spectrum as CSV")
        ->type_name("NAME");
    command->add_option("--material", options->material, "The spectra of this material as CSV")
        ->type_name("INDEX");
    command
        ->add_option("--reflectance", options->reflectance,
                     "The table of reflectance of this material as CSV")
        ->type_name("INDEX");
    command->add_flag("--accept-changes", options->acceptChanges,
                      "Take entries that were changed outside this program");
    command->callback([&context, options] {
        context.work = [&context, options] { return exportText(*options, context); };
    });
}

} // namespace

irsg::SignatureDatabase loadedDatabase(const std::string& file, bool acceptChanges,
                                       Context& context) {
    const StageTimer::Scope scope(&context.timer, "load");
    const irsg::LoadedSignature signature = irsg::loadSignatureFile(
        file, acceptChanges ? irsg::OutsideChanges::accept : irsg::OutsideChanges::refuse);
    for (const std::string& entry : signature.changedOutside)
        warn(file + ": " + entry + " was changed outside this program");
    return signature.database;
}

void addDatabaseCommand(CLI::App& app, Context& context) {
    CLI::App* database =
        app.add_subcommand("db", "Makes, checks and exchanges signature databases");
    database->require_subcommand(1);
    addCreate(*database, context);
    addDatabaseInfo(*database, context);
    addDatabaseLint(*database, context);
    addExport(*database, context);
    addDatabaseImport(*database, context);
    addDatabaseCopy(*database, context);
}

} // namespace smat::batch
