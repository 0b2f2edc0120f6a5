// Bars whose fields go on in further rows.
#include "gui/widgets/FlowBar.h"

#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

TEST(FlowBar, GoesOnInFurtherRowsWhereItIsTooNarrow) {
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    auto* bar = new FlowBar(&page);
    auto* below = new QWidget(&page);
    below->setMinimumHeight(40);
    column->addWidget(bar);
    column->addWidget(below, 1);
    QList<QPushButton*> first, second;
    for (const char* word : {"Radiance", "ironbow"}) {
        first << new QPushButton(word, bar);
        bar->first()->addWidget(first.back());
    }
    for (const char* word : {"Histogram", "Profile", "Isotherms", "Hot spots", "Antialiasing tiles",
                             "Explain", "Copy", "Export", "Fit", "1:1"}) {
        second << new QPushButton(word, bar);
        bar->second()->addWidget(second.back());
    }
    page.show();
    const int whole = bar->first()->sizeHint().width() + bar->second()->sizeHint().width() + 60;
    for (const int width : {whole, bar->second()->sizeHint().width() + 30, 390, 300, 150}) {
        SCOPED_TRACE(width);
        page.resize(width, 500);
        QTest::qWait(20);
        ASSERT_EQ(page.width(), width); // nothing makes it wider
        QList<QRect> places;
        for (QPushButton* button : first + second) {
            const QRect at = button->geometry();
            EXPECT_TRUE(bar->rect().contains(at))
                << button->text().toStdString() << ' ' << at.x() << ',' << at.y() << ' '
                << at.width() << 'x' << at.height() << " in " << bar->height();
            for (const QRect& other : places) {
                EXPECT_FALSE(other.intersects(at)) << button->text().toStdString();
            }
            places << at;
        }
        // The narrowest have a row for each, the first group too.
        EXPECT_LT(bar->height(), width == whole ? 40 : width < 200 ? 450 : 230);
        EXPECT_EQ(first.front()->y() == first.back()->y(), width > 200);
        EXPECT_EQ(first.front()->y() == second.front()->y(), width == whole);
    }
}

} // namespace
} // namespace smat::gui
