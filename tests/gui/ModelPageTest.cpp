#include "gui/view/ModelPage.h"

#include <QLabel>

#include "gui/image/ColorBar.h"
#include "gui/plot/PlotLook.h"
#include "irsg/core/Errors.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/TiffFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ModelPageTest : public test::WindowFixture {
  protected:
    ModelPage& page() { return *window->findChild<ModelPage*>("modelPage"); }
    bool showInfrared() {
        page().view()->setDisplay(ViewDisplay::infrared);
        return test::waitUntil(
            [this] {
                const auto* picture = page().view()->shownPicture();
                return picture != nullptr && !picture->coarse && page().view()->isUpToDate();
            },
            20.0);
    }
    /// Where a picture lies in another; the upper part of it decides, since what is written below
    /// may change from one picture to the next.
    static std::optional<QPoint> placeIn(const QImage& whole, const QImage& part, int height) {
        QImage page = whole.convertToFormat(QImage::Format_RGB32);
        QImage wanted = part.convertToFormat(QImage::Format_RGB32).copy(0, 0, part.width(), height);
        page.setDevicePixelRatio(1.0);
        wanted.setDevicePixelRatio(1.0);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 60; ++x) {
                if (page.copy(x, y, wanted.width(), 1) == wanted.copy(0, 0, wanted.width(), 1) &&
                    page.copy(QRect(QPoint(x, y), wanted.size())) == wanted) {
                    return QPoint(x, y);
                }
            }
        }
        return std::nullopt;
    }
    QImage exported(const char* name) {
        page().exportTo(folder / name);
        return QImage(QString::fromStdString((folder / name).string()));
    }
};

TEST_F(ModelPageTest, TheVisibleViewIsWrittenAsAPictureAlone) {
    openSample();
    EXPECT_EQ(page().exportFilters(), QStringList{"Picture (*.png)"});
    const QImage seen = exported("visible.png");
    EXPECT_TRUE(placeIn(seen, page().view()->grab().toImage(), 20));
    EXPECT_TRUE(test::holdsWords(seen, "Ship in the test basin", plotFont(1.1, true)));
    EXPECT_TRUE(test::holdsWords(seen, "range", plotFont(0.9)));
    EXPECT_THROW(page().exportTo(folder / "visible.exr"), irsg::InputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "visible.exr"));
    EXPECT_THROW(page().exportTo(folder / "visible.jpg"), irsg::InputError);
}

TEST_F(ModelPageTest, TheInfraredViewIsWrittenWithItsColourBarAndItsValues) {
    openSample();
    ASSERT_TRUE(showInfrared());
    EXPECT_EQ(page().exportFilters(),
              (QStringList{"OpenEXR image (*.exr)", "Values as text (*.csv)", "Picture (*.png)",
                           "TIFF image of 32-bit floats (*.tif *.tiff)"}));
    // None of its colours is that of paper.
    page().view()->infrared().setColorMap("inferno");
    ASSERT_TRUE(showInfrared());
    const InfraredPicture& shown = *page().view()->shownPicture();
    page().exportTo(folder / "view.exr");
    EXPECT_EQ(irsg::readExr(folder / "view.exr").primary().values, shown.plane().values);
    page().exportTo(folder / "view.csv");
    const irsg::RadianceImage text = irsg::readCsvImage(folder / "view.csv");
    EXPECT_EQ(text.primary().values, shown.plane().values);
    EXPECT_EQ(text.primary().unit, "W m-2 sr-1");
    page().exportTo(folder / "view.tif");
    EXPECT_EQ(irsg::readTiff(folder / "view.tif").primary().values, shown.plane().values);

    // Right of the view all colours of the bar, from the last one down to the first.
    const QImage picture = exported("view.png");
    QLabel sheet;
    sheet.setPixmap(QPixmap::fromImage(picture));
    test::keepScreenshot(sheet, "infrared-export");
    const double ratio = page().view()->devicePixelRatio();
    const auto place = placeIn(picture, page().view()->grab().toImage(), 20);
    ASSERT_TRUE(place);
    const int edge = place->x() + static_cast<int>(page().view()->width() * ratio);
    EXPECT_TRUE(test::holdsWords(picture, "Ship in the test basin", plotFont(1.1, true)));
    EXPECT_TRUE(test::holdsWords(picture, "3-5 µm", plotFont(0.9)));
    ASSERT_GT(picture.width(), edge + 60);
    int column = 0;
    const auto isColor = [&](int x, int y, double part) {
        const irsg::Rgb color = page().view()->infrared().colorMap().at(part);
        const QColor found = picture.pixelColor(x, y);
        return std::abs(found.red() - color.red) + std::abs(found.green() - color.green) +
                   std::abs(found.blue() - color.blue) <
               12;
    };
    for (int x = edge; x < picture.width() && column == 0; ++x) {
        int top = 0, bottom = 0;
        for (int y = 0; y < picture.height(); ++y) {
            if (top == 0 && isColor(x, y, 1.0)) {
                top = y;
            }
            if (top != 0 && isColor(x, y, 0.0)) {
                bottom = y;
            }
        }
        if (top == 0 || bottom - top < picture.height() / 2) {
            continue;
        }
        bool inOrder = true;
        for (const double part : {0.25, 0.5, 0.75}) {
            inOrder = inOrder && [&] {
                const int middle = bottom - static_cast<int>(part * (bottom - top));
                for (int y = middle - 12; y <= middle + 12; ++y) {
                    if (isColor(x, y, part)) {
                        return true;
                    }
                }
                return false;
            }();
        }
        column = inOrder ? x : 0;
    }
    EXPECT_GT(column, edge) << "no colour bar";

    // Apparent temperature is what is seen, then.
    page().view()->infrared().setQuantity(InfraredQuantity::apparentTemperature);
    ASSERT_TRUE(test::waitUntil(
        [&] {
            const auto* now = page().view()->shownPicture();
            return now != nullptr && now->plane().unit == "K" && page().view()->isUpToDate();
        },
        20.0));
    page().exportTo(folder / "view.csv");
    EXPECT_EQ(irsg::readCsvImage(folder / "view.csv").primary().unit, "K");
}

} // namespace
} // namespace smat::gui
