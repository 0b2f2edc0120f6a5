#include "gui/database/TermsPanel.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>

#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"

namespace smat::gui {
namespace {

/// Beside each other in the form.
constexpr int numbersPerLine = 2;

QString wordOf(const irsg::EntryField<irsg::TemperatureTerms>& row) {
    return QCoreApplication::translate("EntryFields", row.word);
}

} // namespace

TermsPanel::TermsPanel(QWidget* parent)
    : QWidget(parent),
      numbers_(
          irsg::termFields(), this,
          [this](const Row& row, double value) {
              terms_.*row.as<double>() = value;
              emit edited(terms_, row.key, wordOf(row));
          },
          [this] { emit gestureEnded(); }) {
    setObjectName("termsPanel");
    auto* equation =
        new QLabel(tr("T = <b>T<sub>0</sub></b> + <b>a</b>·T<sub>amb</sub>·(1 + 0.2·<b>r</b>·M² + "
                      "<b>ΔT</b>/T<sub>amb</sub>)"),
                   this);
    equation->setObjectName("equation");
    equation->setWordWrap(true);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    numbers_.addTo(*grid, numbersPerLine);

    tables_ = new QTabBar(this);
    tables_->setObjectName("termTables");
    tables_->setDrawBase(false);
    tables_->setExpanding(false);
    irsg::forEachField<irsg::LookupTable>(irsg::termFields(), [&](const Row& row, auto /*member*/) {
        rows_.push_back(&row);
        tables_->addTab(tr(row.label));
        equation->setText(equation->text() + " + " +
                          QString(tr(row.label)).replace(0, 1, "<b>f</b>"));
    });
    nodes_ = new NodeEditor(this);
    loop_ = new QCheckBox(tr("Loop"), this);
    loop_->setObjectName("loop");
    loop_->setToolTip(tr("The table repeats: the period is its last time minus its first"));
    nodes_->addToBar(loop_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(8);
    column->addWidget(equation);
    column->addLayout(grid);
    column->addWidget(tables_);
    column->addWidget(nodes_, 1);

    connect(tables_, &QTabBar::currentChanged, this, &TermsPanel::showTable);
    connect(nodes_, &NodeEditor::edited, this, [this](const Nodes& nodes, const QString& what) {
        // A loop needs two nodes: with fewer the table is a plain one.
        auto& edited = terms_.*shownRow().as<irsg::LookupTable>();
        edited = tableOf(nodes, edited.loop() && nodes.size() > 1);
        const QString word = wordOf(shownRow());
        emit this->edited(terms_, shownRow().key, QStringLiteral("%1 %2").arg(word, what));
        loop_->setChecked(edited.loop());
        loop_->setEnabled(nodes.size() > 1);
    });
    connect(nodes_, &NodeEditor::gestureEnded, this, &TermsPanel::gestureEnded);
    connect(loop_, &QCheckBox::clicked, this, [this](bool on) {
        auto& edited = terms_.*shownRow().as<irsg::LookupTable>();
        edited = tableOf(nodesOf(edited), on);
        const QString word = wordOf(shownRow());
        emit this->edited(terms_, "loop",
                          on ? tr("%1 to a loop").arg(word) : tr("%1 to no loop").arg(word));
        emit gestureEnded();
    });
    showTable();
}

const TermsPanel::Row& TermsPanel::shownRow() const {
    return *rows_[static_cast<std::size_t>(tables_->currentIndex())];
}

void TermsPanel::showTable() {
    const Row& row = shownRow();
    if (shownRow_ != &row) {
        shownRow_ = &row;
        nodes_->setNodes({});
        nodes_->setRules(rulesOf(row.table, row.unit));
    }
    const irsg::LookupTable& shown = terms_.*row.as<irsg::LookupTable>();
    nodes_->setNodes(nodesOf(shown));
    loop_->setVisible(row.table.mayLoop);
    loop_->setChecked(shown.loop());
    loop_->setEnabled(shown.x().size() > 1);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const auto count = (terms_.*rows_[i]->as<irsg::LookupTable>()).x().size();
        const QString name = tr(rows_[i]->label);
        tables_->setTabText(static_cast<int>(i),
                            count == 0 ? name : QStringLiteral("%1 · %2").arg(name).arg(count));
    }
}

void TermsPanel::setTerms(const irsg::TemperatureTerms& terms) {
    terms_ = terms;
    numbers_.show(terms);
    showTable();
}

} // namespace smat::gui

#include "moc_TermsPanel.cpp"
