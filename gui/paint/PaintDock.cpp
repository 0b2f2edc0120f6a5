#include "gui/paint/PaintDock.h"

#include <numbers>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/VerticalScrollArea.h"

namespace smat::gui {
namespace {

QLabel* bold(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

QComboBox* choice(const QStringList& items, const char* name, const QString& tip, QWidget* parent) {
    auto* box = new QComboBox(parent);
    box->addItems(items);
    box->setObjectName(name);
    box->setToolTip(tip);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    return box;
}

QString areaWords(double area_m2) {
    return QStringLiteral("%1 m²").arg(QString::number(area_m2, 'g', 4));
}

} // namespace

PaintDock::PaintDock(QWidget* parent) : QDockWidget(tr("Paint codes"), parent) {
    setObjectName("paintDock");
    auto* body = new QWidget(this);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(12, 10, 12, 10);
    column->setSpacing(12);
    column->addWidget(makePicking());
    column->addWidget(makePainting());
    column->addWidget(makeLegend(), 1);
    // No wider than the docks beside and below it.
    setWidget(new VerticalScrollArea(body, this, 250));
    connect(by_, &QComboBox::activated, this, [this] {
        refresh();
        emit pickByChosen();
    });
    connect(model_, &QComboBox::activated, this, &PaintDock::modelChosen);
    connect(temperature_, &IndexBox::edited, this, &PaintDock::refresh);
    connect(material_, &IndexBox::edited, this, &PaintDock::refresh);
    connect(paint_, &QPushButton::clicked, this, &PaintDock::paintWanted);
    connect(erase_, &QPushButton::clicked, this, &PaintDock::eraseWanted);
    connect(clear_, &QPushButton::clicked, this, &PaintDock::clearWanted);
    connect(shown_, &QComboBox::activated, this, &PaintDock::shownChosen);
    connect(legend_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        emit indexWanted(item->data(0, Qt::UserRole).toInt());
    });
    refresh();
}

QWidget* PaintDock::makePicking() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bold(tr("Choose faces"), part));
    auto* form = new QFormLayout;
    column->addLayout(form);
    modelRow_ = new QWidget(part);
    auto* modelRow = new QHBoxLayout(modelRow_);
    modelRow->setContentsMargins(0, 0, 0, 0);
    model_ = choice({}, "paintModel", tr("The model whose faces are painted"), modelRow_);
    modelRow->addWidget(new QLabel(tr("Model"), modelRow_));
    modelRow->addWidget(model_, 1);
    form->addRow(modelRow_);
    by_ = choice({tr("Single faces"), tr("Connected part"), tr("All of one material"),
                  tr("Smooth surface"), tr("Box in the view")},
                 "pickBy", tr("What a click in the view chooses"), part);
    form->addRow(tr("Pick"), by_);
    angle_ = new RealBox("pickAngle", tr("°"), part);
    angle_->setRange(0.0, 180.0);
    angle_->setDecimals(1);
    angle_->setValue(20.0);
    angle_->setToolTip(tr("The surface ends where it bends by more than that"));
    form->addRow(tr("Bends up to"), angle_);
    hidden_ = new QCheckBox(tr("Also hidden faces"), part);
    hidden_->setObjectName("pickHidden");
    hidden_->setToolTip(tr("Includes hidden faces and faces that look away"));
    form->addRow(QString(), hidden_);
    hint_ = new QLabel(part);
    hint_->setObjectName("paintHint");
    hint_->setWordWrap(true);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(hint_);
    auto* row = new QHBoxLayout;
    chosen_ = new QLabel(part);
    chosen_->setObjectName("paintChosen");
    chosen_->setWordWrap(true);
    clear_ = new QPushButton(tr("Clear selection"), part);
    clear_->setObjectName("clearChosen");
    row->addWidget(chosen_, 1);
    row->addWidget(clear_);
    column->addLayout(row);
    return part;
}

QWidget* PaintDock::makePainting() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bold(tr("Give them"), part));
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    temperature_ = new IndexBox(part);
    temperature_->setObjectName("paintTemperature");
    material_ = new IndexBox(part);
    material_->setObjectName("paintMaterial");
    for (auto* box : {temperature_, material_})
        box->setToolTip(
            tr("An entry of the database, or a number; empty leaves their codes unchanged"));
    form->addRow(tr("Temperature"), temperature_);
    form->addRow(tr("Material"), material_);
    column->addLayout(form);
    auto* row = new QHBoxLayout;
    paint_ = new QPushButton(icon("paint"), tr("Paint"), part);
    paint_->setObjectName("paintFaces");
    erase_ = new QPushButton(tr("Erase"), part);
    erase_->setObjectName("eraseFaces");
    erase_->setToolTip(
        tr("Restores the codes that the model's file and its rules give to the chosen faces"));
    row->addWidget(paint_);
    row->addWidget(erase_);
    row->addStretch(1);
    column->addLayout(row);
    return part;
}

QWidget* PaintDock::makeLegend() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bold(tr("Codes in the view"), part));
    shown_ = choice({tr("Colours of the model"), tr("Temperature index"), tr("Material index")},
                    "codesShown", tr("What the visible display shows of the faces"), part);
    column->addWidget(shown_);
    legend_ = new QTreeWidget(part);
    legend_->setObjectName("codeLegend");
    legend_->setHeaderLabels({tr("Index"), tr("Name"), tr("Faces"), tr("Area")});
    legend_->setRootIsDecorated(false);
    legend_->setUniformRowHeights(true);
    legend_->setMinimumHeight(120);
    legend_->setToolTip(tr("Enter or a double click chooses all faces of an index"));
    legend_->header()->setStretchLastSection(false);
    legend_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    legend_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    column->addWidget(legend_, 1);
    return part;
}

void PaintDock::setModels(const QStringList& names, int model) {
    model_->clear();
    model_->addItems(names);
    model_->setCurrentIndex(model);
    modelRow_->setVisible(names.size() > 1);
}

int PaintDock::model() const {
    return std::max(0, model_->currentIndex());
}

PickBy PaintDock::pickBy() const {
    return static_cast<PickBy>(by_->currentIndex());
}

double PaintDock::angle_rad() const {
    return angle_->value() * std::numbers::pi / 180.0;
}

bool PaintDock::takesHidden() const {
    return hidden_->isChecked();
}

irsg::GivenCodes PaintDock::codes() const {
    return {temperature_->index(), material_->index()};
}

CodesShown PaintDock::shown() const {
    return static_cast<CodesShown>(shown_->currentIndex());
}

void PaintDock::setChosen(std::size_t faces, double area_m2, const QString& problem) {
    faces_ = faces;
    chosen_->setText(!problem.isEmpty() ? problem
                     : faces == 0       ? tr("Nothing is chosen")
                     : faces == 1       ? tr("1 face, %1").arg(areaWords(area_m2))
                                        : tr("%1 faces, %2").arg(faces).arg(areaWords(area_m2)));
    refresh();
}

void PaintDock::refresh() {
    const PickBy by = pickBy();
    angle_->setEnabled(by == PickBy::angle);
    hidden_->setEnabled(by == PickBy::box);
    hint_->setText(by == PickBy::box
                       ? tr("Draw a box with the left button. Shift adds to the selection, Ctrl "
                            "takes away from it. The right button and the wheel move the camera.")
                       : tr("Click in the view. Shift adds to the selection, Ctrl takes away "
                            "from it."));
    clear_->setEnabled(faces_ > 0);
    erase_->setEnabled(faces_ > 0);
    const bool right = temperature_->isRight() && material_->isRight();
    paint_->setEnabled(faces_ > 0 && right && codes() != irsg::GivenCodes());
    paint_->setToolTip(!right ? tr("An index is a whole number.")
                       : codes() == irsg::GivenCodes()
                           ? tr("Choose a temperature or material first.")
                           : tr("Gives the chosen faces these indices"));
}

void PaintDock::setLegend(const std::vector<CodeRow>& rows) {
    legend_->clear();
    for (const CodeRow& row : rows) {
        auto* item =
            new QTreeWidgetItem(legend_, {QString::number(row.index), row.name,
                                          QString::number(row.faces), areaWords(row.area_m2)});
        item->setData(0, Qt::UserRole, row.index);
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setTextAlignment(3, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(1, row.name);
        QPixmap swatch(14, 14);
        swatch.fill(row.color);
        item->setIcon(0, swatch);
    }
}

} // namespace smat::gui

#include "moc_PaintDock.cpp"
