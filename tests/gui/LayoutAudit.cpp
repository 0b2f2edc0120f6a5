#include "tests/gui/LayoutAudit.h"

#include <algorithm>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>

namespace smat::gui::test {
namespace {

QString nameOf(const QWidget& widget) {
    QString name = widget.objectName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        name += " '" + button->text() + "'";
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        name += " '" + label->text().left(40) + "'";
    }
    for (const QWidget* above = widget.parentWidget(); above != nullptr && name.size() < 90;
         above = above->parentWidget()) {
        if (!above->objectName().isEmpty() && !above->objectName().startsWith("qt_")) {
            name += " in " + above->objectName();
        }
    }
    return QString("%1 %2").arg(widget.metaObject()->className(), name);
}

QString at(const QRect& place) {
    return QString(" (%1,%2 %3x%4)")
        .arg(place.x())
        .arg(place.y())
        .arg(place.width())
        .arg(place.height());
}

/// What is read or pressed; views of data may be drawn over.
bool isField(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QLabel*>(&widget) != nullptr ||
           widget.inherits("QwtTextLabel"); // titles of plots
}

/// Fields within others, such as the line of a spin box, are parts of these.
bool isPart(const QWidget& widget) {
    for (const QWidget* above = widget.parentWidget(); above != nullptr;
         above = above->parentWidget()) {
        if (qobject_cast<const QAbstractSpinBox*>(above) != nullptr ||
            qobject_cast<const QComboBox*>(above) != nullptr ||
            qobject_cast<const QTabBar*>(above) != nullptr) {
            return true;
        }
    }
    return widget.objectName().startsWith("qt_");
}

/// The area that scrolls it, in whose hidden part it may lie.
const QAbstractScrollArea* scrollOf(const QWidget& widget) {
    for (const QWidget* above = widget.parentWidget(); above != nullptr;
         above = above->parentWidget()) {
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(above)) {
            return area;
        }
    }
    return nullptr;
}

/// What needs the most room to the right on a page.
QString farthestOn(const QWidget& page) {
    QString farthest = "itself";
    int most_px = 0;
    for (const QWidget* widget : page.findChildren<QWidget*>()) {
        const int least_px = std::max(widget->minimumSizeHint().width(), widget->minimumWidth());
        const int right_px = widget->mapTo(&page, QPoint(least_px, 0)).x();
        if (widget->isVisible() && right_px > most_px) {
            most_px = right_px;
            farthest = QString("%1, up to %2").arg(nameOf(*widget)).arg(right_px);
        }
    }
    return farthest;
}

void findNarrow(const QWidget& widget, QStringList& faults) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget);
        label != nullptr && !label->wordWrap() && label->pixmap().isNull() &&
        !label->text().isEmpty() && label->width() < label->sizeHint().width()) {
        faults << QString("cut words: %1 has %2 of %3 px")
                      .arg(nameOf(widget))
                      .arg(label->width())
                      .arg(label->sizeHint().width());
    }
    if (const auto* label = qobject_cast<const QLabel*>(&widget);
        label != nullptr && label->wordWrap() && !label->text().isEmpty() &&
        label->height() < label->heightForWidth(label->width())) {
        faults << QString("cut lines: %1 has %2 of %3 px")
                      .arg(nameOf(widget))
                      .arg(label->height())
                      .arg(label->heightForWidth(label->width()));
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget);
        button != nullptr && !button->text().isEmpty() &&
        button->width() < button->minimumSizeHint().width()) {
        faults << QString("cut words: %1 has %2 of %3 px")
                      .arg(nameOf(widget))
                      .arg(button->width())
                      .arg(button->minimumSizeHint().width());
    }
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget)) {
        const auto* line = box->findChild<QLineEdit*>();
        const int words_px = line->fontMetrics().horizontalAdvance(line->displayText());
        if (words_px > line->width()) {
            faults << QString("cut number: %1 '%2'").arg(nameOf(widget), line->displayText());
        }
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        option.editable = box->isEditable();
        const QRect field = box->style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                         QStyle::SC_ComboBoxEditField, box);
        const bool hasIcon = !box->itemIcon(box->currentIndex()).isNull();
        const int icon_px = hasIcon ? box->iconSize().width() + 4 : 0;
        if (box->fontMetrics().horizontalAdvance(box->currentText()) + icon_px > field.width()) {
            faults << QString("cut choice: %1 '%2' has %3 px")
                          .arg(nameOf(widget), box->currentText())
                          .arg(field.width());
        }
    }
    // Of what is not a table or a tree, whose columns a person widens.
    if (const auto* area = qobject_cast<const QScrollArea*>(&widget);
        area != nullptr && area->widget() != nullptr &&
        area->widget()->width() > area->viewport()->width()) {
        faults << QString("scrolls sideways: %1 shows %2 of %3 px, for %4")
                      .arg(nameOf(widget))
                      .arg(area->viewport()->width())
                      .arg(area->widget()->width())
                      .arg(farthestOn(*area->widget()));
    }
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget); tabs != nullptr) {
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->isTabVisible(i) &&
                tabs->fontMetrics().horizontalAdvance(QString(tabs->tabText(i)).remove('&')) + 8 >
                    tabs->tabRect(i).width()) {
                faults << QString("cut tab: %1 '%2'").arg(nameOf(widget), tabs->tabText(i));
            }
        }
    }
}

} // namespace

QStringList layoutFaults(const QWidget& page) {
    QStringList faults;
    QList<const QWidget*> fields;
    for (const QWidget* widget : page.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->window() != page.window() || widget->size().isEmpty() ||
            widget->visibleRegion().isEmpty()) {
            continue;
        }
        findNarrow(*widget, faults);
        if (!isField(*widget) || isPart(*widget)) {
            continue;
        }
        fields << widget;
        const auto* area = scrollOf(*widget);
        const QRect seen = widget->visibleRegion().boundingRect();
        // A label may be wider than its words.
        const int words_px = qobject_cast<const QLabel*>(widget) != nullptr
                                 ? std::min(widget->width(), widget->sizeHint().width())
                                 : widget->width();
        if (seen.width() < words_px && area != nullptr &&
            widget->mapTo(area, QPoint(words_px, 0)).x() > area->width()) {
            faults << "cut off at the right: " + nameOf(*widget);
        }
        if (area == nullptr && seen != widget->rect()) {
            faults << "cut off: " + nameOf(*widget);
        }
    }
    for (int i = 0; i < fields.size(); ++i) {
        for (int k = i + 1; k < fields.size(); ++k) {
            if (fields[i]->isAncestorOf(fields[k]) || fields[k]->isAncestorOf(fields[i]) ||
                scrollOf(*fields[i]) != scrollOf(*fields[k])) {
                continue;
            }
            const auto placeOf = [&](const QWidget* widget) {
                return QRect(widget->mapTo(page.window(), QPoint()), widget->size());
            };
            const QRect both = placeOf(fields[i]).intersected(placeOf(fields[k]));
            if (both.width() > 1 && both.height() > 1) {
                faults << QString("one on the other: %1%2 and %3%4")
                              .arg(nameOf(*fields[i]), at(placeOf(fields[i])), nameOf(*fields[k]),
                                   at(placeOf(fields[k])));
            }
        }
    }
    return faults;
}

} // namespace smat::gui::test
