#include "gui/start/GuidePage.h"

#include <QImage>

#include "gui/start/DataFolder.h"

namespace smat::gui {
namespace {

constexpr const char* guideFolder = "docs/user-guide";
constexpr int widestPicture_px = 760;

} // namespace

GuidePage::GuidePage(const QString& chapter, QWidget* parent) : QTextBrowser(parent) {
    setObjectName("guidePage");
    setFrameShape(QFrame::NoFrame);
    setOpenExternalLinks(true);
    document()->setDocumentMargin(24);
    const auto file = dataFolder(guideFolder) / chapter.toStdString();
    setSource(QUrl::fromLocalFile(QString::fromStdString(file.string())));
}

bool GuidePage::isThere() {
    return !dataFolder(guideFolder).empty();
}

QVariant GuidePage::loadResource(int type, const QUrl& name) {
    const QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource)
        return resource;
    QImage picture;
    if (resource.canConvert<QImage>())
        picture = resource.value<QImage>();
    if (picture.isNull() && resource.typeId() == QMetaType::QByteArray)
        picture.loadFromData(resource.toByteArray());
    if (picture.width() <= widestPicture_px)
        return picture.isNull() ? resource : QVariant(picture);
    return picture.scaledToWidth(widestPicture_px, Qt::SmoothTransformation);
}

} // namespace smat::gui

#include "moc_GuidePage.cpp"
