#include "gui/view/ModelPage.h"

#include <algorithm>
#include <tuple>

#include <QAction>
#include <QActionGroup>
#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageExport.h"
#include "gui/image/PaperPicture.h"
#include "gui/image/ShownImage.h"
#include "gui/view/SensorFrusta.h"
#include "gui/view/ViewOverlay.h"
#include "gui/widgets/FlowBar.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

QIcon swatch(const irsg::ColorMap& map) {
    QPixmap pixmap(48, 14);
    QPainter painter(&pixmap);
    for (int x = 0; x < pixmap.width(); ++x) {
        const irsg::Rgb color = map.at((x + 0.5) / pixmap.width());
        painter.fillRect(x, 0, 1, pixmap.height(), QColor(color.red, color.green, color.blue));
    }
    return pixmap;
}

QToolButton* switchButton(const QString& text, const char* name, const QString& tip,
                          QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setStyleSheet(QStringLiteral(
        "QToolButton { border: 1px solid palette(mid); border-radius: 4px; padding: 3px 10px; }"
        "QToolButton:checked { background: palette(highlight); border-color: palette(highlight);"
        " color: palette(highlighted-text); }"));
    return button;
}

} // namespace

ModelPage::ModelPage(QWidget* parent) : QWidget(parent) {
    setObjectName("modelPage");
    view_ = new SceneView(this);
    bar_ = new ColorBar(this);
    makeActions();

    makeStrip();
    auto* middle = new QHBoxLayout;
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(0);
    middle->addWidget(view_, 1);
    barHolder_ = new QWidget(this);
    auto* holder = new QVBoxLayout(barHolder_);
    holder->setContentsMargins(2, 6, 8, 8);
    holder->addWidget(bar_);
    middle->addWidget(barHolder_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(strip_);
    column->addLayout(middle, 1);

    connect(bar_, &ColorBar::limitsEdited, this, [this](irsg::DisplayLimits limits) {
        const InfraredPicture* picture = view_->shownPicture();
        const ShownUnit* unit = picture == nullptr ? nullptr : unitOfPlane(picture->plane());
        if (unit != nullptr) {
            limits.low = unit->back(limits.low);
            limits.high = unit->back(limits.high);
        }
        view_->infrared().setLimits(limits);
    });
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            &ModelPage::refreshBar);
    const auto takeRule = [this] { view_->infrared().setColorRule(bar_->rule()); };
    connect(bar_, &ColorBar::scaleChosen, view_, takeRule);
    connect(bar_, &ColorBar::modeChosen, view_, takeRule);
    connect(bar_, &ColorBar::marksChosen, view_, takeRule);
    connect(view_, &SceneView::displayChanged, this, &ModelPage::refresh);
    connect(view_, &SceneView::pictureShown, this, &ModelPage::refreshBar);
    refresh();
}

void ModelPage::makeStrip() {
    visibleButton_ = switchButton(tr("Visible"), "showVisible",
                                  tr("The model in the colours of its file"), this);
    infraredButton_ =
        switchButton(tr("Infrared"), "showInfrared",
                     tr("The model as the infrared renderer sees it from here (%1)")
                         .arg(infrared_->shortcut().toString(QKeySequence::NativeText)),
                     this);
    auto* displays = new QButtonGroup(this);
    displays->addButton(visibleButton_);
    displays->addButton(infraredButton_);
    connect(visibleButton_, &QToolButton::clicked, this, [this] { infrared_->setChecked(false); });
    connect(infraredButton_, &QToolButton::clicked, this, [this] { infrared_->setChecked(true); });

    quantityBox_ = new QComboBox(this);
    quantityBox_->setObjectName("viewQuantity");
    quantityBox_->addItems({tr("Radiance"), tr("Apparent temperature")});
    quantityBox_->setToolTip(tr("What the infrared display shows of a pixel"));
    connect(quantityBox_, &QComboBox::activated, this, [this](int index) {
        view_->infrared().setQuantity(static_cast<InfraredQuantity>(index));
    });
    mapBox_ = new QComboBox(this);
    mapBox_->setObjectName("viewColorMap");
    mapBox_->setIconSize(QSize(48, 14));
    mapBox_->setToolTip(tr("Colours of the infrared display"));
    for (const QAction* action : maps_->actions())
        mapBox_->addItem(action->icon(), action->text());
    connect(mapBox_, &QComboBox::textActivated, this,
            [this](const QString& name) { view_->infrared().setColorMap(name.toStdString()); });

    sensorButton_ =
        switchButton(tr("Sensor"), "showSensor",
                     tr("What the sensor of the project sees; it is moved with Ctrl"), this);
    inspectButton_ =
        switchButton(tr("Inspect"), "showInspection",
                     tr("A camera for looking around, which changes nothing in the project (%1)")
                         .arg(inspection_->shortcut().toString(QKeySequence::NativeText)),
                     this);
    auto* cameras = new QButtonGroup(this);
    cameras->addButton(sensorButton_);
    cameras->addButton(inspectButton_);
    connect(sensorButton_, &QToolButton::clicked, this, [this] { inspection_->setChecked(false); });
    connect(inspectButton_, &QToolButton::clicked, this, [this] { inspection_->setChecked(true); });

    strip_ = new FlowBar(this);
    strip_->layout()->setContentsMargins(8, 5, 8, 5);
    auto* strip = strip_->first();
    strip->setSpacing(2);
    strip->addWidget(visibleButton_);
    strip->addWidget(infraredButton_);
    strip->addSpacing(10);
    strip->addWidget(quantityBox_);
    strip->addSpacing(4);
    strip->addWidget(mapBox_);
    strip_->second()->addWidget(sensorButton_);
    strip_->second()->addWidget(inspectButton_);
    for (QAction* action : QList<QAction*>{fit_} + onStrip_) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setIconSize(QSize(18, 18));
        strip_->second()->addWidget(button);
    }
    strip_->second()->setSpacing(2);
}

void ModelPage::addField(QWidget* field) {
    // Behind the cameras, before the buttons.
    constexpr int place = 2;
    strip_->second()->insertSpacing(place, 8);
    strip_->second()->insertWidget(place + 1, field);
    strip_->second()->insertSpacing(place + 2, 8);
}

QAction* ModelPage::toggle(const char* name, const QString& text, const QKeySequence& keys,
                           const QString& tip, bool on, const std::function<void(bool)>& set) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setCheckable(true);
    action->setChecked(on);
    action->setShortcut(keys);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
    connect(action, &QAction::toggled, view_, set);
    return action;
}

void ModelPage::makeActions() {
    constexpr auto ctrlShift = Qt::CTRL | Qt::SHIFT;
    infrared_ = new QAction(icon("infrared"), tr("&Infrared display"), this);
    infrared_->setObjectName("infraredDisplay");
    infrared_->setCheckable(true);
    infrared_->setShortcut(QKeySequence(ctrlShift | Qt::Key_I));
    connect(infrared_, &QAction::toggled, view_, [this](bool on) {
        view_->setDisplay(on ? ViewDisplay::infrared : ViewDisplay::visible);
    });
    apparent_ = new QAction(tr("Apparent &temperature"), this);
    apparent_->setObjectName("apparentTemperature");
    apparent_->setCheckable(true);
    apparent_->setShortcut(QKeySequence(ctrlShift | Qt::Key_T));
    apparent_->setToolTip(tr("Shows apparent temperature instead of radiance"));
    connect(apparent_, &QAction::toggled, view_, [this](bool on) {
        view_->infrared().setQuantity(on ? InfraredQuantity::apparentTemperature
                                         : InfraredQuantity::radiance);
    });

    maps_ = new QActionGroup(this);
    for (const auto& name : irsg::ColorMap::names()) {
        const auto& map = irsg::ColorMap::named(name);
        if (map.isDiverging())
            continue;
        auto* action = maps_->addAction(swatch(map), QString::fromStdString(name));
        action->setCheckable(true);
        action->setObjectName(QStringLiteral("colorMap-") + QString::fromStdString(name));
        connect(action, &QAction::triggered, view_,
                [this, name] { view_->infrared().setColorMap(name); });
    }
    nextMap_ = new QAction(tr("&Next colour map"), this);
    nextMap_->setObjectName("nextColorMap");
    nextMap_->setShortcut(QKeySequence(ctrlShift | Qt::Key_C));
    connect(nextMap_, &QAction::triggered, this, [this] {
        const auto all = maps_->actions();
        const auto at = all.indexOf(maps_->checkedAction());
        all.at((at + 1) % all.size())->trigger();
    });

    auto* wireframe =
        toggle("wireframe", tr("&Wireframe"), ctrlShift | Qt::Key_W, tr("Edges of all faces"),
               false, [this](bool on) { view_->setWireframe(on); });
    wireframe->setIcon(icon("wireframe"));
    auto* viewAxes = toggle("viewAxes", tr("&View axes"), ctrlShift | Qt::Key_A,
                            tr("East, north and up at the bottom left"), true,
                            [this](bool on) { view_->overlay().setViewAxesVisible(on); });
    viewAxes->setIcon(icon("axes"));
    auto* modelAxes = toggle("modelAxes", tr("M&odel axes"), ctrlShift | Qt::Key_M,
                             tr("Starboard, nose and up from the model's centre"), false,
                             [this](bool on) { view_->overlay().setModelAxesVisible(on); });
    modelAxes->setIcon(icon("model-axes"));
    auto* sun = toggle("sunVector", tr("&Sun vector"), ctrlShift | Qt::Key_U,
                       tr("A yellow line from the model's centre towards the sun"), false,
                       [this](bool on) { view_->overlay().setSunVectorVisible(on); });
    sun->setIcon(icon("sun-vector"));
    handles_ = toggle("placeHandles", tr("Handles to &place a model"), ctrlShift | Qt::Key_H,
                      tr("Arrows that move the chosen model and rings that turn it"), false,
                      [this](bool on) { view_->setHandlesVisible(on); });
    handles_->setIcon(icon("place-handles"));
    auto* inset = toggle("pictureInPicture", tr("Othe&r camera in a corner"), ctrlShift | Qt::Key_N,
                         tr("What the other camera sees, in a corner"), true,
                         [this](bool on) { view_->setInsetVisible(on); });
    inset->setIcon(icon("detach"));
    auto* frusta = toggle("zoomFrusta", tr("Frusta of the &zoom windows"), ctrlShift | Qt::Key_J,
                          tr("What the sensor's antialiasing samples by itself, as seen from the "
                             "inspection camera"),
                          false, [this](bool on) { view_->frusta().setOn(on); });
    frusta->setIcon(icon("frusta"));
    toggles_ = {viewAxes, modelAxes, handles_, sun, frusta, wireframe, inset};
    // Beside the editor a small screen has no room for more.
    onStrip_ = {viewAxes, modelAxes, sun, wireframe, inset};
    makeCameraActions();
}

void ModelPage::showHandles(bool on) {
    handles_->setChecked(on);
}

void ModelPage::makeCameraActions() {
    inspection_ = new QAction(icon("eye"), tr("Inspectio&n camera"), this);
    inspection_->setObjectName("inspectionCamera");
    inspection_->setCheckable(true);
    inspection_->setShortcut(Qt::Key_F7);
    inspection_->setToolTip(tr("Looks around without moving the sensor (F7)"));
    connect(inspection_, &QAction::toggled, view_, [this](bool on) {
        view_->navigation().showCamera(on ? ViewCamera::inspection : ViewCamera::sensor);
    });
    fit_ = new QAction(icon("home"), tr("&Fit the scene in the view"), this);
    fit_->setObjectName("fitModel");
    fit_->setShortcut(QKeySequence(Qt::ALT | Qt::Key_0));
    fit_->setToolTip(
        tr("Moves the inspection camera to where the model, or all of several, is seen (Alt+0)"));
    connect(fit_, &QAction::triggered, &view_->navigation(), &ViewNavigation::fit);
    fitChosen_ = new QAction(tr("Fit the chosen mo&del in the view"), this);
    fitChosen_->setObjectName("fitChosenModel");
    fitChosen_->setShortcut(QKeySequence(Qt::ALT | Qt::Key_9));
    fitChosen_->setToolTip(
        tr("Moves the inspection camera to where the chosen one of several models is seen "
           "(Alt+9)"));
    connect(fitChosen_, &QAction::triggered, &view_->navigation(), &ViewNavigation::fitChosen);
    const std::tuple<const char*, QString, ViewSide> sides[] = {
        {"lookAtFront", tr("&Front"), ViewSide::front},
        {"lookAtRear", tr("&Rear"), ViewSide::rear},
        {"lookAtPort", tr("&Port side"), ViewSide::port},
        {"lookAtStarboard", tr("&Starboard side"), ViewSide::starboard},
        {"lookAtTop", tr("&Top"), ViewSide::top},
        {"lookAtBottom", tr("&Bottom"), ViewSide::bottom}};
    int key = Qt::Key_1;
    for (const auto& [name, text, side] : sides) {
        auto* action = new QAction(text, this);
        action->setObjectName(name);
        action->setShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(key++)));
        connect(action, &QAction::triggered, view_,
                [this, side = side] { view_->navigation().lookAt(side); });
        sides_ << action;
    }
}

void ModelPage::fillMenu(QMenu* menu) {
    menu->addAction(infrared_);
    menu->addAction(apparent_);
    auto* maps = menu->addMenu(tr("&Colour map"));
    maps->setObjectName("colorMaps");
    maps->addActions(maps_->actions());
    maps->addSeparator();
    maps->addAction(nextMap_);
    menu->addSeparator();
    menu->addAction(inspection_);
    menu->addActions({fit_, fitChosen_});
    auto* sides = menu->addMenu(tr("&Look at"));
    sides->setObjectName("viewSides");
    sides->addActions(sides_);
    menu->addSeparator();
    menu->addActions(toggles_);
}

void ModelPage::refresh() {
    const bool infrared = view_->display() == ViewDisplay::infrared;
    const bool apparent = view_->infrared().quantity() == InfraredQuantity::apparentTemperature;
    const QString map = QString::fromStdString(view_->infrared().colorMap().name());
    infrared_->setChecked(infrared);
    const bool inspecting = view_->cameras().isInspecting();
    inspection_->setChecked(inspecting);
    (inspecting ? inspectButton_ : sensorButton_)->setChecked(true);
    (infrared ? infraredButton_ : visibleButton_)->setChecked(true);
    apparent_->setChecked(apparent);
    quantityBox_->setCurrentIndex(apparent ? 1 : 0);
    mapBox_->setCurrentText(map);
    for (QAction* action : maps_->actions())
        action->setChecked(action->text() == map);
    for (QWidget* box :
         {static_cast<QWidget*>(quantityBox_), static_cast<QWidget*>(mapBox_), barHolder_})
        box->setVisible(infrared);
    const ColorRule& rule = view_->infrared().colorRule();
    bar_->setMode(rule.mode);
    // The colours that were chosen, also while there is no picture to take limits from.
    bar_->setColors(view_->infrared().colorMap(), bar_->limits());
    bar_->setScale(rule.scale);
    bar_->setMarksOutside(rule.marksOutside);
}

void ModelPage::refreshBar() {
    const InfraredPicture* picture = view_->shownPicture();
    bar_->setEnabled(picture != nullptr);
    if (picture == nullptr)
        return;
    const auto& plane = picture->plane();
    const ShownUnit* unit = unitOfPlane(plane);
    bar_->setTitle(QStringLiteral("%1 (%2)").arg(
        planeTitle(plane), unit == nullptr ? formattedUnit(plane.unit) : unit->unit));
    irsg::DisplayLimits limits = picture->limits;
    if (unit != nullptr) {
        limits.low = unit->shown(limits.low);
        limits.high = unit->shown(limits.high);
        if (limits.levels) {
            std::vector<double> levels = *limits.levels;
            std::ranges::transform(levels, levels.begin(), unit->shown);
            limits.levels = std::make_shared<const std::vector<double>>(std::move(levels));
        }
    }
    bar_->setColors(view_->infrared().colorMap(), limits);
}

QStringList ModelPage::exportFilters() const {
    QStringList filters;
    for (const irsg::ImageFormat* format : irsg::imageFormats())
        if (view_->shownPicture() != nullptr || format->keeps == irsg::ImageFormat::Keeps::picture)
            filters += filterOf(*format);
    return filters;
}

void ModelPage::exportTo(const std::filesystem::path& file) const {
    const irsg::ImageFormat& format = irsg::requiredImageFormat(file);
    const InfraredPicture* picture = view_->shownPicture();
    if (format.keeps == irsg::ImageFormat::Keeps::picture) {
        writePicture(pictureOfPage(), file);
        return;
    }
    if (picture == nullptr)
        throw irsg::InputError({file.string(), "", "the visible display, which has no values",
                                "the infrared display, or a name that ends in .png"});
    if (picture->coarse || !view_->isUpToDate())
        throw irsg::InputError({file.string(), "", "a picture that is still being drawn",
                                "one of a view at rest: try again in a moment"});
    exportImage(*picture->image, picture->plane().name, {}, file);
}

QImage ModelPage::pictureOfPage() const {
    const bool infrared = view_->shownPicture() != nullptr;
    std::vector<Condition> conditions = conditionsOf(view_->shownSettings());
    // In visible colours neither band nor air is seen.
    if (!infrared)
        std::erase_if(conditions, [](const Condition& one) {
            return one.key == key::sensorBand || one.key == key::environmentAtmospheres;
        });
    auto* view = const_cast<SceneView*>(view_);
    const bool hasHandles = view->hasHandles();
    view->setHandlesVisible(false); // nothing of the scene
    const QImage picture = view->grab().toImage();
    view->setHandlesVisible(hasHandles);
    return onPaper(
        {picture, title_, QString::fromStdString(lineOf(conditions)), infrared ? bar_ : nullptr});
}

} // namespace smat::gui

#include "moc_ModelPage.cpp"
