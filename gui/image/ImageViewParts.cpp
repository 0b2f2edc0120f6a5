#include <initializer_list>

#include <QComboBox>
#include <QCoreApplication>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/image/ColorBar.h"
#include "gui/image/HotSpotsPanel.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ImageLines.h"
#include "gui/image/ImageView.h"
#include "gui/image/IndexLegend.h"
#include "gui/image/LinkedViews.h"
#include "gui/image/ProfilePanel.h"
#include "gui/widgets/FlowBar.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {
namespace {

/// Two parts beside each other where there is room for both, else one above the other.
class RoomySplitter : public QSplitter {
  public:
    using QSplitter::QSplitter;

  protected:
    void resizeEvent(QResizeEvent* event) override {
        constexpr int besideFrom_px = 900;
        setOrientation(width() < besideFrom_px ? Qt::Vertical : Qt::Horizontal);
        QSplitter::resizeEvent(event);
    }
};

} // namespace

ImageView::ImageView(QWidget* parent, Dialogs dialogs)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    setObjectName("imageView");
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    canvas_ = new ImageCanvas(this);
    colorBar_ = new ColorBar(this);
    legend_ = new IndexLegend(this);
    legend_->hide();
    inspector_ = new ImageInspector(this);
    inspector_->hide();
    pixels_ = new PixelPanel(this);
    pixels_->hide();
    // Through those of the view, which may be given others.
    Dialogs through = dialogs_;
    through.saveFile = [this](QWidget* over, const QString& title, const QStringList& filters,
                              const QString& suggestion) {
        return dialogs_.saveFile(over, title, filters, suggestion);
    };
    through.tell = [this](QWidget* over, const QString& title, const QStringList& sentences) {
        dialogs_.tell(over, title, sentences);
    };
    through.run = [this](QDialog& dialog) { return dialogs_.run(dialog); };
    profile_ = new ProfilePanel(through, this);
    profile_->hide();
    hotSpots_ = new HotSpotsPanel(this);
    hotSpots_->hide();
    lines_ = new ImageLines(*canvas_, *profile_, *hotSpots_, this);
    conditions_ = new QLabel(this);
    conditions_->setObjectName("conditions");
    conditions_->setForegroundRole(QPalette::PlaceholderText);
    conditions_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    conditions_->setWordWrap(true);
    conditions_->hide();
    readout_ = new QLabel(this);
    readout_->setObjectName("pixelReadout");
    statistics_ = new QLabel(this);
    statistics_->setObjectName("statistics");
    statistics_->setForegroundRole(QPalette::PlaceholderText);
    for (QLabel* label : {readout_, statistics_}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setMinimumWidth(0);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    statistics_->setWordWrap(true);

    auto* picture = new QWidget(this);
    auto* middle = new QHBoxLayout(picture);
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(0);
    middle->addWidget(canvas_, 1);
    middle->addWidget(colorBar_);
    middle->addWidget(legend_);
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(picture);
    splitter->addWidget(inspector_);
    splitter->addWidget(profile_);
    splitter->addWidget(hotSpots_);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 1);
    splitter->setStretchFactor(2, 2);
    auto* across = new RoomySplitter(this);
    across->setObjectName("imageAndPixel");
    across->setChildrenCollapsible(false);
    across->addWidget(splitter);
    across->addWidget(pixels_);
    across->setStretchFactor(0, 3);
    across->setStretchFactor(1, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(8);
    column->addLayout(makeBar());
    column->addWidget(conditions_);
    column->addWidget(across, 1);
    column->addWidget(readout_);
    column->addWidget(statistics_);
    connectParts();
}

void ImageView::focusInEvent(QFocusEvent* event) {
    // No proxy: Tab would jump over all that stands before it.
    canvas_->setFocus(event->reason());
}

QHBoxLayout* ImageView::makeBar() {
    plane_ = new QComboBox(this);
    plane_->setObjectName("plane");
    plane_->setToolTip(tr("What is shown (1 to 9)"));
    plane_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    colors_ = new QComboBox(this);
    colors_->setObjectName("colorMap");
    colors_->setToolTip(tr("Colours of the view; the data stay as they are (M)"));
    colors_->setIconSize(QSize(56, 14));
    for (const auto& name : irsg::ColorMap::names()) {
        const auto& map = irsg::ColorMap::named(name);
        if (!map.isDiverging())
            colors_->addItem(swatchOf(map), QString::fromStdString(name));
    }
    histogram_ = textButton(tr("Histogram"), "showHistogram", tr("Histogram and statistics (H)"));
    histogram_->setCheckable(true);
    tilesShown_ = textButton(tr("Antialiasing tiles"), "showWindows",
                             tr("Outline the tiles that antialiasing samples separately (W)"));
    tilesShown_->setCheckable(true);
    explains_ = textButton(tr("Explain"), "explainPixels",
                           tr("Click a pixel to see what its radiance is made of (X)"));
    explains_->setCheckable(true);
    explains_->hide();
    auto* copy = menuButton(tr("Copy"), "copyImage", tr("Copy to other programs"));
    copy->menu()->addAction(tr("Picture with colour bar"), this, [this] { copyPicture(true); });
    copy->menu()->addAction(tr("Picture"), this, [this] { copyPicture(false); });
    copy->menu()->addAction(tr("Values"), this, &ImageView::copyValues);
    auto* write = menuButton(tr("Export"), "exportImage", tr("Write the image to a file"));
    const auto format = [&](const QString& text, const QString& filter, bool withBar) {
        write->menu()->addAction(text, this,
                                 [this, filter, withBar] { askAndExport(filter, withBar); });
    };
    for (const irsg::ImageFormat* one : irsg::imageFormats()) {
        const QString filter = filterOf(*one), name = QString::fromUtf8(one->shortName);
        if (one->keeps == irsg::ImageFormat::Keeps::picture) {
            format(tr("Picture with colour bar…"), filter, true);
            format(tr("Picture…"), filter, false);
        } else {
            format(one->keeps == irsg::ImageFormat::Keeps::allPlanes
                       ? tr("All planes as %1…").arg(name)
                       : tr("This plane as %1…").arg(name),
                   filter, false);
        }
    }
    auto* fit = textButton(tr("Fit"), "fit", tr("Show the whole image (F, double click)"));
    auto* actual =
        textButton(tr("1:1"), "actualSize", tr("One pixel of the image is one of the screen (A)"));
    connect(fit, &QToolButton::clicked, canvas_, &ImageCanvas::fit);
    connect(actual, &QToolButton::clicked, canvas_, &ImageCanvas::showActualSize);
    connect(tilesShown_, &QToolButton::toggled, this, &ImageView::outlineTiles);
    connect(explains_, &QToolButton::toggled, this, [this](bool on) {
        pixels_->setVisible(on);
        if (on)
            pixels_->prepare();
    });
    connect(histogram_, &QToolButton::toggled, inspector_, &QWidget::setVisible);

    // In two rows where the page is narrow.
    auto* flow = new FlowBar(this);
    flow->first()->addWidget(plane_);
    flow->first()->addWidget(colors_);
    for (QWidget* widget : std::initializer_list<QWidget*>{
             histogram_, lines_->profileButton(), lines_->isoButton(), lines_->levelsField(),
             lines_->spotsButton(), tilesShown_, explains_, copy, write, fit, actual})
        flow->second()->addWidget(widget);
    auto* bar = new QHBoxLayout;
    bar->addWidget(flow);
    return bar;
}

void ImageView::connectParts() {
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            &ImageView::takeUnits);
    connect(plane_, &QComboBox::activated, this, &ImageView::showPlane);
    connect(colors_, &QComboBox::textActivated, this,
            [this](const QString& name) { setColorMap(name.toStdString()); });
    connect(canvas_, &ImageCanvas::hovered, this, &ImageView::tellPixel);
    LinkedViews::instance().add(this);
    connect(canvas_, &ImageCanvas::clicked, this, &ImageView::explainAt);
    connect(canvas_, &ImageCanvas::selectionChanged, this, &ImageView::updateStatistics);
    connect(colorBar_, &ColorBar::limitsEdited, this, &ImageView::recolor);
    connect(colorBar_, &ColorBar::modeChosen, this, &ImageView::updateColors);
    connect(colorBar_, &ColorBar::scaleChosen, this, &ImageView::updateColors);
    connect(colorBar_, &ColorBar::marksChosen, this, &ImageView::updateColors);
    // Behind what these buttons show themselves.
    for (QToolButton* part :
         {histogram_, lines_->profileButton(), lines_->spotsButton(), explains_})
        connect(part, &QToolButton::toggled, this, [this, part](bool on) {
            if (on) // once sizes are up to date
                QTimer::singleShot(0, this, [this, part] { makeRoomFor(part); });
        });
}

void ImageView::makeRoomFor(QToolButton* part) {
    const QScrollArea* page = nullptr;
    for (QWidget* above = parentWidget(); above != nullptr && page == nullptr;
         above = above->parentWidget())
        page = qobject_cast<QScrollArea*>(above);
    if (page == nullptr || page->widget() == nullptr)
        return;
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    if (page->widget()->minimumSizeHint().height() <= page->viewport()->height())
        return;
    for (QToolButton* other :
         {histogram_, lines_->profileButton(), lines_->spotsButton(), explains_})
        if (other != part && other->isChecked()) {
            other->setChecked(false);
            QTimer::singleShot(0, this, [this, part] { makeRoomFor(part); });
            return;
        }
}

} // namespace smat::gui
