#include "gui/tools/GasLayersBox.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/EntryNumbers.h"
#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "smatcore/tools/GasLayerText.h"

namespace smat::gui {

namespace {

constexpr int shownLayers = 4;   ///< lines of the list without scrolling
constexpr int leastRoom_px = 14; ///< about the text of a field

/// "700 K, 1 atm, 0.5 m: CO2 0.033, H2O 0.033".
QString wordsOf(const irsg::GasLayer& layer) {
    QStringList needed, others;
    for (const GasLayerField& field : gasLayerFields()) {
        const QString value = exactNumber(field.valueIn(layer));
        if (field.isNeeded)
            needed << value + ' ' + field.unit;
        else if (field.valueIn(layer) != 0.0)
            others << QString("%1 %2 %3")
                          .arg(GasLayersBox::tr(field.label), value, field.unit)
                          .trimmed();
    }
    if (others.isEmpty())
        others << GasLayersBox::tr("nitrogen alone");
    return needed.join(", ") + ": " + others.join(", ");
}

} // namespace

GasLayersBox::GasLayersBox(QUndoStack& undoStack, QWidget* parent)
    : QWidget(parent),
      state_(undoStack, {{gasLayerFromText(gasLayerExample, "layer 1")}, 0},
             [this] { showState(); }) {
    list_ = new QListWidget(this);
    list_->setObjectName("gasLayers");
    list_->setAccessibleName(tr("Layers"));
    list_->setToolTip(tr("In order from the sensor: the first is the nearest"));
    list_->setFixedHeight(shownLayers * (fontMetrics().height() + 5) + 4);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideRight);
    auto* title = new QLabel(tr("Layers, from the sensor"), this);
    title->setForegroundRole(QPalette::PlaceholderText);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(2);
    bar->addWidget(title, 1);
    bar->addWidget(
        makeButton("addLayer", "add", tr("Add a layer like this behind it"), &GasLayersBox::add));
    bar->addWidget(remove_ = makeButton("removeLayer", "remove", tr("Remove this layer"),
                                        &GasLayersBox::remove));
    bar->addWidget(up_ = makeButton("layerUp", "", tr("Move this layer towards the sensor"),
                                    &GasLayersBox::moveUp));
    bar->addWidget(down_ = makeButton("layerDown", "", tr("Move this layer away from the sensor"),
                                      &GasLayersBox::moveDown));
    up_->setArrowType(Qt::UpArrow);
    down_->setArrowType(Qt::DownArrow);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(bar);
    column->addWidget(list_);
    column->addWidget(makeFields());
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        showChosen();
        emit changed();
    });
    showState();
}

QToolButton* GasLayersBox::makeButton(const char* name, const char* picture, const QString& tip,
                                      void (GasLayersBox::*act)()) {
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    if (*picture != 0)
        button->setIcon(icon(picture));
    connect(button, &QToolButton::clicked, this, act);
    return button;
}

QWidget* GasLayersBox::makeFields() {
    auto* holder = new QWidget(this);
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(5);
    constexpr int perLine = 2;
    for (const GasLayerField& field : gasLayerFields()) {
        const std::size_t number = fields_.size();
        auto* edit = new NumberField(field.unit, holder);
        edit->setObjectName(field.key);
        edit->setToolTip(tr(field.help));
        edit->setStep(field.step);
        // Two in a row, where the form of a page is narrow.
        edit->setMinimumWidth(fontMetrics().horizontalAdvance(QString("0000.0 ") + field.unit) +
                              leastRoom_px);
        edit->setRange(0.0, std::numeric_limits<double>::infinity());
        edit->setCheck([this, number](double value) { return problemOf(number, value); });
        connect(edit, &NumberField::edited, this,
                [this, number](double value) { set(number, value); });
        // After the field's own slot, which says whether the text can stand.
        connect(edit, &QLineEdit::textEdited, this, &GasLayersBox::changed);
        connect(edit, &NumberField::finished, this, [this] {
            gesture_ = EditedState<State>::noGesture;
            emit changed();
        });
        auto* label = makeFieldLabel(field.label, holder);
        label->setBuddy(edit);
        edit->setAccessibleName(tr(field.label));
        const int line = static_cast<int>(number) / perLine;
        const int column = 2 * (static_cast<int>(number) % perLine);
        grid->addWidget(label, line, column);
        grid->addWidget(edit, line, column + 1);
        grid->setColumnStretch(column + 1, 1);
        fields_.push_back(edit);
    }
    return holder;
}

std::size_t GasLayersBox::chosen() const {
    return static_cast<std::size_t>(std::max(list_->currentRow(), 0));
}

void GasLayersBox::choose(std::size_t layer) {
    list_->setCurrentRow(static_cast<int>(layer));
}

void GasLayersBox::edit(State after, const QString& step, int gesture) {
    // Undo comes back to the layer that was edited.
    State before = *state_;
    before.chosen = chosen();
    state_.amend(std::move(before));
    state_.set(std::move(after), step, gesture);
}

void GasLayersBox::showState() {
    refill();
    {
        const QSignalBlocker quiet(list_);
        choose(state_->chosen);
    }
    showChosen();
    emit changed();
}

void GasLayersBox::set(std::size_t field, double value) {
    if (gesture_ == EditedState<State>::noGesture)
        gesture_ = newGesture();
    State after{layers(), chosen()};
    gasLayerFields()[field].of(after.layers[after.chosen]) = value;
    edit(std::move(after),
         tr("Set %1 of gas layer %2").arg(tr(gasLayerFields()[field].label)).arg(chosen() + 1),
         gesture_);
}

void GasLayersBox::add() {
    State after{layers(), chosen() + 1};
    after.layers.insert(after.layers.begin() + static_cast<std::ptrdiff_t>(after.chosen),
                        layers()[chosen()]);
    edit(std::move(after), tr("Add gas layer %1").arg(chosen() + 2));
}

void GasLayersBox::remove() {
    if (layers().size() == 1)
        return;
    const std::size_t at = chosen();
    State after{layers(), std::min(at, layers().size() - 2)};
    after.layers.erase(after.layers.begin() + static_cast<std::ptrdiff_t>(at));
    edit(std::move(after), tr("Remove gas layer %1").arg(at + 1));
}

void GasLayersBox::move(int by) {
    const auto at = static_cast<int>(chosen()), to = at + by;
    if (to < 0 || to >= static_cast<int>(layers().size()))
        return;
    State after{layers(), static_cast<std::size_t>(to)};
    std::swap(after.layers[static_cast<std::size_t>(at)], after.layers[after.chosen]);
    edit(std::move(after), by < 0 ? tr("Move gas layer %1 towards the sensor").arg(at + 1)
                                  : tr("Move gas layer %1 away from the sensor").arg(at + 1));
}

QString GasLayersBox::problemOf(std::size_t field, double value) const {
    irsg::GasLayer layer = layers()[chosen()];
    const GasLayerField& changed = gasLayerFields()[field];
    changed.of(layer) = value;
    for (irsg::Diagnostic& diagnostic : irsg::gasLayerDiagnostics(layer, ""))
        if (diagnostic.position == changed.key) {
            diagnostic.position.clear();
            return withFormattedUnits(sentenceOf(diagnostic));
        }
    return {};
}

QStringList GasLayersBox::problems() const {
    QStringList sentences;
    for (std::size_t i = 0; i < fields_.size(); ++i)
        if (!fields_[i]->isRight())
            sentences << tr("Layer %1, %2: %3")
                             .arg(chosen() + 1)
                             .arg(tr(gasLayerFields()[i].label), fields_[i]->problem());
    for (std::size_t i = 0; i < layers().size(); ++i)
        for (const irsg::Diagnostic& diagnostic :
             irsg::gasLayerDiagnostics(layers()[i], tr("Layer %1").arg(i + 1).toStdString()))
            sentences << withFormattedUnits(sentenceOf(diagnostic));
    return sentences;
}

void GasLayersBox::refill() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const irsg::GasLayer& layer : layers()) {
        auto* item = new QListWidgetItem(wordsOf(layer), list_);
        item->setToolTip(wordsOf(layer));
    }
}

void GasLayersBox::showChosen() {
    const irsg::GasLayer& layer = layers()[chosen()];
    for (std::size_t i = 0; i < fields_.size(); ++i)
        fields_[i]->setValue(gasLayerFields()[i].valueIn(layer));
    refreshButtons();
}

void GasLayersBox::refreshButtons() {
    remove_->setEnabled(layers().size() > 1);
    up_->setEnabled(chosen() > 0);
    down_->setEnabled(chosen() + 1 < layers().size());
}

} // namespace smat::gui

#include "moc_GasLayersBox.cpp"
