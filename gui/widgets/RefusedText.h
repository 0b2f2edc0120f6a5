#pragma once

#include <QString>

class QLineEdit;
class QWidget;

namespace smat::gui {

/// Says beside a field that what was typed is not taken and which value stays: "'2,5,0' has several
/// decimal signs; 100 stays". The sentence stands as long as a tooltip does.
void sayRefused(QWidget& field, const QString& problem, const QString& stays);

/// Reddens a field while its text cannot stand, with the reason as its tooltip; `help` in place of
/// an empty reason.
void markField(QLineEdit& field, const QString& problem, const QString& help);

} // namespace smat::gui
