#include "gui/database/FactorsPanel.h"

#include <algorithm>
#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTabBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/SpectrumCsv.h"

namespace smat::gui {

FactorsPanel::FactorsPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent), context_(context) {
    setObjectName("factorsPanel");
    list_ = new QTreeWidget(this);
    list_->setObjectName("components");
    list_->setHeaderLabels({tr("Component"), tr("Constant"), tr("Time"), tr("Angle"), tr("Now")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setStretchLastSection(false);

    axis_ = new QTabBar(this);
    axis_->setObjectName("factorAxis");
    axis_->setDrawBase(false);
    axis_->setExpanding(false);
    irsg::forEachField<irsg::LookupTable>(irsg::geometryBuffers(),
                                          [&](const Row& row, auto /*member*/) {
                                              rows_.push_back(&row);
                                              axis_->addTab(tr(row.label));
                                          });
    irsg::forEachField<double>(irsg::geometryBuffers(), [&](const Row& row, auto /*member*/) {
        constantRow_ = &row;
        constant_ = makeNumberField(row.key, row.unit, row.help, row.number, this);
        constant_->setObjectName("factorConstant");
    });
    irsg::forEachField<irsg::FactorSelection>(
        irsg::geometryBuffers(), [&](const Row& row, auto /*member*/) {
            selectionRow_ = &row;
            selection_ = new QComboBox(this);
            selection_->setObjectName("factorSelection");
            selection_->setAccessibleName(tr(row.label));
            selection_->setToolTip(tr(row.help));
            selection_->addItem(tr("Tables"), static_cast<int>(irsg::FactorSelection::table));
            selection_->addItem(tr("Constant alone"),
                                static_cast<int>(irsg::FactorSelection::constant));
        });
    auto* row = new QHBoxLayout;
    row->addWidget(selection_);
    row->addSpacing(12);
    row->addWidget(makeFieldLabel(constantRow_->label, this));
    row->addWidget(constant_);
    row->addStretch(1);

    nodes_ = new NodeEditor(this);
    loop_ = new QCheckBox(tr("Loop"), this);
    loop_->setObjectName("loop");
    loop_->setToolTip(tr("The table repeats: the period is its last time minus its first"));
    auto* import = new QToolButton(this);
    import->setObjectName("importFactors");
    import->setIcon(icon("import"));
    import->setAutoRaise(true);
    import->setToolTip(tr("Import a table for several components: CSV with an empty first cell, "
                          "names in the first row, seconds or degrees in the first column"));
    nodes_->addToBar(loop_);
    nodes_->addToBar(import);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(8);
    column->addWidget(list_);
    column->addLayout(row);
    column->addWidget(axis_, 0, Qt::AlignLeft);
    column->addWidget(nodes_, 1);

    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item == nullptr)
            return;
        component_ = item->text(0);
        shownRow_ = nullptr;
        showTable();
    });
    connect(axis_, &QTabBar::currentChanged, this, &FactorsPanel::showTable);
    connect(constant_, &NumberField::edited, this, [this](double value) {
        factor().*constantRow_->as<double>() = value;
        push(constantRow_->key, tr("%1 of %2").arg(tr(constantRow_->word), component_));
    });
    connect(constant_, &NumberField::finished, this, &FactorsPanel::gestureEnded);
    connect(selection_, &QComboBox::activated, this, [this](int chosen) {
        const auto selection =
            static_cast<irsg::FactorSelection>(selection_->itemData(chosen).toInt());
        if (selection == shownFactor().selection)
            return;
        factor().*selectionRow_->as<irsg::FactorSelection>() = selection;
        push(selectionRow_->key, tr("%1 of %2").arg(tr(selectionRow_->word), component_));
        emit gestureEnded();
    });
    connect(nodes_, &NodeEditor::edited, this, [this](const Nodes& nodes, const QString& what) {
        const Row& row = shownRow();
        auto& table = factor().*row.as<irsg::LookupTable>();
        table = tableOf(nodes, table.loop() && nodes.size() > 1);
        push(row.key, tr("%1 of %2 %3").arg(tr(row.word), component_, what));
    });
    connect(nodes_, &NodeEditor::gestureEnded, this, &FactorsPanel::gestureEnded);
    connect(loop_, &QCheckBox::clicked, this, [this](bool on) {
        const Row& row = shownRow();
        auto& table = factor().*row.as<irsg::LookupTable>();
        table = tableOf(nodesOf(table), on);
        push("loop", (on ? tr("%1 of %2 to a loop") : tr("%1 of %2 to no loop"))
                         .arg(tr(row.word), component_));
        emit gestureEnded();
    });
    connect(import, &QToolButton::clicked, this, &FactorsPanel::importTable);
}

const FactorsPanel::Row& FactorsPanel::shownRow() const {
    return *rows_[static_cast<std::size_t>(axis_->currentIndex())];
}

irsg::ComponentFactor FactorsPanel::shownFactor() const {
    const auto found =
        std::ranges::find(factors_, component_.toStdString(), &irsg::ComponentFactor::component);
    return found == factors_.end() ? irsg::ComponentFactor{component_.toStdString(), 1.0, {}, {}}
                                   : *found;
}

irsg::ComponentFactor& FactorsPanel::factor() {
    const auto found =
        std::ranges::find(factors_, component_.toStdString(), &irsg::ComponentFactor::component);
    if (found != factors_.end())
        return *found;
    return factors_.emplace_back(irsg::ComponentFactor{component_.toStdString(), 1.0, {}, {}});
}

void FactorsPanel::push(const QString& field, const QString& what) {
    emit edited(factors_, component_ + "." + field, what);
}

void FactorsPanel::setFactors(const irsg::ComponentFactors& factors,
                              const irsg::UserSpectrum* spectrum, const irsg::EntityState& state) {
    factors_ = factors;
    spectrum_ = spectrum != nullptr ? *spectrum : irsg::UserSpectrum();
    state_ = state;
    showList();
    showTable();
}

void FactorsPanel::showList() {
    // Components of the spectrum, and factors that name none of them.
    std::vector<std::string> names;
    for (const auto& component : spectrum_.components)
        names.push_back(component.name);
    for (const auto& factor : factors_)
        if (std::ranges::find(names, factor.component) == names.end())
            names.push_back(factor.component);
    const QSignalBlocker quiet(list_);
    list_->clear();
    QTreeWidgetItem* chosen = nullptr;
    const auto nodeCount = [](const irsg::ComponentFactor& factor, const irsg::LookupTable& table) {
        const QString count =
            table.empty() ? QString("–")
                          : counted(static_cast<long>(table.x().size()), tr("node"), tr("nodes")) +
                                (table.loop() ? tr(", loop") : QString());
        const bool isAside = factor.selection == irsg::FactorSelection::constant && !table.empty();
        return isAside ? tr("%1, not used").arg(count) : count;
    };
    for (const auto& name : names) {
        const auto found = std::ranges::find(factors_, name, &irsg::ComponentFactor::component);
        const irsg::ComponentFactor factor =
            found == factors_.end() ? irsg::ComponentFactor{name, 1.0, {}, {}} : *found;
        auto* item = new QTreeWidgetItem(
            {QString::fromStdString(name), textOf(factor.constant), nodeCount(factor, factor.time),
             nodeCount(factor, factor.angle), QString::number(factor.at(state_), 'g', 4)});
        if (spectrum_.find(name) == nullptr)
            item->setToolTip(0, tr("The spectrum has no component of this name"));
        list_->addTopLevelItem(item);
        if (item->text(0) == component_)
            chosen = item;
    }
    // As high as its rows, few or many: the room is the table's and its plot's.
    const int rows = std::clamp(list_->topLevelItemCount(), 1, 6);
    list_->setFixedHeight(list_->header()->sizeHint().height() +
                          rows * std::max(list_->sizeHintForRow(0), fontMetrics().height()) + 4);
    if (chosen == nullptr && list_->topLevelItemCount() > 0) {
        chosen = list_->topLevelItem(0);
        component_ = chosen->text(0);
        shownRow_ = nullptr;
    }
    list_->setCurrentItem(chosen);
    if (chosen == nullptr)
        component_.clear();
}

void FactorsPanel::showTable() {
    const bool any = !component_.isEmpty();
    constant_->setEnabled(any);
    selection_->setEnabled(any);
    nodes_->setEnabled(any);
    axis_->setEnabled(any);
    const Row& row = shownRow();
    if (shownRow_ != &row) {
        shownRow_ = &row;
        const NodeRules rules = rulesOf(row.table, {});
        nodes_->setNodes({});
        nodes_->setRules(rules);
        const bool bounded = std::isfinite(rules.xMinimum) && std::isfinite(rules.xMaximum);
        nodes_->plot()->setLeastView(
            bounded ? std::optional(Interval{rules.xMinimum, rules.xMaximum}) : std::nullopt,
            std::nullopt);
    }
    const auto shown = shownFactor();
    const irsg::LookupTable& table = shown.*row.as<irsg::LookupTable>();
    constant_->setValue(shown.*constantRow_->as<double>());
    selection_->setCurrentIndex(selection_->findData(static_cast<int>(shown.selection)));
    nodes_->setNodes(nodesOf(table));
    loop_->setVisible(row.table.mayLoop);
    loop_->setChecked(table.loop());
    loop_->setEnabled(table.x().size() > 1);
}

void FactorsPanel::importTable() {
    const bool time = shownRow().as<irsg::LookupTable>() == &irsg::ComponentFactor::time;
    const QString file = context_.dialogs().openFile(
        context_.window, time ? tr("Import time factors") : tr("Import angle factors"),
        {tr("Tables (*.csv *.txt)"), tr("All files (*)")});
    if (file.isEmpty())
        return;
    try {
        irsg::readFactorCsv(file.toStdString(),
                            time ? irsg::FactorAxis::time_s : irsg::FactorAxis::angle_deg,
                            time && loop_->isChecked(), spectrum_, factors_);
        push("import",
             time ? tr("time factors to those of a file") : tr("angle factors to those of a file"));
        emit gestureEnded();
    } catch (const irsg::InputError& error) {
        context_.dialogs().tell(context_.window, tr("This table cannot be imported"),
                                sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_FactorsPanel.cpp"
