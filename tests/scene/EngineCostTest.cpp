// The rule of render.engine auto against what was measured (bench_rays engines).
#include <gtest/gtest.h>

#include <cmath>

#include "irsg/scene/EngineCost.h"

using namespace irsg;

namespace {

/// A sphere that covers 35 % of a picture, as the benchmark has it.
EngineWork sphere(double facets, double samples) {
    return {facets, samples, 0.35 * samples, 0.0};
}

} // namespace

TEST(EngineCostTest, TakesTheEngineThatWasQuicker) {
    struct Row {
        double facets, samples, openGl_ms, rays_ms;
    };
    // Processor time of frames without shadows and lobes, which take the same beside both.
    for (const Row& row : {Row{1e3, 4096, 0.42, 0.78}, Row{1e3, 65536, 2.02, 9.26},
                           Row{1e3, 409600, 7.19, 54.09}, Row{1e4, 4096, 2.20, 0.76},
                           Row{1e4, 65536, 5.03, 10.56}, Row{1e4, 409600, 12.84, 57.64}}) {
        const EngineWork work = sphere(row.facets, row.samples);
        EXPECT_EQ(quickerEngine(work),
                  row.openGl_ms <= row.rays_ms ? EngineChoice::opengl : EngineChoice::rays)
            << row.facets << " facets, " << row.samples << " samples";
        // A cost model of a handful of numbers.
        EXPECT_LT(std::abs(std::log(openGlCost_ms(work) / row.openGl_ms)), std::log(2.0))
            << row.facets << " " << row.samples << ": " << openGlCost_ms(work);
        EXPECT_LT(std::abs(std::log(raysCost_ms(work) / row.rays_ms)), std::log(2.0))
            << row.facets << " " << row.samples << ": " << raysCost_ms(work);
    }
}

TEST(EngineCostTest, LeavesSmallPicturesOfLargeModelsToRays) {
    EXPECT_EQ(quickerEngine(sphere(2e4, 4096)), EngineChoice::rays);
    EXPECT_EQ(quickerEngine(sphere(2e4, 409600)), EngineChoice::opengl);
    EXPECT_EQ(quickerEngine(sphere(2e6, 409600)), EngineChoice::rays);
    EXPECT_EQ(quickerEngine({0.0, 64.0, 0.0, 0.0}), EngineChoice::rays);
}

TEST(EngineCostTest, GrowsWithAllThatThereIsToDo) {
    const EngineWork few{1e3, 1e4, 3e3, 0.5};
    for (double EngineWork::*of :
         {&EngineWork::facets, &EngineWork::samples, &EngineWork::covered, &EngineWork::layers}) {
        EngineWork more = few;
        more.*of *= 2.0;
        EXPECT_GT(openGlCost_ms(more), openGlCost_ms(few));
        EXPECT_GT(raysCost_ms(more), raysCost_ms(few));
    }
}

TEST(EngineCostTest, SaysWhatItIsMadeOf) {
    const std::string words = wordsOf({1540.0, 65536.0, 9000.0, 0.7});
    EXPECT_NE(words.find("1540 facets, 65536 samples, 0.7 layers before one"), std::string::npos)
        << words;
    EXPECT_NE(words.find("by rays"), std::string::npos) << words;
}
