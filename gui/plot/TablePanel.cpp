#include "gui/plot/TablePanel.h"

#include <algorithm>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/FlowBar.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

TablePanel::TablePanel(std::shared_ptr<const ResultTable> table, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    setObjectName("tablePanel");
    plot_ = new TablePlot(std::move(table), this);
    variables_ = variablesOf(plot_->drawing().table());
    readout_ = new QLabel(this);
    readout_->setObjectName("tableReadout");
    readout_->setMinimumWidth(0);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(8);
    fillBar();
    column->addWidget(plot_, 1);
    column->addWidget(readout_);
    const auto read = [this](const QString& words) {
        readout_->setText(words.isEmpty()
                              ? tr("Move the mouse over map or ball to read a direction; "
                                   "drag the ball, or press the arrows, to turn it")
                              : words);
    };
    read({});
    connect(plot_, &TablePlot::hovered, this, read);
    choose();
}

QComboBox* TablePanel::box(const QString& name, const QString& tip) {
    auto* made = new QComboBox(this);
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    made->setMinimumWidth(70);
    connect(made, &QComboBox::activated, this, &TablePanel::choose);
    return made;
}

void TablePanel::fillBar() {
    auto* flow = new FlowBar(this);
    quantity_ = box("tableQuantity", tr("Quantity to plot"));
    for (const TableVariable& variable : variables_.list) {
        const QString unit = formattedUnit(variable.unit);
        quantity_->addItem(QString::fromStdString(variable.title) +
                               (unit.isEmpty() ? QString() : " (" + unit + ")"),
                           QString::fromStdString(variable.name));
    }
    int usual = quantity_->findData(QStringLiteral("detection_range"));
    if (usual < 0)
        usual = quantity_->findData(QStringLiteral("contrast_intensity"));
    quantity_->setCurrentIndex(std::max(usual, 0));
    flow->first()->addWidget(quantity_);
    band_ = box("tableBand", tr("Band"));
    for (const std::string& band : variables_.bands)
        band_->addItem(withFormattedUnits(QString::fromStdString(band)));
    band_->setVisible(variables_.bands.size() > 1);
    flow->first()->addWidget(band_);
    for (const SignatureTable::Axis& axis : plot_->drawing().table().axes()) {
        const auto quantity = irsg::quantityOfKey(axis.key);
        const QString name =
            QString::fromStdString(quantity ? std::string(irsg::info(*quantity).label) : axis.key);
        auto* values = box("tableAxis." + QString::fromStdString(axis.key), name);
        for (const double value : axis.values)
            values->addItem(QStringLiteral("%1 %2 %3")
                                .arg(name, formattedNumber(value), formattedUnit(axis.unit))
                                .trimmed());
        axes_.push_back(values);
        flow->first()->addWidget(values);
    }
    scale_ = box("tableScale", tr("Values as they are, or the size of them in decibels; negative "
                                  "cells are hatched in either"));
    scale_->addItems({tr("linear"), tr("dB")});
    colors_ = box("tableColors", tr("Colours"));
    for (const std::string& name : irsg::ColorMap::names())
        colors_->addItem(QString::fromStdString(name));
    colors_->setCurrentText("viridis");
    auto* copy = textButton(tr("Copy"), "copyTable", tr("Copy the picture (Ctrl+C)"));
    copy->setShortcut(QKeySequence::Copy);
    connect(copy, &QToolButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setImage(tablePicture(plot_->drawing())); });
    auto* write = textButton(tr("Save picture…"), "saveTablePicture",
                             tr("Write map and ball as .svg, .pdf or .png, or the cells as .csv"));
    connect(write, &QToolButton::clicked, this, &TablePanel::save);
    for (QWidget* widget : std::initializer_list<QWidget*>{scale_, colors_, copy, write})
        flow->second()->addWidget(widget);
    auto* bar = new QHBoxLayout;
    bar->addWidget(flow);
    static_cast<QVBoxLayout*>(layout())->addLayout(bar);
}

void TablePanel::choose() {
    const TableVariable& variable =
        variables_.list.at(static_cast<std::size_t>(quantity_->currentIndex()));
    const auto band = static_cast<std::size_t>(std::max(band_->currentIndex(), 0));
    const ResultColumn* column = variable.ofBand.at(band);
    if (column == nullptr)
        column =
            *std::ranges::find_if(variable.ofBand, [](const auto* one) { return one != nullptr; });
    SignatureTable::Choice choice;
    for (const QComboBox* axis : axes_)
        choice.push_back(static_cast<std::size_t>(axis->currentIndex()));
    TableDrawing& drawing = plot_->drawing();
    drawing.setColumn(column->key);
    drawing.setChoice(choice);
    drawing.setDecibel(scale_->currentIndex() == 1);
    drawing.setColorMap(colors_->currentText().toStdString());
    plot_->refresh();
}

void TablePanel::setTitle(const QString& title) {
    plot_->drawing().title = title;
    plot_->refresh();
}

void TablePanel::setConditions(const QString& conditions) {
    plot_->drawing().conditions = conditions;
    plot_->refresh();
}

void TablePanel::exportTo(const std::filesystem::path& file) const {
    exportTable(plot_->drawing(), file);
}

void TablePanel::save() {
    const QString file = dialogs_.saveFile(
        this, tr("Save the picture"),
        {tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)"),
         tr("Values as text (*.csv)")},
        (plot_->drawing().title.isEmpty() ? tr("table") : plot_->drawing().title) + ".svg");
    if (file.isEmpty())
        return;
    try {
        exportTo(file.toStdString());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("The picture cannot be written"), sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_TablePanel.cpp"
