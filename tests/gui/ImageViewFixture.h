#pragma once

#include <QComboBox>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "gui/image/ColorRule.h"
#include "gui/image/ImageView.h"

namespace smat::gui::test {

/// The view of an image; this test stands in for the person in front of it.
class ImageViewTest : public ::testing::Test {
  protected:
    /// 8 x 6, dark but for one bright pixel in the top row.
    static irsg::RadianceImage small() {
        irsg::RadianceImage image(8, 6);
        for (std::size_t i = 0; i < image.pixelCount(); ++i) {
            image.primary().values[i] = 1.0F;
        }
        image.primary().values[image.offset(2, 0)] = 5.0F;
        auto& index = image.channel("temperature_index");
        index.values[image.offset(2, 0)] = 7.0F;
        return image;
    }

    static QAction* menuEntry(ImageView& view, const char* button, const QString& text) {
        for (QAction* action : view.findChild<QToolButton*>(button)->menu()->actions()) {
            if (action->text() == text) {
                return action;
            }
        }
        return nullptr;
    }

    static void setMode(ImageView& view, LimitMode mode) {
        auto* box = view.findChild<QComboBox*>("limitMode");
        box->setCurrentIndex(box->findData(static_cast<int>(mode)));
        emit box->activated(box->currentIndex());
    }
    ImageViewTest() {
        Dialogs people;
        people.saveFile = [this](QWidget*, const QString&, const QStringList&, const QString&) {
            return chosen;
        };
        people.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            told += sentences;
        };
        view.setDialogs(people);
        view.resize(760, 560);
        view.setImage(small(), irsg::Band::topHat(3.0, 5.0));
        view.show();
        QTest::qWait(20);
    }
    ImageView view;
    QString chosen;
    QStringList told;
};

} // namespace smat::gui::test
