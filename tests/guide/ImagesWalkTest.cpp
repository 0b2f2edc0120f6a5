#include <QApplication>
#include <QClipboard>
#include <QDropEvent>
#include <QMimeData>
#include <QTreeWidget>
#include <QUrl>

#include "gui/image/ColorBar.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/HotSpotsPanel.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ImageView.h"
#include "gui/image/PixelPanel.h"
#include "gui/image/ProfilePanel.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class ImagesWalkTest : public test::GuideFixture {
  protected:
    ImageView* shown() {
        auto* result = window->currentPage();
        return result != nullptr ? result->imageView() : page<ImageView>();
    }
    static QPointF at(ImageView& view, double x, double y) {
        return view.canvas()->widgetPoint({x, y});
    }
    void setScale(ImageView& view, irsg::ColorScale scale) {
        auto* box = get<QComboBox>("colorScale", &view);
        choose(box, box->findData(static_cast<int>(scale)));
    }
    void setLimits(ImageView& view, LimitMode mode) {
        auto* box = get<QComboBox>("limitMode", &view);
        choose(box, box->findData(static_cast<int>(mode)));
    }
};

TEST_F(ImagesWalkTest, OpenReadAndColour) {
    test::GuideWalk walk("images", "");
    test::keepClipboard();
    const auto project = own("turboprop4");
    ASSERT_TRUE(opens(project));
    for (const auto& [key, value] : {std::pair{"sensor.width", "96"},
                                     {"sensor.height", "72"},
                                     {"state.power", "0.7"},
                                     {"camera.azimuth", "150"},
                                     {"image.truthLayers", "true"}}) {
        workbench.set(key, value);
    }
    runAnalysis("image");
    const irsg::RadianceImage computed = workbench.results().back().data->image;
    ImageView& view = *shown();
    ImageCanvas& canvas = *view.canvas();
    canvas.setFocus();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(&canvas, key, with);
    };

    walk.step("File → Open…, or a drop on the window, shows EXR files and matrices of numbers "
              "(.txt, .dat). Open saved result… adds them, and CSV files, to the results.");
    chosen = path("own.exr");
    act("saveResultAction");
    smat::test::write(folder / "plain.txt", "1 2 3\n4 5 6\n");
    smat::test::write(folder / "plain.dat", "1 2 3\n4 5 6\n");
    for (const char* name : {"own.exr", "plain.txt", "plain.dat"}) {
        chosen = path(name);
        act("openProject");
        ASSERT_NE(shown(), nullptr) << name << said();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path(name))});
        QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &drop);
        ASSERT_NE(shown(), nullptr) << name << said();
        const auto before = workbench.results().size();
        act("openResultAction");
        ASSERT_EQ(workbench.results().size(), before + 1) << name << said();
        EXPECT_EQ(workbench.results().back().data->image.width(), shown()->image().width()) << name;
    }
    EXPECT_EQ(shown()->image().width(), 3);
    const auto results = workbench.results().size();
    irsg::writeCsvImage(computed, folder / "matrix.csv");
    chosen = path("matrix.csv");
    act("openResultAction");
    EXPECT_EQ(workbench.results().size(), results + 1) << said();
    selectResults({0});
    act("showResultAction");
    ASSERT_EQ(shown(), &view);

    walk.step("zoom | wheel, + and −; far in, each pixel shows its value");
    const double fitted = canvas.zoom();
    wheel(&canvas, at(view, 48, 36), 3);
    EXPECT_GT(canvas.zoom(), fitted);
    press(Qt::Key_Plus);
    press(Qt::Key_Minus);
    wheel(&canvas, at(view, 48, 36), 30);
    EXPECT_GT(canvas.zoom(), 40.0) << "as large as a number";
    walk.step("move | right drag, Ctrl+arrows; F fits the image, A shows its actual size");
    auto centre = canvas.view().centre;
    drag(&canvas, Qt::RightButton, QPointF(canvas.rect().center()), {30, 10});
    EXPECT_NE(canvas.view().centre, centre);
    centre = canvas.view().centre;
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_NE(canvas.view().centre, centre);
    press(Qt::Key_A);
    EXPECT_DOUBLE_EQ(canvas.zoom() * canvas.devicePixelRatioF(), 1.0);
    press(Qt::Key_F);
    EXPECT_DOUBLE_EQ(canvas.zoom(), fitted);

    walk.step("read a pixel | hover, or the arrows: radiance, apparent temperature and, with truth "
              "layers, indices and range");
    QTest::mouseMove(&canvas, at(view, 44.5, 35.5).toPoint());
    emit canvas.hovered(canvas.pixelAt(at(view, 44.5, 35.5)));
    const QString read = get<QLabel>("pixelReadout", &view)->text();
    for (const char* word :
         {"x 44   y 35", "Radiance", "Apparent temperature", "emperature index", "ange"}) {
        EXPECT_TRUE(read.contains(word)) << word << " in " << read.toStdString();
    }
    press(Qt::Key_Right);
    EXPECT_NE(get<QLabel>("pixelReadout", &view)->text(), read);

    walk.step("get statistics | drag a rectangle: least, largest, mean, median, deviation, sum, "
              "contrast intensity");
    drag(&canvas, Qt::LeftButton, at(view, 30.5, 20.5),
         at(view, 60.5, 50.5) - at(view, 30.5, 20.5));
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    for (const char* word : {"Rectangle 31 × 31", "contrast intensity", "mean"}) {
        EXPECT_TRUE(view.statistics().contains(word)) << view.statistics().toStdString();
    }
    press(Qt::Key_H);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    const QString figures = view.inspector()->table()->allText();
    for (const char* word : {"Minimum", "Maximum", "Mean", "Median", "deviation", "Sum"}) {
        EXPECT_TRUE(figures.contains(word)) << word << " in " << figures.toStdString();
    }
    press(Qt::Key_H);

    walk.step("see values along a line | Profile (P), then drag a line, or click a pixel for its "
              "row and column; the plot below is exported like any other");
    press(Qt::Key_P);
    QTest::qWait(20);
    drag(&canvas, Qt::LeftButton, at(view, 30.5, 20.5),
         at(view, 60.5, 50.5) - at(view, 30.5, 20.5));
    PlotPanel& profile = *view.profile()->plot();
    ASSERT_EQ(profile.cartesian()->data().curves.size(), 1U);
    EXPECT_EQ(profile.cartesian()->data().curves[0].y.size(), 31U);
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, at(view, 44.5, 35.5).toPoint());
    EXPECT_EQ(profile.cartesian()->data().curves.size(), 2U);
    chosen = path("profile.csv");
    profile.action("saveAllValues")->trigger();
    EXPECT_GT(std::filesystem::file_size(folder / "profile.csv"), 1000U);
    press(Qt::Key_P);
    walk.step("see isotherms | Isotherms (I): lines of equal value in the plane that is shown, at "
              "round levels inside the limits or at those that are typed; exported pictures with "
              "a colour bar have them");
    press(Qt::Key_I);
    ASSERT_TRUE(test::waitUntil([&] { return !view.isBusy(); }));
    EXPECT_FALSE(canvas.isoLines().empty());
    press(Qt::Key_I);

    walk.step("list the hottest spots | Hot spots (G): the ten largest maxima of the plane that is "
              "shown, at least 8 pixels apart, with what the other planes have there: temperature "
              "and, with truth layers, indices and range; a click on a row goes there");
    press(Qt::Key_G);
    FiguresTable& spots = *view.hotSpots()->table();
    ASSERT_GE(spots.rowCount(), 2);
    EXPECT_LE(spots.rowCount(), 10);
    for (const char* word : {"emperature index", "ange", "Apparent temperature"}) {
        EXPECT_TRUE(spots.allText().contains(word)) << spots.allText().toStdString();
    }
    emit spots.cellClicked(0, 0);
    EXPECT_EQ(canvas.cursorPixel(), canvas.spots().front());
    press(Qt::Key_G);

    walk.step("change colours | white-hot, black-hot, ironbow, inferno, viridis; they are never "
              "part of saved data");
    auto* colors = get<QComboBox>("colorMap", &view);
    for (const char* name : {"white-hot", "black-hot", "ironbow", "inferno", "viridis"}) {
        ASSERT_GE(colors->findText(name), 0) << name;
        colors->setCurrentText(name);
        emit colors->textActivated(name);
        EXPECT_EQ(view.colorMap().name(), name);
    }
    view.exportTo(folder / "colored.exr");
    EXPECT_EQ(irsg::readExr(folder / "colored.exr").primary(), computed.primary());

    walk.step("see the antialiasing | W outlines the antialiasing tiles");
    press(Qt::Key_W);
    ASSERT_GE(canvas.outlines().size(), 2U) << "the aircraft and a hot part of it";
    const QPointF inside = canvas.outlines().front().center();
    EXPECT_TRUE(view.readoutAt(static_cast<int>(inside.x()), static_cast<int>(inside.y()))
                    .contains("samples per pixel"));
    press(Qt::Key_W);

    walk.step("learn what a pixel is made of | Explain (X), then a click, or Return on the pixel "
              "that is read: its surfaces");
    canvas.setSelection({});
    press(Qt::Key_X);
    PixelPanel& panel = *view.pixelPanel();
    ASSERT_TRUE(test::waitUntil([&] { return !panel.isBusy(); }, 60.0));
    // The brightest pixel: a surface is there.
    const auto& values = view.image().primary().values;
    const auto most = static_cast<int>(std::ranges::max_element(values) - values.begin());
    const QPoint bright(most % 96, most / 96);
    QTest::mouseClick(&canvas, Qt::LeftButton, {},
                      at(view, bright.x() + 0.5, bright.y() + 0.5).toPoint());
    ASSERT_TRUE(test::waitUntil([&] { return !panel.isBusy(); }, 60.0));
    ASSERT_TRUE(panel.answer()) << panel.problem().toStdString();
    EXPECT_FALSE(panel.answer()->computed.surfaces.empty());
    EXPECT_LT(std::abs(panel.answer()->relative()), 1e-4);
    get<QToolButton>("copyExplanation", &panel)->click();
    EXPECT_TRUE(QApplication::clipboard()->text().contains("thermal"));
    canvas.setCursorPixel(QPoint(0, 0));
    press(Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return !panel.isBusy(); }, 60.0));
    EXPECT_EQ(panel.answer()->computed.x, 0);
    press(Qt::Key_X);

    walk.step("change the scale | automatic, linear, square root, logarithmic, equalized");
    auto* scales = get<QComboBox>("colorScale", &view);
    EXPECT_EQ(scales->count(), 5);
    EXPECT_EQ(scales->currentIndex(), 0);
    walk.step("set the limits | type them at the ends of the colour bar, or let them follow the "
              "target, the whole range or percentiles");
    setLimits(view, LimitMode::full);
    const auto full = view.colorBar()->limits();
    const auto [least, largest] = std::ranges::minmax(values);
    EXPECT_FLOAT_EQ(static_cast<float>(full.high), largest);
    EXPECT_FLOAT_EQ(static_cast<float>(full.low), least);
    setLimits(view, LimitMode::percentile);
    EXPECT_NE(view.colorBar()->limits(), full);
    write(get<QLineEdit>("limitHigh", &view), "2.5");
    EXPECT_EQ(view.colorBar()->limits().high, 2.5);

    walk.step("The automatic scale shows both skin and exhaust pipes: linear if that is enough, "
              "else square root or logarithmic");
    setLimits(view, LimitMode::target);
    EXPECT_EQ(view.colorBar()->outOfRange().above, 0U);
    EXPECT_NE(view.colorBar()->limits().scale, irsg::ColorScale::linear) << "pipes a hundred times";
    const QColor skin = canvas.picture().pixelColor(48, 36),
                 sky = canvas.picture().pixelColor(1, 1);
    EXPECT_NE(skin, sky);
    EXPECT_TRUE(scales->currentText().contains("(") || scales->itemText(0).size() > 4)
        << scales->currentText().toStdString();
    setScale(view, irsg::ColorScale::linear);
    EXPECT_GT(view.colorBar()->outOfRange().above, 0U) << "leaves out the few hottest pixels";
    const auto ran = terminal(
        "smat-batch image " + project.string() +
        " --set sensor.width=32 --set sensor.height=24 --color-scale logarithmic --out a.png");
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png")) << ran.err;

    walk.step(
        "--shadows (render.shadows) takes the sun for a point, which is the default, for a "
        "disc with its penumbra, or casts none. Surfaces hide sky and ground from each other");
    workbench.set("sensor.width", "32");
    workbench.set("sensor.height", "24");
    workbench.set("image.truthLayers", "false");
    const std::string small = " --width 32 --height 24 --out x.exr";
    EXPECT_EQ(Settings().text("render.shadows"), "point");
    EXPECT_EQ(Settings().text("render.bounces"), "converged");
    for (const char* options : {"--shadows off", "--shadows disc", "--bounces 0", "--bounces 1",
                                "--engine rays", "--engine auto"}) {
        terminal("smat-batch image " + project.string() + " " + options + small);
    }
    const auto image = [&](const std::string& options) {
        terminal("smat-batch image " + project.string() + " " + options + small);
        return irsg::readExr(folder / "x.exr").primary().values;
    };
    const auto opengl = image("--engine opengl"), rays = image("--engine rays");
    ASSERT_EQ(opengl.size(), rays.size());
    for (std::size_t i = 0; i < opengl.size(); ++i) {
        EXPECT_NEAR(rays[i], opengl[i], 2e-2F * std::abs(opengl[i]) + 2e-3F) << i;
    }

    walk.step("Pixels beyond the limits have the colours of the ends and are counted; Mark outside "
              "below the colour bar gives them colours of their own (--mark-outside in files)");
    setScale(view, irsg::ColorScale::linear);
    write(get<QLineEdit>("limitHigh", &view), "1");
    EXPECT_GT(view.colorBar()->outOfRange().above, 0U);
    const auto colorOf = [](const irsg::Rgb& color) {
        return QColor(color.red, color.green, color.blue);
    };
    EXPECT_EQ(canvas.picture().pixelColor(bright), colorOf(view.colorMap().at(1.0)));
    get<QCheckBox>("markOutside", &view)->click();
    EXPECT_EQ(canvas.picture().pixelColor(bright), colorOf(view.colorMap().above()));
    terminal("smat-batch image " + project.string() +
             " --width 32 --height 24 --mark-outside --out b.png");
    irsg::RadianceImage photo(4, 2, "R", "");
    for (const char* name : {"G", "B"}) {
        photo.channel(name);
    }
    std::ranges::fill(photo.channel("R").values, 1.0F);
    irsg::writeExr(photo, folder / "photo.exr");
    chosen = path("photo.exr");
    act("openProject");
    ASSERT_TRUE(test::waitUntil([this] { return page<ImageView>() != nullptr; }, 10.0))
        << said() << asked.join(' ').toStdString()
        << tabs()->tabText(tabs()->currentIndex()).toStdString();
    EXPECT_TRUE(shown()->showsColors());
    EXPECT_EQ(shown()->canvas()->picture().pixelColor(1, 1), QColor(255, 0, 0));
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
