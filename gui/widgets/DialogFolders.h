#pragma once

#include <QString>

namespace smat::gui {

/// The folder in which a dialog of this title was last answered, in this session or an earlier one;
/// where it never was, that of the last answer to any; empty where that is gone.
QString lastFolder(const QString& title);
/// Where a dialog begins: a suggestion with a folder as it is, a bare name in the last folder.
QString startOf(const QString& title, const QString& suggestion);
/// Remembers the folder of an answer, if it is one. Gives it back.
QString remembered(const QString& title, const QString& file);

} // namespace smat::gui
