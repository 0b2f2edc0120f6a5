#include "gui/WindowMessages.h"

#include <algorithm>
#include <filesystem>

#include <QApplication>
#include <QFileInfo>
#include <QPointer>

#include "gui/widgets/NumberFormat.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Remarks.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// The file that a sentence begins with, as "FILE: words" and "FILE, line 3: words" do; empty for
/// none.
QString fileOf(const QString& sentence) {
    for (qsizetype end = sentence.indexOf(": "); end > 0; end = sentence.indexOf(": ", end + 1)) {
        const QString before = sentence.left(end);
        for (const QString& candidate : {before, before.section(", ", 0, 0)})
            if (QFileInfo(candidate).isFile())
                return candidate;
    }
    return {};
}

bool isSame(const std::filesystem::path& a, const QString& b) {
    std::error_code none;
    return std::filesystem::equivalent(a, b.toStdString(), none);
}

} // namespace

WindowMessages::WindowMessages(Workbench& workbench, QObject* parent)
    : QObject(parent), workbench_(workbench) {
    const ResultStore& results = workbench_.resultStore();
    connect(&results, &ResultStore::added, this, &WindowMessages::takeWarnings);
    connect(&results, &ResultStore::addedQuietly, this, [this](int id) {
        // What was kept with the project has said this before.
        if (const ResultEntry* entry = workbench_.result(id); entry && entry->document.empty())
            takeWarnings(id);
    });
    irsg::setRemarkListener([self = QPointer<WindowMessages>(this)](const std::string& sentence) {
        const QString text = QString::fromStdString(sentence);
        QMetaObject::invokeMethod(
            qApp,
            [self, text] {
                if (self)
                    self->remark(text);
            },
            Qt::QueuedConnection);
    });
}

WindowMessages::~WindowMessages() {
    irsg::setRemarkListener({});
}

void WindowMessages::follow(Dialogs& dialogs) {
    dialogs.tell = [self = QPointer<WindowMessages>(this), tell = dialogs.tell](
                       QWidget* parent, const QString& title, const QStringList& sentences) {
        for (const QString& sentence : sentences)
            if (self)
                self->log_.add({MessageKind::error, title, sentence, self->placeOfTold_});
        tell(parent, title, sentences);
    };
}

void WindowMessages::tellRefusal(const Dialogs& dialogs, QWidget* parent, const QString& title,
                                 const QStringList& sentences) {
    if (workbench_.hasProject())
        placeOfTold_ = places_.settings;
    dialogs.tell(parent, title, sentences);
    placeOfTold_ = {};
}

void WindowMessages::remark(const QString& sentence) {
    const QString file = fileOf(sentence);
    if (file.isEmpty()) {
        log_.add({MessageKind::remark, {}, sentence});
        return;
    }
    QString words = sentence.mid(file.size());
    for (const char* separator : {": ", ", "})
        if (words.startsWith(separator))
            words.remove(0, 2);
    log_.add({MessageKind::remark, QFileInfo(file).fileName(), words, placeOf(file)});
}

std::function<void()> WindowMessages::placeOf(const QString& file) const {
    if (!workbench_.hasProject())
        return {};
    const Project& project = workbench_.project();
    for (std::size_t model = 0; model < project.models.size(); ++model) {
        if (isSame(project.resolve(project.models[model].file), file))
            return [show = places_.model, model] { show(model); };
        if (!project.models[model].database.empty() &&
            isSame(project.resolve(project.models[model].database), file))
            return [show = places_.database, model] { show(model); };
    }
    for (const std::filesystem::path& air : workbench_.settings()[key::environmentAtmospheres])
        if (isSame(project.resolve(air), file))
            return places_.atmosphere;
    return {};
}

void WindowMessages::takeWarnings(int id) {
    const ResultEntry* entry = workbench_.result(id);
    if (entry == nullptr)
        return;
    for (const std::string& warning : entry->data->warnings)
        log_.add({MessageKind::warning, entry->title, textOf(warning),
                  [show = places_.result, id] { show(id); }});
}

} // namespace smat::gui

#include "moc_WindowMessages.cpp"
