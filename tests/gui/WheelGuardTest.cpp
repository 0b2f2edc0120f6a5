#include "gui/widgets/WheelGuard.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QtTest/qtestspontaneevent.h>
#include <gtest/gtest.h>

namespace smat::gui {
namespace {

/// Three notches away from the person, over the middle of a widget, as the window system brings
/// them.
void wheelOver(QWidget& widget) {
    const QPoint at = widget.rect().center();
    QWheelEvent event(at, widget.mapToGlobal(at), {}, QPoint(0, -360), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&widget, &event);
}

class WheelGuardTest : public testing::Test {
  protected:
    WheelGuardTest() {
        auto* column = new QVBoxLayout(&content);
        combo = new QComboBox;
        combo->addItems({"a", "b", "c", "d", "e"});
        combo->setCurrentIndex(1);
        editable = new QComboBox;
        editable->setEditable(true);
        editable->addItems({"a", "b", "c"});
        spin = new QSpinBox;
        spin->setValue(50);
        slider = new QSlider(Qt::Horizontal);
        slider->setValue(50);
        for (QWidget* field : std::initializer_list<QWidget*>{combo, editable, spin, slider}) {
            column->addWidget(field);
        }
    }
    void expectNothingChanged() const {
        EXPECT_EQ(combo->currentIndex(), 1);
        EXPECT_EQ(editable->currentIndex(), 0);
        EXPECT_EQ(spin->value(), 50);
        EXPECT_EQ(slider->value(), 50);
    }

    QWidget content;
    QComboBox *combo = nullptr, *editable = nullptr;
    QSpinBox* spin = nullptr;
    QSlider* slider = nullptr;
};

TEST_F(WheelGuardTest, AFormThatScrollsScrollsAndItsFieldsStay) {
    QScrollArea area;
    content.setMinimumHeight(3000);
    area.setWidget(&content);
    area.setWidgetResizable(true);
    area.resize(300, 300);
    area.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&area));
    int before = area.verticalScrollBar()->value();
    for (QWidget* field :
         std::initializer_list<QWidget*>{combo, editable, editable->lineEdit(), spin, slider}) {
        field->setFocus();
        wheelOver(*field);
        expectNothingChanged();
        EXPECT_GT(area.verticalScrollBar()->value(), before) << field->metaObject()->className();
        before = area.verticalScrollBar()->value();
    }
    area.takeWidget();
}

TEST_F(WheelGuardTest, ElsewhereTheFieldWithTheFocusAloneChanges) {
    content.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&content));
    content.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&content));
    slider->setFocus();
    wheelOver(*combo);
    wheelOver(*editable);
    wheelOver(*spin);
    expectNothingChanged();
    wheelOver(*slider);
    EXPECT_NE(slider->value(), 50);
}

} // namespace
} // namespace smat::gui
