#include "gui/image/ColorBar.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageCanvas.h"
#include "gui/settings/SettingsDialog.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

irsg::RadianceImage image(float hottest) {
    irsg::RadianceImage made(20, 15);
    for (std::size_t i = 0; i < made.pixelCount(); ++i) {
        made.primary().values[i] = 2.0F + 0.001F * static_cast<float>(i);
    }
    made.primary().values[made.offset(7, 4)] = hottest;
    return made;
}

class ComparisonWalkTest : public test::GuideFixture {};

TEST_F(ComparisonWalkTest, TwoImagesAndTheirDifference) {
    test::GuideWalk walk("images", "Comparing two images");
    irsg::writeExr(image(3.0F), folder / "a.exr");
    irsg::writeExr(image(2.5F), folder / "b.exr");
    irsg::writeExr(irsg::RadianceImage(8, 8), folder / "other.exr");
    irsg::writeCsvImage(image(2.5F), folder / "b.csv");

    walk.step("Tools → Compare images… takes EXR of this and other programs and CSV, also plain "
              "matrices as SMAT and KARMA wrote them. A is top left, B top right, A − B below.");
    act("compareImages");
    auto* compared = page<ComparisonWindow>();
    ASSERT_NE(compared, nullptr);
    smat::test::write(folder / "plain.txt", "1 2 3\n4 5 6\n");
    compared->openFiles({path("plain.txt"), path("plain.txt")});
    ASSERT_TRUE(test::waitUntil([&] { return compared->comparison().has_value(); })) << said();
    for (const char* second : {"b.csv", "b.exr"}) {
        compared->openFiles({path("a.exr"), path(second)});
        ASSERT_TRUE(test::waitUntil([&] {
            return !compared->isBusy() && compared->comparison().has_value();
        })) << said();
        EXPECT_FLOAT_EQ(static_cast<float>(compared->comparison()->largest.error), 0.5F) << second;
    }
    ComparisonPanes& panes = *compared->panes();
    const auto place = [&](int i) {
        return panes.canvas(i)->mapTo(compared, panes.canvas(i)->rect().center());
    };
    EXPECT_LT(place(0).x(), place(1).x());
    EXPECT_EQ(place(0).y(), place(1).y());
    EXPECT_GT(place(2).y(), place(0).y());

    walk.step("All three zoom and move together, and the read-out shows A, B and the difference. "
              "Hold Space to flicker");
    ImageCanvas& first = *panes.canvas(0);
    first.setFocus();
    wheel(&first, {40, 40}, 4);
    drag(&first, Qt::RightButton, {60, 50}, {20, 10});
    for (const int i : {1, 2}) {
        EXPECT_DOUBLE_EQ(panes.canvas(i)->zoom(), first.zoom());
        EXPECT_EQ(panes.canvas(i)->view().centre, first.view().centre);
    }
    const auto press = [&](Qt::Key key) {
        QTest::keyClick(&first, key);
        QTest::qWait(10);
    };
    const auto text = [&](const char* name) { return get<QLabel>(name, compared)->text(); };
    press(Qt::Key_W);
    EXPECT_EQ(first.cursorPixel(), QPoint(7, 4));
    for (const char* words : {"A  3 ", "B  2.5 ", "A − B  0.5 "}) {
        EXPECT_TRUE(text("comparisonReadout").contains(words))
            << text("comparisonReadout").toStdString();
    }
    QTest::keyPress(&first, Qt::Key_Space);
    EXPECT_TRUE(panes.isFlickering());
    EXPECT_TRUE(text("titleA").contains("b.exr"));
    QTest::keyRelease(&first, Qt::Key_Space);
    EXPECT_TRUE(text("titleA").contains("a.exr"));
    press(Qt::Key_V);
    EXPECT_TRUE(panes.isWiping());
    press(Qt::Key_V);
    for (const auto& [key, words] : {std::pair{Qt::Key_2, "|A − B|  0.5"},
                                     {Qt::Key_3, "0.181818"},
                                     {Qt::Key_4, "A / B  1.2"},
                                     {Qt::Key_1, "A − B  0.5"}}) {
        press(key);
        emit first.hovered(QPoint(7, 4));
        EXPECT_TRUE(text("comparisonReadout").contains(words))
            << text("comparisonReadout").toStdString();
    }
    auto* bar = panes.differenceBar();
    EXPECT_TRUE(bar->map().isDiverging());
    EXPECT_EQ(bar->limits().low, -bar->limits().high);
    EXPECT_EQ(bar->mode(), LimitMode::percentile);
    EXPECT_EQ(bar->percentiles().second, 99.5);
    auto* mode = bar->findChild<QComboBox*>("limitMode");
    ASSERT_GE(mode->findText("Full range"), 0);
    choose(mode, mode->findText("Full range"));
    EXPECT_FLOAT_EQ(static_cast<float>(bar->limits().high), 0.5F);
    press(Qt::Key_X);
    EXPECT_TRUE(get<QCheckBox>("markPixels", compared)->isChecked());
    press(Qt::Key_X);

    walk.step("The table has all numbers: mean error, MAE, RMSE, PSNR with its peak, relMSE with "
              "its ε");
    const QString numbers = compared->numbers()->allText();
    for (const char* word :
         {"Mean error, A − B", "Mean absolute error", "RMS error", "PSNR", "peak 3", "relMSE",
          "epsilon ", "at (7, 4), A 3, B 2.5", "Pixels over the fail threshold", "NaN in A",
          "Infinite in A", "Sum of the values, A − B"}) {
        EXPECT_TRUE(numbers.contains(word)) << word << " in " << numbers.toStdString();
    }
    EXPECT_FALSE(get<QWidget>("thresholds", compared)->isVisible());
    press(Qt::Key_T);
    auto* line = get<QLineEdit>("commandLine", compared);
    EXPECT_TRUE(line->isVisible());
    write(get<QLineEdit>("warnAbsolute", compared), "1e-6");
    write(get<QLineEdit>("failAbsolute", compared), "1e-3");
    EXPECT_TRUE(line->text().startsWith("smat-batch compare ")) << line->text().toStdString();
    EXPECT_EQ(text("verdict"), "FAILURE");
    compared->openFiles({path("a.exr"), path("other.exr")});
    ASSERT_TRUE(test::waitUntil([&] { return text("verdict") == "REFUSED"; }));

    walk.step("smat-batch compare a.exr b.exr --warn 1e-6 --fail 1e-3 --out difference.exr");
    terminal("smat-batch compare a.exr b.exr --warn 1e-6 --fail 1e-3 --out difference.exr", 2);
    EXPECT_FLOAT_EQ(irsg::readExr(folder / "difference.exr").at(7, 4), 0.5F);
    terminal("smat-batch compare a.exr b.exr --warn 1e-6 --fail 1", 1);
    terminal("smat-batch compare a.exr a.exr --warn 1e-6 --fail 1e-3", 0);

    walk.step("In fog and spray objects have a haze: Tools → Options…, page Scattering, switches "
              "it on, names its MTF database");
    openSample();
    bool isThere = false;
    onDialog = [&](QDialog& dialog) {
        auto* pages = dialog.findChild<QListWidget*>("pageList");
        const auto found = pages->findItems("Scattering", Qt::MatchExactly);
        ASSERT_EQ(found.size(), 1);
        pages->setCurrentItem(found.front());
        QTest::qWait(20);
        isThere = dialog.findChild<QLineEdit*>("environment.mtf") != nullptr;
        EXPECT_NE(dialog.findChild<QLabel*>("mtfNote"), nullptr);
    };
    act("options");
    onDialog = nullptr;
    EXPECT_TRUE(isThere);
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
