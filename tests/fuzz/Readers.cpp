#include "tests/fuzz/Readers.h"

#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/atmosphere/import/ModtranJson.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "irsg/atmosphere/import/TextLines.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/JsonText.h"
#include "irsg/geometry/flight/FlightScanner.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/EnviFile.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/PlainImages.h"
#include "irsg/image/PngPlane.h"
#include "irsg/image/TiffFile.h"
#include "irsg/karma/KarmaXml.h"
#include "irsg/radiometry/Band.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"
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

/// The first lines of a file of the tree.
std::string linesOf(const std::string& file, int count) {
    std::ifstream stream(fs::path(SMAT_SOURCE_DIR) / file, std::ios::binary);
    std::string lines;
    for (std::string line; count > 0 && std::getline(stream, line); --count) {
        lines += line + "\n";
    }
    return lines;
}

const char* const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nusemtl m\n"
                           "f 1/1/1 2/1/1 3/1/1\nf -1//1 -2//1 -3//1\n";
const char* const facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 1 1 0\nendloop\nendfacet\nendsolid a\n";
/// A square and a strip with a restart, as text and in numbers of either order.
const char* const polygons =
    "ply\nformat ascii 1.0\ncomment units = mm\nelement vertex 4\nproperty float x\nproperty "
    "float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar int vertex_indices\nelement tristrips 1\nproperty list "
    "int int vertex_indices\nend_header\n0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n0 1 0 9 9 9\n"
    "4 0 1 2 3\n5 0 1 -1 2 3\n";
std::string packedPolygons() {
    std::string bytes = "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\n"
                        "property short y\nproperty short z\nelement face 1\nproperty list uchar "
                        "uchar vertex_index\nend_header\n";
    for (const char value : std::string_view("\0\0\0\1\0\0\0\1\0", 9)) {
        bytes += '\0';
        bytes += value;
    }
    return bytes + "\3" + std::string("\0\1\2", 3);
}
const char* const drawing =
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n"
    "2\nb\n10\n1\n20\n0\n30\n0\n0\n3DFACE\n8\nhull\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n1"
    "\n"
    "22\n1\n32\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nb\n10\n5\n50\n90\n7"
    "0\n"
    "2\n44\n3\n0\nPOLYLINE\n8\nskin\n70\n64\n0\nVERTEX\n70\n192\n10\n0\n20\n0\n0\nVERTEX\n70\n192\n"
    "10\n1\n"
    "20\n0\n0\nVERTEX\n70\n192\n10\n1\n20\n1\n0\nVERTEX\n70\n128\n71\n1\n72\n2\n73\n-"
    "3\n0\nSEQEND\n0\n"
    "SOLID\n10\n0\n20\n0\n11\n1\n21\n0\n12\n0\n22\n1\n13\n1\n23\n1\n210\n0\n220\n1\n230\n0\n0\nENDS"
    "EC\n0\n"
    "EOF\n";
const char* const trajectory = "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg]\n"
                               "0,0,0,100,0,0,0\n1,10,0,100,5,0,0\n";

} // namespace

const std::vector<FuzzedReader>& fuzzedReaders() {
    static const std::string air = "resources/atmospheres/";
    static const std::string strangers = "tests/data/strangers/";
    static std::vector<FuzzedReader> list = {
        {"csv-table",
         ".csv",
         [](File f) { irsg::CsvTable::read(f); },
         {},
         {linesOf("samples/ship/gas.csv", 12)}},
        {"spectrum-csv",
         ".csv",
         [](File f) { irsg::readSpectrumCsv(f); },
         {},
         {linesOf("samples/ship/gas.csv", 12), "# unit: W m-2 sr-1 um-1\num,a,b\n3,1,2\n4,2,3\n"}},
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
         {"um,emissivity\n3,0.9\n5,0.8\n", "um,n,k\n3,1.5,0.1\n5,2,0.2\n",
          "wl,n\n3,4\n5,5\n\nwl,k\n3,29\n5,40\n", "\xEF\xBB\xBFum;emissivity\n3;0,9\n5;0,8\n",
          "Wellenl\xe4nge [\xc5];Reflexionsgrad in %\n30 000;9,5\n50 000;8\n",
          "longueur d\u2019onde (nm)\tfacteur de r\u00e9flexion\n3\u202f000\t0,9\n5'000\t0,8\n"}},
        {"spectral-library",
         ".txt",
         [](File f) {
             irsg::Material into;
             irsg::readMaterialCsv(f, into);
         },
         {strangers + "material-forms/dirsig.ems",
          strangers + "material-forms/ecostress.spectrum.txt",
          strangers + "material-forms/jcamp.jdx", strangers + "material-forms/rii.yml",
          strangers + "material-forms/usgs.asc"},
         {"DATA:\n  - type: formula 1\n    wavelength_range: 0.5 7\n    coefficients: 0 0.7 0.07 "
          "0.9 9.9\n"
          "  - type: tabulated k\n    data: |\n        1 0.1\n        5 0.2\n",
          "DATA:\n  - type: formula 4\n    wavelength_range: 1 5\n    coefficients: 2 3 1 0.5 2 1 "
          "2 0.3 1 "
          "0.25 2\n",
          "DATA:\n  - type: formula 7\n    wavelength_range: 1 5\n    coefficients: 3.4 0.1 -0.1 "
          "1e-6\n",
          "##TITLE=x\n##XUNITS=1/CM\n##YUNITS=TRANSMITTANCE\n##FIRSTX=2000\n##LASTX=2500\n"
          "##XYDATA=(X++(Y..Y))\n2000A0K%Tlr\n##END=\n"}},
        {"reflectance-table",
         ".csv",
         [](File f) { irsg::readReflectanceTable(f); },
         {},
         {"incidence_deg,3.4,10.6\n0,0.2,0.3\n60,0.3,0.4\n",
          "incidence_deg,reflection_deg,azimuth_deg,4\n0,0,0,0.1\n0,0,180,0.1\n0,60,0,0.1\n"
          "0,60,180,0.2\n",
          "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType "
          "BRDF\nSampleRotation 1\n0\nAngleOfIncidence 1\n0\nScatterAzimuth 2\n0 180\n"
          "ScatterRadial 2\n0 90\nMonochrome\nDataBegin\nTIS 0.5\n0.3 0.1\n0.3 0.1\n"
          "DataEnd\n"}},
        {"band-csv",
         ".csv",
         [](File f) { irsg::Band::fromCsv(f); },
         {},
         {"wavelength [um],response\n3,0\n4,1\n5,0\n", "3 0\n4 1\n5 0\n",
          "N x\nmid\n 3000. 0. 3333.\n 4000. 1. 2500.\n"}},
        {"csv-image",
         ".csv",
         [](File f) { irsg::readCsvImage(f); },
         {},
         {imageBytes(".csv"), "1 2 3\n4 5 6\n", "a;b\n\n1,5;2\n3;4,5\n"}},
        {"esri-grid",
         ".asc",
         [](File f) { irsg::readEsriGrid(f); },
         {},
         {"ncols 2\nnrows 1\nNODATA_value -9\n1 2\n"}},
        {"pfm", ".pfm", [](File f) { irsg::readPfm(f); }, {strangers + "image-forms/grid.pfm"}, {}},
        {"npy",
         ".npy",
         [](File f) { irsg::readNpy(f); },
         {strangers + "image-forms/matrix.npy"},
         {}},
        {"envi-header",
         ".hdr",
         [](File f) {
             // The data beside it stay as they are.
             fs::path data = f;
             data.replace_extension(".img");
             std::ofstream(data, std::ios::binary) << std::string(48, '\0');
             irsg::readEnvi(f);
         },
         {strangers + "image-forms/envi.hdr"},
         {}},
        {"exr", ".exr", [](File f) { irsg::readExr(f); }, {}, {imageBytes(".exr")}},
        {"exr-parts",
         ".exr",
         [](File f) {
             irsg::exrParts(f);
             irsg::readExr(f, {.part = "2"});
         },
         {strangers + "multipart-exr/depth-first.exr"},
         {},
         16384},
        {"tiff", ".tif", [](File f) { irsg::readTiff(f); }, {}, {imageBytes(".tif")}},
        {"tiff-pages",
         ".tif",
         [](File f) {
             irsg::tiffPages(f);
             irsg::readTiff(f, {.page = 2});
         },
         {strangers + "multipage-tiff/two.tif"},
         {}},
        {"png", ".png", [](File f) { irsg::readPngPlane(f); }, {}, {imageBytes(".png")}},
        {"signature-json",
         ".json",
         [](File f) { irsg::signatureFromJson(irsg::readFile(f)); },
         {"samples/box/signature.json"},
         {}},
        {"signature-file",
         ".sigdb",
         [](File f) { irsg::loadSignatureFile(f); },
         {"samples/box/box.sigdb"},
         {},
         32768},
        {"json-text",
         ".json",
         [](File f) {
             const std::string text = irsg::readFile(f);
             const auto value =
                 irsg::parseJson(text, "a", {.expected = "JSON", .mayComment = true});
             const irsg::JsonPlaces places(text, true);
             for (const char* path : {"a", "a[1].range [m]", "0.0", ""}) {
                 places.position(path);
             }
             irsg::shownJson(value);
         },
         {},
         {"{\"a\": [1, {\"range [m]\": 2.5e3}], /* b */\n\"c\": \"\\u00e9\"} // d\n"}},
        {"scaling-xml",
         ".xml",
         [](File f) { irsg::readScalingFile(f, irsg::ScalingKind::temperature); },
         {"samples/ship/ship(temperaturesScalings).xml"},
         {}},
        {"karma-xml",
         ".xml",
         [](File f) { irsg::KarmaXml::read(f); },
         {air + "subarctic-winter.xml"},
         {},
         8192},
        {"smart-xml",
         ".xml",
         [](File f) { irsg::fromKarma(irsg::KarmaXml::read(f)); },
         {air + "subarctic-winter.xml"},
         {},
         8192},
        {"environment-xml",
         ".xml",
         [](File f) { irsg::environmentFromKarma(irsg::KarmaXml::read(f)); },
         {air + "tropical-maritime.xml"},
         {environmentText()},
         8192},
        {"sensor-xml",
         ".xml",
         [](File f) { imagingSensorFromKarma(irsg::KarmaXml::read(f)); },
         {"samples/flyby/ImagingSensor.xml"},
         {}},
        {"sensor",
         ".smatsensor",
         [](File f) { irsg::loadSensor(f); },
         {"resources/sensors/uncooled-bolometer.smatsensor",
          "resources/sensors/cooled-mwir.smatsensor"},
         {}},
        {"beer-lambert",
         ".csv",
         [](File f) { irsg::BeerLambert::fromCsv(f); },
         {},
         {linesOf(air + "haze-23km.csv", 60)}},
        {"spectra-csv",
         ".csv",
         [](File f) { irsg::SpectraAtmosphere::fromCsv(f); },
         {},
         {linesOf(air + "haze-23km.csv", 60), radiativeText()}},
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
        {"flight", ".flt", [](File f) { irsg::scanFlight(f); }, {"samples/box/box.flt"}, {}, 8192},
        {"obj", ".obj", [](File f) { irsg::Model::load(f); }, {}, {square}},
        {"stl", ".stl", [](File f) { irsg::Model::load(f); }, {}, {facet}},
        {"ply", ".ply", [](File f) { irsg::Model::load(f); }, {}, {polygons, packedPolygons()}},
        {"dxf", ".dxf", [](File f) { irsg::Model::load(f); }, {}, {drawing}},
    };
    static const bool isWhole = [] {
        for (const auto& some : {packedReaders(), keptReaders(), resultReaders()}) {
            list.insert(list.end(), some.begin(), some.end());
        }
        return true;
    }();
    static_cast<void>(isWhole);
    return list;
}

namespace {

/// A file that takes other bytes at every reading, in memory where the temporary folder is.
class ReadFile {
  public:
    explicit ReadFile(const std::string& extension) {
        const fs::path folder =
            fs::temp_directory_path() / ("smat-fuzz-" + std::to_string(getpid()));
        fs::create_directories(folder);
        path_ = folder / ("a" + extension);
        descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    }
    const fs::path& path() const { return path_; }
    void take(std::string_view bytes) const {
        // Cut last: a file that is emptied first is put on the disk at once by some file systems.
        const auto size = static_cast<ssize_t>(bytes.size());
        if (pwrite(descriptor_, bytes.data(), bytes.size(), 0) != size ||
            ftruncate(descriptor_, size) != 0) {
            throw std::runtime_error("no room for " + path_.string());
        }
    }

  private:
    fs::path path_;
    int descriptor_ = -1;
};

} // namespace

bool readBytes(const FuzzedReader& reader, std::string_view bytes) {
    static std::map<std::string, ReadFile> files;
    const ReadFile& file = files.try_emplace(reader.extension, reader.extension).first->second;
    file.take(bytes);
    try {
        reader.read(file.path());
        return true;
    } catch (const irsg::InputError& error) {
        for (const irsg::Diagnostic& diagnostic : error.diagnostics()) {
            if (diagnostic.value.empty() && diagnostic.expected.empty()) {
                throw std::logic_error("a refusal without a sentence");
            }
        }
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
