#include "irsg/scattering/MtfBuild.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/scattering/PhaseFunction.h"

namespace irsg {
namespace {

MtfRecipe small() {
    MtfRecipe recipe;
    recipe.sizes = SizeDistribution::single(5.0);
    recipe.wavelength_um = 10.0;
    recipe.opticalDepths = {0.5, 2.0};
    recipe.frequencies = 21;
    recipe.highestFrequency_per_rad = 1000.0;
    return recipe;
}

MtfRecipe traced() {
    MtfRecipe recipe = small();
    recipe.method = MtfRecipe::Method::monteCarlo;
    recipe.photons = 90'000;
    return recipe;
}

TEST(MtfBuild, MakesADatabaseThatCanBeRead) {
    const auto file = std::filesystem::temp_directory_path() / "built.mtf";
    const BuiltMtf built = buildMtf(small());
    built.database.write(file);
    const MtfDatabase read = MtfDatabase::read(file);
    EXPECT_NEAR(1e6 * read.header().particleDiameter_m, 10.0, 1e-9);
    EXPECT_NEAR(read.header().wavelength_um(), 10.0, 1e-9);
    EXPECT_NEAR(read.values(1).front(), std::exp(2.0 * built.forwardFraction), 1e-6);
    EXPECT_GT(built.asymmetry, 0.5);
}

TEST(MtfBuild, TellsHowFarItIs) {
    std::vector<double> told;
    buildMtf(traced(), [&](double part) {
        told.push_back(part);
        return true;
    });
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GT(told.size(), 8u);
    EXPECT_EQ(told.back(), 1.0);
}

TEST(MtfBuild, IsCancelledAndGoesOnWithTheSameResult) {
    const auto file = std::filesystem::temp_directory_path() / "resume.part";
    std::filesystem::remove(file);
    const BuiltMtf whole = buildMtf(traced());
    EXPECT_THROW(buildMtf(
                     traced(), [](double part) { return part < 0.6; }, file),
                 Cancelled);
    ASSERT_TRUE(std::filesystem::exists(file));
    std::ifstream in(file);
    int lines = 0;
    for (std::string line; std::getline(in, line);) {
        ++lines;
    }
    EXPECT_GT(lines, 3);
    // A kill cuts the last line short.
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 9);
    const BuiltMtf resumed = buildMtf(traced(), {}, file);
    EXPECT_EQ(resumed.database.values(0), whole.database.values(0));
    EXPECT_EQ(resumed.database.values(1), whole.database.values(1));
    EXPECT_EQ(resumed.standardErrors, whole.standardErrors);
}

TEST(MtfBuild, TakesNothingOfAnotherRecipe) {
    const auto file = std::filesystem::temp_directory_path() / "other.part";
    MtfRecipe other = traced();
    other.seed = 99;
    buildMtf(other, {}, file);
    EXPECT_EQ(buildMtf(traced(), {}, file).database.values(1),
              buildMtf(traced()).database.values(1));
}

TEST(MtfBuild, DoesNotDependOnTheNumberOfThreads) {
    const BuiltMtf many = buildMtf(traced());
    setMostThreads(1);
    const BuiltMtf one = buildMtf(traced());
    setMostThreads(0);
    EXPECT_EQ(many.database.values(0), one.database.values(0));
}

TEST(MtfBuild, TakesAnAerosolByItsMeanOptics) {
    MtfRecipe recipe = small();
    recipe.aerosol = HazeAerosol{"an aerosol", 0.9, 0.74};
    const BuiltMtf built = buildMtf(recipe);
    // Henyey and Greenstein's function in closed form: its asymmetry, and what it sends forward.
    const double g = 0.74;
    const double forward =
        (1.0 - g * g) / (2.0 * g) * (1.0 / (1.0 - g) - 1.0 / std::sqrt(1.0 + g * g));
    EXPECT_NEAR(built.asymmetry, g, 1e-5);
    EXPECT_NEAR(built.forwardFraction, forward, 1e-5);
    EXPECT_EQ(built.albedo, 0.9);
    EXPECT_EQ(built.database.header().particleDiameter_m, 0.0) << "unknown";
    EXPECT_NEAR(built.database.values(1).front(), std::exp(2.0 * forward), 1e-4);
    EXPECT_NEAR(built.database.values(1).back(), 1.0, 0.01);

    recipe.aerosol->asymmetry = 0.99;
    recipe.aerosol->albedo = 1.1;
    try {
        buildMtf(recipe);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 2u) << error.what();
    }
}

TEST(MtfBuild, RefusesAllThatIsWrongAtOnce) {
    MtfRecipe wrong = small();
    wrong.wavelength_um = 20.0;
    wrong.opticalDepths = {2.0, 1.0};
    wrong.sizes.radius_um = -1.0;
    wrong.layers = {{1.0, 0.0}};
    wrong.photons = 0;
    try {
        buildMtf(wrong);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 5u) << error.what();
    }
}

} // namespace
} // namespace irsg
