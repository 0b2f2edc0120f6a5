#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSignalSpy>
#include <QWheelEvent>

#include "gui/view/InfraredScene.h"
#include "irsg/geometry/view/ImageQuantity.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ProcessCounts.h"
#include "tests/gui/ViewFixture.h"

namespace smat::gui {
namespace {

using test::apart;
using test::waitUntil;

class InfraredViewTest : public test::ViewFixture {
  protected:
    irsg::RadianceImage analysis() {
        SceneBuilder builder;
        AnalysisGenerator generator(openRenderDoor(), [&](const Project& p, const Settings& s) {
            return builder.build(p, s);
        });
        AnalysisData data = AnalysisData::of(project, AnalysisKind::image);
        generator.run(data);
        return data.image;
    }
    double mean() const {
        const auto& values = view.shownPicture()->plane().values;
        double sum = 0.0;
        for (const float value : values) {
            sum += static_cast<double>(value);
        }
        return sum / static_cast<double>(values.size());
    }
};

TEST_F(InfraredViewTest, AgreesWithTheImageAnalysisPixelByPixel) {
    for (const auto* name : {"turboprop4", "ship", "sphere"}) {
        SCOPED_TRACE(name);
        ASSERT_NO_FATAL_FAILURE(show(sample(name)));
        ASSERT_TRUE(showInfrared());
        const irsg::RadianceImage& seen = *view.shownPicture()->image;
        const irsg::RadianceImage image = analysis();
        ASSERT_EQ(seen.width(), image.width());
        ASSERT_EQ(seen.height(), image.height());
        std::size_t others = 0;
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            others += std::abs(seen.primary().values[i] - image.primary().values[i]) >
                      1e-6F * std::abs(image.primary().values[i]);
        }
        // An edge that runs through the middle of a sample may fall to either side.
        EXPECT_LE(others, image.pixelCount() / 10000);
        const auto [least, most] = std::ranges::minmax(seen.primary().values);
        EXPECT_GT(most, 1.05F * least) << "a picture of nothing";
    }
}

TEST_F(InfraredViewTest, TheWindowHasTheColoursOfThePixels) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    QTest::qWait(50);
    const QImage seen = view.grabFramebuffer();
    const auto& picture = *view.shownPicture();
    ASSERT_EQ(seen.size(), picture.size_px);
    long others = 0;
    std::set<QRgb> colors;
    for (int y = 0; y < seen.height(); ++y) {
        for (int x = 0; x < seen.width(); ++x) {
            const auto value = static_cast<double>(picture.image->at(x, y));
            const irsg::Rgb color = view.infrared().colorMap().color(
                std::clamp(value, picture.limits.low, picture.limits.high), picture.limits);
            others += apart(seen.pixelColor(x, y), QColor(color.red, color.green, color.blue)) > 3;
            colors.insert(seen.pixel(x, y));
        }
    }
    EXPECT_EQ(others, 0);
    EXPECT_GT(colors.size(), 50U);
}

TEST_F(InfraredViewTest, ShowsTheApparentTemperatureThatTheAnalysisGives) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    view.infrared().setQuantity(InfraredQuantity::apparentTemperature);
    ASSERT_TRUE(showInfrared());
    set("image.quantity", "apparent-temperature");
    ASSERT_TRUE(waitForPicture());
    const irsg::RadianceImage image = analysis();
    const auto& plane = view.shownPicture()->plane();
    EXPECT_EQ(plane.unit, "K");
    for (const auto& [x, y] : {std::pair{200, 150}, {120, 160}, {5, 5}}) {
        EXPECT_NEAR(plane.values[image.offset(x, y)], image.at(x, y), 2e-3) << x << " " << y;
    }
}

TEST_F(InfraredViewTest, FollowsEverySettingThatChangesTheRadiance) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    const std::pair<const char*, const char*> changes[] = {
        {"camera.azimuth", "-40"},       {"target.roll", "30"},   {"state.power", "0.2"},
        {"state.time", "0.7"},           {"state.mach", "0.8"},   {"environment.sunAzimuth", "10"},
        {"environment.atmospheres", ""}, {"sensor.band", "8-12"}, {"render.sun", "off"},
        {"render.background", "5"},      {"sensor.fov", "4"}};
    for (const auto& [key, value] : changes) {
        const double before = mean();
        set(key, *value == '\0' ? "none" : value);
        ASSERT_TRUE(waitForPicture()) << key;
        EXPECT_NE(mean(), before) << key;
    }
    // And the whole chain of them is what an analysis of these settings gives.
    const irsg::RadianceImage image = analysis();
    const irsg::RadianceImage& seen = *view.shownPicture()->image;
    for (const auto& [x, y] : {std::pair{200, 150}, {120, 160}, {5, 5}}) {
        EXPECT_FLOAT_EQ(seen.at(x, y), image.at(x, y));
    }
}

TEST_F(InfraredViewTest, ShowsAnEditedDatabaseByTheComputedAmount) {
    // A black body of one temperature: every pixel of it is Planck's integral.
    Project black = sample("sphere");
    for (const auto& [key, value] : {std::pair{"render.sun", "off"},
                                     {"render.ambientReflection", "off"},
                                     {"render.background", "none"},
                                     {"environment.atmospheres", "none"}}) {
        black.settings.set(key, value);
    }
    ASSERT_NO_FATAL_FAILURE(show(black));
    view.infrared().setQuantity(InfraredQuantity::apparentTemperature);
    const auto file = project.resolve(project.models.front().database);
    irsg::SignatureDatabase database = irsg::loadSignatureFile(file).database;
    for (auto& [index, material] : database.materials) {
        material = {};
        material.emissivity = irsg::Spectrum::constant(1.0);
    }
    for (const double kelvin : {310.0, 355.0}) {
        for (auto& [index, entry] : database.temperatures) {
            entry = {};
            entry.terms.base_K = kelvin;
            entry.terms.ambientFactor = 0.0;
        }
        view.setEditedDatabase(file, std::make_shared<const irsg::SignatureDatabase>(database));
        ASSERT_TRUE(view.display() == ViewDisplay::infrared ? waitForPicture() : showInfrared());
        const auto& picture = *view.shownPicture();
        EXPECT_NEAR(picture.plane().values[picture.image->offset(pixels(200), pixels(150))], kelvin,
                    1e-2);
    }
    // The file again.
    const double edited = mean();
    view.setEditedDatabase(file, nullptr);
    ASSERT_TRUE(waitForPicture());
    EXPECT_NE(mean(), edited);
}

TEST_F(InfraredViewTest, IsCoarserWhileOneDragsAndFullAtRest) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    std::vector<bool> coarse;
    QObject::connect(&view, &SceneView::pictureShown, &view,
                     [&] { coarse.push_back(view.shownPicture()->coarse); });
    QTest::mousePress(&view, Qt::LeftButton, {}, {200, 150});
    for (int i = 1; i <= 12; ++i) {
        QTest::mouseMove(&view, {200 + 8 * i, 150});
        waitUntil([&, before = coarse.size()] { return coarse.size() > before; }, 5.0);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, {296, 150});
    ASSERT_TRUE(waitForPicture());
    ASSERT_GE(coarse.size(), 6U);
    EXPECT_TRUE(coarse.front());
    EXPECT_FALSE(coarse.back());
    EXPECT_EQ(view.shownPicture()->size_px, QSize(400, 300) * pixelRatio());
}

TEST_F(InfraredViewTest, TheFirstLookAtALargeModelDoesNotWaitForLightBetweenSurfaces) {
    ASSERT_NO_FATAL_FAILURE(show(sample("corvette")));
    std::vector<bool> direct;
    QObject::connect(&view, &SceneView::pictureShown, &view, [&] {
        if (const InfraredPicture* picture = view.shownPicture()) {
            direct.push_back(picture->direct);
        }
    });
    ASSERT_TRUE(showInfrared());
    EXPECT_EQ(direct, (std::vector<bool>{true, false}));
    // What is known is not left out again.
    set("camera.azimuth", "61");
    ASSERT_TRUE(waitForPicture());
    EXPECT_FALSE(direct.back());
    EXPECT_EQ(std::ranges::count(direct, true), 1);
    // Nothing is left out of a small model, or where no light between surfaces is wanted.
    view.setDisplay(ViewDisplay::visible);
    direct.clear();
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    view.setDisplay(ViewDisplay::visible);
    Project without = sample("corvette");
    without.settings.set("render.bounces", "0");
    ASSERT_NO_FATAL_FAILURE(show(without));
    ASSERT_TRUE(showInfrared());
    EXPECT_GE(direct.size(), 2U);
    EXPECT_EQ(std::ranges::count(direct, true), 0);
}

TEST_F(InfraredViewTest, TheLatestOfManyRequestsIsTheOneThatStays) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    ASSERT_TRUE(showInfrared());
    QSignalSpy shown(&view, &SceneView::pictureShown);
    for (int azimuth = 0; azimuth < 100; ++azimuth) {
        set("camera.azimuth", std::to_string(azimuth));
    }
    ASSERT_TRUE(waitForPicture());
    EXPECT_LT(shown.count(), 20);
    const auto& eye = view.shownPicture()->eye.position_m;
    EXPECT_NEAR(irsg::degrees(std::atan2(eye.x, eye.y)), 99.0, 0.5);
}

TEST_F(InfraredViewTest, EditsInQuickSuccessionAreAllInFullAndGoBackToTheSame) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    const auto sum = [this] {
        const auto& values = view.shownPicture()->plane().values;
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    const double before = sum();
    const auto file = project.resolve(project.models.front().database);
    irsg::SignatureDatabase database = irsg::loadSignatureFile(file).database;
    bool coarse = false;
    QObject::connect(&view, &SceneView::pictureShown, &view,
                     [&] { coarse = coarse || view.shownPicture()->coarse; });
    double last = before;
    for (int i = 0; i < 6; ++i) {
        for (auto& [index, entry] : database.temperatures) {
            entry.terms.base_K += 10.0;
        }
        view.setEditedDatabase(file, std::make_shared<const irsg::SignatureDatabase>(database));
        ASSERT_TRUE(waitForPicture());
        EXPECT_GT(sum(), 1.001 * last) << i;
        last = sum();
    }
    EXPECT_FALSE(coarse);
    view.setEditedDatabase(file, nullptr);
    ASSERT_TRUE(waitForPicture());
    EXPECT_NEAR(sum() / before, 1.0, 1e-6);
}

TEST_F(InfraredViewTest, BeginsInTheScaleAndLimitsOfTheImageInItsBand) {
    Project begun =
        sample("turboprop4"); // mwir-image: square root, 1.3 to 10; lwir-image: 28 to 38
    begun.settings.set("render.bounces", "0");
    ASSERT_NO_FATAL_FAILURE(show(begun));
    const auto has = [&](LimitMode mode, double low, double high, irsg::ColorScale scale) {
        return waitUntil([&] {
            const auto* picture = view.shownPicture();
            return picture != nullptr && view.isUpToDate() &&
                   view.infrared().colorRule().mode == mode && picture->limits.low == low &&
                   picture->limits.high == high && view.infrared().colorRule().scale == scale;
        });
    };
    using enum irsg::ColorScale;
    ASSERT_TRUE(showInfrared());
    EXPECT_TRUE(has(LimitMode::locked, 1.3, 10.0, squareRoot));
    set("sensor.band", "8-12");
    EXPECT_TRUE(has(LimitMode::locked, 28.0, 38.0, automatic));
    set("display.minimum", "20"); // what the project sets itself counts
    EXPECT_TRUE(has(LimitMode::locked, 20.0, 38.0, automatic));
    view.infrared().setLimits({25.0, 30.0}); // until others are chosen
    set("camera.azimuth", "70");
    EXPECT_TRUE(has(LimitMode::locked, 25.0, 30.0, automatic));
    // No image is in this band.
    project.settings.reset("display.minimum");
    set("sensor.band", "3.4-4.1");
    ASSERT_TRUE(waitForPicture());
    EXPECT_EQ(view.infrared().colorRule().mode, LimitMode::target);
    // Another project without such images has none of these limits.
    project.settings.set("sensor.band", "3-5");
    begun.analyses.clear();
    ASSERT_NO_FATAL_FAILURE(show(begun));
    ASSERT_TRUE(waitForPicture());
    EXPECT_EQ(view.infrared().colorRule(), ColorRule{});
}

TEST_F(InfraredViewTest, LimitsFollowTheTargetOrStayLocked) {
    Project plain = sample("turboprop4");
    plain.analyses.clear();
    ASSERT_NO_FATAL_FAILURE(show(plain));
    ASSERT_TRUE(showInfrared());
    EXPECT_EQ(view.shownPicture()->limits,
              limitsBy(ColorRule{}, {&view.shownPicture()->plane().values}));
    view.infrared().setLimits({1.0, 2.5});
    ASSERT_TRUE(waitForPicture());
    ASSERT_TRUE(waitUntil([&] { return view.shownPicture()->limits.high == 2.5; }));
    set("camera.azimuth", "120");
    ASSERT_TRUE(waitForPicture());
    EXPECT_EQ(view.shownPicture()->limits.low, 1.0);
    EXPECT_EQ(view.shownPicture()->limits.high, 2.5);
    view.infrared().setColorRule({.mode = LimitMode::full});
    ASSERT_TRUE(waitUntil([&] {
        return view.shownPicture()->limits.high ==
               irsg::percentileLimits(view.shownPicture()->plane().values).high;
    }));
}

TEST_F(InfraredViewTest, ScalesHoldThePipesBesideTheSkin) {
    ASSERT_NO_FATAL_FAILURE(show(sample("turboprop4")));
    ASSERT_TRUE(showInfrared());
    // On a busy machine a picture may be awaited for a while.
    const auto has = [&](irsg::ColorScale scale) {
        return waitUntil([&] {
            // While the scene changes a coarse picture, of fewer colours, is shown first.
            const auto* picture = view.shownPicture();
            return picture != nullptr && !picture->coarse && view.isUpToDate() &&
                   picture->limits.scale == scale;
        });
    };
    const auto colors = [&] {
        std::set<QRgb> all;
        const QImage picture = view.shownPicture()->colors.convertToFormat(QImage::Format_RGB32);
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                all.insert(picture.pixel(x, y));
            }
        }
        return all.size();
    };
    view.infrared().setColorRule({.mode = LimitMode::full, .scale = irsg::ColorScale::linear});
    ASSERT_TRUE(waitForPicture());
    ASSERT_TRUE(has(irsg::ColorScale::linear));
    const std::size_t linear = colors();
    set("display.scale", "equalized"); // as a project or the settings do
    ASSERT_TRUE(has(irsg::ColorScale::equalized));
    EXPECT_NE(view.shownPicture()->limits.levels, nullptr);
    EXPECT_GT(colors(), 2 * linear);
    test::keepScreenshot(view, "infrared-view-equalized");
    view.infrared().setColorRule(
        {.mode = view.infrared().colorRule().mode, .scale = irsg::ColorScale::linear});
    ASSERT_TRUE(has(irsg::ColorScale::linear));
    EXPECT_EQ(colors(), linear);
}

TEST_F(InfraredViewTest, SaysInWordsWhatIsMissingAndRecovers) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    ASSERT_TRUE(showInfrared());
    const auto file = project.resolve(project.models.front().database);
    irsg::SignatureDatabase broken = irsg::loadSignatureFile(file).database;
    const int gone = broken.temperatures.rbegin()->first;
    broken.temperatures.erase(gone);
    QSignalSpy failed(&view, &SceneView::pictureFailed);
    view.setEditedDatabase(file, std::make_shared<const irsg::SignatureDatabase>(broken));
    ASSERT_TRUE(waitUntil([&] { return failed.count() > 0; }));
    EXPECT_EQ(view.shownPicture(), nullptr);
    EXPECT_TRUE(failed.front().front().toStringList().join(' ').contains(QString::number(gone)));
    test::keepScreenshot(view, "view-infrared-problem");
    view.setEditedDatabase(file, nullptr);
    EXPECT_TRUE(waitForPicture());

    failed.clear();
    set("environment.atmospheres", "no-such-air.xml");
    ASSERT_TRUE(waitUntil([&] { return failed.count() > 0; }));
    EXPECT_TRUE(failed.front().front().toStringList().join(' ').contains("no-such-air.xml"));
    set("environment.atmospheres", "none");
    EXPECT_TRUE(waitForPicture());
}

TEST_F(InfraredViewTest, GoesBackToTheSameVisiblePicture) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    const QImage before = view.grabFramebuffer();
    ASSERT_TRUE(showInfrared());
    EXPECT_NE(view.grabFramebuffer(), before);
    view.setDisplay(ViewDisplay::visible);
    QTest::qWait(30);
    EXPECT_EQ(view.grabFramebuffer(), before);
}

struct Held {
    int textures = 0, buffers = 0, lists = 0; ///< alive in the context of the view
};
Held heldBy(SceneView& view) {
    Held held;
    // Names are given in ascending order: those up to the next one are all there ever were.
    view.makeCurrent();
    auto* gl = view.context()->functions();
    GLuint next = 0;
    gl->glGenTextures(1, &next);
    gl->glDeleteTextures(1, &next);
    for (GLuint name = 1; name < next; ++name) {
        held.textures += gl->glIsTexture(name);
    }
    gl->glGenBuffers(1, &next);
    gl->glDeleteBuffers(1, &next);
    for (GLuint name = 1; name < next; ++name) {
        held.buffers += gl->glIsBuffer(name);
    }
    for (GLuint name = 1; name < 20'000; ++name) {
        held.lists += glIsList(name);
    }
    view.doneCurrent();
    return held;
}

int threadCount() {
    return smat::test::processCounts().threads;
}

TEST_F(InfraredViewTest, ManyScenesLeaveNothingBehind) {
    const Project projects[] = {sample("sphere"), sample("ship")};
    ASSERT_NO_FATAL_FAILURE(show(projects[0]));
    const auto showNext = [&](int number) {
        project = projects[number % 2];
        view.setScene(loadDisplayScene(project, project.settings));
        view.setProject(project, project.settings);
        view.setHighlighted({.temperature = 1, .material = {}, .model = {}});
        if (number % 4 == 0) {
            view.setDisplay(ViewDisplay::infrared);
            ASSERT_TRUE(waitUntil([&] { return view.shownPicture() != nullptr; }, 20.0)) << number;
        } else {
            view.setDisplay(ViewDisplay::visible);
        }
        view.grabFramebuffer();
    };
    const auto showWhole = [&](const Project& shown) {
        project = shown;
        view.setScene(loadDisplayScene(project, project.settings));
        view.setProject(project, project.settings);
        ASSERT_TRUE(showInfrared());
    };
    int number = 0;
    double held_kB = 0.0;
    // Always at the same scene, whose whole picture is there, after whole pictures of both and two
    // more of other ranges: a picture that is under way holds megabytes, and one that was left
    // while it was computed may have come to keep its air or not.
    const auto heldAfter = [&](int scenes) {
        for (const int end = number + scenes; number < end && !HasFatalFailure(); ++number) {
            showNext(number);
        }
        showWhole(projects[1]);
        showWhole(projects[0]);
        for (const char* range_m : {"900", "800"}) {
            set("camera.range", range_m);
            EXPECT_TRUE(waitForPicture());
        }
        held_kB = smat::test::allocated_kB();
        return heldBy(view);
    };
    const Held before = heldAfter(20);
    const auto threadsBefore = threadCount();
    // What is lost a scene is lost in each round; what a busy machine makes come and go is not.
    double growth_kB = std::numeric_limits<double>::infinity();
    Held after;
    for (int round = 0; round < 3 && !HasFatalFailure(); ++round) {
        const double earlier_kB = held_kB;
        after = heldAfter(20);
        growth_kB = std::min(growth_kB, held_kB - earlier_kB);
    }
    EXPECT_GT(before.buffers, 0);
    EXPECT_LE(after.textures, before.textures);
    EXPECT_LE(after.buffers, before.buffers);
    EXPECT_LE(after.lists, before.lists);
    // 100 kB a scene.
    EXPECT_LT(growth_kB, 2'000.0);
    // A thread of a pool that was needed once waits 30 s for more work.
    EXPECT_TRUE(waitUntil([&] { return threadCount() <= threadsBefore; }, 45.0))
        << threadCount() << " " << threadsBefore;
}

TEST_F(InfraredViewTest, AViewThatGoesTakesItsThreadAlong) {
    ASSERT_NO_FATAL_FAILURE(show(sample("sphere")));
    ASSERT_TRUE(showInfrared());
    const auto before = threadCount();
    for (int i = 0; i < 5; ++i) {
        SceneView other;
        other.resize(320, 240);
        other.setScene(loadDisplayScene(project, project.settings));
        other.setProject(project, project.settings);
        other.show();
        other.setDisplay(ViewDisplay::infrared);
        // In the middle of its first picture, or after it.
        QTest::qWait(i * 30);
    }
    // Longer than the 30 s for which a thread of the pool that was needed once waits for more work.
    EXPECT_TRUE(waitUntil([&] { return threadCount() <= before; }, 45.0))
        << threadCount() << " " << before;
}

} // namespace
} // namespace smat::gui
