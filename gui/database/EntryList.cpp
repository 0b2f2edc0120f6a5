#include "gui/database/EntryList.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/QuestionDialog.h"
#include "gui/database/RenumberDialog.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

EntryList::EntryList(EditorContext& context, EntryKind kind, QWidget* parent)
    : QWidget(parent), context_(context), kind_(kind) {
    model_ = new EntryListModel(context, kind, this);
    filter_ = new QSortFilterProxyModel(this);
    filter_->setSourceModel(model_);
    filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    filter_->setFilterKeyColumn(-1);

    search_ = new QLineEdit(this);
    search_->setObjectName("entryFilter");
    search_->setPlaceholderText(tr("Filter by index, name or value"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, filter_,
            &QSortFilterProxyModel::setFilterFixedString);

    view_ = new QTableView(this);
    view_->setObjectName("entryTable");
    view_->setModel(filter_);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setShowGrid(false);
    view_->setAlternatingRowColors(true);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setTabKeyNavigation(false);
    view_->setWordWrap(false);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 9);
    view_->horizontalHeader()->setHighlightSections(false);
    view_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    view_->horizontalHeader()->setSectionResizeMode(EntryListModel::nameColumn,
                                                    QHeaderView::Stretch);
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        shown_ = current();
        emit currentChanged();
    });

    bar_ = new QHBoxLayout;
    bar_->setContentsMargins(0, 0, 0, 0);
    bar_->setSpacing(2);
    bar_->addWidget(search_, 1);
    bar_->addSpacing(4);
    const bool byName = kind == EntryKind::spectrum;
    if (!byName)
        connect(addButton("add", "addEntry", tr("Add an entry with the next free index")),
                &QToolButton::clicked, this, &EntryList::add);
    connect(addButton("duplicate", "duplicateEntry", tr("Duplicate this entry")),
            &QToolButton::clicked, this, &EntryList::duplicate);
    connect(addButton("renumber", "renumberEntry",
                      byName ? tr("Give this spectrum another name")
                             : tr("Give this entry another index")),
            &QToolButton::clicked, this, &EntryList::renumber);
    connect(addButton("remove", "removeEntry", tr("Delete this entry")), &QToolButton::clicked,
            this, &EntryList::remove);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(bar_);
    column->addWidget(view_, 1);
    setMinimumHeight(130);

    connect(&context_.session(), &DatabaseSession::changed, this, &EntryList::refresh);
    connect(&context_.session(), &DatabaseSession::opened, this, &EntryList::refresh);
    connect(&context_, &EditorContext::surroundingsChanged, this, &EntryList::refresh);
    refresh();
}

QToolButton* EntryList::addButton(const QString& picture, const QString& name, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setIcon(icon(picture));
    button->setToolTip(tip);
    button->setAutoRaise(true);
    bar_->addWidget(button);
    return button;
}

std::optional<EntryKey> EntryList::current() const {
    return model_->keyAt(filter_->mapToSource(view_->currentIndex()).row());
}

void EntryList::select(const EntryKey& key) {
    int row = model_->rowOf(key);
    if (row < 0)
        return;
    QModelIndex shown = filter_->mapFromSource(model_->index(row, 0));
    if (!shown.isValid()) {
        // The filter hides it.
        search_->clear();
        shown = filter_->mapFromSource(model_->index(row, 0));
    }
    view_->setCurrentIndex(shown);
    view_->scrollTo(shown);
}

void EntryList::refresh() {
    const auto before = shown_;
    const int row = view_->currentIndex().row();
    model_->refresh();
    if (before && model_->rowOf(*before) >= 0) {
        if (current() != before)
            select(*before);
    } else if (filter_->rowCount() > 0) {
        view_->setCurrentIndex(filter_->index(std::clamp(row, 0, filter_->rowCount() - 1), 0));
    } else if (before) {
        shown_.reset();
        emit currentChanged();
    }
}

bool EntryList::agreed(const QString& title, const QString& text, const QString& button) const {
    QuestionDialog question(title, text, {button}, context_.window);
    return context_.dialogs().run(question);
}

void EntryList::add() {
    if (!context_.session().isOpen())
        return;
    const auto now = current();
    // An index that the model asks for goes before the next free one.
    EntryKey key{
        kind_, freeIndex(context_.session().value(), kind_, now ? std::max(now->index, 0) + 1 : 1)};
    for (const auto& missing : context_.missing()) {
        if (missing.kind == kind_) {
            key = missing;
            break;
        }
    }
    const bool material = kind_ == EntryKind::material;
    context_.session().edit(
        tr("Add %1 %2").arg(material ? tr("material") : tr("temperature")).arg(key.index),
        [&](irsg::SignatureDatabase& database) {
            if (material) {
                database.materials[key.index].name = tr("new material").toStdString();
                return;
            }
            irsg::TemperatureEntry& entry = database.temperatures[key.index];
            entry.name = tr("new temperature").toStdString();
            entry.terms = irsg::TemperatureTerms::ofAmbient();
        });
    select(key);
}

void EntryList::duplicate() {
    const auto from = current();
    if (!from)
        return;
    const auto& database = context_.session().value();
    EntryKey to = *from;
    if (kind_ == EntryKind::spectrum)
        to.name = freeSpectrumName(database, from->name);
    else
        to.index = freeIndex(database, kind_, from->index + 1);
    context_.session().edit(
        tr("Duplicate %1").arg(context_.title(*from)),
        [&](irsg::SignatureDatabase& into) { duplicateEntry(into, *from, to); });
    select(to);
}

void EntryList::renumber() {
    const auto from = current();
    if (!from)
        return;
    RenumberDialog dialog(context_, *from, context_.window);
    if (!context_.dialogs().run(dialog))
        return;
    const EntryKey to = dialog.wanted();
    const QString name =
        kind_ == EntryKind::spectrum
            ? tr("Rename %1 to %2").arg(context_.title(*from), QString::fromStdString(to.name))
            : tr("Renumber %1 to %2").arg(context_.title(*from)).arg(to.index);
    context_.session().edit(name,
                            [&](irsg::SignatureDatabase& into) { renumberEntry(into, *from, to); });
    select(to);
}

void EntryList::remove() {
    const auto key = current();
    if (!key)
        return;
    const QString title = context_.title(*key);
    if (const int faces = context_.facesOf(*key); faces > 0) {
        if (!agreed(tr("Delete %1").arg(title),
                    tr("In use by %1 of the model. Without an entry they cannot be drawn.")
                        .arg(counted(faces, tr("face"), tr("faces"))),
                    tr("Delete")))
            return;
    }
    if (kind_ == EntryKind::spectrum) {
        const auto users = usersOfSpectrum(context_.session().value(), key->name);
        if (!users.empty() && !agreed(tr("Delete %1").arg(title),
                                      tr("In use by %1. They will have no spectrum to emit.")
                                          .arg(counted(static_cast<long>(users.size()),
                                                       tr("temperature"), tr("temperatures"))),
                                      tr("Delete")))
            return;
    }
    context_.session().edit(tr("Delete %1").arg(title), [&](irsg::SignatureDatabase& database) {
        removeEntry(database, *key);
    });
}

} // namespace smat::gui

#include "moc_EntryList.cpp"
