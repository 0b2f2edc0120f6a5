#include "gui/analysis/ResultsDock.h"

#include <algorithm>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/ResultDetailsDialog.h"
#include "gui/analysis/ResultItemDelegate.h"
#include "gui/analysis/ResultNotesDialog.h"
#include "gui/image/ImageExport.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/UnsavedNote.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/MonteCarloFile.h"

namespace smat::gui {
namespace {

/// What an analysis was asked, without what came out.
AnalysisData askedOf(const ResultEntry& entry) {
    AnalysisData data;
    data.name = entry.data->name;
    data.kind = entry.data->kind;
    data.project = entry.data->project;
    data.settings = entry.data->settings;
    data.commandLine = entry.data->commandLine;
    return data;
}

/// "36 cases, angle 0 to 350 deg, 640 x 512 px".
QString askedWords(const ResultEntry& entry) {
    if (!entry.canRunAgain())
        return stateOf(entry);
    try {
        const QString words = QString::fromStdString(
            planAnalysis(entry.data->kind, entry.data->project, entry.data->settings).description);
        return words.mid(words.indexOf(": ") + 2);
    } catch (const irsg::InputError&) {
        return QString::fromStdString(title(entry.data->kind));
    }
}

/// Of these the part that tells one run from the next, short enough for a line of the list:
/// "angle 0 to 350 deg", "2000 to 3333.33 cm-1", "640 x 512 px".
QString sweptWords(const ResultEntry& entry) {
    const QString asked = askedWords(entry);
    const QStringList parts = asked.split(", ");
    if (!entry.canRunAgain() || parts.size() < 2)
        return asked;
    if (entry.data->kind->form == AnalysisForm::spectrum)
        return parts[1].section(" from ", -1);
    return parts[1];
}

} // namespace

ResultsDock::ResultsDock(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QDockWidget(tr("Results"), parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("resultsDock");
    setFeatures(DockWidgetMovable | DockWidgetFloatable | DockWidgetClosable);
    auto* body = new QWidget(this);
    body->setMinimumWidth(250);

    list_ = new QListWidget(body);
    list_->setObjectName("resultList");
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setItemDelegate(new ResultItemDelegate(list_));
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    list_->setMouseTracking(true);
    empty_ = new QLabel(tr("No results yet.\nChoose one of the analyses,\nor open a saved result."),
                        list_);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* overEmpty = new QVBoxLayout(list_);
    overEmpty->addWidget(empty_);
    makeActions();

    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(10, 8, 10, 8);
    column->addWidget(list_, 1);
    column->addWidget(makeButtons());
    setWidget(body);

    const ResultStore& store = workbench_.resultStore();
    connect(&store, &ResultStore::added, this, &ResultsDock::addResult);
    connect(&store, &ResultStore::addedQuietly, this, &ResultsDock::addResult);
    connect(&store, &ResultStore::unsavedChanged, this, [this] {
        const int count = workbench_.resultStore().unsavedCount();
        // Short, as it stands in a tab beside others, too.
        setWindowTitle(count > 0 ? tr("Results (%1*)").arg(count) : tr("Results"));
        setToolTip(count > 0 ? tr("%1 not saved").arg(count) : QString());
    });
    connect(&store, &ResultStore::renamed, this, &ResultsDock::refreshItem);
    connect(&store, &ResultStore::removed, this, &ResultsDock::removeItem);
    connect(list_, &QListWidget::itemSelectionChanged, this, &ResultsDock::refreshActions);
    connect(list_, &QListWidget::itemActivated, this, &ResultsDock::showSelected);
    connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        const int id = item->data(ResultItemDelegate::idRole).toInt();
        const ResultEntry* entry = workbench_.result(id);
        if (entry != nullptr && item->text() != entry->title) {
            workbench_.resultStore().rename(id, item->text());
            refreshItem(id); // an empty name is none
        }
    });
    refreshActions();
}

QAction* ResultsDock::add(const QString& name, const QString& iconName, const QString& text,
                          const QString& tip, const QKeySequence& key,
                          void (ResultsDock::*work)()) {
    auto* action =
        iconName.isEmpty() ? new QAction(text, this) : new QAction(icon(iconName), text, this);
    action->setObjectName(name + "Action");
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setToolTip(key.isEmpty() ? tip
                                     : tip + " (" + key.toString(QKeySequence::NativeText) + ")");
    connect(action, &QAction::triggered, this, work);
    actions_[name] = action;
    list_->addAction(action);
    return action;
}

void ResultsDock::makeActions() {
    const auto line = [this] {
        auto* separator = new QAction(this);
        separator->setSeparator(true);
        list_->addAction(separator);
    };
    add("showResult", "", tr("Show"), tr("Show the selected results"), Qt::Key_Return,
        &ResultsDock::showSelected);
    add("overlayResults", "overlay", tr("Overlay"), tr("Draw the selected results on one plot"),
        QKeySequence(Qt::CTRL | Qt::Key_L), &ResultsDock::overlay);
    add("subtractResults", "difference", tr("Difference"),
        tr("Subtract the second of two selected results from the first; two images are compared"),
        QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_D), &ResultsDock::subtract);
    line();
    add("rerunResult", "rerun", tr("Run again"), tr("Run the same analysis again"),
        QKeySequence(Qt::Key_F5), &ResultsDock::runAgain);
    add("editResult", "edit", tr("Edit and run again…"), tr("Change what was asked and run again"),
        QKeySequence(Qt::SHIFT | Qt::Key_F5), &ResultsDock::editAndRun);
    line();
    add("renameResult", "", tr("Rename"), tr("Give the result another name"),
        QKeySequence(Qt::Key_F2), &ResultsDock::rename);
    add("annotateResult", "", tr("Notes…"), tr("Note to keep with the result"),
        QKeySequence(Qt::SHIFT | Qt::Key_F2), &ResultsDock::annotate);
    add("showCommandLine", "terminal", tr("Show command line…"),
        tr("The command line that makes this result, and its provenance"),
        QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_I), &ResultsDock::showDetails);
    line();
    add("openResult", "open", tr("Open saved result…"),
        tr("Open a saved result or an image (%1) as a result again")
            .arg(readableResultPatterns().remove('*').replace(" ", ", ")),
        QKeySequence(), &ResultsDock::openFile);
    add("saveResult", "export", tr("Save result…"), tr("Save the data with their provenance"),
        QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S), &ResultsDock::save);
    line();
    add("removeResult", "remove", tr("Remove"), tr("Take the selected results off the list"),
        QKeySequence(Qt::Key_Delete), &ResultsDock::removeSelected);
}

QList<QAction*> ResultsDock::commands() const {
    return list_->actions();
}

QWidget* ResultsDock::makeButtons() {
    auto* holder = new QWidget(this);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto button = [&](const QString& name) {
        auto* tool = new QToolButton(holder);
        tool->setDefaultAction(actions_.at(name));
        tool->setToolTip(actions_.at(name)->toolTip());
        tool->setObjectName(name);
        tool->setAutoRaise(true);
        tool->setIconSize(QSize(18, 18));
        row->addWidget(tool);
    };
    for (const char* name :
         {"overlayResults", "subtractResults", "rerunResult", "editResult", "showCommandLine"})
        button(name);
    row->addStretch(1);
    for (const char* name : {"openResult", "saveResult", "removeResult"})
        button(name);
    return holder;
}

void ResultsDock::addResult(int id) {
    auto* item = new QListWidgetItem(list_);
    item->setData(ResultItemDelegate::idRole, id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    refreshItem(id);
    list_->setCurrentItem(item, QItemSelectionModel::ClearAndSelect);
    empty_->hide();
    refreshActions();
}

void ResultsDock::refreshItem(int id) {
    const ResultEntry* entry = workbench_.result(id);
    QListWidgetItem* item = itemOf(id);
    if (entry == nullptr || item == nullptr)
        return;
    const QSignalBlocker quiet(list_);
    item->setText(entry->title);
    item->setIcon(icon(entry->kind()->icon));
    const bool isOfToday = entry->madeAt.date() == QDate::currentDate();
    QStringList words{entry->madeAt.toString(isOfToday ? "HH:mm" : "d MMM HH:mm")};
    if (entry->canRunAgain())
        words << durationText(entry->data->elapsed_s);
    if (entry->canRunAgain() && entry->data->state == AnalysisState::partial)
        words << stateOf(*entry);
    words << sweptWords(*entry);
    if (!entry->notes.isEmpty())
        words << entry->notes.section('\n', 0, 0);
    item->setData(ResultItemDelegate::detailRole, withFormattedUnits(words.join(" · ")));

    // The first lines are the figures; the whole provenance has a dialog.
    constexpr int shown = 9;
    QStringList lines = describe(*entry).mid(0, shown);
    lines.insert(2, withFormattedUnits(askedWords(*entry)));
    for (const auto& warning : entry->data->warnings)
        lines << tr("Note: %1").arg(QString::fromStdString(warning));
    item->setToolTip(lines.join('\n'));
}

void ResultsDock::removeItem(int id) {
    delete itemOf(id);
    empty_->setVisible(list_->count() == 0);
    refreshActions();
}

QListWidgetItem* ResultsDock::itemOf(int id) const {
    for (int row = 0; row < list_->count(); ++row)
        if (list_->item(row)->data(ResultItemDelegate::idRole).toInt() == id)
            return list_->item(row);
    return nullptr;
}

QList<int> ResultsDock::selectedResults() const {
    QList<int> ids;
    for (int row = 0; row < list_->count(); ++row)
        if (list_->item(row)->isSelected())
            ids << list_->item(row)->data(ResultItemDelegate::idRole).toInt();
    return ids;
}

const ResultEntry* ResultsDock::onlySelected() const {
    const auto ids = selectedResults();
    return ids.size() == 1 ? workbench_.result(ids.front()) : nullptr;
}

void ResultsDock::refreshActions() {
    const auto ids = selectedResults();
    const ResultEntry* one = onlySelected();
    const auto images = std::count_if(ids.begin(), ids.end(), [this](int id) {
        const auto* entry = workbench_.result(id);
        return entry != nullptr && entry->isImage();
    });
    const bool plots = images == 0 && std::ranges::none_of(ids, [this](int id) {
                           const auto* entry = workbench_.result(id);
                           return entry != nullptr && entry->monteCarlo;
                       });
    const bool again = one != nullptr && one->canRunAgain();
    actions_.at("showResult")->setEnabled(!ids.isEmpty());
    actions_.at("overlayResults")->setEnabled(plots && ids.size() > 1);
    actions_.at("subtractResults")->setEnabled(ids.size() == 2 && (plots || images == 2));
    actions_.at("rerunResult")->setEnabled(again);
    actions_.at("editResult")->setEnabled(again && !one->monteCarlo);
    for (const char* name : {"renameResult", "annotateResult", "showCommandLine", "saveResult"})
        actions_.at(name)->setEnabled(one != nullptr);
    actions_.at("removeResult")->setEnabled(!ids.isEmpty());
}

void ResultsDock::showSelected() {
    for (const int id : selectedResults())
        emit showRequested({id});
}

void ResultsDock::overlay() {
    emit showRequested(selectedResults());
}

void ResultsDock::subtract() {
    const auto ids = selectedResults();
    const ResultEntry* first = workbench_.result(ids.at(0));
    if (first != nullptr && first->isImage()) {
        emit comparisonRequested(ids.at(0), ids.at(1));
        return;
    }
    try {
        workbench_.resultStore().addDifference(ids.at(0), ids.at(1));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("These results cannot be subtracted"), sentencesOf(error));
    }
}

void ResultsDock::runAgain() {
    const ResultEntry* entry = onlySelected();
    if (entry == nullptr)
        return;
    if (!entry->monteCarlo) {
        workbench_.start(askedOf(*entry));
        return;
    }
    MonteCarloData again;
    again.analysis = askedOf(*entry);
    again.options = entry->monteCarlo->options;
    workbench_.start(again);
}

void ResultsDock::editAndRun() {
    const ResultEntry* entry = onlySelected();
    if (entry == nullptr)
        return;
    const FileChooser chooser = [this](const QString& title, const QString& filter) {
        return dialogs_.openFile(this, title, {filter});
    };
    AnalysisGeneratorDialog dialog(entry->data->project, entry->data->settings, entry->data->kind,
                                   chooser, this);
    if (entry->data->name != name(entry->data->kind))
        dialog.setName(QString::fromStdString(entry->data->name));
    dialog.setUnsavedNote(unsavedNote(workbench_));
    if (dialogs_.run(dialog) && dialog.isAcceptable())
        workbench_.start(dialog.data());
}

void ResultsDock::rename() {
    if (const ResultEntry* entry = onlySelected())
        list_->editItem(itemOf(entry->id));
}

void ResultsDock::annotate() {
    const ResultEntry* entry = onlySelected();
    if (entry == nullptr)
        return;
    ResultNotesDialog dialog(*entry, this);
    if (dialogs_.run(dialog))
        workbench_.resultStore().annotate(dialog.id(), dialog.notes());
}

void ResultsDock::showDetails() {
    if (const ResultEntry* entry = onlySelected()) {
        ResultDetailsDialog dialog(*entry, this);
        dialogs_.run(dialog);
    }
}

void ResultsDock::save() {
    const ResultEntry* entry = onlySelected();
    if (entry == nullptr)
        return;
    const QStringList filters =
        entry->isImage() ? imageFilters() + QStringList{tr("Row of sums (*.json)")}
                         : QStringList{tr("Values as text (*.csv)"), tr("Values as JSON (*.json)")};
    const QString file = dialogs_.saveFile(this, tr("Save result"), filters,
                                           QString::fromStdString(name(entry->kind())));
    if (file.isEmpty())
        return;
    try {
        // A table is one whatever it was measured for, also the sums of an image.
        if (!entry->isImage())
            checkResultFile(AnalysisKind::other, file.toStdString());
        if (entry->monteCarlo)
            saveMonteCarlo(*entry->monteCarlo, file.toStdString());
        else if (entry->isImage())
            saveResult(*entry->data, file.toStdString());
        else
            entry->data->table.save(file.toStdString());
        const irsg::ImageFormat* format = irsg::imageFormatOf(file.toStdString());
        if (entry->isImage() && format != nullptr &&
            format->keeps == irsg::ImageFormat::Keeps::allPlanes)
            workbench_.resultStore().noteSaved(entry->id, file.toStdString());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This cannot be saved"), sentencesOf(error));
    }
}

void ResultsDock::openFile() {
    const QString file = dialogs_.openFile(
        this, tr("Open a saved result"),
        {tr("Results and matrices (%1)").arg(readableResultPatterns()), tr("All files (*)")});
    if (!file.isEmpty())
        openResult(file.toStdString());
}

bool ResultsDock::openResult(const std::filesystem::path& file) {
    try {
        workbench_.resultStore().open(file);
        return true;
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This result cannot be opened"), sentencesOf(error));
        return false;
    }
}

void ResultsDock::removeSelected() {
    for (const int id : selectedResults())
        workbench_.removeResult(id);
}

} // namespace smat::gui

#include "moc_ResultsDock.cpp"
