#include "gui/workbench/RecentFiles.h"

#include <QSettings>

#include "gui/widgets/Memory.h"

namespace smat::gui {
namespace {

constexpr int keptFiles = 10;

} // namespace

QStringList recentFiles() {
    return memory().value("recentFiles").toStringList();
}

void rememberFile(const std::filesystem::path& file) {
    QStringList files = recentFiles();
    const QString name = QString::fromStdString(file.string());
    files.removeAll(name);
    files.prepend(name);
    memory().setValue("recentFiles", QStringList(files.mid(0, keptFiles)));
}

} // namespace smat::gui
