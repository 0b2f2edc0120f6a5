#include <algorithm>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "smatcore/results/ResultFolder.h"

namespace smat::gui {
namespace {

ResultDocument documentOf(const ResultEntry& entry) {
    return {.title = entry.title.toStdString(),
            .notes = entry.notes.toStdString(),
            .origin = entry.origin,
            .madeAt = entry.madeAt.toString(Qt::ISODate).toStdString(),
            .data = entry.data,
            .monteCarlo = entry.monteCarlo,
            .file = entry.file};
}

ResultEntry entryOf(const ResultDocument& document, const std::string& stem) {
    return {.title = QString::fromStdString(document.title),
            .notes = QString::fromStdString(document.notes),
            .data = document.data,
            .monteCarlo = document.monteCarlo,
            .origin = document.origin,
            .madeAt = QDateTime::fromString(QString::fromStdString(document.madeAt), Qt::ISODate),
            .file = document.file,
            .document = stem};
}

} // namespace

/// What was found beside a project.
struct ResultStore::Read {
    std::vector<std::pair<std::string, ResultDocument>> documents; ///< by stem
    QStringList sentences;
};

void ResultStore::clear() {
    reading_.cancel();
    while (!entries_.empty()) {
        const int id = entries_.back().id;
        entries_.pop_back();
        emit removed(id);
    }
    nextId_ = 1;
    removed_.clear();
    folder_.clear();
    emit unsavedChanged();
}

void ResultStore::openProject(const std::filesystem::path& projectFile, const std::string& folder) {
    reading_.cancel();
    folder_ =
        projectFile.empty() ? std::filesystem::path() : ResultFolder(projectFile, folder).path();
    if (projectFile.empty())
        return;
    reading_.run<std::shared_ptr<Read>>(
        [projectFile, name = folder] {
            auto read = std::make_shared<Read>();
            const ResultFolder folder(projectFile, name);
            const auto stems = folder.documents();
            if (!name.empty() && stems.empty())
                read->sentences << tr("The results of this project are missing: %1 was "
                                      "moved or deleted.")
                                       .arg(QString::fromStdString(folder.path().string()));
            for (const auto& stem : stems) {
                try {
                    read->documents.emplace_back(stem, folder.load(stem));
                } catch (const irsg::InputError& error) {
                    read->sentences << sentencesOf(error);
                }
            }
            return read;
        },
        [this, from = folder_](const std::shared_ptr<Read>& read) { restore(from, *read); });
}

void ResultStore::restore(const std::filesystem::path& folder, const Read& read) {
    for (const auto& [stem, document] : read.documents) {
        ResultEntry entry = entryOf(document, stem);
        // Saved under another name in the meantime: there they are not yet.
        if (folder != folder_)
            entry.document.clear();
        const int number = QString::fromStdString(stem).section('-', 0, 0).toInt();
        entry.id = number > 0 && find(number) == nullptr ? number : nextId_;
        nextId_ = std::max(nextId_, entry.id + 1);
        entries_.push_back(std::move(entry));
        emit addedQuietly(entries_.back().id);
    }
    emit unsavedChanged();
    if (!read.sentences.isEmpty())
        emit problems(read.sentences);
}

bool ResultStore::holdsAny(const std::filesystem::path& projectFile,
                           const std::string& folder) const {
    if (!entries_.empty() || isReading())
        return true;
    // Those that cannot be read are no reason to forget the folder.
    return ResultFolder(projectFile, folder).documents().size() > removed_.size();
}

void ResultStore::saveWith(const std::filesystem::path& projectFile, const std::string& name) {
    const ResultFolder folder(projectFile, name);
    // Elsewhere none is kept yet, and what was taken off the list never was.
    if (folder.path() != folder_) {
        for (ResultEntry& entry : entries_)
            entry.document.clear();
        removed_.clear();
        folder_ = folder.path();
    }
    QStringList writtenAgain;
    std::vector<irsg::Diagnostic> refused;
    for (ResultEntry& entry : entries_) {
        const bool isGone = !entry.document.empty() && !folder.holds(entry.document);
        if (isGone)
            writtenAgain << entry.title;
        irsg::collect(refused, [&] {
            if (isGone || entry.document.empty())
                entry.document = folder.save(documentOf(entry), entry.id);
            else if (entry.wordsChanged)
                folder.saveWords(documentOf(entry), entry.document);
            entry.wordsChanged = false;
        });
    }
    std::erase_if(removed_, [&](const auto& document) {
        irsg::collect(refused, [&] { folder.remove(document); });
        return !folder.holds(document);
    });
    emit unsavedChanged();
    if (!writtenAgain.isEmpty())
        emit problems({tr("Moved or deleted meanwhile, and written again: %1.")
                           .arg(writtenAgain.join(", "))});
    if (!refused.empty())
        throw irsg::InputError(refused);
}

} // namespace smat::gui
