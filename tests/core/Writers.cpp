#include "tests/core/Writers.h"

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/ModelConverter.h"
#include "irsg/image/Canvas.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/TiffFile.h"
#include "irsg/karma/KarmaXml.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "smatcore/tables/TableFormats.h"
#ifdef SMAT_HAS_SCATTERING
#include "irsg/scattering/FinishedBatches.h"
#include "irsg/scattering/MtfDatabase.h"
#endif

namespace smat::test {

namespace {

namespace fs = std::filesystem;

const fs::path source = SMAT_SOURCE_DIR;

std::string bytesOf(const fs::path& file) {
    return irsg::readFile(file);
}

/// What is in a model, whose bytes may differ from writing to writing.
std::string facesOf(const fs::path& file) {
    const std::shared_ptr<irsg::Model> model = irsg::Model::load(file);
    std::string text;
    for (const auto& [codes, use] : model->codes()) {
        text += std::to_string(codes.temperature) + " " + std::to_string(codes.material) + " " +
                std::to_string(use.faces) + "\n";
    }
    return text;
}

irsg::RadianceImage image(bool second) {
    irsg::RadianceImage made(4, 3, "L", "W m-2 sr-1");
    made.channels.front().values.assign(12, second ? 2.0f : 1.0f);
    return made;
}

irsg::SignatureDatabase made(bool second) {
    const fs::path sample = fs::path(SMAT_SOURCE_DIR) / "samples/box/box.sigdb";
    irsg::SignatureDatabase database = irsg::loadSignatureFile(sample).database;
    database.title = second ? "second" : "first";
    // More pages than a journal of one.
    database.notes = std::string(second ? 20000 : 10, 'n');
    return database;
}

const irsg::SignatureDatabase& database(bool second) {
    static const irsg::SignatureDatabase all[] = {made(false), made(true)};
    return all[second];
}

ResultTable table(bool second) {
    ResultTable made;
    made.add(irsg::Quantity::range);
    made.addRow({second ? 2.0 : 1.0});
    return made;
}

/// Over directions.
ResultTable signatureTable(bool second) {
    ResultTable made;
    made.add(irsg::Quantity::azimuth);
    made.add(irsg::Quantity::elevation);
    made.add(irsg::Quantity::contrastIntensity);
    made.addRow({0.0, 0.0, second ? 2.0 : 1.0});
    return made;
}

irsg::GasTable gasTable(bool second) {
    const irsg::GasTable::Grid grid{
        {1100.0, 600.0, 300.0, 100.0, 30.0, 1.0}, {180.0, 220.0, 260.0, 300.0, 340.0}, 0.04, 4};
    const std::vector<float> block(30, -50.0f);
    const auto bins = [](double width_per_cm) {
        return irsg::BinSet{width_per_cm, {{1000.0, 1005.0, 0, 1}}, {0}, {1.0f}};
    };
    return {grid,
            {1001.0},
            {{0, irsg::Gas::CO2, block}},
            {bins(1.0), bins(5.0), bins(15.0)},
            second ? "second" : "first"};
}

irsg::TabulatedAtmosphere atmosphere(bool second) {
    const std::string name = second ? "second" : "first";
    return irsg::TabulatedAtmosphere::fromText(
        R"({"format":"irsg tabulated atmosphere","version":1,"name":")" + name +
            R"(","wavenumbers [cm-1]":[2050,2051,2052],"runs":[{"source":"s","kind":)"
            R"("transmittance","path":"horizontal","sensor_altitude [m]":2000,)"
            R"("target_altitude [m]":2000,"range [m]":2000,"elevation [rad]":0,"cards":{},)"
            R"("transmittance":[0.9,0.8,0.7]}]})",
        "a.smatatm");
}

} // namespace

const std::vector<Writer>& waysOfWriting() {
    static const std::vector<Writer> list = {
        {"Text", "a.txt",
         [](const fs::path& file, bool second) {
             irsg::writeFileDurably(file, second ? "second" : "first");
         },
         bytesOf},
        {"ExrImage", "a.exr",
         [](const fs::path& file, bool second) { irsg::writeExr(image(second), file); }, bytesOf},
        {"TiffImage", "a.tif",
         [](const fs::path& file, bool second) { irsg::writeTiff(image(second), file); }, bytesOf},
        {"CsvImage", "a.csv",
         [](const fs::path& file, bool second) { irsg::writeCsvImage(image(second), file); },
         bytesOf},
        {"ResultTable", "a.csv",
         [](const fs::path& file, bool second) { table(second).save(file); }, bytesOf},
        {"ResultJson", "a.json",
         [](const fs::path& file, bool second) { table(second).save(file); }, bytesOf},
        {"Project", "a.smat",
         [](const fs::path& file, bool second) {
             Project project;
             project.notes = second ? "second" : "first";
             saveProject(project, file);
         },
         bytesOf},
        {"KarmaXml", "a.xml",
         [](const fs::path& file, bool second) {
             irsg::KarmaXml::read(fs::path(SMAT_RESOURCES_DIR) / "atmospheres" /
                                  (second ? "tropical-maritime.xml" : "subarctic-winter.xml"))
                 .write(file);
         },
         bytesOf},
        {"Database", "a.sigdb",
         [](const fs::path& file, bool second) { irsg::saveSignatureFile(database(second), file); },
         [](const fs::path& file) {
             return irsg::signatureToJson(irsg::loadSignatureFile(file).database);
         }},
    };
    return list;
}

const std::vector<Writer>& otherWriters() {
    static const std::vector<Writer> list = {
        {"Png", "a.png",
         [](const fs::path& file, bool second) {
             irsg::writePng(irsg::Canvas(4, 3, second ? irsg::Rgb{1, 2, 3} : irsg::Rgb{4, 5, 6}),
                            file);
         },
         bytesOf},
        {"ConvertedModel", "a.osgb",
         [](const fs::path& file, bool second) {
             irsg::convertModel(source / (second ? "samples/ship/ship.flt" : "samples/box/box.flt"),
                                file);
         },
         facesOf},
        {"TabulatedAtmosphere", "a.smatatm",
         [](const fs::path& file, bool second) { atmosphere(second).write(file); }, bytesOf},
        {"GasTable", "a.gastable",
         [](const fs::path& file, bool second) { gasTable(second).write(file); }, bytesOf},
        {"Scenario", "a.json",
         [](const fs::path& file, bool second) {
             Scenario scenario;
             scenario.title = second ? "second" : "first";
             saveScenario(scenario, file);
         },
         bytesOf},
        {"Sensor", "a.smatsensor",
         [](const fs::path& file, bool second) {
             irsg::SensorDescription sensor =
                 irsg::loadSensor(source / "resources/sensors/cooled-mwir.smatsensor");
             sensor.title = second ? "second" : "first";
             irsg::saveSensor(sensor, file);
         },
         bytesOf},
        {"ImagingSensor", "a.xml",
         [](const fs::path& file, bool second) {
             irsg::KarmaXml document =
                 irsg::KarmaXml::read(source / "samples/flyby/ImagingSensor.xml");
             ImagingSensorParameters parameters;
             parameters.calculationMode = second ? 2.0 : 1.0;
             toKarma(parameters, document);
             document.write(file);
         },
         bytesOf},
        {"Spectrum", "a.csv",
         [](const fs::path& file, bool second) {
             irsg::UserSpectrum spectrum;
             spectrum.components = {{"CO2", {{3.0, 5.0}, {1.0, second ? 2.0 : 1.0}}}};
             irsg::writeSpectrumCsv(spectrum, file);
         },
         bytesOf},
        {"Material", "a.csv",
         [](const fs::path& file, bool second) {
             irsg::Material material;
             material.emissivity = irsg::Spectrum::constant(second ? 0.9 : 0.8);
             irsg::writeMaterialCsv(material, file);
         },
         bytesOf},
        {"ReflectanceTable", "a.csv",
         [](const fs::path& file, bool second) {
             irsg::writeReflectanceCsv(
                 {false, {4.0}, {{0, 0, 0, {second ? 0.9 : 0.8}}, {90, 0, 0, {1.0}}}}, file);
         },
         bytesOf},
        {"ScalingFile",
         "a(temperaturesScalings).xml",
         [](const fs::path& file, bool) {
             irsg::createScalingFiles(file.parent_path() / "a.flt", database(false));
         },
         bytesOf,
         false,
         {"a(emissivitiesScalings).xml"}},
#ifdef SMAT_HAS_TABLES
        // .mat is written in the same way, after some hundred calls that fill a file in memory.
        {"NetCdfTable", "a.nc",
         [](const fs::path& file, bool second) { saveTable(signatureTable(second), file); },
         bytesOf},
#endif
#ifdef SMAT_HAS_SCATTERING
        {"FinishedBatches", "a.mtf.part",
         [](const fs::path& file, bool second) {
             std::string recipe(irsg::FinishedBatches::firstWords);
             recipe += second ? "; second" : "; first";
             const irsg::FinishedBatches batches(file, recipe, 2);
         },
         bytesOf},
        {"MtfDatabase", "a.mtf",
         [](const fs::path& file, bool second) {
             irsg::MtfDatabase({}, {0.0, 1.0}, {1.0}, {{second ? 2.0 : 1.5, 1.0}}).write(file);
         },
         bytesOf},
#endif
    };
    return list;
}

} // namespace smat::test
