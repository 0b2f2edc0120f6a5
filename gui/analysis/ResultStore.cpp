#include "gui/analysis/ResultStore.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/data/ResultDifference.h"

namespace smat::gui {
namespace {

std::shared_ptr<const AnalysisData> shared(AnalysisData data) {
    return std::make_shared<const AnalysisData>(std::move(data));
}

} // namespace

const ResultEntry* ResultStore::find(int id) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [id](const ResultEntry& entry) { return entry.id == id; });
    return found == entries_.end() ? nullptr : &*found;
}

AnalysisKind ResultEntry::kind() const {
    return monteCarlo ? AnalysisKind::monteCarlo : data->kind;
}

ResultEntry* ResultStore::edit(int id) {
    const auto found = std::ranges::find(entries_, id, &ResultEntry::id);
    return found == entries_.end() ? nullptr : &*found;
}

int ResultStore::keep(ResultEntry entry, bool quietly) {
    entry.id = nextId_++;
    entry.title = QStringLiteral("%1  %2").arg(entry.id).arg(entry.title);
    entry.madeAt = QDateTime::currentDateTime();
    entries_.push_back(std::move(entry));
    const int id = entries_.back().id;
    if (quietly)
        emit addedQuietly(id);
    else
        emit added(id);
    emit unsavedChanged();
    return id;
}

int ResultStore::add(std::shared_ptr<const AnalysisData> data) {
    const bool unnamed = data->name.empty() || data->name == name(data->kind);
    QString what = QString::fromStdString(unnamed ? title(data->kind) : data->name);
    if (data->state == AnalysisState::partial)
        what += tr(" (partial)");
    return keep({.title = what, .data = std::move(data), .origin = ResultEntry::Origin::run});
}

int ResultStore::add(std::shared_ptr<const MonteCarloData> run, bool quietly) {
    const AnalysisData& data = run->analysis;
    const bool unnamed = data.name.empty() || data.name == name(data.kind);
    QString what =
        tr("Monte Carlo: %1").arg(QString::fromStdString(unnamed ? title(data.kind) : data.name));
    if (data.state == AnalysisState::partial)
        what += tr(" (partial)");
    return keep({.title = what,
                 .data = {run, &run->analysis},
                 .monteCarlo = run,
                 .origin = ResultEntry::Origin::run},
                quietly);
}

int ResultStore::open(const std::filesystem::path& file) {
    return keep({.title = QString::fromStdString(file.filename().string()),
                 .data = shared(loadResult(file)),
                 .origin = ResultEntry::Origin::file,
                 .file = file});
}

int ResultStore::addDifference(int first, int second) {
    const ResultEntry* a = find(first);
    const ResultEntry* b = find(second);
    if (a == nullptr || b == nullptr)
        throw irsg::LogicError("a difference needs two results that are there");
    if (a->isImage() || b->isImage())
        throw irsg::InputError({a->title.toStdString() + ", " + b->title.toStdString(), "",
                                "images",
                                "two plots; images are compared in Tools, Compare "
                                "images"});
    AnalysisData data;
    data.kind = a->data->kind;
    data.state = AnalysisState::complete;
    data.table = differenceOf({a->title.toStdString(), &a->data->table},
                              {b->title.toStdString(), &b->data->table});
    data.name = data.table.provenance.value("name");
    return keep({.title = QStringLiteral("%1 − %2").arg(first).arg(second),
                 .data = shared(std::move(data)),
                 .origin = ResultEntry::Origin::difference});
}

int ResultStore::addTable(const QString& title, const ResultTable& table, bool quietly) {
    AnalysisData data;
    data.kind = resultKindOf(table.provenance);
    data.state = AnalysisState::complete;
    data.name = title.toStdString();
    data.table = table;
    data.commandLine = table.provenance.value("command");
    return keep(
        {.title = title, .data = shared(std::move(data)), .origin = ResultEntry::Origin::tool},
        quietly);
}

void ResultStore::rename(int id, const QString& title) {
    ResultEntry* entry = edit(id);
    if (entry == nullptr || title.trimmed().isEmpty() || entry->title == title.trimmed())
        return;
    entry->title = title.trimmed();
    entry->wordsChanged = true;
    emit renamed(id);
    emit unsavedChanged();
}

void ResultStore::annotate(int id, const QString& notes) {
    ResultEntry* entry = edit(id);
    if (entry == nullptr || entry->notes == notes.trimmed())
        return;
    entry->notes = notes.trimmed();
    entry->wordsChanged = true;
    emit renamed(id);
    emit unsavedChanged();
}

void ResultStore::noteSaved(int id, const std::filesystem::path& file) {
    ResultEntry* entry = edit(id);
    if (entry != nullptr && entry->origin != ResultEntry::Origin::file) {
        entry->file = file;
        emit unsavedChanged();
    }
}

void ResultStore::remove(int id) {
    const ResultEntry* entry = find(id);
    if (entry == nullptr)
        return;
    if (!entry->document.empty())
        removed_.push_back(entry->document);
    std::erase_if(entries_, [id](const ResultEntry& one) { return one.id == id; });
    emit removed(id);
    emit unsavedChanged();
}

int ResultStore::unsavedCount() const {
    return static_cast<int>(
        std::ranges::count_if(entries_, [](const auto& entry) { return entry.isUnsaved(); }) +
        static_cast<std::ptrdiff_t>(removed_.size()));
}

QString durationText(double seconds) {
    if (seconds < 60.0)
        return ResultStore::tr("%1 s").arg(QString::number(seconds, 'g', 3));
    const auto whole = static_cast<long long>(seconds + 0.5);
    if (whole < 3600)
        return ResultStore::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return ResultStore::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

QString stateOf(const ResultEntry& entry) {
    switch (entry.origin) {
    case ResultEntry::Origin::file:
        return ResultStore::tr("opened from %1")
            .arg(QString::fromStdString(entry.file.filename().string()));
    case ResultEntry::Origin::difference:
        return ResultStore::tr("difference");
    case ResultEntry::Origin::tool:
        return ResultStore::tr("computed");
    case ResultEntry::Origin::run:
        break;
    }
    return entry.data->state == AnalysisState::partial ? ResultStore::tr("partial")
                                                       : ResultStore::tr("complete");
}

QStringList describe(const ResultEntry& entry) {
    QStringList lines{entry.title};
    QString made =
        QLocale::system().toString(entry.madeAt, QLocale::ShortFormat) + ", " + stateOf(entry);
    if (entry.canRunAgain())
        made += ResultStore::tr(", %1").arg(durationText(entry.data->elapsed_s));
    lines << made;
    for (const auto& figure : entry.data->summary)
        lines << QStringLiteral("%1: %2 %3")
                     .arg(QString::fromStdString(figure.label))
                     .arg(figure.value, 0, 'g', 6)
                     .arg(QString::fromStdString(figure.unit))
                     .trimmed();
    if (!entry.notes.isEmpty())
        lines << ResultStore::tr("Notes: %1").arg(QString(entry.notes).replace('\n', ' '));
    for (const auto& [key, value] : entry.data->table.provenance.entries)
        lines << QString::fromStdString(key) + ": " + QString::fromStdString(value);
    return lines;
}

} // namespace smat::gui

#include "moc_ResultStore.cpp"
