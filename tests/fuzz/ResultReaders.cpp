#include <fstream>
#include <map>

#include <unistd.h>

#include "irsg/core/FileReading.h"
#include "irsg/image/ExrFile.h"
#include "smatcore/analysis/CaseFile.h"
#include "smatcore/analysis/MonteCarlo.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/project/FileCollection.h"
#include "smatcore/results/ResultFolder.h"
#include "smatcore/support/PartialFile.h"
#include "tests/fuzz/Readers.h"
#include "tests/fuzz/SeedTexts.h"

// Readers of results: tables, Monte Carlo runs and the folder in which a project keeps them.

namespace smat::test {

namespace {

namespace fs = std::filesystem;
using File = const fs::path&;

/// Two ranges, three draws at each.
MonteCarloData monteCarloRun() {
    MonteCarloData data;
    data.analysis = AnalysisData::of({}, AnalysisKind::range);
    data.options.samples = 3;
    data.options.subpixelShifts = 2;
    data.options.ranking = true;
    data.options.standardError = 0.01;
    data.options.rankingAt = 100.0;
    data.scalings = {{{0, irsg::ScalingKind::temperature, 3, 0.9, 1.1},
                      irsg::Distribution(irsg::DistributionKind::normal, 0.9, 1.1),
                      "skin"}};
    data.unit = "W sr-1";
    data.abscissaKey = "range";
    data.abscissaUnit = "m";
    data.abscissae = {100.0, 200.0};
    data.otherAxes = {{"power", "", {0.5, 1.0}}};
    data.bands = {""};
    data.values = {{1.0, 2.0, 3.0}, {2.0, 3.0, 4.0}};
    data.nominal = {2.0, 3.0};
    data.numericalError = {0.1, 0.1};
    data.statistic = {{2.0, 0.1, 1.8, 2.2}, {3.0, 0.1, 2.8, 3.2}};
    data.ranking = {{0, {0.9, 0.01, 0.88, 0.92}, {0.91, 0.01, 0.89, 0.93}}};
    ResultTable& table = data.analysis.table;
    table.provenance.add("analysis", "range");
    table.add("range", "m");
    table.add("power", "");
    table.add(data.columnKey("nominal", 0), "W sr-1");
    table.add(data.columnKey("error_numerical", 0), "W sr-1");
    table.addRow({100.0, 0.5, 2.0, 0.1});
    table.addRow({200.0, 1.0, 3.0, 0.1});
    return data;
}

/// A folder of results beside no project: a sweep, an image and a Monte Carlo run, whose numbers
/// any `.result` of that stem can speak of.
class Results {
  public:
    static const Results& all() {
        static const Results results;
        return results;
    }

    std::vector<std::string> words; ///< the `.result` of each
    std::string monteCarlo;         ///< the numbers of a Monte Carlo run

    /// Puts the numbers that a result may speak of beside its words.
    void putBeside(File wordsFile) const {
        for (const auto& [ending, bytes] : numbers_) {
            std::ofstream(fs::path(wordsFile).replace_extension().string() + ending,
                          std::ios::binary)
                << bytes;
        }
    }

  private:
    Results() {
        const fs::path parent =
            fs::temp_directory_path() / ("smat-fuzz-results-" + std::to_string(getpid()));
        fs::create_directories(parent);
        const ResultFolder folder(parent / "a.smat");
        const auto keep = [&](const ResultDocument& document) {
            const fs::path stem = folder.path() / folder.save(document);
            words.push_back(irsg::readFile(stem.string() + ".result"));
            for (const char* ending : {".json", ".exr", "-draws.exr"}) {
                if (fs::exists(stem.string() + ending)) {
                    numbers_[ending] = irsg::readFile(stem.string() + ending);
                }
            }
        };
        AnalysisData image = AnalysisData::of({}, AnalysisKind::image);
        image.image = irsg::RadianceImage(2, 1, "L", "W m-2 sr-1");
        image.table.add("pixels", "");
        image.table.addRow({2.0});
        image.summary = {{"Intensity", 2.5, "W sr-1"}};
        ResultDocument document{.title = "a",
                                .notes = "b",
                                .madeAt = "2026-11-23T07:02:11",
                                .data = std::make_shared<const AnalysisData>(std::move(image))};
        keep(document);
        const auto run = std::make_shared<const MonteCarloData>(monteCarloRun());
        document.data = {run, &run->analysis};
        document.monteCarlo = run;
        keep(document);
        document.monteCarlo = nullptr;
        document.origin = ResultDocument::Origin::difference;
        keep(document);
        // The numbers of the Monte Carlo run are a table as well, which the words may ask for.
        monteCarlo = irsg::readFile(folder.path() / "002-montecarlo.json");
        numbers_[".json"] = monteCarlo;
        fs::remove_all(parent);
    }
    std::map<std::string, std::string> numbers_;
};

void readWords(File file) {
    static const bool isBeside = [&] {
        Results::all().putBeside(file);
        return true;
    }();
    static_cast<void>(isBeside);
    const fs::path folder = file.parent_path();
    ResultFolder(folder.parent_path() / "a.smat", folder.filename().string())
        .load(file.stem().string());
}

void readMonteCarlo(File file) {
    static const irsg::RadianceImage realisations = realisationsImage(monteCarloRun());
    loadMonteCarlo(file, realisations);
}

/// A sweep of two cases, of which one is done.
AnalysisData sweep() {
    AnalysisData data = AnalysisData::of({}, AnalysisKind::range);
    data.table.add("range", "m");
    data.table.add("intensity", "W sr-1");
    data.table.provenance.add("analysis", "range");
    return data;
}

std::string casesText() {
    CaseFile::Options options;
    options.inputs = {{"a.sigdb", "00ff"}};
    const CaseRecord record{
        "range 100 m", {100.0, 2.5}, {"transmittance: a"}, {{"far", "a sentence", 1.5}}};
    return CaseFile::headText(sweep(), 2, options) + CaseFile::recordText(0, record);
}

/// The same with both cases, as one run leaves it.
std::string casesOfAllText() {
    return casesText() + CaseFile::recordText(1, {"range 200 m", {200.0, 1.5}, {}, {}});
}

void readCases(File file) {
    joinedCases({file});
    CaseFile::Options options;
    options.resumes = true;
    options.inputs = {{"a.sigdb", "00ff"}};
    CaseFile(file, options).rehearse(sweep(), 2);
}

} // namespace

std::vector<FuzzedReader> resultReaders() {
    return {
        {"result-csv",
         ".csv",
         [](File f) { ResultTable::load(f); },
         {},
         {"# program: smat 1\nrange [m],intensity [W sr-1]\n100,1\n200,2\n"}},
        {"result-json", ".json", [](File f) { ResultTable::load(f); }, {}, {resultJsonText()}},
        {"cases", ".cases", readCases, {}, {casesText(), casesOfAllText()}},
        {"partial-result",
         ".csv",
         [](File f) { isPartialResult(f); },
         {},
         {"# program: smat 1\n# state: partial\nrange [m]\n100\n"}},
        {"named-files",
         ".gltf",
         [](File f) { filesNamedBy(f); },
         {},
         {"{\"buffers\": [{\"uri\": \"a.bin\"}, {\"uri\": \"..\\\\b%20c.bin\"}]}\n<a>b.xml</a>\n"}},
        {"monte-carlo", ".json", readMonteCarlo, {}, {Results::all().monteCarlo}, 8192},
        {"result-words", ".result", readWords, {}, Results::all().words, 8192},
    };
}

} // namespace smat::test
