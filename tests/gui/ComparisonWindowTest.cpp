#include "gui/image/ComparisonWindow.h"

#include <cmath>
#include <limits>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "gui/image/ColorBar.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ThresholdForm.h"
#include "gui/widgets/Theme.h"
#include "tests/gui/ComparisonFixture.h"

namespace smat::gui {
namespace {

using test::ComparisonTest;

TEST_F(ComparisonTest, FindsOneChangedPixelWithSignAndPlaceAndGoesThere) {
    for (const float change : {0.5F, -0.25F}) {
        open(changed(31, 7, change), scene());
        ASSERT_TRUE(window->comparison());
        EXPECT_EQ(window->comparison()->largest.x, 31);
        EXPECT_EQ(window->comparison()->largest.y, 7);
        EXPECT_EQ(text("verdict"), "DIFFERENT");
        press(Qt::Key_W);
        for (const int i : {0, 1, 2}) {
            EXPECT_EQ(window->panes()->canvas(i)->cursorPixel(), QPoint(31, 7));
            EXPECT_EQ(window->panes()->canvas(i)->pixelAt(
                          QPointF(window->panes()->canvas(i)->rect().center())),
                      QPoint(31, 7));
        }
        EXPECT_TRUE(text("comparisonReadout").contains(QString("A − B  %1 W·m⁻²·sr⁻¹").arg(change)))
            << text("comparisonReadout").toStdString();
        // Red where A is brighter, blue where it is darker.
        press(Qt::Key_F);
        press(Qt::Key_Escape);
        const QColor color = seen(2, {31, 7});
        EXPECT_EQ(color.red() > color.blue(), change > 0.0F);
        EXPECT_EQ(seen(2, {3, 3}), QColor(Qt::white));
    }
}

TEST_F(ComparisonTest, ShowsAllNumbersAndCopiesThem) {
    test::keepClipboard();
    open(changed(31, 7, 0.5F), scene());
    press(Qt::Key_C, Qt::ControlModifier);
    const QString copied = QGuiApplication::clipboard()->text();
    for (const char* word :
         {"Mean error, A − B\t0.000416667 W·m⁻²·sr⁻¹", "Mean absolute error", "RMS error", "PSNR\t",
          "peak 5", "relMSE\t", "epsilon ", "at (31, 7), A 2.5, B 2",
          "Largest relative error\t0.222222", "Pixels over the fail threshold\t1 px",
          "NaN in A\t0 px", "Sum of the values, A − B\t0.5"}) {
        EXPECT_TRUE(copied.contains(word)) << word << "\n" << copied.toStdString();
    }
}

TEST_F(ComparisonTest, ZoomPanCursorAndRectangleAreOneForAllThree) {
    open(changed(31, 7, 0.5F), scene());
    auto* b = window->panes()->canvas(1);
    const QPointF at(60.0, 50.0);
    QWheelEvent wheel(at, b->mapToGlobal(at), {}, QPoint(0, 480), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(b, &wheel);
    for (const int i : {0, 2}) {
        EXPECT_DOUBLE_EQ(window->panes()->canvas(i)->zoom(), b->zoom());
        EXPECT_EQ(window->panes()->canvas(i)->view().centre, b->view().centre);
    }
    QTest::mouseMove(b, {100, 100});
    QTest::qWait(20);
    emit b->hovered(b->pixelAt({100.0, 100.0}));
    for (const int i : {0, 2}) {
        EXPECT_EQ(window->panes()->canvas(i)->cursorPixel(), b->pixelAt({100.0, 100.0}));
    }
    window->panes()->canvas(2)->setSelection(irsg::PixelRectangle{30, 6, 4, 2});
    emit window->panes()->canvas(2)->selectionChanged();
    EXPECT_EQ(window->panes()->canvas(0)->selection(), (irsg::PixelRectangle{30, 6, 4, 2}));
    ASSERT_TRUE(window->comparisonOfRectangle());
    EXPECT_DOUBLE_EQ(window->comparisonOfRectangle()->meanError, 0.5 / 8.0);
    EXPECT_TRUE(window->numbers()->allText().contains(
        "Mean error, A − B\t0.000416667 W·m⁻²·sr⁻¹\t0.0625 W·m⁻²·sr⁻¹"))
        << window->numbers()->allText().toStdString();
}

TEST_F(ComparisonTest, AllThreeImagesAreEquallyLarge) {
    open(changed(31, 7, 0.5F), scene());
    for (const int i : {1, 2}) {
        EXPECT_NEAR(window->panes()->canvas(i)->width(), window->panes()->canvas(0)->width(), 1);
        EXPECT_NEAR(window->panes()->canvas(i)->height(), window->panes()->canvas(0)->height(), 1);
    }
}

TEST_F(ComparisonTest, TheReadoutFollowsTheKindOfDifference) {
    open(changed(31, 7, -0.5F), scene());
    const std::pair<Qt::Key, const char*> rows[] = {
        {Qt::Key_1, "A − B  -0.5 W·m⁻²·sr⁻¹"},
        {Qt::Key_2, "|A − B|  0.5 W·m⁻²·sr⁻¹"},
        {Qt::Key_3, "(A − B) / ½(|A| + |B|)  -0.285714"},
        {Qt::Key_4, "A / B  0.75"}};
    emit window->panes()->canvas(0)->hovered(QPoint(31, 7));
    for (const auto& [key, words] : rows) {
        press(key);
        EXPECT_TRUE(text("comparisonReadout").endsWith(words))
            << text("comparisonReadout").toStdString();
        EXPECT_TRUE(text("comparisonReadout").contains("A  1.5 W·m⁻²·sr⁻¹"));
        EXPECT_TRUE(text("comparisonReadout").contains("B  2 W·m⁻²·sr⁻¹"));
    }
    const auto& limits = window->panes()->differenceBar()->limits();
    EXPECT_DOUBLE_EQ(limits.low + limits.high, 2.0); // a ratio diverges from 1
    press(Qt::Key_2);
    EXPECT_FALSE(window->panes()->differenceBar()->map().isDiverging());
    EXPECT_EQ(window->panes()->differenceBar()->limits().low, 0.0);
    press(Qt::Key_1);
    EXPECT_TRUE(window->panes()->differenceBar()->map().isDiverging());
    EXPECT_DOUBLE_EQ(window->panes()->differenceBar()->limits().low, -0.5);
    EXPECT_DOUBLE_EQ(window->panes()->differenceBar()->limits().high, 0.5);
}

TEST_F(ComparisonTest, AFewLargeDifferencesDoNotHideTheSmallOnes) {
    // 100 of 1200 pixels differ by a tenth, one by 100.
    irsg::RadianceImage other = scene();
    for (int i = 0; i < 100; ++i) {
        other.primary().values[static_cast<std::size_t>(i)] += 0.1F;
    }
    other.primary().values.back() += 100.0F;
    open(scene(), other);
    auto* bar = window->panes()->differenceBar();
    EXPECT_EQ(bar->mode(), LimitMode::percentile);
    EXPECT_NEAR(bar->limits().high, 0.1, 1e-6);
    EXPECT_NEAR(bar->limits().low, -0.1, 1e-6);
    EXPECT_EQ(bar->outOfRange().below, 1U);
    bar->setMode(LimitMode::full);
    emit bar->modeChosen(LimitMode::full);
    EXPECT_NEAR(bar->limits().high, 100.0, 1e-4);
}

TEST_F(ComparisonTest, AllThreeImagesAreEquallyLargeAndNamedInFullOrWithoutTheirMiddle) {
    open(changed(31, 7, 3.0F), scene());
    for (const int width : {1200, 700, 620}) {
        window->resize(width, 600);
        QTest::qWait(20);
        const auto* panes = window->panes();
        EXPECT_NEAR(panes->canvas(0)->width(), panes->canvas(1)->width(), 1) << width;
        EXPECT_NEAR(panes->canvas(0)->width(), panes->canvas(2)->width(), 1) << width;
        EXPECT_NEAR(panes->canvas(0)->height(), panes->canvas(2)->height(), 1) << width;
        EXPECT_GT(panes->canvas(0)->width(), 180) << width;
        for (const char* title : {"titleA", "titleB", "titleDifference"}) {
            const auto* label = window->findChild<QLabel*>(title);
            EXPECT_LE(label->sizeHint().width(), label->width() + 2) << title << width;
        }
        // The box and the slider of the wipe cover nothing.
        const auto* wipe = window->findChild<QCheckBox*>("wipe");
        const QRect box(wipe->mapTo(window.get(), QPoint()), wipe->size());
        for (int i = 0; i < 3; ++i) {
            const auto* canvas = panes->canvas(i);
            EXPECT_FALSE(
                QRect(canvas->mapTo(window.get(), QPoint()), canvas->size()).intersects(box));
        }
    }
    test::keepScreenshot(*window, "comparison-narrow");
}

TEST_F(ComparisonTest, SpaceShowsBInThePlaceOfAWhileItIsHeld) {
    open(changed(31, 7, 3.0F), scene());
    window->panes()->setColorMap("white-hot");
    const QColor bright = seen(0, {31, 7});
    QTest::keyPress(window->panes()->canvas(0), Qt::Key_Space);
    EXPECT_LT(seen(0, {31, 7}).lightness(), bright.lightness() - 100);
    EXPECT_TRUE(text("titleA").contains("b.exr"));
    QTest::keyRelease(window->panes()->canvas(0), Qt::Key_Space);
    EXPECT_EQ(seen(0, {31, 7}), bright);
    EXPECT_TRUE(text("titleA").contains("a.exr"));
}

TEST_F(ComparisonTest, TheWipeShowsBOnTheRightOfItsLine) {
    open(changed(31, 7, 3.0F), scene());
    const QColor bright = seen(0, {31, 7});
    press(Qt::Key_V);
    EXPECT_TRUE(window->findChild<QCheckBox*>("wipe")->isChecked());
    EXPECT_LT(seen(0, {31, 7}).lightness(), bright.lightness() - 100);
    window->findChild<QSlider*>("wipeAt")->setValue(990);
    EXPECT_EQ(seen(0, {31, 7}), bright);
    press(Qt::Key_V);
    EXPECT_EQ(seen(0, {31, 7}), bright);
}

TEST_F(ComparisonTest, AAndBShareTheirLimitsAndTheirColours) {
    open(changed(31, 7, 8.0F), scene());
    auto* bar = window->panes()->sharedBar();
    bar->setMode(LimitMode::full);
    emit bar->modeChosen(LimitMode::full);
    EXPECT_EQ(bar->limits(), (irsg::DisplayLimits{2.0, 10.0}));
    EXPECT_EQ(seen(0, {12, 12}), seen(1, {12, 12}));
    bar->edit({2.0, 5.0});
    EXPECT_EQ(seen(0, {12, 12}), QColor(Qt::white));
    EXPECT_EQ(seen(1, {12, 12}), QColor(Qt::white));
    press(Qt::Key_M);
    EXPECT_EQ(seen(0, {12, 12}), QColor(Qt::black));
    EXPECT_EQ(seen(1, {12, 12}), QColor(Qt::black));
}

TEST_F(ComparisonTest, ThresholdsDecideTheVerdictAndMarkPixels) {
    open(changed(31, 7, 0.5F), scene());
    EXPECT_EQ(text("verdict"), "DIFFERENT"); // nobody has said what a failure is
    type("failAbsolute", "0.6");
    EXPECT_EQ(text("verdict"), "WARNING");
    type("warnAbsolute", "0.6");
    EXPECT_EQ(text("verdict"), "PASS");
    type("warnHard", "0.4");
    EXPECT_EQ(text("verdict"), "WARNING");
    type("warnHard", "");
    type("failAbsolute", "0.1");
    EXPECT_EQ(text("verdict"), "FAILURE");
    type("failAllowed", "1");
    EXPECT_EQ(text("verdict"), "PASS");
    EXPECT_EQ(window->commandLine(),
              "smat-batch compare a.exr b.exr --fail 0.1 --allow-failures 1 --warn 0.6");

    const QColor unmarked = seen(2, {31, 7});
    press(Qt::Key_X);
    EXPECT_EQ(seen(2, {31, 7}), ColoredPlane::markColor(ColoredPlane::failed));
    EXPECT_EQ(seen(2, {3, 3}), QColor(Qt::white));
    press(Qt::Key_X);
    EXPECT_EQ(seen(2, {31, 7}), unmarked);
}

TEST_F(ComparisonTest, ThresholdsThatCannotBeUsedAreToldAndLeftOut) {
    open(changed(31, 7, 0.5F), scene());
    const std::pair<const char*, const char*> rows[] = {
        {"failAbsolute", "much"}, {"failAbsolute", "-1"}, {"warnPercent", "100"},
        {"warnRelative", "2"},    {"failAllowed", "1.5"}, {"failHard", "nan"},
        {"warnAbsolute", ""}};
    for (const auto& [field, value] : rows) {
        const QString before = window->findChild<QLineEdit*>(field)->text();
        type(field, value);
        EXPECT_FALSE(text("thresholdsWrong").isEmpty()) << field << " " << value;
        EXPECT_EQ(window->options().fail, irsg::ComparisonLevel());
        EXPECT_EQ(window->options().warn, irsg::ComparisonLevel());
        type(field, before);
        EXPECT_TRUE(text("thresholdsWrong").isEmpty());
    }
}

TEST_F(ComparisonTest, RefusesImagesOfDifferentSizeAndSaysWhy) {
    open(scene(), irsg::RadianceImage(30, 40));
    EXPECT_FALSE(window->comparison());
    EXPECT_EQ(text("verdict"), "REFUSED");
    EXPECT_TRUE(text("verdictSentence").contains("30 x 40 pixels"));
    EXPECT_TRUE(text("verdictSentence").contains("40 x 30 pixels"));
    EXPECT_TRUE(window->panes()->canvas(0)->hasImage());
    EXPECT_TRUE(window->panes()->canvas(1)->hasImage());
    EXPECT_FALSE(window->panes()->canvas(2)->hasImage());
    EXPECT_TRUE(window->exportFilters().isEmpty());
    EXPECT_FALSE(window->findChild<QToolButton*>("worstPixel")->isEnabled());
    for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key) {
        press(static_cast<Qt::Key>(key));
    }
    test::keepScreenshot(*window, "comparison-refused");
    window->setSides(ComparisonSide::of(scene(), "a.exr"), ComparisonSide::of(scene(), "c.exr"));
    EXPECT_EQ(text("verdict"), "PASS");
    EXPECT_TRUE(window->panes()->canvas(2)->hasImage());
}

TEST_F(ComparisonTest, NamesNaNAndInfinityWithTheirPlace) {
    irsg::RadianceImage a = scene(), b = scene();
    a.primary().values[a.offset(4, 3)] = std::numeric_limits<float>::quiet_NaN();
    b.primary().values[b.offset(9, 9)] = std::numeric_limits<float>::infinity();
    open(a, b);
    type("failAbsolute", "1000");
    type("failAllowed", "1000");
    EXPECT_EQ(text("verdict"), "FAILURE");
    EXPECT_TRUE(window->numbers()->allText().contains("NaN in A\t1 px\tthe first at (4, 3)"));
    EXPECT_TRUE(window->numbers()->allText().contains("Infinite in B\t1 px\tthe first at (9, 9)"));
    const irsg::Rgb hole = irsg::ColorMap::named("diverging").notANumber();
    EXPECT_EQ(seen(2, {4, 3}), QColor(hole.red, hole.green, hole.blue));
}

TEST_F(ComparisonTest, ChoosesThePlaneAmongThoseThatBothHave) {
    irsg::RadianceImage a = scene(), b = scene();
    a.channel("range_m", "m").values[5] = 7.0F;
    b.channel("range_m", "m").values[5] = 9.0F;
    a.channel("only in A");
    open(a, b);
    auto* planes = window->findChild<QComboBox*>("comparedPlane");
    ASSERT_EQ(planes->count(), 2);
    EXPECT_EQ(text("verdict"), "PASS");
    planes->setCurrentIndex(1);
    emit planes->activated(1);
    EXPECT_EQ(text("verdict"), "DIFFERENT");
    EXPECT_TRUE(window->readoutAt(5, 0).endsWith("A − B  -2 m"))
        << window->readoutAt(5, 0).toStdString();
    EXPECT_TRUE(window->commandLine().contains("--channel range_m"));
}

TEST_F(ComparisonTest, LargeImagesAreComparedInTheBackgroundAndMayGoMeanwhile) {
    irsg::RadianceImage a(900, 700), b(900, 700);
    a.primary().values[a.offset(800, 600)] = 3.0F;
    open(a, b);
    ASSERT_TRUE(settled());
    ASSERT_TRUE(window->comparison());
    EXPECT_EQ(window->comparison()->largest.x, 800);
    type("failAbsolute", "5");
    window.reset();
    QTest::qWait(50);
}

TEST_F(ComparisonTest, KeepsPicturesOfItselfInBothThemes) {
    irsg::RadianceImage a = scene(), b = scene();
    for (std::size_t i = 0; i < a.pixelCount(); ++i) {
        a.primary().values[i] += 0.4F * std::sin(static_cast<float>(i % 40) * 0.4F);
    }
    // Least and most lightness: of a text on its ground far apart, whichever is the darker one.
    const auto lightnessOf = [](QWidget& widget) {
        const QImage picture = widget.grab().toImage();
        std::pair range{255, 0};
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const int lightness = picture.pixelColor(x, y).lightness();
                range = {std::min(range.first, lightness), std::max(range.second, lightness)};
            }
        }
        return range;
    };
    std::vector<QColor> ofImage;
    for (const auto& [mode, name] :
         {std::pair(ThemeMode::light, "light"), {ThemeMode::dark, "dark"}}) {
        SCOPED_TRACE(name);
        applyTheme(*qApp, mode);
        open(a, b);
        auto* tabs = window->findChild<QTabWidget*>("comparisonTabs");
        test::keepScreenshot(*window, std::string("comparison-numbers-") + name);
        const int ground = window->grab().toImage().pixelColor(3, 3).lightness();
        EXPECT_TRUE(mode == ThemeMode::dark ? ground < 90 : ground > 200) << ground;
        for (const char* words : {"comparisonReadout", "verdictSentence", "comparisonNumbers"}) {
            const auto [least, most] = lightnessOf(*window->findChild<QWidget*>(words));
            EXPECT_GT(most - least, 130) << words;
            EXPECT_TRUE(mode == ThemeMode::dark ? least < 90 : most > 200) << words;
        }
        ofImage.push_back(seen(0, {12, 12}));
        EXPECT_EQ(seen(0, {12, 12}), ofImage.front()) << "a theme changes no value's colour";
        press(Qt::Key_T);
        press(Qt::Key_X);
        QTest::qWait(20);
        EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "Thresholds");
        EXPECT_EQ(seen(2, {3, 3}), ColoredPlane::markColor(ColoredPlane::failed));
        test::keepScreenshot(*window, std::string("comparison-thresholds-") + name);
        press(Qt::Key_H);
        press(Qt::Key_V);
        ASSERT_TRUE(settled());
        EXPECT_EQ(tabs->tabText(tabs->currentIndex()), "Histogram");
        const auto [least, most] = lightnessOf(*tabs->currentWidget());
        EXPECT_GT(most - least, 130);
        EXPECT_TRUE(mode == ThemeMode::dark ? least < 90 : most > 200);
        test::keepScreenshot(*window, std::string("comparison-histogram-") + name);
    }
    applyTheme(*qApp, ThemeMode::light);
}

} // namespace
} // namespace smat::gui
