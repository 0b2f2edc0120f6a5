#include "gui/widgets/DialogFolders.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

#include "gui/widgets/Memory.h"

namespace smat::gui {
namespace {

constexpr const char* ofAny = "folders/last";

/// Titles have letters that keys of settings cannot have.
QString keyOf(const QString& title) {
    const QByteArray digest =
        QCryptographicHash::hash(title.toUtf8(), QCryptographicHash::Sha1).toHex().left(12);
    return "folders/" + QString::fromLatin1(digest);
}

} // namespace

QString lastFolder(const QString& title) {
    const QSettings kept = memory();
    for (const QString& key : {keyOf(title), QString(ofAny)})
        if (const QString folder = kept.value(key).toString();
            !folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    return {};
}

QString startOf(const QString& title, const QString& suggestion) {
    const QString folder = lastFolder(title);
    if (suggestion.isEmpty())
        return folder;
    return suggestion.contains('/') || folder.isEmpty() ? suggestion
                                                        : QDir(folder).filePath(suggestion);
}

QString remembered(const QString& title, const QString& file) {
    if (file.isEmpty())
        return file;
    const QString folder = QFileInfo(file).absolutePath();
    QSettings kept = memory();
    kept.setValue(keyOf(title), folder);
    kept.setValue(ofAny, folder);
    return file;
}

} // namespace smat::gui
