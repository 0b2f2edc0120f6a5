#pragma once

#include <filesystem>
#include <memory>

#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageCanvas.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui::test {

/// The window that compares two images; this test stands in for the person in front of it.
class ComparisonTest : public ::testing::Test {
  protected:
    /// 40 x 30 of 2, and 5 where a bright thing is.
    static irsg::RadianceImage scene() {
        irsg::RadianceImage image(40, 30);
        for (float& value : image.primary().values) {
            value = 2.0F;
        }
        for (int x = 10; x < 20; ++x) {
            image.primary().values[image.offset(x, 12)] = 5.0F;
        }
        return image;
    }

    static irsg::RadianceImage changed(int x, int y, float by) {
        irsg::RadianceImage image = scene();
        image.primary().values[image.offset(x, y)] += by;
        return image;
    }
    ComparisonTest() {
        people.openFile = [this](QWidget*, const QString&, const QStringList&) { return chosen; };
        people.saveFile = [this](QWidget*, const QString&, const QStringList&, const QString&) {
            return chosen;
        };
        people.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            told += sentences;
        };
    }
    void open(irsg::RadianceImage a, irsg::RadianceImage b) {
        window = std::make_unique<ComparisonWindow>(ComparisonSide::of(std::move(a), "a.exr"),
                                                    ComparisonSide::of(std::move(b), "b.exr"),
                                                    nullptr, people);
        showWindow();
    }
    void showWindow() {
        window->resize(1200, 860);
        window->show();
        window->panes()->canvas(0)->setFocus();
        QTest::qWait(30);
    }
    QString text(const char* name) const { return window->findChild<QLabel*>(name)->text(); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(window->panes()->canvas(0), key, modifiers);
    }
    void type(const char* field, const QString& value) {
        auto* edit = window->findChild<QLineEdit*>(field);
        edit->setText(value);
        emit edit->editingFinished();
    }
    QColor seen(int canvas, const QPoint& pixel) const {
        auto* widget = window->panes()->canvas(canvas);
        return test::colorAt(widget->grab().toImage(),
                             widget->widgetPoint(QPointF(pixel) + QPointF(0.5, 0.5)));
    }
    bool settled() {
        return test::waitUntil([this] { return !window->isBusy(); });
    }

    Dialogs people;
    QString chosen;
    QStringList told;
    std::unique_ptr<ComparisonWindow> window;
    std::filesystem::path folder = test::freshFolder("comparison");
};

} // namespace smat::gui::test
