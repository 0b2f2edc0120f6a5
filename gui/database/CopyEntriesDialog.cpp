#include "gui/database/CopyEntriesDialog.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/database/NodePlot.h"
#include "gui/widgets/DialogButtons.h"

namespace smat::gui {
namespace {

enum Column { entryColumn, nameColumn, targetColumn, clashColumn };
constexpr int keyRole = Qt::UserRole;
/// Of the box of a clash.
constexpr int replaceThere = 1;

} // namespace

CopyEntriesDialog::CopyEntriesDialog(const EditorContext& context, irsg::SignatureDatabase source,
                                     const QString& title, QWidget* parent)
    : QDialog(parent), context_(context), source_(std::move(source)) {
    setObjectName("copyEntriesDialog");
    setWindowTitle(title);
    resize(1080, 620);
    search_ = new QLineEdit(this);
    search_->setObjectName("copyFilter");
    search_->setPlaceholderText(tr("Filter by name or notes"));
    search_->setClearButtonEnabled(true);
    list_ = new QTreeWidget(this);
    list_->setObjectName("copyList");
    list_->setHeaderLabels({tr("There"), tr("Name"), tr("Here as"), tr("If its index is taken")});
    list_->setAlternatingRowColors(true);
    list_->setUniformRowHeights(false);
    list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
    list_->header()->setStretchLastSection(false);
    plot_ = new NodePlot(this);
    plot_->setReadOnly(true);
    NodeRules rules;
    rules.xName = tr("wavelength");
    rules.xUnit = tr("µm");
    rules.yName = tr("emissivity");
    plot_->setRules(rules);
    plot_->setCurveColors(1, {0});
    notes_ = new QLabel(this);
    notes_->setObjectName("copyNotes");
    notes_->setWordWrap(true);
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    notes_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    notes_->setMinimumHeight(110);
    auto* side = new QWidget(this);
    auto* sideColumn = new QVBoxLayout(side);
    sideColumn->setContentsMargins(0, 0, 0, 0);
    sideColumn->addWidget(plot_, 2);
    sideColumn->addWidget(notes_, 1);
    auto* split = new QSplitter(this);
    split->setChildrenCollapsible(false);
    split->addWidget(list_);
    split->addWidget(side);
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    verdict_ = new QLabel(this);
    verdict_->setObjectName("copyVerdict");
    buttons_ = okAndCancel(*this, tr("Add"));
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(verdict_, 1);
    bottom->addWidget(buttons_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 12);
    column->setSpacing(10);
    column->addWidget(search_);
    column->addWidget(split, 1);
    column->addLayout(bottom);
    fill();
    connect(search_, &QLineEdit::textChanged, this, &CopyEntriesDialog::filter);
    connect(list_, &QTreeWidget::itemChanged, this, &CopyEntriesDialog::validate);
    connect(list_, &QTreeWidget::currentItemChanged, this, &CopyEntriesDialog::preview);
    if (const auto all = entries(); !all.empty())
        list_->setCurrentItem(all.front());
    validate();
}

void CopyEntriesDialog::fill() {
    const auto group = [&](const QString& title) {
        auto* item = new QTreeWidgetItem(list_, {title});
        item->setFirstColumnSpanned(true);
        item->setFlags(Qt::ItemIsEnabled);
        item->setExpanded(true);
        return item;
    };
    if (!source_.materials.empty()) {
        auto* materials = group(tr("Materials"));
        for (const auto& [index, material] : source_.materials)
            addItem(materials, {EntryKind::material, index}, QString::fromStdString(material.name),
                    material.notes);
    }
    if (!source_.temperatures.empty()) {
        auto* temperatures = group(tr("Temperatures"));
        for (const auto& [index, entry] : source_.temperatures)
            addItem(temperatures, {EntryKind::temperature, index},
                    QString::fromStdString(entry.name), entry.notes);
    }
    if (!source_.spectra.empty()) {
        auto* spectra = group(tr("Spectra"));
        for (const auto& [name, spectrum] : source_.spectra)
            addItem(spectra, {EntryKind::spectrum, 0, name}, QString::fromStdString(name),
                    spectrum.notes);
    }
}

void CopyEntriesDialog::addItem(QTreeWidgetItem* group, const EntryKey& key, const QString& name,
                                const std::string& notes) {
    const bool byName = key.kind == EntryKind::spectrum;
    const auto& here = context_.session().value();
    auto* item =
        new QTreeWidgetItem(group, {byName ? QString() : QString::number(key.index), name});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(entryColumn, Qt::Unchecked);
    item->setData(entryColumn, keyRole, static_cast<int>(keys_.size()));
    item->setToolTip(nameColumn, QString::fromStdString(notes));
    keys_.push_back(key);

    auto* target = new QLineEdit(byName ? name : QString::number(key.index), list_);
    target->setObjectName("target");
    target->setMaximumWidth(byName ? 160 : 70);
    connect(target, &QLineEdit::textChanged, this, &CopyEntriesDialog::validate);
    list_->setItemWidget(item, targetColumn, target);
    auto* clash = new QComboBox(list_);
    clash->setObjectName("clash");
    clash->addItem(byName ? tr("take a free name") : tr("take the next free index"));
    clash->addItem(tr("replace the existing entry"));
    clash->setVisible(contains(here, key));
    connect(clash, &QComboBox::currentIndexChanged, this, &CopyEntriesDialog::validate);
    list_->setItemWidget(item, clashColumn, clash);
}

EntryKey CopyEntriesDialog::keyOf(const QTreeWidgetItem* item) const {
    return keys_[static_cast<std::size_t>(item->data(entryColumn, keyRole).toInt())];
}

std::vector<QTreeWidgetItem*> CopyEntriesDialog::entries() const {
    std::vector<QTreeWidgetItem*> items;
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        for (int k = 0; k < list_->topLevelItem(i)->childCount(); ++k)
            items.push_back(list_->topLevelItem(i)->child(k));
    return items;
}

void CopyEntriesDialog::choose(const EntryKey& key) {
    for (auto* item : entries()) {
        if (keyOf(item) == key) {
            item->setCheckState(entryColumn, Qt::Checked);
            list_->setCurrentItem(item);
        }
    }
}

void CopyEntriesDialog::filter(const QString& text) {
    for (auto* item : entries())
        item->setHidden(!item->text(nameColumn).contains(text, Qt::CaseInsensitive) &&
                        !item->toolTip(nameColumn).contains(text, Qt::CaseInsensitive));
}

std::vector<EntryCopy> CopyEntriesDialog::copies() const {
    // Free places are counted on a copy, so that two chosen entries do not meet.
    std::vector<EntryCopy> chosen;
    irsg::SignatureDatabase taken = context_.session().value();
    for (auto* item : entries()) {
        if (item->checkState(entryColumn) != Qt::Checked)
            continue;
        EntryCopy copy{keyOf(item), keyOf(item), false};
        const QString text =
            static_cast<QLineEdit*>(list_->itemWidget(item, targetColumn))->text().trimmed();
        const auto* clash = static_cast<QComboBox*>(list_->itemWidget(item, clashColumn));
        if (copy.to.kind == EntryKind::spectrum)
            copy.to.name = text.toStdString();
        else
            copy.to.index = text.toInt();
        if (contains(taken, copy.to)) {
            copy.replace = clash->currentIndex() == replaceThere;
            if (!copy.replace && copy.to.kind == EntryKind::spectrum)
                copy.to.name = freeSpectrumName(taken, copy.to.name);
            else if (!copy.replace)
                copy.to.index = freeIndex(taken, copy.to.kind, copy.to.index);
        }
        copyEntries(source_, {copy}, taken);
        chosen.push_back(copy);
    }
    return chosen;
}

void CopyEntriesDialog::validate() {
    const auto& here = context_.session().value();
    int chosen = 0;
    bool right = true;
    for (auto* item : entries()) {
        EntryKey key = keyOf(item);
        const QString text =
            static_cast<QLineEdit*>(list_->itemWidget(item, targetColumn))->text().trimmed();
        bool whole = true;
        if (key.kind == EntryKind::spectrum)
            key.name = text.toStdString();
        else
            key.index = text.toInt(&whole);
        list_->itemWidget(item, clashColumn)->setVisible(contains(here, key));
        if (item->checkState(entryColumn) == Qt::Checked) {
            ++chosen;
            right = right && whole && !text.isEmpty();
        }
    }
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(chosen > 0 && right);
    verdict_->setText(chosen == 0 ? tr("Check what is to be added")
                      : !right    ? tr("An index has to be a whole number")
                               : tr("%1 to add").arg(counted(chosen, tr("entry"), tr("entries"))));
}

void CopyEntriesDialog::preview() {
    const auto* item = list_->currentItem();
    if (item == nullptr || item->parent() == nullptr)
        return;
    const EntryKey key = keyOf(item);
    notes_->setText(item->toolTip(nameColumn));
    plot_->setVisible(key.kind != EntryKind::temperature);
    if (key.kind == EntryKind::material) {
        const auto& material = source_.materials.at(key.index);
        const auto level = material.emissivity.maximum();
        plot_->setLeastView(Interval{0.4, 14.0}, Interval{0.0, 1.0});
        plot_->setBackdrop({{tr("transmissivity"),
                             {0.4, 14.0},
                             {material.transmissivity.at(0.4), material.transmissivity.at(14.0)}}});
        plot_->setNodes(material.emissivity.isConstant() ? Nodes{{0.4, level}, {14.0, level}}
                                                         : nodesOf(material.emissivity));
    } else if (key.kind == EntryKind::spectrum) {
        plot_->setNodes({});
        std::vector<Curve> curves;
        double most = 0.0;
        Interval x{0.4, 14.0};
        for (const auto& component : source_.spectra.at(key.name).components) {
            const auto& axis = component.radiance.wavelengths_um();
            x = {axis.front(), axis.back()};
            most = std::max(most, component.radiance.maximum());
            curves.push_back(
                {QString::fromStdString(component.name), axis, component.radiance.values()});
        }
        plot_->setLeastView(x, Interval{0.0, most});
        plot_->setBackdrop(std::move(curves));
    }
}

} // namespace smat::gui

#include "moc_CopyEntriesDialog.cpp"
