#include "gui/view/ModelPage.h"

#include <QLabel>

#include "gui/image/ColorBar.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/TiffFile.h"
#include "irsg/radiometry/Errors.h"
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
    QImage exported(const char* name) {
        page().exportTo(folder / name);
        return QImage(QString::fromStdString((folder / name).string()));
    }
};

TEST_F(ModelPageTest, TheVisibleViewIsWrittenAsAPictureAlone) {
    openSample();
    EXPECT_EQ(page().exportFilters(), QStringList{"Picture (*.png)"});
    const QImage seen = exported("visible.png");
    EXPECT_EQ(seen.size(), page().view()->size() * page().view()->devicePixelRatio());
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
    const int edge = static_cast<int>(page().view()->width() * ratio);
    const auto topOf = [edge](const QImage& of) {
        QImage part = of.convertToFormat(QImage::Format_RGB32).copy(0, 0, edge, 20);
        part.setDevicePixelRatio(1.0);
        return part;
    };
    EXPECT_TRUE(topOf(picture) == topOf(page().view()->grab().toImage()));
    ASSERT_GT(picture.width(), edge + 60);
    int column = 0;
    const auto isColor = [&](int x, int y, double part) {
        const irsg::Rgb color = page().view()->colorMap().at(part);
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
    page().view()->setQuantity(InfraredQuantity::apparentTemperature);
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
