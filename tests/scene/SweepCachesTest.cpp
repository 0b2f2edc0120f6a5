// What is kept from case to case is keyed by values: whatever changes between two cases, a renderer
// that has seen others says what a new one says, bit by bit.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/radiance/PlanckTable.h"
#include "irsg/radiance/RadiometryCache.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/scene/Renderer.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/WidebandScenes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes body{1, 1}, gas{2, 2};

/// Air of which every answer depends on every number of its query.
class SensitiveAtmosphere : public Atmosphere {
  public:
    explicit SensitiveAtmosphere(double density = 1.0) : density_(density) {}

    std::string name() const override { return "sensitive air"; }
    SpectralRange base() const override { return {0.2, 40.0}; }
    bool supports(AtmosphereProperty) const override { return true; }
    bool dependsOnAzimuth(AtmosphereProperty property) const override { return hasSun(property); }
    double ambientTemperature_K(double altitude_m) const override {
        return 290.0 - 0.0065 * altitude_m;
    }

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query, const SpectralRange&) const override {
        const auto& numbers = query.key(true).numbers;
        double depth = 0.0;
        const double weights[] = {3e-5, 2e-5, 3e-3, 0.2, 0.1, 0.3, 0.4};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            depth += weights[i] * numbers[i];
        }
        const double value = query.quantity == AtmosphereProperty::transmittance
                                 ? std::exp(-density_ * depth)
                                 : 2.0 + std::sin(density_ * depth);
        return Spectrum({0.2, 3.0, 4.0, 40.0}, {value, value, 0.5 * value, value});
    }

  private:
    double density_;
};

/// A sphere in a box of gas, whose measured spectrum depends on time and aspect.
SignatureDatabase bodyInPlume() {
    SignatureDatabase database;
    database.temperatures[1] = TemperatureEntry{};
    database.temperatures[1].terms = TemperatureTerms::ofAmbient();
    database.temperatures[1].terms.power = LookupTable({0.0, 1.0}, {0.0, 200.0});
    database.temperatures[1].terms.altitude = LookupTable({800.0, 1200.0}, {40.0, 80.0});
    database.temperatures[2].mode = EmissionMode::userSpectrum;
    database.temperatures[2].userSpectrum = "plume";
    database.temperatures[2].factors = {
        {"hot", 1.0, LookupTable({0.0, 10.0}, {1.0, 3.0}), LookupTable({0.0, 180.0}, {1.0, 2.0})}};
    database.spectra["plume"] = {"plume",
                                 20.0,
                                 "",
                                 "",
                                 {{"hot", Spectrum({2.0, 4.0, 15.0}, {0.1, 0.9, 0.2})},
                                  {"cold", Spectrum({2.0, 4.5, 15.0}, {0.2, 0.1, 0.3})}}};
    database.materials[1] = greyMaterial(0.7);
    database.materials[2] = greyMaterial(0.3, 0.6);
    return database;
}

struct Case {
    Scene scene;
    SensorView view;
    std::vector<Band> bands;

    void seeFrom(double range_m, double azimuth_rad, double elevation_rad, double aside = 0.0) {
        const Vec3 target = scene.entities.front().pose.position_m;
        view.viewpoint = Viewpoint::lookAt(target + direction(azimuth_rad, elevation_rad) * range_m,
                                           target + Vec3{aside, 0.0, aside}, {0, 0, 1}, {1, 0, 0});
    }
};

Case first(bool inVacuum = false) {
    Case one;
    one.scene.settings = RenderSettings::direct();
    one.scene.environment = inVacuum ? Environment::vacuum() : Environment();
    if (!inVacuum) {
        one.scene.environment.add(std::make_shared<SensitiveAtmosphere>());
    }
    one.scene.environment.sun = {1.0, 0.6};
    Entity entity = entityOf(modelOf(joined(sphereMesh(1.0, 12, 24, body),
                                            boxMesh({3, 3, 3}, std::vector<IrCodes>(6, gas)))),
                             bodyInPlume());
    entity.pose.position_m = {0, 0, standingAltitude_m};
    one.scene.entities = {entity};
    one.view.sensor = sensorOf(48, 48, 3.0);
    one.bands = {Band::topHat(3.0, 5.0), Band::topHat(4.2, 4.5)};
    one.seeFrom(150.0, 0.4, 0.3);
    return one;
}

struct Change {
    const char* name;
    std::function<void(Case&)> make;
};

/// One for every input of the keys.
const std::vector<Change> changes{
    {"range", [](Case& one) { one.seeFrom(150.5, 0.4, 0.3); }},
    {"elevation", [](Case& one) { one.seeFrom(150.0, 0.4, 0.31); }},
    {"azimuth, by which this air answers", [](Case& one) { one.seeFrom(150.0, 1.4, 0.3); }},
    {"centre of the field", [](Case& one) { one.seeFrom(150.0, 0.4, 0.3, 0.1); }},
    {"inside of a reference distance", [](Case& one) { one.seeFrom(15.0, 0.4, 0.3); }},
    {"altitude",
     [](Case& one) {
         one.scene.entities[0].pose.position_m.z = 900.0;
         one.seeFrom(150.0, 0.4, 0.3);
     }},
    {"heading", [](Case& one) { one.scene.entities[0].pose.attitude.yaw_rad = 0.7; }},
    {"time", [](Case& one) { one.scene.entities[0].state.time_s = 4.0; }},
    {"power", [](Case& one) { one.scene.entities[0].state.power = 0.5; }},
    {"Mach number",
     [](Case& one) {
         one.scene.entities[0].state.mach = 0.8;
         one.scene.entities[0].state.power = 0.2;
     }},
    {"scale of a temperature", [](Case& one) { one.scene.entities[0].temperatureScale[1] = 1.1; }},
    {"scale of an emissivity", [](Case& one) { one.scene.entities[0].emissivityScale[2] = 0.9; }},
    {"database",
     [](Case& one) {
         SignatureDatabase other = bodyInPlume();
         other.materials[1] = greyMaterial(0.4);
         one.scene.entities[0].database = std::make_shared<const SignatureDatabase>(other);
     }},
    {"model",
     [](Case& one) {
         one.scene.entities[0].model = modelOf(joined(
             sphereMesh(1.2, 12, 24, body), boxMesh({3, 3, 3}, std::vector<IrCodes>(6, gas))));
     }},
    {"another object",
     [](Case& one) {
         Entity other = one.scene.entities[0];
         other.pose.position_m.y += 4.0;
         one.scene.entities.push_back(other);
     }},
    {"bands",
     [](Case& one) {
         one.bands = {Band::topHat(3.0, 5.0), Band::topHat(8, 9)};
     }},
    {"order of the bands", [](Case& one) { std::ranges::reverse(one.bands); }},
    {"atmosphere",
     [](Case& one) {
         one.scene.environment = Environment();
         one.scene.environment.add(std::make_shared<SensitiveAtmosphere>(1.3));
         one.scene.environment.sun = {1.0, 0.6};
     }},
    {"azimuth of the sun", [](Case& one) { one.scene.environment.sun.azimuth_rad = 2.0; }},
    {"elevation of the sun", [](Case& one) { one.scene.environment.sun.elevation_rad = 0.2; }},
    {"sun off", [](Case& one) { one.scene.settings.sun = ReflectionMode::off; }},
    {"fluxes off", [](Case& one) { one.scene.settings.ambientReflection = ReflectionMode::off; }},
    {"no background", [](Case& one) { one.scene.settings.background = BackgroundMode::none; }},
    {"constant background",
     [](Case& one) {
         one.scene.settings.background = BackgroundMode::constant;
         one.scene.settings.background_W_m2_sr = 3.0;
     }},
    {"another constant background",
     [](Case& one) {
         one.scene.settings.background = BackgroundMode::constant;
         one.scene.settings.background_W_m2_sr = 4.0;
     }},
    {"slices", [](Case& one) { one.scene.settings.atmosphereSliceFrom = 1e9; }},
};

/// All that is told of a case.
auto told(Renderer& renderer, const Case& one) {
    std::vector<double> numbers;
    std::vector<std::string> lines;
    for (const RenderReport& report :
         renderer.render(one.scene, one.view, Outputs::reports(one.bands)).reports) {
        numbers.insert(numbers.end(), {report.totalIrradiance_W_m2, report.background_W_m2_sr});
        std::vector<ObjectRadiometry> objects = report.objects;
        objects.push_back(report.all);
        for (const ObjectRadiometry& object : objects) {
            numbers.insert(numbers.end(), {object.intensity_W_sr, object.contrastIntensity_W_sr,
                                           object.irradiance_W_m2, object.coveredPixels,
                                           object.solidAngle_sr, object.atmosphereError});
        }
        lines.insert(lines.end(), report.providedBy.begin(), report.providedBy.end());
        lines.insert(lines.end(), report.warnings.begin(), report.warnings.end());
    }
    return std::pair{numbers, lines};
}

} // namespace

TEST(CachesOfASweep, AreSeenByNobodyWhateverChangesFromCaseToCase) {
    // In vacuum other paths have equal air, and scenes are found again by the values of it.
    for (const bool inVacuum : {false, true}) {
        Renderer warm;
        const Case base = first(inVacuum);
        const auto ofBase = told(warm, base);
        for (const Change& change : changes) {
            const std::string where =
                inVacuum ? std::string(change.name) + " in vacuum" : change.name;
            Case changed = base;
            change.make(changed);
            Renderer fresh;
            const auto expected = told(fresh, changed);
            EXPECT_TRUE(inVacuum || expected.first != ofBase.first) << where << " changes nothing";
            EXPECT_EQ(told(warm, changed), expected) << where;
            EXPECT_EQ(told(warm, base), ofBase) << "after " << where;
        }
    }
}

TEST(CachesOfASweep, AreSeenByNobodyInTheTurnOfAnAspect) {
    Renderer warm;
    const Case base = first();
    for (int i = 0; i < 24; ++i) {
        Case one = base;
        one.seeFrom(150.0, 0.5 * i, 0.3);
        Renderer fresh;
        EXPECT_EQ(told(warm, one), told(fresh, one)) << i;
    }
}

TEST(CachesOfASweep, AreSeenByNobodyWhereSurfacesLightEachOther) {
    // About the sun path radiance alone changes, and what surfaces send each other is found again.
    Renderer warm;
    std::vector<PendingRender> begun;
    std::vector<Case> cases;
    const auto intensitiesOf = [](const Rendered& rendered) {
        std::vector<double> all;
        for (const RenderReport& report : rendered.reports) {
            all.insert(all.end(), {report.all.intensity_W_sr, report.all.contrastIntensity_W_sr,
                                   report.all.irradiance_W_m2,
                                   report.all.errors.value().intensity_W_sr.sum()});
        }
        return all;
    };
    Case base = first();
    base.scene.settings.bounces = 2;
    base.scene.settings.atmosphereSliceFrom = 1e9; // as many slices about the sun
    base.scene.settings.errors = true;
    base.scene.entities[0].model =
        modelOf(joined(sphereMesh(1.0, 12, 24, body), boxMesh({1, 1, 4}, std::vector(6, body))));
    for (int i = 0; i < 8; ++i) {
        Case one = base;
        one.seeFrom(150.0, 0.8 * i, 0.3);
        begun.push_back(warm.begin(one.scene, one.view, Outputs::reports(one.bands)));
        cases.push_back(std::move(one));
    }
    for (const std::size_t i : {7, 0, 3, 1, 6, 2, 5, 4}) {
        Renderer fresh;
        const Case& one = cases[i];
        EXPECT_EQ(intensitiesOf(begun[i].get()),
                  intensitiesOf(fresh.render(one.scene, one.view, Outputs::reports(one.bands))))
            << i;
    }
}

TEST(RadiometryCache, KeepsWhatDiffersByPathRadianceAlone) {
    const Case base = first();
    AtmosphericQueryCache answers;
    answers.setEnvironment(base.scene.environment);
    SceneSampling sampling;
    SampledScenes scenes;
    RadiometryCache cache;
    const OccluderStacks occluderStacks;
    const RadianceTerms& terms = RadianceTerms::standard();
    struct Seen {
        std::shared_ptr<EvaluatedScene> scene;
        std::shared_ptr<const SampledScene> sampled;
        double constant = 0.0, perFactor = 0.0;
    };
    const auto at = [&](RadiometryCache& of, double range_m, double azimuth_rad) {
        ObjectGeometry geometry;
        geometry.path = {1100.0, 1000.0, range_m, azimuth_rad};
        geometry.nearest_m = range_m - 2.0;
        geometry.farthest_m = range_m + 2.0;
        std::vector<ObjectGeometry> all{geometry};
        Seen seen;
        seen.sampled = scenes.of(
            answers,
            {terms, base.scene.entities, all, base.scene.settings, {1100.0, 0.0, azimuth_rad}},
            {Band::topHat(3.0, 5.0)}, false,
            [&](const AtmosphereScene& scene, const std::vector<Band>& bands) {
                return sampling.spectral(answers, scene, bands);
            });
        all.front().slices_m = seen.sampled->slices_m.front();
        seen.scene = of.of(terms, base.scene.entities, all, seen.sampled, occluderStacks);
        const SurfaceStackId kind{0, 0};
        seen.scene->radiances.prepare({kind});
        seen.constant = seen.scene->radiances.of(kind).constant;
        seen.perFactor = seen.scene->radiances.of(kind).perFactor[0];
        return seen;
    };
    const auto told = [](const Seen& seen) { return std::pair{seen.constant, seen.perFactor}; };
    const auto alone = [&](double range_m, double azimuth_rad) {
        RadiometryCache own;
        return told(at(own, range_m, azimuth_rad));
    };
    const Seen one = at(cache, 150.0, 0.3), other = at(cache, 150.0, 1.9);
    EXPECT_EQ(other.scene, one.scene);
    EXPECT_NE(other.constant, one.constant);
    EXPECT_EQ(other.perFactor, one.perFactor);
    EXPECT_EQ(told(other), alone(150.0, 1.9));
    // Another frame turns it back.
    one.scene->seeAlong(one.sampled);
    one.scene->radiances.prepare({{0, 0}});
    EXPECT_EQ(one.scene->radiances.of({0, 0}).constant, one.constant);
    EXPECT_EQ(told(one), alone(150.0, 0.3));
    EXPECT_NE(at(cache, 150.5, 0.3).scene, one.scene);
}

TEST(SampledScenes, AreFoundAgainOnlyWhereTheAirIsTheSame) {
    const Case base = first();
    AtmosphericQueryCache answers;
    answers.setEnvironment(base.scene.environment);
    SceneSampling sampling;
    SampledScenes scenes;
    int sampled = 0;
    const auto at = [&](double range_m, double azimuth_rad) {
        ObjectGeometry geometry;
        geometry.path = {1100.0, 1000.0, range_m, azimuth_rad};
        geometry.nearest_m = range_m - 2.0;
        geometry.farthest_m = range_m + 2.0;
        const std::vector<ObjectGeometry> all{geometry};
        return scenes.of(answers,
                         {RadianceTerms::standard(),
                          base.scene.entities,
                          all,
                          base.scene.settings,
                          {1100.0, 0.0, azimuth_rad}},
                         {Band::topHat(3.0, 5.0)}, false,
                         [&](const AtmosphereScene& scene, const std::vector<Band>& bands) {
                             ++sampled;
                             return sampling.spectral(answers, scene, bands);
                         });
    };
    const auto one = at(150.0, 0.3);
    EXPECT_EQ(at(150.0, 0.3), one);
    EXPECT_EQ(sampled, 1);
    // Left and right of the sun the air is the same.
    EXPECT_EQ(at(150.0, 2.0 * base.scene.environment.sun.azimuth_rad - 0.3), one);
    EXPECT_NE(at(150.0, 0.4), one);
    EXPECT_NE(at(151.0, 0.3), one);
    EXPECT_EQ(sampled, 3);
    // However many there were, what is found is what was asked for.
    for (int i = 0; i < 40; ++i) {
        at(200.0 + i, 0.3);
    }
    const auto again = at(150.0, 0.3);
    ASSERT_EQ(again->bands.size(), 1u);
    EXPECT_EQ(again->bands[0].air.objects, one->bands[0].air.objects);
    EXPECT_EQ(again->slices_m, one->slices_m);
    EXPECT_EQ(*again->background, *one->background);
}

TEST(SampledScenes, AskTheAirOnceForBandsNextToEachOther) {
    const Case base = first();
    AtmosphericQueryCache answers;
    SceneSampling sampling;
    ObjectGeometry object;
    object.path = {1100.0, 1000.0, 150.0, 0.3};
    object.nearest_m = 148.0;
    object.farthest_m = 152.0;
    const std::vector<ObjectGeometry> geometry{object};
    const AtmosphereScene scene{RadianceTerms::standard(),
                                base.scene.entities,
                                geometry,
                                base.scene.settings,
                                {1100.0, 0.0, 0.3}};
    const auto outputsOf = [&](const Environment& environment) {
        answers.setEnvironment(environment);
        std::vector<std::size_t> outputs;
        for (const SampledBand& band : sampling.spectral(
                 answers, scene,
                 {Band::topHat(3.0, 3.2), Band::topHat(3.2, 3.4), Band::topHat(3.5, 3.6),
                  Band::topHat(3.1, 3.3), Band::topHat(4.4, 4.5), Band::topHat(8.0, 9.0)})) {
            outputs.push_back(band.outputs.size());
            EXPECT_EQ(band.areas_um.size(), band.outputs.size());
        }
        return outputs;
    };
    // Those that go back, and those that are far from the one before, begin anew.
    AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMax_um = 10.0;
    const auto air = std::make_shared<AtmosphereSmart>(parameters, "own");
    EXPECT_EQ(outputsOf(environmentOf(air)), (std::vector<std::size_t>{3, 1, 1, 1}));
    EXPECT_EQ(outputsOf(Environment::vacuum()), std::vector<std::size_t>(6, 1)) << "no nodes";
}

TEST(CachesOfASweep, LetAirGoThatNobodyHasAnyMore) {
    Renderer renderer;
    Case one = first();
    // Computed air holds its table of gases, and so does whatever computes on after it.
    const auto opened = [&](CalculationMode mode) {
        auto gases = GasTable::read(atmosphereResource("gases.gastable"));
        AtmosphereSmartParameters parameters;
        one.scene.settings.mode = mode;
        one.scene.environment = environmentOf(
            std::make_shared<AtmosphereSmart>(parameters, "own", std::filesystem::path(), gases));
        return std::weak_ptr<const GasTable>(gases);
    };
    const auto render = [&](double range_m) {
        one.seeFrom(range_m, 0.4, 0.3);
        renderer.render(one.scene, one.view, Outputs::reports(one.bands));
    };
    one.bands = {Band::topHat(4.2, 4.3)};
    std::vector<std::weak_ptr<const GasTable>> gone;
    for (const auto mode : {CalculationMode::spectral, CalculationMode::wideband}) {
        gone.push_back(opened(mode));
        render(150.0);
        render(160.0);
    }
    EXPECT_FALSE(gone.back().expired());
    opened(CalculationMode::spectral);
    // What was evaluated of the last two scenes is kept, whatever their air.
    render(150.0);
    render(160.0);
    for (const auto& gases : gone) {
        EXPECT_TRUE(gases.expired());
    }
}

TEST(PlanckTable, HoldsWhatPlancksLawSaysHoweverMuchItForgets) {
    std::vector<double> wavelengths_um(200000);
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
        wavelengths_um[i] = 3.0 + 1e-5 * static_cast<double>(i);
    }
    PlanckTable table(wavelengths_um);
    for (int turn = 0; turn < 2; ++turn) {
        for (double temperature_K = 300.0; temperature_K < 350.0; temperature_K += 1.0) {
            const SharedValues values = table.at(temperature_K);
            ASSERT_EQ(values->size(), wavelengths_um.size());
            for (const std::size_t i : {0, 777, 199999}) {
                ASSERT_EQ((*values)[i],
                          planckRadiance_W_m2_sr_um(wavelengths_um[i], temperature_K));
            }
        }
    }
}
