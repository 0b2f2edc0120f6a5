#pragma once

#include <QDialogButtonBox>

class QDialog;

namespace smat::gui {

/// The buttons of a dialog, which accept and reject it. `word` stands on the first of them in place
/// of OK.
QDialogButtonBox* okAndCancel(QDialog& dialog, const QString& word = {});
QDialogButtonBox* closeAlone(QDialog& dialog);

} // namespace smat::gui
