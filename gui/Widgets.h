#pragma once

#include <optional>

#include <QString>

class QLineEdit;
class QToolButton;

namespace smat::gui {

/// A button of a bar, without a parent.
QToolButton* textButton(const QString& text, const QString& objectName, const QString& toolTip);

/// The finite number that a field holds, as files have them; none for anything else.
std::optional<double> numberIn(const QLineEdit* field);

} // namespace smat::gui
