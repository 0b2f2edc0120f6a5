#include "gui/database/TemperatureResult.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/NumberField.h"
#include "gui/widgets/Theme.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/EntryFields.h"

namespace smat::gui {
namespace {

struct StateField {
    const char *name, *label, *unit;
    double irsg::EntityState::*member;
    double step;
};
using State = irsg::EntityState;
constexpr StateField stateFields[] = {
    {"tryTime", QT_TRANSLATE_NOOP("TemperatureResult", "time"), "s", &State::time_s, 1.0},
    {"tryPower", QT_TRANSLATE_NOOP("TemperatureResult", "power"), "", &State::power, 0.05},
    {"tryMach", QT_TRANSLATE_NOOP("TemperatureResult", "Mach"), "", &State::mach, 0.05},
    {"tryAltitude", QT_TRANSLATE_NOOP("TemperatureResult", "altitude"), "m", &State::altitude_m,
     100.0},
    {"tryAmbient", QT_TRANSLATE_NOOP("TemperatureResult", "air"), "K", &State::ambient_K, 1.0}};

} // namespace

TemperatureResult::TemperatureResult(QWidget* parent) : QWidget(parent) {
    setObjectName("temperatureResult");
    sum_ = new QLabel(this);
    sum_->setObjectName("resultingTemperature");
    QFont large = sum_->font();
    large.setPointSizeF(large.pointSizeF() * 1.7);
    large.setBold(true);
    sum_->setFont(large);
    back_ = new QToolButton(this);
    back_->setObjectName("projectState");
    back_->setText(tr("State of the project"));
    back_->setToolTip(tr("Return from the trial state to that of the project"));
    auto* top = new QHBoxLayout;
    top->addWidget(sum_);
    top->addStretch(1);
    top->addWidget(back_);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto& about = stateFields[i];
        auto* label = new QLabel(tr(about.label), this);
        label->setForegroundRole(QPalette::PlaceholderText);
        auto* field = new NumberField(about.unit, this);
        field->setObjectName(about.name);
        field->setStep(about.step);
        field->setMinimumWidth(60);
        field->setToolTip(tr("Try another state: changes nothing but this view"));
        if (about.member == &State::ambient_K)
            field->setRange(1.0, 2000.0);
        grid->addWidget(label, 0, static_cast<int>(i));
        grid->addWidget(field, 1, static_cast<int>(i));
        connect(field, &NumberField::edited, this, [this, about](double value) {
            state_.*about.member = value;
            tried_ = true;
            refresh();
        });
        fields_[i] = field;
    }
    list_ = new QTreeWidget(this);
    list_->setObjectName("termValues");
    list_->setColumnCount(3);
    list_->setHeaderLabels({tr("Term"), tr("How"), tr("K")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSelectionMode(QAbstractItemView::NoSelection);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 10, 0, 0);
    column->setSpacing(10);
    column->addLayout(top);
    column->addLayout(grid);
    column->addWidget(list_, 1);
    connect(back_, &QToolButton::clicked, this, [this] {
        tried_ = false;
        state_ = project_;
        showState();
        refresh();
    });
    showState();
}

void TemperatureResult::setTerms(const irsg::TemperatureTerms& terms) {
    terms_ = terms;
    refresh();
}

void TemperatureResult::setProjectState(const irsg::EntityState& state) {
    project_ = state;
    if (tried_)
        return;
    state_ = state;
    showState();
    refresh();
}

void TemperatureResult::showState() {
    for (std::size_t i = 0; i < fields_.size(); ++i)
        fields_[i]->setValue(state_.*stateFields[i].member);
}

void TemperatureResult::refresh() {
    const auto number = [](double value, int digits = 4) {
        return QString::number(value, 'g', digits);
    };
    const auto held = [&](const irsg::LookupTable& table, double x, const QString& axis) {
        if (table.empty())
            return tr("no table");
        const QString at = tr("table at %1 %2").arg(axis, number(x, 6));
        return table.isOutside(x) ? at + tr(", end value held") : at;
    };
    struct Row {
        QString term, how;
        double value_K;
    };
    std::vector<Row> rows = {
        {tr("T₀"), tr("constant"), terms_.base_K},
        {tr("a · T_amb"), number(terms_.ambientFactor) + " · " + number(state_.ambient_K, 6) + " K",
         irsg::ambientTerm_K(terms_, state_)},
        {tr("a · T_amb · 0.2 r M²"),
         tr("r %1, Mach %2").arg(number(terms_.recoveryFactor), number(state_.mach)),
         irsg::aerodynamicTerm_K(terms_, state_)},
        {tr("a · ΔT"), tr("ΔT %1 K").arg(number(terms_.ambientOffset_K)),
         irsg::offsetTerm_K(terms_, state_)}};
    irsg::forEachField<irsg::LookupTable>(irsg::termFields(), [&](const auto& field, auto member) {
        const irsg::LookupTable& table = terms_.*member;
        const double position = field.table.position(state_);
        rows.push_back({tr(field.label), held(table, position, tr(field.table.axis)),
                        irsg::tableTerm_K(table, position)});
    });
    list_->clear();
    for (const auto& row : rows) {
        auto* item = new QTreeWidgetItem({row.term, row.how, QString::number(row.value_K, 'f', 2)});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        if (row.value_K == 0.0)
            for (int i = 0; i < 3; ++i)
                item->setForeground(i, palette().color(QPalette::PlaceholderText));
        list_->addTopLevelItem(item);
    }
    const double sum_K = irsg::surfaceTemperature_K(terms_, state_);
    sum_->setText(tr("%1 K").arg(QString::number(sum_K, 'f', 2)));
    sum_->setToolTip(tr("%1 °C").arg(QString::number(irsg::celsiusFromKelvin(sum_K), 'f', 2)));
    back_->setVisible(tried_);
}

} // namespace smat::gui

#include "moc_TemperatureResult.cpp"
