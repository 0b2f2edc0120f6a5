#include "tests/fuzz/Readers.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <unistd.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/atmosphere/import/TextLines.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/PngPlane.h"
#include "irsg/image/TiffFile.h"
#include "irsg/karma/KarmaXml.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/FileReading.h"
#include "irsg/scene/model/FlightScanner.h"
#include "irsg/scene/model/Model.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "smatcore/simulate/Trajectory.h"
#include "tests/fuzz/SeedTexts.h"

namespace smat::test {

namespace {

namespace fs = std::filesystem;
using File = const fs::path&;

std::string imageBytes(const char* extension) {
    irsg::RadianceImage image(3, 2, "L", "W m-2 sr-1");
    image.channels.front().values = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
    image.attributes["band"] = "3-5 um";
    const fs::path file =
        fs::temp_directory_path() / ("smat-fuzz-seed-" + std::to_string(getpid()) + extension);
    irsg::writeImageFile(image, file);
    const std::string bytes = irsg::readFile(file);
    fs::remove(file);
    return bytes;
}

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nusemtl m\n"
                           "f 1/1/1 2/1/1 3/1/1\nf -1//1 -2//1 -3//1\n";
const char* const facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 1 1 0\nendloop\nendfacet\nendsolid a\n";
const char* const trajectory = "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg]\n"
                               "0,0,0,100,0,0,0\n1,10,0,100,5,0,0\n";

} // namespace

const std::vector<FuzzedReader>& fuzzedReaders() {
    static const std::string air = "resources/atmospheres/";
    static std::vector<FuzzedReader> list = {
        {"csv-table",
         ".csv",
         [](File f) { irsg::CsvTable::read(f); },
         {"samples/ship/gas.csv"},
         {}},
        {"spectrum-csv",
         ".csv",
         [](File f) { irsg::readSpectrumCsv(f); },
         {"samples/ship/gas.csv"},
         {"# unit: W m-2 sr-1 um-1\num,a,b\n3,1,2\n4,2,3\n"}},
        {"factor-csv",
         ".csv",
         [](File f) {
             irsg::ComponentFactors into;
             irsg::UserSpectrum spectrum;
             spectrum.components = {{"a", {{3.0, 5.0}, {1.0, 1.0}}},
                                    {"b", {{3.0, 5.0}, {1.0, 1.0}}}};
             irsg::readFactorCsv(f, irsg::FactorAxis::time_s, false, spectrum, into);
         },
         {},
         {",a,b\n0,1,1\n10,0.5,2\n"}},
        {"material-csv",
         ".csv",
         [](File f) {
             irsg::Material into;
             irsg::readMaterialCsv(f, into);
         },
         {},
         {"um,emissivity\n3,0.9\n5,0.8\n"}},
        {"band-csv",
         ".csv",
         [](File f) { irsg::Band::fromCsv(f); },
         {},
         {"wavelength [um],response\n3,0\n4,1\n5,0\n"}},
        {"csv-image",
         ".csv",
         [](File f) { irsg::readCsvImage(f); },
         {},
         {imageBytes(".csv"), "1 2 3\n4 5 6\n"}},
        {"exr", ".exr", [](File f) { irsg::readExr(f); }, {}, {imageBytes(".exr")}},
        {"tiff", ".tif", [](File f) { irsg::readTiff(f); }, {}, {imageBytes(".tif")}},
        {"png", ".png", [](File f) { irsg::readPngPlane(f); }, {"samples/valley/ground.png"}, {}},
        {"signature-json",
         ".json",
         [](File f) { irsg::signatureFromJson(irsg::readFile(f)); },
         {"samples/box/signature.json"},
         {}},
        {"signature-file",
         ".sigdb",
         [](File f) { irsg::loadSignatureFile(f); },
         {"samples/box/box.sigdb"},
         {}},
        {"scaling-xml",
         ".xml",
         [](File f) { irsg::readScalingFile(f, irsg::ScalingKind::temperature); },
         {"samples/ship/ship(temperaturesScalings).xml"},
         {}},
        {"karma-xml",
         ".xml",
         [](File f) { irsg::KarmaXml::read(f); },
         {air + "subarctic-winter.xml"},
         {}},
        {"environment-xml",
         ".xml",
         [](File f) { irsg::environmentFromKarma(irsg::KarmaXml::read(f)); },
         {air + "tropical-maritime.xml"},
         {environmentText()}},
        {"sensor-xml",
         ".xml",
         [](File f) { imagingSensorFromKarma(irsg::KarmaXml::read(f)); },
         {"samples/flyby/ImagingSensor.xml"},
         {}},
        {"beer-lambert",
         ".csv",
         [](File f) { irsg::BeerLambert::fromCsv(f); },
         {air + "haze-23km.csv"},
         {}},
        {"spectra-csv",
         ".csv",
         [](File f) { irsg::SpectraAtmosphere::fromCsv(f); },
         {air + "haze-23km.csv"},
         {radiativeText()}},
        {"tape7", ".dat", [](File f) { irsg::readTape7(f); }, {}, {tape7Text()}},
        {"modtran-csv", ".csv", [](File f) { irsg::readModtranCsv(f); }, {}, {modtranCsvText()}},
        {"modtran-json",
         ".json",
         [](File f) { irsg::parseModtranJson(irsg::readTextFile(f), "a"); },
         {},
         {modtranJsonText()}},
        {"atmosphere-table",
         ".smatatm",
         [](File f) { irsg::TabulatedAtmosphere::read(f); },
         {},
         {tabulatedAtmosphereText()}},
        {"project", ".smat", [](File f) { loadProject(f); }, {"samples/box/box.smat"}, {}},
        {"scenario", ".json", [](File f) { loadScenario(f); }, {"samples/flyby/flyby.json"}, {}},
        {"trajectory",
         ".csv",
         [](File f) { Trajectory::read(f); },
         {"samples/flyby/near.csv"},
         {trajectory}},
        {"result-csv",
         ".csv",
         [](File f) { ResultTable::load(f); },
         {},
         {"# program: smat 1\nrange [m],intensity [W sr-1]\n100,1\n200,2\n"}},
        {"result-json", ".json", [](File f) { ResultTable::load(f); }, {}, {resultJsonText()}},
        {"flight", ".flt", [](File f) { irsg::scanFlight(f); }, {"samples/box/box.flt"}, {}},
        {"obj", ".obj", [](File f) { irsg::Model::load(f); }, {}, {square}},
        {"stl", ".stl", [](File f) { irsg::Model::load(f); }, {}, {facet}},
    };
    static const bool isWhole = [] {
        const std::vector<FuzzedReader> packed = packedReaders();
        list.insert(list.end(), packed.begin(), packed.end());
        return true;
    }();
    static_cast<void>(isWhole);
    return list;
}

bool readBytes(const FuzzedReader& reader, std::string_view bytes) {
    static const fs::path folder = [] {
        fs::path made = fs::temp_directory_path() / ("smat-fuzz-" + std::to_string(getpid()));
        fs::create_directories(made);
        return made;
    }();
    const fs::path file = folder / ("a" + reader.extension);
    std::ofstream(file, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    try {
        reader.read(file);
        return true;
    } catch (const irsg::InputError& error) {
        for (const irsg::Diagnostic& diagnostic : error.diagnostics())
            if (diagnostic.message().empty())
                throw std::logic_error("a refusal without a sentence");
        return false;
    }
}

std::vector<std::string> seedsOf(const FuzzedReader& reader) {
    std::vector<std::string> seeds = reader.seedTexts;
    for (const std::string& seed : reader.seeds) {
        std::ifstream stream(fs::path(SMAT_SOURCE_DIR) / seed, std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>());
    }
    return seeds;
}

} // namespace smat::test
