// What an image file says of the analysis that it came from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/render/rays/RaysBuilt.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/AnalysisOfResult.h"
#include "smatcore/analysis/PixelExplainer.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using test::refusalOf;
using testing::HasSubstr;

const std::filesystem::path sphere =
    std::filesystem::path(SMAT_SOURCE_DIR) / "samples/sphere/sphere.smat";

AnalysisData drawn() {
    Settings settings;
    settings.set("sensor.width", "32");
    settings.set("sensor.height", "24");
    settings.set("camera.azimuth", "33.5");
    settings.set("render.engine", irsg::areRaysBuilt() ? "rays" : "auto");
    AnalysisData data = AnalysisData::of(loadProject(sphere), AnalysisKind::image, settings);
    SceneBuilder builder;
    AnalysisGenerator(openRenderDoor(), [&](const Project& project, const Settings& with) {
        return builder.build(project, with);
    }).run(data);
    return data;
}

TEST(AnalysisOfResult, SaysWhatItWasAskedFor) {
    if (!irsg::areRaysBuilt()) {
        GTEST_SKIP() << irsg::whyNoRays();
    }
    const AnalysisData data = drawn();
    // Its project beside it, or open.
    for (const bool isOpen : {false, true}) {
        const AnalysisData found = analysisOfImage(
            data.image,
            isOpen ? std::filesystem::path("/nowhere/a.exr") : sphere.parent_path() / "a.exr",
            isOpen ? std::vector<Project>{loadProject(sphere)} : std::vector<Project>{});
        EXPECT_EQ(found.settings.text("camera.azimuth"), "33.5");
        PixelExplainer explainer(found);
        EXPECT_EQ(explainer.drawn().image.primary().values, data.image.primary().values);
        const ExplainedPixel pixel = explainer.explain(16, 12);
        EXPECT_FALSE(pixel.computed.surfaces.empty());
        EXPECT_LT(std::abs(pixel.relative()), 1e-6);
        EXPECT_THAT(explanationText({pixel}, "rays"), HasSubstr("pixel 16,12"));
    }
}

TEST(AnalysisOfResult, SaysWhyItIsNotKnown) {
    if (!irsg::areRaysBuilt()) {
        GTEST_SKIP() << irsg::whyNoRays();
    }
    const AnalysisData data = drawn();
    struct Row {
        const char *name, *attribute, *value, *says;
    };
    for (const Row& row :
         {Row{"another program", "program", "hand 1.0", "does not say how"},
          {"no image", "analysis", "polar", "found polar"},
          {"a bare model", "project", "sphere", "bare model"},
          {"another project", "project", "gone.smat", "gone.smat"},
          {"unsaved edits", "database", "sphere.sigdb, with edits that are not saved", "edits"},
          {"another model", "model", "cube.flt", "sphere.flt"},
          {"another size", "sensor.width", "33", "32 x 24 pixels"}}) {
        irsg::RadianceImage image = data.image;
        image.attributes[row.attribute] = row.value;
        EXPECT_THAT(refusalOf([&] { analysisOfImage(image, sphere.parent_path() / "a.exr"); }),
                    HasSubstr(row.says))
            << row.name;
    }
}

TEST(AskedAnalysis, IsNoneOfMonteCarlo) {
    AnalysisData loaded;
    for (const auto& [key, value] :
         {std::pair("program", "smat 1"), std::pair("analysis", "polar"),
          std::pair("monte carlo", "64 draws of the sobol sequence, seed 3"),
          std::pair("project", "sphere.smat")}) {
        loaded.table.provenance.add(key, value);
    }
    EXPECT_THAT(refusalOf([&] { analysisOfResult(loaded, sphere.parent_path() / "draws.csv"); }),
                HasSubstr("draws.csv: monte carlo: found 64 draws of the sobol sequence, seed 3, "
                          "expected a result of one run"));
}

} // namespace
} // namespace smat
