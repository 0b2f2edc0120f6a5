#include "gui/image/ImageView.h"
#include "gui/plot/PlotLook.h"

#include <limits>
#include <set>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageInspector.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/SampledTiles.h"
#include "irsg/image/TiffFile.h"
#include "irsg/radiometry/Planck.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ImageViewFixture.h"
#include "tests/gui/SampleProject.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::gui {
namespace {

using test::ImageViewTest;

TEST_F(ImageViewTest, ALargeImageIsColouredInAnotherThreadWhileTheOldPictureStays) {
    // In bars, of which one lies in the middle whatever width the canvas has.
    irsg::RadianceImage large(700, 600);
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 700; ++x) {
            large.primary().values[large.offset(x, y)] = static_cast<float>(1 + x / 100);
        }
    }
    view.setImage(large);
    EXPECT_TRUE(view.isBusy());
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const auto limits = view.colorBar()->limits();
    EXPECT_LT(limits.low, limits.high);
    EXPECT_LE(limits.high, 100.0);
    const auto middle = [&] {
        const QImage seen = view.canvas()->grab().toImage();
        return seen.pixelColor(seen.width() / 2, seen.height() / 2);
    };
    const QColor before = middle();
    EXPECT_EQ(before, view.canvas()->picture().pixelColor(350, 300));

    // What a project says of the limits counts as if it were typed, one of them or both.
    view.setLimits(std::nullopt, 50.0);
    EXPECT_EQ(view.colorBar()->limits().low, limits.low);
    EXPECT_EQ(view.colorBar()->limits().high, 50.0);
    view.setLimits(60.0, 50.0);
    EXPECT_EQ(view.colorBar()->limits().high, 50.0) << "limits that do not ascend change nothing";
    EXPECT_EQ(view.colorBar()->limits().low, limits.low);
    view.colorBar()->edit(limits);

    // Locked limits count at once in the bar, the picture follows.
    view.colorBar()->edit({200.0, 300.0});
    EXPECT_EQ(middle(), before);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const irsg::Rgb first = view.colorMap().at(0.0);
    EXPECT_EQ(middle(), QColor(first.red, first.green, first.blue));
    view.findChild<QCheckBox*>("markOutside")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const irsg::Rgb below = view.colorMap().below();
    EXPECT_EQ(middle(), QColor(below.red, below.green, below.blue));
    EXPECT_EQ(view.colorBar()->outOfRange().below, 700U * 600U);

    // A rule that takes its time gives the same as it does at once.
    setMode(view, LimitMode::percentile);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const auto found = limitsBy(view.colorBar()->rule(), {&large.primary().values});
    EXPECT_EQ(view.colorBar()->limits().low, found.low);
    EXPECT_EQ(view.colorBar()->limits().high, found.high);
}

TEST_F(ImageViewTest, AnotherImageOfTheSameSizeTakesTheOldPictureAwayAtOnce) {
    // A dark and a bright image with a limit at each end, so that both fill the range of colours.
    const auto image = [](float middle) {
        irsg::RadianceImage large(700, 600);
        std::ranges::fill(large.primary().values, middle);
        large.primary().values[0] = 0.0F;
        large.primary().values[1] = 100.0F;
        return large;
    };
    const auto middle = [&] {
        const QImage seen = view.canvas()->grab().toImage();
        return seen.pixelColor(seen.width() / 2, seen.height() / 4);
    };
    setMode(view, LimitMode::full);
    view.setImage(image(90.0F));
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const QColor bright = middle();
    EXPECT_EQ(bright, view.canvas()->picture().pixelColor(350, 150));
    view.setImage(image(80.0F));
    const QColor meanwhile = middle();
    EXPECT_NE(meanwhile, bright);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    EXPECT_EQ(middle(), view.canvas()->picture().pixelColor(350, 150));
    EXPECT_NE(middle(), meanwhile);
}

TEST_F(ImageViewTest, TopRowOfTheImageIsAtTheTop) {
    const QImage seen = view.canvas()->grab().toImage();
    const auto colorAt = [&](int x, int y) {
        return seen.pixelColor(
            (view.canvas()->widgetPoint(QPointF(x + 0.1, y + 0.1)) * seen.devicePixelRatio())
                .toPoint());
    };
    EXPECT_GT(colorAt(2, 0).lightness(), 240);
    EXPECT_LT(colorAt(2, 5).lightness(), 15);
    EXPECT_LT(colorAt(5, 0).lightness(), 15);
    EXPECT_EQ(view.canvas()->pixelAt(view.canvas()->widgetPoint({2.5, 0.5})), QPoint(2, 0));
}

TEST_F(ImageViewTest, ReadsRadianceTemperatureAndIndexOfAPixel) {
    const QString text = view.readoutAt(2, 0);
    EXPECT_TRUE(text.contains("x 2   y 0"));
    EXPECT_TRUE(text.contains("Radiance 5 W·m⁻²·sr⁻¹")) << text.toStdString();
    EXPECT_TRUE(text.contains("Temperature index 7")) << text.toStdString();
    EXPECT_TRUE(text.contains("Apparent temperature")) << text.toStdString();
    EXPECT_NE(view.image().find(irsg::apparentTemperatureChannel), nullptr);
}

TEST_F(ImageViewTest, EditedLimitsLockAndUselessOnesAreTakenBack) {
    auto* high = view.findChild<QLineEdit*>("limitHigh");
    high->setText("2.5");
    emit high->editingFinished();
    EXPECT_EQ(view.colorBar()->limits().high, 2.5);
    EXPECT_EQ(view.colorBar()->mode(), LimitMode::locked);
    for (const auto* useless : {"hot", "-7", "nan", ""}) {
        high->setText(useless);
        emit high->editingFinished();
        EXPECT_EQ(high->text(), "2.5") << useless;
    }
    view.setImage(small());
    EXPECT_EQ(view.colorBar()->limits().high, 2.5);
}

TEST_F(ImageViewTest, ShowsEveryPlaneUnderItsNameAndUnit) {
    auto* planes = view.findChild<QComboBox*>("plane");
    ASSERT_EQ(planes->count(), 3);
    planes->setCurrentIndex(2);
    emit planes->activated(2);
    EXPECT_EQ(view.shownChannel(), irsg::apparentTemperatureChannel);
    view.setColorMap("ironbow");
    test::keepScreenshot(view, "image-view");
}

TEST_F(ImageViewTest, ScalesShowWhatIsDimBesideWhatGlows) {
    // Background, skin at 1 and 2, and one pipe at 1000.
    irsg::RadianceImage image(100, 3);
    auto& values = image.primary().values;
    std::fill_n(values.begin() + 100, 100, 1.0F);
    std::fill_n(values.begin() + 200, 100, 2.0F);
    values[0] = 1000.0F;
    view.setImage(image);
    view.setColorMap("white-hot");
    const auto red = [&](int x, int y) { return view.canvas()->picture().pixelColor(x, y).red(); };
    // By itself it shows both.
    EXPECT_EQ(view.colorBar()->outOfRange().above, 0U);
    EXPECT_EQ(view.colorBar()->limits().scale, irsg::ColorScale::logarithmic);
    EXPECT_GT(red(50, 2) - red(50, 1), 5);

    auto* scale = view.findChild<QComboBox*>("colorScale");
    const auto choose = [&](irsg::ColorScale wanted) {
        scale->setCurrentIndex(scale->findData(static_cast<int>(wanted)));
        emit scale->activated(scale->currentIndex());
    };
    choose(irsg::ColorScale::linear);
    EXPECT_EQ(view.colorBar()->outOfRange().above, 1U); // Target leaves the hottest pixel out
    int before = 0;
    for (const irsg::ColorScale wanted :
         {irsg::ColorScale::squareRoot, irsg::ColorScale::logarithmic,
          irsg::ColorScale::equalized}) {
        choose(wanted);
        EXPECT_EQ(view.colorBar()->limits().scale, wanted);
        EXPECT_EQ(view.colorBar()->limits().high, 1000.0);
        EXPECT_EQ(view.colorBar()->outOfRange().above, 0U);
        EXPECT_EQ(red(0, 0), 255);
        EXPECT_EQ(red(50, 0), 0);
        EXPECT_GT(red(50, 2) - red(50, 1), before) << irsg::nameOf(wanted);
        before = red(50, 2) - red(50, 1);
    }
    test::keepScreenshot(view, "image-view-equalized");
    // Limits that are typed in keep the scale, and a file that is written has it.
    choose(irsg::ColorScale::logarithmic);
    view.colorBar()->edit({0.0, 500.0});
    EXPECT_EQ(view.colorBar()->limits(),
              (irsg::DisplayLimits{0.0, 500.0, irsg::ColorScale::logarithmic, {}}));
    const int locked = red(50, 1);
    EXPECT_EQ(locked, view.colorMap().color(1.0, view.colorBar()->limits()).red);
    choose(irsg::ColorScale::linear);
    EXPECT_EQ(view.colorBar()->limits(), (irsg::DisplayLimits{0.0, 500.0}));
    EXPECT_LT(red(50, 1), locked);
}

TEST_F(ImageViewTest, APictureInVisibleLightHasItsColours) {
    const smat::test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "photo.exr";
    irsg::RadianceImage photo(40, 30, "R", "");
    for (const char* name : {"G", "B"}) {
        photo.channel(name);
    }
    const auto paint = [&](int x, float r, float g, float b) {
        for (int y = 0; y < 30; ++y) {
            photo.channel("R").values[photo.offset(x, y)] = r;
            photo.channel("G").values[photo.offset(x, y)] = g;
            photo.channel("B").values[photo.offset(x, y)] = b;
        }
    };
    for (int x = 0; x < 20; ++x) {
        paint(x, 1.0F, 0.0F, 0.0F);
    }
    for (int x = 20; x < 40; ++x) {
        paint(x, 0.0F, 0.2158605F, 1.0F); // half way to white as sRGB counts
    }
    irsg::writeExr(photo, file);
    view.setImage(irsg::readExr(file));
    EXPECT_TRUE(view.showsColors());
    EXPECT_EQ(view.canvas()->picture().pixelColor(5, 5), QColor(255, 0, 0));
    EXPECT_EQ(view.canvas()->picture().pixelColor(30, 5), QColor(0, 128, 255));
    EXPECT_TRUE(view.readoutAt(5, 5).contains("R 1")) << view.readoutAt(5, 5).toStdString();
    EXPECT_TRUE(view.readoutAt(5, 5).contains("Luminance 0.2126"));
    test::keepScreenshot(view, "image-view-visible-light");
    // What is written is what is seen, and every plane can be looked at by itself.
    view.exportTo(file.parent_path() / "photo.png");
    EXPECT_EQ(QImage(QString::fromStdString((file.parent_path() / "photo.png").string()))
                  .pixelColor(30, 5),
              QColor(0, 128, 255));
    view.setShownPlane(1);
    EXPECT_FALSE(view.showsColors());
    EXPECT_EQ(view.shownChannel(), "R");
    EXPECT_EQ(view.canvas()->picture().pixelColor(30, 5), QColor(0, 0, 0));
}

TEST_F(ImageViewTest, PercentilesSetTheLimitsAndStayInOrder) {
    irsg::RadianceImage ramp(101, 1);
    for (int x = 0; x < 101; ++x) {
        ramp.primary().values[static_cast<std::size_t>(x)] = static_cast<float>(x);
    }
    view.setImage(ramp);
    setMode(view, LimitMode::percentile);
    view.colorBar()->setPercentiles(10.0, 90.0);
    EXPECT_EQ(view.colorBar()->limits(), (irsg::DisplayLimits{10.0, 90.0}));
    EXPECT_EQ(view.colorBar()->outOfRange().below, 10u);
    EXPECT_EQ(view.colorBar()->outOfRange().above, 10u);
    view.findChild<QDoubleSpinBox*>("percentLow")->setValue(95.0);
    EXPECT_LT(view.colorBar()->percentiles().first, view.colorBar()->percentiles().second);
    EXPECT_LT(view.colorBar()->limits().low, view.colorBar()->limits().high);
    test::keepScreenshot(view, "image-view-percentiles");
}

TEST_F(ImageViewTest, OutlinesTheTilesOfTheAntialiasing) {
    auto* button = view.findChild<QToolButton*>("showWindows");
    EXPECT_FALSE(button->isEnabled()); // this image tells of none
    irsg::RadianceImage image = small();
    irsg::describeTiles(
        {{1.0, 0.0, 6.0, 4.0, 25.0, 26.0, "hull"}, {2.25, 0.5, 2.5, 0.75, 900.0, 900.0, "hull"}},
        image);
    view.setImage(image, irsg::Band::topHat(3.0, 5.0));
    EXPECT_TRUE(button->isEnabled());
    EXPECT_TRUE(view.canvas()->outlines().empty());
    EXPECT_FALSE(view.readoutAt(2, 0).contains("Tile"));

    view.canvas()->setFocus();
    QTest::keyClick(view.canvas(), Qt::Key_W);
    ASSERT_EQ(view.canvas()->outlines().size(), 2u);
    EXPECT_EQ(view.canvas()->outlines()[0], QRectF(1.0, 0.0, 5.0, 4.0));
    EXPECT_TRUE(view.readoutAt(2, 0).endsWith("Tile: 900 × 900 samples per pixel, hull"));
    EXPECT_TRUE(view.readoutAt(5, 3).endsWith("Tile: 25 × 26 samples per pixel, hull"));
    EXPECT_FALSE(view.readoutAt(7, 5).contains("Tile"));
    // A line where the image says that the window's edge is.
    const QImage seen = view.canvas()->grab().toImage();
    const QPointF edge = view.canvas()->widgetPoint(QPointF(6.0, 2.3)) * seen.devicePixelRatio();
    EXPECT_GT(seen.pixelColor(edge.toPoint()).lightness(), 200);
    test::keepScreenshot(view, "image-view-windows");

    button->click();
    EXPECT_TRUE(view.canvas()->outlines().empty());
}

TEST_F(ImageViewTest, KeysChangePlaneColoursExposureAndOffset) {
    view.canvas()->setFocus();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(view.canvas(), key, modifiers);
    };
    setMode(view, LimitMode::full);
    press(Qt::Key_E);
    press(Qt::Key_E);
    press(Qt::Key_E);
    press(Qt::Key_E);
    EXPECT_NEAR(view.colorBar()->limits().high, 3.0, 1e-12); // 1 to 5, one stop brighter
    EXPECT_EQ(view.colorBar()->mode(), LimitMode::locked);
    press(Qt::Key_E, Qt::ShiftModifier);
    EXPECT_GT(view.colorBar()->limits().high, 3.0);
    press(Qt::Key_N);
    EXPECT_EQ(view.colorBar()->mode(), LimitMode::target);
    const auto before = view.colorBar()->limits();
    press(Qt::Key_O);
    EXPECT_LT(view.colorBar()->limits().low, before.low);
    press(Qt::Key_M);
    EXPECT_EQ(view.colorMap().name(), "black-hot");
    press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_EQ(view.colorMap().name(), "white-hot");
    press(Qt::Key_2);
    EXPECT_EQ(view.shownChannel(), "temperature_index");
    press(Qt::Key_9);
    EXPECT_EQ(view.shownChannel(), "temperature_index");
    press(Qt::Key_Right);
    EXPECT_TRUE(view.findChild<QLabel*>("pixelReadout")->text().startsWith("x 4   y 3"));
}

TEST_F(ImageViewTest, ExportsDataAndPicturesWithAndWithoutBar) {
    const auto folder = test::freshFolder("image-export");
    setMode(view, LimitMode::full);
    view.setTitle("a scene of steps");
    view.setConditions("3-5 µm · range 900 m");
    const auto write = [&](const QString& entry, const char* name) {
        chosen = QString::fromStdString((folder / name).string());
        menuEntry(view, "exportImage", entry)->trigger();
        return folder / name;
    };
    const auto exr = irsg::readExr(write("All planes as OpenEXR…", "a.exr"));
    EXPECT_EQ(exr.primary(), view.image().primary());
    EXPECT_EQ(exr.channels.size(), 3u);
    EXPECT_EQ(irsg::readCsvImage(write("This plane as CSV…", "a.csv")).primary().values,
              view.image().primary().values);
    const QImage bare(QString::fromStdString(write("Picture…", "bare.png").string()));
    EXPECT_EQ(bare.size(), QSize(8, 6));
    EXPECT_EQ(bare.pixelColor(2, 0), QColor(Qt::white));
    const QImage full(
        QString::fromStdString(write("Picture with colour bar…", "bar.png").string()));
    EXPECT_GT(full.width(), full.height());
    EXPECT_TRUE(test::holdsWords(full, "a scene of steps", plotFont(1.1, true)));
    EXPECT_TRUE(test::holdsWords(full, "3-5 µm", plotFont(0.9)));
    EXPECT_TRUE(told.isEmpty());
    chosen = "/nowhere/at/all.exr";
    menuEntry(view, "exportImage", "All planes as OpenEXR…")->trigger();
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains("/nowhere/at/all.exr"));
    EXPECT_EQ(irsg::readTiff(write("All planes as TIFF…", "a.tif")).channels.size(), 3U);
    EXPECT_THROW(view.exportTo("image.jpeg"), irsg::InputError);
}

TEST_F(ImageViewTest, CopiesValuesOfTheRectangleAndThePicture) {
    test::keepClipboard();
    view.canvas()->setSelection(irsg::PixelRectangle{1, 0, 2, 2});
    QTest::keyClick(view.canvas(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), "1\t5\n1\t1\n");
    menuEntry(view, "copyImage", "Picture")->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->image().size(), QSize(8, 6));
    QTest::keyClick(view.canvas(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_GT(QGuiApplication::clipboard()->image().width(), 100);
}

TEST_F(ImageViewTest, ALargeImageIsShownAtOnceAndItsTemperaturesFollow) {
    irsg::RadianceImage large(700, 600);
    for (std::size_t i = 0; i < large.pixelCount(); ++i) {
        large.primary().values[i] = 1.0F + 1e-5F * static_cast<float>(i);
    }
    view.setImage(large, irsg::Band::topHat(3.0, 5.0));
    EXPECT_EQ(view.image().channels.size(), 1u);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    ASSERT_NE(view.image().find(irsg::apparentTemperatureChannel), nullptr);
    EXPECT_TRUE(view.readoutAt(3, 3).contains("Apparent temperature"));
    EXPECT_TRUE(view.findChild<QLabel*>("statistics")->text().startsWith("Image 700 × 600"));
    // One that goes while it is worked out is not heard of again.
    auto gone = std::make_unique<ImageView>();
    gone->setImage(large, irsg::Band::topHat(3.0, 5.0));
    gone.reset();
    QTest::qWait(50);
}

TEST_F(ImageViewTest, ALargeImageIsNotCopiedAndNothingElseIsSeenBeforeIt) {
    auto large = std::make_shared<irsg::RadianceImage>(700, 600);
    for (std::size_t i = 0; i < large->pixelCount(); ++i) {
        large->primary().values[i] = 1.0F + 1e-5F * static_cast<float>(i);
    }
    ImageView fresh;
    fresh.resize(760, 560);
    fresh.setImage(std::shared_ptr<const irsg::RadianceImage>(large));
    EXPECT_EQ(&fresh.image(), large.get());
    fresh.show();
    // Nothing comes from other threads before the next turn of the event loop. Above the words that
    // say so there is nothing.
    const auto colours = [&] {
        const QImage seen = fresh.canvas()->grab().toImage();
        std::set<QRgb> found;
        for (int y = 0; y < seen.height() / 3; y += 7) {
            for (int x = 0; x < seen.width(); x += 7) {
                found.insert(seen.pixel(x, y));
            }
        }
        return found;
    };
    EXPECT_EQ(colours().size(), 1U);
    EXPECT_TRUE(fresh.isBusy());
    ASSERT_TRUE(test::waitUntil([&] { return !fresh.isBusy(); }));
    EXPECT_GT(colours().size(), 10U);
    EXPECT_EQ(&fresh.image(), large.get());
}

TEST_F(ImageViewTest, LivesWithPixelsThatAreNoNumbersAndWithOnePixel) {
    irsg::RadianceImage image(1, 1);
    image.primary().values[0] = std::numeric_limits<float>::quiet_NaN();
    view.setImage(image, irsg::Band::topHat(8.0, 12.0));
    EXPECT_TRUE(view.readoutAt(0, 0).contains("no value"));
    view.setImage(irsg::RadianceImage(1, 977), irsg::Band::topHat(8.0, 12.0));
    view.grab();
}

} // namespace
} // namespace smat::gui
