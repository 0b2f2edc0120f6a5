#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <gtest/gtest.h>

namespace smat::gui::test {

/// Types a name, and Return, into the field that renaming a result opened in the list.
inline void typeNewName(const QListWidget& list, const QString& name) {
    auto* field = list.findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    field->setText(name);
    QTest::keyClick(field, Qt::Key_Return);
    QTest::qWait(30);
}

} // namespace smat::gui::test
