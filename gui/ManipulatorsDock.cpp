#include "gui/ManipulatorsDock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/ModelFieldsForm.h"
#include "gui/settings/SettingForm.h"
#include "gui/settings/TypedSetting.h"
#include "gui/widgets/FlowBar.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

constexpr int sliderSteps = 3600; ///< a tenth of a degree over a turn
constexpr int leastWidth_px = 236;
/// With all buttons in one row.
constexpr int usualWidth_px = 302;

class FieldsArea : public QScrollArea {
  public:
    using QScrollArea::QScrollArea;
    QSize sizeHint() const override {
        return {usualWidth_px + style()->pixelMetric(QStyle::PM_ScrollBarExtent),
                QScrollArea::sizeHint().height()};
    }
};

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

ManipulatorsDock::ManipulatorsDock(Workbench& workbench, QWidget* parent)
    : QDockWidget(tr("Camera and model"), parent), workbench_(workbench) {
    setObjectName("manipulatorsDock");
    auto* body = new QWidget;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    grid->addWidget(heading(tr("Camera"), body), grid->rowCount(), 0, 1, 4);
    addRow(grid, key::cameraAzimuth, tr("A&zimuth"), {-180, 180});
    addRow(grid, key::cameraElevation, tr("E&levation"), {-90, 90});
    addRow(grid, key::cameraRange, tr("Ra&nge"), {1, 1e6, true});
    addViews(grid);
    const int modelLine = grid->rowCount();
    grid->addWidget(heading(tr("Model"), body), modelLine, 0);
    models_ = new QComboBox(body);
    models_->setObjectName("chosenModel");
    models_->setToolTip(tr("The model that is placed here, that the database editor edits and that "
                           "has handles in the view"));
    models_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid->addWidget(models_, modelLine, 1, 1, 3);
    connect(models_, &QComboBox::activated, this,
            [this](int index) { workbench_.chooseModel(static_cast<std::size_t>(index)); });
    addRow(grid, key::targetYaw, tr("&Yaw"), {-180, 180});
    addRow(grid, key::targetPitch, tr("&Pitch"), {-90, 90});
    addRow(grid, key::targetRoll, tr("&Roll"), {-180, 180});
    others_ = new ModelFieldsForm(workbench_, body);

    form_ = new SettingForm({key::targetAltitude, key::stateTime, key::statePower, key::stateMach},
                            {}, body);
    form_->layout()->setContentsMargins(0, 6, 0, 0);
    static_cast<QFormLayout*>(form_->layout())->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form_->setLive();
    connect(form_, &SettingForm::edited, this,
            [this](const std::string& key) { workbench_.set(key, form_->value(key)); });
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(12, 8, 12, 8);
    column->addLayout(grid);
    column->addWidget(form_);
    column->addSpacing(6);
    column->addWidget(others_);
    column->addStretch(1);
    body->setEnabled(false);
    auto* scroll = new FieldsArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(body);
    // As wide as its fields beside a scroll bar; a slider gives way first.
    scroll->setMinimumWidth(leastWidth_px + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    setWidget(scroll);

    connect(&workbench_, &Workbench::projectOpened, this, [body] { body->setEnabled(true); });
    connect(&workbench_, &Workbench::settingsChanged, this, &ManipulatorsDock::refresh);
    connect(&workbench_, &Workbench::projectOpened, this, &ManipulatorsDock::refreshModels);
    connect(&workbench_, &Workbench::projectChanged, this, &ManipulatorsDock::refreshModels);
    connect(&workbench_, &Workbench::modelChosen, this, &ManipulatorsDock::refreshModels);
    refresh();
    refreshModels();
}

void ManipulatorsDock::refreshModels() {
    QStringList names;
    if (workbench_.hasProject())
        for (const ProjectModel& model : workbench_.project().models)
            names << QString::fromStdString(model.shownName());
    QStringList shown;
    for (int i = 0; i < models_->count(); ++i)
        shown << models_->itemText(i);
    if (names != shown) {
        models_->clear();
        models_->addItems(names);
    }
    models_->setCurrentIndex(static_cast<int>(workbench_.chosenModel()));
    models_->setVisible(names.size() > 1);
    // The target stands and does as the settings say, the others as they themselves do.
    const bool isTarget = workbench_.chosenModel() == 0;
    for (QWidget* widget : ofTarget_)
        widget->setVisible(isTarget);
    form_->setVisible(isTarget);
    others_->setVisible(!isTarget);
    others_->refresh();
}

void ManipulatorsDock::addRow(QGridLayout* grid, const std::string& key, const QString& label,
                              const Reach& reach) {
    const SettingInfo& info = settingInfo(key);
    const QString name = QString::fromStdString(key);
    Row row{reach, new QSlider(Qt::Horizontal), new QLineEdit};
    row.slider->setObjectName(name + ".slider");
    row.slider->setFocusPolicy(Qt::StrongFocus);
    row.slider->setRange(0, sliderSteps);
    row.slider->setSingleStep(10);
    row.slider->setPageStep(sliderSteps / 24);
    row.slider->setMinimumWidth(40);
    row.field->setObjectName(name);
    row.field->setFixedWidth(76);
    row.field->setAlignment(Qt::AlignRight);
    row.slider->setToolTip(SettingForm::helpText(info));
    row.field->setToolTip(row.slider->toolTip());
    auto* caption = new QLabel(label);
    caption->setBuddy(row.field);
    auto* unit = new QLabel(formattedUnit(info.unit));
    unit->setForegroundRole(QPalette::PlaceholderText);
    const int line = grid->rowCount();
    grid->addWidget(caption, line, 0);
    grid->addWidget(row.slider, line, 1);
    grid->addWidget(row.field, line, 2);
    grid->addWidget(unit, line, 3);
    rows_[key] = row;
    if (key.starts_with("target."))
        for (QWidget* widget :
             std::initializer_list<QWidget*>{caption, row.slider, row.field, unit})
            ofTarget_.push_back(widget);

    connect(row.slider, &QSlider::sliderPressed, this, [this] { workbench_.holdStep(); });
    connect(row.slider, &QSlider::sliderReleased, this, [this] { workbench_.closeStep(); });
    connect(row.slider, &QSlider::valueChanged, this,
            [this, key](int position) { onSlider(key, position); });
    connect(row.field, &QLineEdit::textEdited, this, [this, key] { onText(key); });
    connect(row.field, &QLineEdit::editingFinished, this, [this, key] { finish(key); });
}

void ManipulatorsDock::addViews(QGridLayout* grid) {
    struct View {
        const char* name;
        const char* text;
        const char* azimuth;
        const char* elevation;
        QString tip;
    };
    const std::array<View, 6> views{{{"viewNose", "Nose", "0", "0", tr("From the nose")},
                                     {"viewTail", "Tail", "180", "0", tr("From the tail")},
                                     {"viewPort", "Port", "-90", "0", tr("From port")},
                                     {"viewStarboard", "Starb.", "90", "0", tr("From starboard")},
                                     {"viewTop", "Top", "0", "90", tr("From above")},
                                     {"viewBelly", "Belly", "0", "-90", tr("From below")}}};
    auto* buttons = new WrappingRow;
    buttons->setSpacing(4);
    for (std::size_t i = 0; i < views.size(); ++i) {
        const View& view = views[i];
        auto* button = new QToolButton;
        button->setObjectName(view.name);
        button->setText(tr(view.text));
        button->setToolTip(view.tip);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this, [this, view] {
            Settings settings = workbench_.settings();
            settings.set(key::cameraAzimuth, view.azimuth);
            settings.set(key::cameraElevation, view.elevation);
            workbench_.set(settings, tr("Look: %1").arg(view.tip.toLower()));
        });
        buttons->addWidget(button);
    }
    grid->addLayout(buttons, grid->rowCount(), 0, 1, 4);
}

int ManipulatorsDock::positionOf(const Reach& reach, double value) {
    const double inside = std::clamp(value, reach.minimum, reach.maximum);
    const double part = reach.isLogarithmic
                            ? irsg::fractionByRatio(reach.minimum, reach.maximum, inside)
                            : (inside - reach.minimum) / (reach.maximum - reach.minimum);
    return static_cast<int>(std::lround(part * sliderSteps));
}

double ManipulatorsDock::valueAt(const Reach& reach, int position) {
    const double part = static_cast<double>(position) / sliderSteps;
    if (!reach.isLogarithmic)
        return std::round(10.0 * (reach.minimum + part * (reach.maximum - reach.minimum))) / 10.0;
    // Three digits, so that a drag passes by numbers people like.
    const double value = irsg::lerpByRatio(reach.minimum, reach.maximum, part);
    const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return std::round(value / digit) * digit;
}

void ManipulatorsDock::onSlider(const std::string& key, int position) {
    const Row& row = rows_.at(key);
    if (refreshing_)
        return;
    workbench_.set(key, QString::number(valueAt(row.reach, position), 'g', 6).toStdString());
}

void ManipulatorsDock::onText(const std::string& key) {
    Row& row = rows_.at(key);
    if (!row.before)
        row.before = workbench_.settings().text(key);
    const auto text = typedSetting(settingInfo(key), row.field->text());
    QPalette colours; // of the theme, but for a mark
    if (!text)
        colours.setColor(QPalette::Base, colors::wrongField(palette()));
    row.field->setPalette(colours);
    if (text)
        workbench_.set(key, *text);
}

void ManipulatorsDock::finish(const std::string& key) {
    Row& row = rows_.at(key);
    const QString problem = problemOf(settingInfo(key), row.field->text());
    // A text that cannot stay takes along what its first letters did.
    if (const auto before = std::exchange(row.before, std::nullopt); before && !problem.isEmpty()) {
        sayRefused(*row.field, problem, textOf(*before));
        workbench_.set(key, *before);
    }
    workbench_.closeStep();
    row.field->clear();
    refresh();
}

void ManipulatorsDock::refresh() {
    refreshing_ = true;
    const Settings& settings = workbench_.settings();
    for (const auto& [key, row] : rows_) {
        row.slider->setValue(positionOf(row.reach, settings[RealKey{key.c_str()}]));
        // A field that is being typed into holds the same value already and keeps its text.
        const std::string& text = settings.text(key);
        if (typedSetting(settingInfo(key), row.field->text()) != text) {
            row.field->setText(QString::fromStdString(text));
            row.field->setPalette(QPalette());
        }
    }
    for (const auto& key : form_->keys())
        if (form_->value(key) != settings.text(key))
            form_->setValue(key, settings.text(key));
    refreshing_ = false;
}

} // namespace smat::gui

#include "moc_ManipulatorsDock.cpp"
