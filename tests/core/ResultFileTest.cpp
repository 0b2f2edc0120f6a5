#include "smatcore/analysis/ResultFile.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using irsg::Quantity;
using testing::HasSubstr;

class ResultFileTest : public testing::Test {
  protected:
    static AnalysisData polar() {
        AnalysisData data;
        data.kind = AnalysisKind::polar;
        data.name = "round";
        data.state = AnalysisState::partial;
        for (const auto& [key, value] :
             {std::pair("analysis", "polar"), std::pair("name", "round"),
              std::pair("state", "partial"), std::pair("command", "smat-batch polar x.smat"),
              std::pair("renderer", "llvmpipe"), std::pair("answered by", "transmittance: vacuum"),
              std::pair("warning", "stopped after 2 of 9 cases")}) {
            data.table.provenance.add(key, value);
        }
        data.table.add(Quantity::angle);
        data.table.add(Quantity::contrastIntensity);
        data.table.addRow({0.0, 12.5});
        data.table.addRow({40.0, 0.1});
        return data;
    }
    std::string refusal(const std::string& name, const std::string& content) {
        std::ofstream(folder / name) << content;
        try {
            loadResult(folder / name);
        } catch (const irsg::InputError& error) {
            return error.what();
        }
        return "";
    }
    const test::TemporaryFolder folder;
};

TEST_F(ResultFileTest, GivesATableBackWithAllThatWasSaidOfIt) {
    const AnalysisData saved = polar();
    for (const char* name : {"p.csv", "p.json"}) {
        saveResult(saved, folder / name);
        const AnalysisData read = loadResult(folder / name);
        EXPECT_EQ(read.table, saved.table) << name;
        EXPECT_EQ(read.kind, AnalysisKind::polar) << name;
        EXPECT_EQ(read.name, "round") << name;
        EXPECT_EQ(read.state, AnalysisState::partial) << name;
        EXPECT_EQ(read.commandLine, "smat-batch polar x.smat") << name;
        EXPECT_EQ(read.renderer, "llvmpipe") << name;
        EXPECT_THAT(read.warnings, testing::ElementsAre("stopped after 2 of 9 cases")) << name;
        EXPECT_THAT(read.providedBy, testing::ElementsAre("transmittance: vacuum")) << name;
        EXPECT_FALSE(read.summary.empty()) << name;
    }
}

TEST_F(ResultFileTest, KnowsMonteCarloByItsDrawsAndNotByWhatItRepeats) {
    AnalysisData saved = polar();
    saved.table.provenance.add("monte carlo", "64 draws of the sobol sequence, seed 3");
    for (const char* name : {"m.csv", "m.json"}) {
        saveResult(saved, folder / name);
        EXPECT_EQ(loadResult(folder / name).kind, AnalysisKind::monteCarlo) << name;
    }
    Provenance difference;
    difference.add("analysis", "difference");
    difference.add("a.analysis", "polar");
    EXPECT_EQ(resultKindOf(difference), AnalysisKind::polar);
    difference.add("a.monte carlo", "64 draws of the sobol sequence, seed 3");
    EXPECT_EQ(resultKindOf(difference), AnalysisKind::monteCarlo);
}

TEST_F(ResultFileTest, KnowsFramesOfASimulationFromOtherImages) {
    AnalysisData saved;
    saved.image = irsg::RadianceImage(3, 2);
    for (const auto& [analysis, kind] :
         {std::pair("simulate", AnalysisKind::simulation), std::pair("image", AnalysisKind::image),
          std::pair("polar", AnalysisKind::image)}) {
        saved.image.attributes["analysis"] = analysis;
        saveResult(saved, folder / "first.exr");
        const AnalysisData read = loadResult(folder / "first.exr");
        EXPECT_EQ(read.kind, kind) << analysis;
        EXPECT_FALSE(read.summary.empty()) << analysis;
        // It is written again as every image is.
        saveResult(read, folder / "again.exr");
        EXPECT_EQ(loadResult(folder / "again.exr").kind, kind) << analysis;
    }
}

TEST_F(ResultFileTest, GivesAnImageBackFromEveryDataFormat) {
    AnalysisData saved;
    saved.kind = AnalysisKind::image;
    saved.image = irsg::RadianceImage(3, 2);
    saved.image.primary().values = {1.0F, 2.5F, -3.0F, 0.0F, 1e-20F, 7.0F};
    saved.image.attributes["name"] = "picture";
    for (const char* name : {"i.exr", "i.csv"}) {
        saveResult(saved, folder / name);
        const AnalysisData read = loadResult(folder / name);
        EXPECT_EQ(read.kind, AnalysisKind::image) << name;
        EXPECT_EQ(read.image.primary().values, saved.image.primary().values) << name;
        EXPECT_EQ(read.name, "picture") << name;
    }
    // A plain matrix of another program is an image as well.
    for (const char* name : {"matrix.csv", "karma.txt", "karma.dat"}) {
        std::ofstream(folder / name) << "nan 2\n3 4\n5 6\n";
        EXPECT_EQ(loadResult(folder / name).image.height(), 3) << name;
    }
}

TEST_F(ResultFileTest, RefusesWhatIsNoResult) {
    EXPECT_THAT(
        refusal("a.xml", "x"),
        HasSubstr(".exr, .csv, .txt, .dat, .tif, .tiff, .hdr, .img, .raw, .bsq, .bil, .bip, "
                  ".asc, .grd, .pfm, .npy or .json"));
    EXPECT_THAT(refusal("a.txt", "range [m],L\n1,2\n"), HasSubstr("a table of results"));
    EXPECT_THAT(refusal("b.csv", "range [m],intensity [W sr-1]\n"), HasSubstr("without rows"));
    EXPECT_THAT(refusal("c.csv", "range [m],intensity [W sr-1]\n1,seven\n"), HasSubstr("seven"));
    EXPECT_THAT(refusal("d.json", "{"), HasSubstr("d.json"));
    EXPECT_THAT(refusal("e.exr", "no"), HasSubstr("e.exr"));
    EXPECT_THROW(loadResult(folder / "missing.csv"), irsg::InputError);
}

} // namespace
} // namespace smat
