#include "gui/database/TermsPanel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>

#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"
#include "gui/database/NumberField.h"

namespace smat::gui {
namespace {

struct TableText {
    const char *tab, *axis, *unit, *what;
    double step;
};
/// In the order of the tabs.
constexpr TableText tableTexts[] = {
    {QT_TRANSLATE_NOOP("TermsPanel", "f(t)"), QT_TRANSLATE_NOOP("TermsPanel", "time"), "s",
     "f(time)", 1.0},
    {QT_TRANSLATE_NOOP("TermsPanel", "f(power)"), QT_TRANSLATE_NOOP("TermsPanel", "power setting"),
     "", "f(power)", 0.1},
    {QT_TRANSLATE_NOOP("TermsPanel", "f(altitude)"), QT_TRANSLATE_NOOP("TermsPanel", "altitude"),
     "m", "f(altitude)", 1000.0},
    {QT_TRANSLATE_NOOP("TermsPanel", "f(M)"), QT_TRANSLATE_NOOP("TermsPanel", "Mach number"), "",
     "f(Mach)", 0.1}};
constexpr int timeTable = 0;

} // namespace

TermsPanel::TermsPanel(QWidget* parent) : QWidget(parent) {
    using Terms = irsg::TemperatureTerms;
    setObjectName("termsPanel");
    auto* equation = new QLabel(
        tr("T = <b>T<sub>0</sub></b> + <b>a</b>·T<sub>amb</sub>·(1 + 0.2·<b>r</b>·M² + "
           "<b>ΔT</b>/T<sub>amb</sub>) + <b>f</b>(t) + <b>f</b>(power) + <b>f</b>(altitude) + "
           "<b>f</b>(M)"),
        this);
    equation->setObjectName("equation");
    equation->setWordWrap(true);
    fields_[0] = makeField("base_K", "K", 1.0, tr("T0: what does not depend on the air"),
                           &Terms::base_K, tr("T0"));
    fields_[1] = makeField("ambientFactor", {}, 0.05,
                           tr("a: the part of the ambient temperature that counts"),
                           &Terms::ambientFactor, tr("a"));
    fields_[2] = makeField("recoveryFactor", {}, 0.01,
                           tr("r: recovery factor of the heating by the air that passes, 0.85 "
                              "laminar, 0.89 turbulent, 1 on a stagnation line"),
                           &Terms::recoveryFactor, tr("r"));
    fields_[3] = makeField("ambientOffset_K", "K", 1.0,
                           tr("ΔT: above or below the ambient temperature, times a"),
                           &Terms::ambientOffset_K, tr("delta T"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    const QString names[] = {tr("T<sub>0</sub>"), tr("a"), tr("r"), tr("ΔT")};
    for (int i = 0; i < 4; ++i) {
        auto* name = new QLabel(names[i], this);
        name->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        const int pair = 2 * (i % 2);
        grid->addWidget(name, i / 2, pair);
        grid->addWidget(fields_[static_cast<std::size_t>(i)], i / 2, pair + 1);
        grid->setColumnStretch(pair + 1, 1);
    }

    tables_ = new QTabBar(this);
    tables_->setObjectName("termTables");
    tables_->setDrawBase(false);
    tables_->setExpanding(false);
    for (const auto& text : tableTexts)
        tables_->addTab(tr(text.tab));
    nodes_ = new NodeEditor(this);
    loop_ = new QCheckBox(tr("Loop"), this);
    loop_->setObjectName("loop");
    loop_->setToolTip(tr("The table repeats: the period is its last time less its first"));
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
        const auto& text = tableTexts[tables_->currentIndex()];
        // A loop needs two nodes: with fewer the table is a plain one.
        irsg::LookupTable& edited = table(tables_->currentIndex());
        edited = tableOf(nodes, edited.loop() && nodes.size() > 1);
        emit this->edited(terms_, text.what, QStringLiteral("%1 %2").arg(text.what, what));
        loop_->setChecked(edited.loop());
        loop_->setEnabled(nodes.size() > 1);
    });
    connect(nodes_, &NodeEditor::gestureEnded, this, &TermsPanel::gestureEnded);
    connect(loop_, &QCheckBox::clicked, this, [this](bool on) {
        terms_.time = tableOf(nodesOf(terms_.time), on);
        emit edited(terms_, "loop", on ? tr("f(time) to a loop") : tr("f(time) to no loop"));
        emit gestureEnded();
    });
    showTable();
}

NumberField* TermsPanel::makeField(const QString& name, const QString& unit, double step,
                                   const QString& help, double irsg::TemperatureTerms::*member,
                                   const QString& word) {
    auto* field = new NumberField(unit, this);
    field->setObjectName(name);
    field->setStep(step);
    field->setToolTip(help);
    connect(field, &NumberField::edited, this, [this, name, member, word](double value) {
        terms_.*member = value;
        emit edited(terms_, name, word);
    });
    connect(field, &NumberField::finished, this, &TermsPanel::gestureEnded);
    return field;
}

irsg::LookupTable& TermsPanel::table(int number) {
    irsg::LookupTable* const all[] = {&terms_.time, &terms_.power, &terms_.altitude, &terms_.mach};
    return *all[number];
}

void TermsPanel::showTable() {
    const int number = tables_->currentIndex();
    const auto& text = tableTexts[number];
    if (shownTable_ != number) {
        shownTable_ = number;
        NodeRules rules;
        rules.xName = tr(text.axis);
        rules.xUnit = text.unit;
        rules.yName = tr("rise");
        rules.yUnit = "K";
        rules.xStep = text.step;
        nodes_->setNodes({});
        nodes_->setRules(rules);
    }
    const irsg::LookupTable& shown = table(number);
    nodes_->setNodes(nodesOf(shown));
    loop_->setVisible(number == timeTable);
    loop_->setChecked(shown.loop());
    loop_->setEnabled(shown.x().size() > 1);
    for (int i = 0; i < 4; ++i) {
        const auto count = table(i).x().size();
        tables_->setTabText(
            i, count == 0 ? tr(tableTexts[i].tab)
                          : QStringLiteral("%1 · %2").arg(tr(tableTexts[i].tab)).arg(count));
    }
}

void TermsPanel::setTerms(const irsg::TemperatureTerms& terms) {
    terms_ = terms;
    fields_[0]->setValue(terms.base_K);
    fields_[1]->setValue(terms.ambientFactor);
    fields_[2]->setValue(terms.recoveryFactor);
    fields_[3]->setValue(terms.ambientOffset_K);
    showTable();
}

} // namespace smat::gui
