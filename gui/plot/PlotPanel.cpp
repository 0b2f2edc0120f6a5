#include "gui/plot/PlotPanel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/plot/AxisLimitsDialog.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotNavigator.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/FlowBar.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

PlotPanel::PlotPanel(PlotKind kind, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    setObjectName("plotPanel");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    const PlotStyle style = PlotStyle::screen(palette());
    PlotNavigator* navigator = nullptr;
    if (kind == PlotKind::polar) {
        polar_ = new PolarPlot(style, this);
        surface_ = polar_;
        navigator = &polar_->navigator();
        connect(polar_, &PolarPlot::viewChanged, this, &PlotPanel::refresh);
    } else {
        cartesian_ = new CartesianPlot(style, this);
        surface_ = cartesian_;
        navigator = &cartesian_->navigator();
        connect(cartesian_, &CartesianPlot::viewChanged, this, &PlotPanel::refresh);
    }
    makeViewActions();
    makeCopyAndSaveActions();
    makeBar();
    connect(navigator, &PlotNavigator::menuRequested, this, [this](const QPoint& where) {
        QMenu* menu = contextMenu(this, "plotMenu");
        for (const char* name :
             {"resetView", "undoZoom", "axisLimits", "", "logX", "logY", "decibel", "crosshair",
              "errorBands", "", "copyPicture", "copyValues", "copyAllValues", "", "savePlot",
              "saveValues", "saveAllValues"}) {
            if (*name == 0)
                menu->addSeparator();
            else if (const auto found = actions_.find(name); found != actions_.end())
                menu->addAction(found->second);
        }
        menu->popup(where);
    });
    connect(actions_.at("crosshair"), &QAction::toggled, navigator,
            &PlotNavigator::setCrosshairVisible);
    refresh();
}

QAction* PlotPanel::add(const QString& name, const QString& iconName, const QString& text) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    if (!iconName.isEmpty())
        action->setIcon(icon(iconName));
    actions_[name] = action;
    return action;
}

void PlotPanel::makeViewActions() {
    const auto toggle = [this](const QString& name, const QString& iconName, const QString& text) {
        auto* action = add(name, iconName, text);
        action->setCheckable(true);
        return action;
    };
    connect(add("resetView", "home", tr("Show all (double click)")), &QAction::triggered, this,
            [this] { surface_->resetView(); });
    connect(add("undoZoom", "zoom-undo", tr("Back to the last view (Backspace)")),
            &QAction::triggered, this, [this] { surface_->undoZoom(); });
    connect(add("axisLimits", "axis-limits", tr("Axis limits…")), &QAction::triggered, this,
            &PlotPanel::typeLimits);
    toggle("crosshair", "crosshair", tr("Crosshair with values"))->setChecked(true);
    auto* bands = toggle("errorBands", "error-band", tr("Error bands"));
    bands->setChecked(true);
    connect(bands, &QAction::toggled, this,
            [this](bool on) { surface_->setErrorBandsVisible(on); });
    if (polar_ != nullptr) {
        connect(toggle("decibel", "", tr("Radius in dB")), &QAction::toggled, this,
                [this](bool on) {
                    polar_->setRadiusScale(on ? RadiusScale::decibel : RadiusScale::linear);
                });
        return;
    }
    connect(toggle("logX", "", tr("Logarithmic x axis")), &QAction::toggled, this, [this](bool on) {
        if (on != cartesian_->isLogarithmic(QwtPlot::xBottom))
            cartesian_->setLogarithmic(QwtPlot::xBottom, on);
    });
    connect(toggle("logY", "", tr("Logarithmic y axis")), &QAction::toggled, this, [this](bool on) {
        if (on != cartesian_->isLogarithmic(QwtPlot::yLeft))
            cartesian_->setLogarithmic(QwtPlot::yLeft, on);
    });
}

void PlotPanel::makeCopyAndSaveActions() {
    connect(add("copyPicture", "copy", tr("Copy picture")), &QAction::triggered, this,
            &PlotPanel::copyPicture);
    connect(add("copyValues", "", tr("Copy visible values")), &QAction::triggered, this,
            [this] { copyValues(PlotPart::visible); });
    connect(add("copyAllValues", "", tr("Copy all values")), &QAction::triggered, this,
            [this] { copyValues(PlotPart::all); });
    connect(add("savePlot", "export", tr("Save picture…")), &QAction::triggered, this,
            &PlotPanel::savePicture);
    connect(add("saveValues", "", tr("Save visible values…")), &QAction::triggered, this,
            [this] { saveValues(PlotPart::visible); });
    connect(add("saveAllValues", "", tr("Save all values…")), &QAction::triggered, this,
            [this] { saveValues(PlotPart::all); });
}

void PlotPanel::makeBar() {
    auto* strip = new FlowBar(this);
    strip->layout()->setContentsMargins(10, 8, 10, 0);
    front_ = strip->first();
    front_->setSpacing(8);
    auto* bar = strip->second();
    bar->setSpacing(2);
    const auto button = [&](const QString& name, const QString& text = {}) {
        if (actions_.find(name) == actions_.end())
            return;
        auto* tool = new QToolButton(this);
        tool->setObjectName(name);
        tool->setDefaultAction(actions_.at(name));
        tool->setAutoRaise(true);
        tool->setIconSize(QSize(18, 18));
        tool->setToolTip(actions_.at(name)->text());
        if (!text.isEmpty())
            actions_.at(name)->setIconText(text);
        bar->addWidget(tool);
    };
    button("logX", tr("log x"));
    button("logY", tr("log y"));
    button("decibel", tr("dB"));
    bar->addSpacing(8);
    for (const char* name : {"resetView", "undoZoom", "axisLimits", "crosshair", "errorBands"})
        button(name);
    bar->addSpacing(8);
    const auto drop = [&](const QString& name, const QString& iconName, const QString& tip,
                          const QStringList& names) {
        auto* tool = new QToolButton(this);
        tool->setObjectName(name);
        tool->setIcon(icon(iconName));
        tool->setIconSize(QSize(18, 18));
        tool->setToolTip(tip);
        tool->setAutoRaise(true);
        tool->setPopupMode(QToolButton::InstantPopup);
        tool->setMenu(menuOf(name + "Menu", names));
        bar->addWidget(tool);
    };
    drop("copyPlot", "copy", tr("Copy picture or values"),
         {"copyPicture", "copyValues", "copyAllValues"});
    drop("exportPlot", "export", tr("Save picture or values"),
         {"savePlot", "saveValues", "saveAllValues"});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(strip);
    column->addWidget(surface_->widget(), 1);
}

QMenu* PlotPanel::menuOf(const QString& name, const QStringList& names) {
    auto* menu = new QMenu(this);
    menu->setObjectName(name);
    for (const auto& action : names)
        menu->addAction(actions_.at(action));
    return menu;
}

void PlotPanel::addInFront(QWidget* widget) {
    front_->addWidget(widget);
}

QAction* PlotPanel::action(const QString& name) const {
    const auto found = actions_.find(name);
    if (found == actions_.end())
        throw irsg::LogicError("this plot has no action " + name.toStdString());
    return found->second;
}

void PlotPanel::refresh() {
    actions_.at("undoZoom")->setEnabled(surface_->canUndoZoom());
    actions_.at("errorBands")->setEnabled(surface_->hasErrors());
    if (cartesian_ != nullptr) {
        actions_.at("logX")->setChecked(cartesian_->isLogarithmic(QwtPlot::xBottom));
        actions_.at("logY")->setChecked(cartesian_->isLogarithmic(QwtPlot::yLeft));
    } else {
        actions_.at("decibel")->setEnabled(polar_->canBeDecibel());
        actions_.at("decibel")->setChecked(polar_->radiusScale() == RadiusScale::decibel);
    }
}

void PlotPanel::typeLimits() {
    std::vector<AxisLimitsDialog::Axis> axes;
    if (cartesian_ != nullptr) {
        const auto view = cartesian_->view();
        const auto& data = cartesian_->data();
        axes = {{data.xTitle, view.x, data.xLogarithmic}, {data.yTitle, view.y, data.yLogarithmic}};
    } else {
        const bool decibel = polar_->radiusScale() == RadiusScale::decibel;
        axes = {{decibel ? tr("Radius (dB)") : polar_->data().radiusTitle, polar_->radiusLimits()}};
    }
    AxisLimitsDialog dialog(axes, this);
    if (!dialogs_.run(dialog) || !dialog.isAcceptable())
        return;
    const auto limits = dialog.limits();
    surface_->rememberView();
    if (cartesian_ != nullptr)
        cartesian_->setView({limits.at(0), limits.at(1)});
    else
        polar_->setRadiusLimits(limits.at(0));
}

void PlotPanel::exportTo(const std::filesystem::path& file) const {
    cartesian_ != nullptr ? exportPlot(*cartesian_, file) : exportPlot(*polar_, file);
}

void PlotPanel::savePicture() {
    const QString file = dialogs_.saveFile(
        this, tr("Save picture"),
        {tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")}, {});
    if (file.isEmpty())
        return;
    try {
        exportTo(file.toStdString());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This cannot be saved"), sentencesOf(error));
    }
}

void PlotPanel::saveValues(PlotPart part) {
    const QString file =
        dialogs_.saveFile(this, tr("Save values"), {tr("Values as text (*.csv)")}, {});
    if (file.isEmpty())
        return;
    try {
        writePlotFile(file.toStdString(), valuesOf(part, ',').toUtf8());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This cannot be saved"), sentencesOf(error));
    }
}

QString PlotPanel::valuesOf(PlotPart part, QChar separator) const {
    return cartesian_ != nullptr ? plotValues(*cartesian_, part, separator)
                                 : plotValues(*polar_, part, separator);
}

void PlotPanel::copyPicture() const {
    auto* mime = new QMimeData;
    mime->setImageData(cartesian_ != nullptr ? plotPicture(*cartesian_) : plotPicture(*polar_));
    mime->setData("image/svg+xml", cartesian_ != nullptr ? plotSvg(*cartesian_) : plotSvg(*polar_));
    QApplication::clipboard()->setMimeData(mime);
}

void PlotPanel::copyValues(PlotPart part) const {
    auto* mime = new QMimeData;
    mime->setText(valuesOf(part, '\t'));
    mime->setData("text/csv", valuesOf(part, ',').toUtf8());
    QApplication::clipboard()->setMimeData(mime);
}

void PlotPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || surface_ == nullptr)
        return;
    const PlotStyle style = PlotStyle::screen(palette());
    cartesian_ != nullptr ? cartesian_->setLook(style) : polar_->setLook(style);
}

} // namespace smat::gui

#include "moc_PlotPanel.cpp"
