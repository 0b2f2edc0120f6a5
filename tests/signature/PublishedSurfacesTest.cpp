// The models of Sandford and Robertson and of Shell: energy, reciprocity and Kirchhoff's law
// against the published equations and sums of the tests' own.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/Fresnel.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/LitBall.h"
#include "irsg/signature/SandfordRobertson.h"
#include "irsg/signature/ShellTarget.h"
#include "irsg/signature/SurfaceModels.h"
#include "tests/signature/SurfaceSums.h"

namespace irsg {

namespace {

using namespace test;
using testing::HasSubstr;

Material paint(double emissivity, double diffuse, double width, double b) {
    Material material;
    material.emissivity = Spectrum::constant(emissivity);
    material.surfaceModel = "sandfordRobertson";
    material.diffuseReflectivity = Spectrum::constant(diffuse);
    material.roughness = width;
    material.grazingFactor = b;
    return material;
}

Material target(double sigma, double n, double k, double diffuse = 0.0, double volume = 0.0) {
    Material material;
    material.surfaceModel = "shellTarget";
    material.roughness = std::sqrt(2.0) * sigma;
    material.refractiveIndex = Spectrum::constant(n);
    material.extinction = Spectrum::constant(k);
    material.diffuseReflectivity = Spectrum::constant(diffuse);
    material.volumeReflectivity = Spectrum::constant(volume);
    return material;
}

} // namespace

TEST(SandfordRobertson, IsWhatWasPublished) {
    const Material material = paint(0.55, 0.15, 0.2, 0.35);
    const auto g = [](double angle_deg) {
        return 1.0 / (1.0 + 0.35 * 0.35 * std::pow(std::tan(radians(angle_deg)), 2));
    };
    const double b = 0.35 * 0.35, mean = (1.0 + b * std::log(b) / (1.0 - b)) / (1.0 - b);
    const double from_deg = 35.0, to_deg = 50.0, azimuth_deg = 170.0;
    const SurfaceDirection from = direction(from_deg), to = direction(to_deg, azimuth_deg);
    const double half = std::acos(halfway(from, to).z);
    const double h =
        1.0 / std::pow(0.04 * std::pow(std::cos(half), 2) + std::pow(std::sin(half), 2), 2);
    const double cosine = std::cos(radians(from_deg)), left = 1.0 - 0.04;
    const double H = (left * cosine + (0.08 + left * left * cosine * cosine) /
                                          std::sqrt(left * left * cosine * cosine + 0.16)) /
                     0.08;
    const double specular = 1.0 - (0.15 + 0.55) * g(from_deg) / mean;
    const double expected = 0.15 * g(from_deg) * g(to_deg) / (pi * mean * mean) +
                            specular * h / (4.0 * pi * H * std::cos(radians(to_deg)));
    EXPECT_NEAR(brdf_per_sr(material, to, from, 4.0) / expected, 1.0, 1e-12);
    EXPECT_NEAR(reflectanceOverAngle(material, std::cos(radians(60.0)), 4.0),
                1.0 - 0.55 * g(60.0) / mean, 1e-4);
    // G at b = 0, 1 and next to 1.
    for (const auto& [factor, value] : {std::pair{0.0, 1.0}, std::pair{1.0, 0.5}}) {
        EXPECT_NEAR(SandfordRobertson(paint(0.4, 0.1, 0.2, factor)).meanGrazing(), value, 1e-9);
    }
    EXPECT_NEAR(SandfordRobertson(paint(0.4, 0.1, 0.2, 0.9999)).meanGrazing(), 0.5, 1e-4);
}

TEST(SandfordRobertson, ReflectsAllThatIsNotEmittedAtEveryAngle) {
    for (const Material& material : {paint(0.0, 0.0, 0.2, 0.3), paint(0.5, 0.2, 0.05, 0.3),
                                     paint(0.3, 0.1, 0.6, 0.8), paint(0.0, 0.4, 0.3, 0.5)}) {
        for (const double angle_deg : {1.0, 30.0, 60.0, 75.0}) {
            const double expected =
                reflectanceOverAngle(material, std::cos(radians(angle_deg)), 4.0);
            EXPECT_NEAR(reflectedOf(material, angle_deg), expected, 1e-3) << angle_deg;
            if (material.emissivity.at(4.0) == 0.0) {
                EXPECT_NEAR(expected, 1.0, 1e-4);
            }
        }
        // Kirchhoff: what is hemispherical is the material's own number.
        const auto model = surfaceModelOf(material);
        const SurfaceModel::Amounts amounts = model->amountsAt(material, 4.0);
        double reflected = 0.0;
        for (std::size_t k = 0; k < model->components(); ++k) {
            reflected += amounts[k] * model->meanAlbedo(k);
        }
        EXPECT_NEAR(1.0 - reflected, material.emissivity.at(4.0), 1e-4);
    }
}

TEST(SandfordRobertson, KeepsItsLobeThatIsNotReciprocalAndLintShowsIt) {
    const Material material = paint(0.55, 0.15, 0.2, 0.35);
    EXPECT_GT(worstReciprocity(material), 0.1);
    EXPECT_THAT(findingsOf(material), HasSubstr("not reciprocal"));
    // Nothing but its diffuse part is left.
    Material diffuse = paint(0.6, 0.4, 0.2, 0.0);
    EXPECT_LT(worstReciprocity(diffuse), 1e-9);
    EXPECT_EQ(findingsOf(diffuse), "");
}

TEST(SandfordRobertson, ScalesItsEmissivityAtEveryAngle) {
    const Material material = paint(0.5, 0.2, 0.2, 0.3);
    const auto model = surfaceModelOf(material);
    const std::vector<double> inputs = {0.5, 0.0, 0.2};
    for (const double scale : {0.7, 1.2}) {
        const auto scaled = model->amounts(inputs, scale), nominal = model->amounts(inputs, 1.0);
        for (const double cosine : {0.1, 0.5, 1.0}) {
            EXPECT_NEAR(1.0 - model->reflected(scaled, cosine),
                        scale * (1.0 - model->reflected(nominal, cosine)), 1e-12);
        }
    }
}

TEST(ShellTarget, IsWhatWasPublished) {
    Material material = target(0.2, 1.4, 0.3, 0.1, 0.05);
    material.shadowTau_deg = 12.0;
    material.shadowOmega_deg = 50.0;
    const SurfaceDirection from = direction(40.0), to = direction(55.0, 160.0);
    const SurfaceDirection facet = halfway(from, to);
    const double tilt = std::acos(facet.z), beta = std::acos(dot(to, facet));
    const double shadowing = (1.0 + tilt / radians(50.0) * std::exp(-2.0 * beta / radians(12.0))) /
                             (1.0 + tilt / radians(50.0));
    const double variance = 0.04;
    const double lobe = std::exp(-std::pow(std::tan(tilt), 2) / (2.0 * variance)) /
                        (8.0 * pi * variance * std::pow(facet.z, 4) * from.z * to.z);
    const double fresnel = fresnelReflectivity(1.4, 0.3, std::cos(beta));
    const double expected =
        fresnel * lobe * shadowing + 0.1 / pi + 0.05 * 2.0 / (pi * (from.z + to.z));
    EXPECT_NEAR(brdf_per_sr(material, to, from, 4.0) / expected, 1.0, 0.006);
}

TEST(ShellTarget, IsReciprocalAndItsReflectanceIsItsIntegral) {
    const Material coat = target(0.2, 1.4, 0.3, 0.1, 0.05), metal = target(0.07, 2.7, 3.8);
    for (const Material& material : {coat, metal}) {
        EXPECT_LT(worstReciprocity(material), 1e-9);
        const auto model = surfaceModelOf(material);
        for (const double angle_deg : {1.0, 30.0, 60.0, 75.0}) {
            const double reflected =
                model->reflected(model->amountsAt(material, 4.0), std::cos(radians(angle_deg)));
            EXPECT_NEAR(reflectedOf(material, angle_deg) / reflected, 1.0, 2e-3) << angle_deg;
        }
    }
    // Not less than all light is lost where it shines along the surface: more is sent than comes.
    EXPECT_THAT(findingsOf(metal), HasSubstr("above 1 - t"));
    const auto model = surfaceModelOf(metal);
    const SurfaceModel::Amounts amounts = model->amountsAt(metal, 4.0);
    EXPECT_GT(model->reflected(amounts, 0.02), 1.001);
    EXPECT_LE(reflectanceOverAngle(metal, 0.02, 4.0), 1.0 + 1e-9);
    EXPECT_THAT(findingsOf(metal), HasSubstr("the model leaves along the normal"));
}

TEST(ShellTarget, AsksForAnIndex) {
    Material material = target(0.2, 0.0, 0.0);
    EXPECT_THROW(surfaceModelOf(material), InputError);
    EXPECT_THAT(findingsOf(material), HasSubstr("n and k"));
}

TEST(SurfaceModel, TakesFieldsThatThereAre) {
    for (const std::string& name : surfaceModelNames()) {
        EXPECT_FALSE(fieldsOfSurfaceModel(name).empty()) << name;
        for (const std::string& key : fieldsOfSurfaceModel(name)) {
            EXPECT_TRUE(std::ranges::any_of(materialFields(), [&](const auto& field) {
                return key == field.key;
            })) << key;
        }
    }
    EXPECT_TRUE(fieldsOfSurfaceModel("").empty());
}

TEST(LitBall, ShowsWhatAMaterialSends) {
    const SpectralRange band{3.0, 5.0};
    // Black: its own emission, everywhere alike.
    Material black;
    const LitBall dark = litBall(black, band, 21);
    const double own = dark.at(10, 10);
    EXPECT_NEAR(own, 1.87, 0.03); // a black body of 300 K in 3 to 5 um, W m-2 sr-1
    EXPECT_NEAR(dark.at(6, 6), own, 1e-12);
    EXPECT_TRUE(std::isnan(dark.at(0, 0)));
    // Lambertian: the sun by the cosine to it, on the side of the sun alone.
    Material white;
    white.emissivity = Spectrum::constant(0.0);
    const LitBall bright = litBall(white, band, 41);
    EXPECT_GT(bright.at(8, 11), 1.5 * bright.at(32, 30));
    // Polished: a glint where the normal is half way to the sun, at x = -0.29, y = 0.41.
    Material polished = white;
    polished.surfaceModel = "ggx";
    polished.roughness = 0.05;
    const LitBall ball = litBall(polished, band, 41);
    double largest = 0.0;
    int row = 0, column = 0;
    for (int i = 0; i < 41; ++i) {
        for (int j = 0; j < 41; ++j) {
            if (ball.at(i, j) > largest) {
                largest = ball.at(i, j);
                row = i;
                column = j;
            }
        }
    }
    EXPECT_GT(largest, 20.0 * own);
    EXPECT_NEAR(row, 20.5 * (1.0 - 0.41), 1.5);
    EXPECT_NEAR(column, 20.5 * (1.0 - 0.29), 1.5);
    EXPECT_NEAR(bandReflectance(polished, 0.5, band), 1.0, 1e-6);
}

} // namespace irsg
