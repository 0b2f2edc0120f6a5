#include <QCheckBox>
#include <QComboBox>
#include <QFocusEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/FlowBar.h"
#include "gui/Theme.h"
#include "gui/Widgets.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/HistogramPlot.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ThresholdForm.h"

namespace smat::gui {
void ComparisonWindow::build() {
    setObjectName("comparisonWindow");
    setAcceptDrops(true);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window); // so that its fields stand out in the dark, too
    panes_ = new ComparisonPanes(this);
    panes_->setCompanion(makePanel());
    readout_ = new QLabel(this);
    readout_->setObjectName("comparisonReadout");
    readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(6);
    column->addWidget(makeBar());
    column->addWidget(panes_, 1);
    column->addWidget(readout_);
    for (int i = 0; i < 3; ++i)
        panes_->canvas(i)->installEventFilter(this);
    connectParts();
}

void ComparisonWindow::focusInEvent(QFocusEvent* event) {
    // No proxy: Tab would jump over all that stands before it.
    panes_->canvas(0)->setFocus(event->reason());
}

QWidget* ComparisonWindow::makeBar() {
    auto* openA = textButton(tr("Open A…"), "openA", tr("Open image A, or drop it on A"));
    auto* openB = textButton(tr("Open B…"), "openB", tr("Open image B, or drop it on B"));
    for (QToolButton* button : {openA, openB}) {
        button->setIcon(icon("open"));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    swap_ = textButton(tr("A ⇄ B"), "swapSides", tr("Exchange A and B (S)"));
    plane_ = new QComboBox;
    plane_->setObjectName("comparedPlane");
    plane_->setToolTip(tr("What is compared"));
    plane_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    colors_ = new QComboBox;
    colors_->setObjectName("comparisonColorMap");
    colors_->setToolTip(tr("Colours of A and B (M)"));
    colors_->setIconSize(QSize(40, 14));
    for (const auto& name : irsg::ColorMap::names())
        if (!irsg::ColorMap::named(name).isDiverging())
            colors_->addItem(swatchOf(irsg::ColorMap::named(name)), QString::fromStdString(name));
    modeBox_ = new QComboBox;
    modeBox_->setObjectName("differenceMode");
    modeBox_->setToolTip(tr("What the difference shows (1 to 4)"));
    for (const auto mode : irsg::allDifferenceModes)
        modeBox_->addItem(differenceName(mode));
    mark_ = new QCheckBox(tr("Mark"));
    mark_->setObjectName("markPixels");
    mark_->setToolTip(tr("Colour the pixels over the thresholds in the difference (X): orange over "
                         "the warning, pink over the failure threshold"));
    worst_ = textButton(tr("Worst pixel"), "worstPixel",
                        tr("Go to the pixel with the largest |A − B| (W)"));
    copy_ = menuButton(tr("Copy"), "copyComparison", tr("Copy to other programs"));
    copy_->menu()->addAction(tr("Numbers"), this, [this] { numbers_->copy(); });
    copy_->menu()->addAction(tr("Picture of the difference"), this, &ComparisonWindow::copyPicture);
    copyCommandAction_ =
        copy_->menu()->addAction(tr("Command line"), this, &ComparisonWindow::copyCommand);
    copyCommandAction_->setObjectName("copyCommandLine");
    export_ = menuButton(tr("Export"), "exportComparison", tr("Write the difference to a file"));
    for (const QString& filter : imageFilters())
        export_->menu()->addAction(filter, this, [this, filter] { askAndExport(filter); });
    auto* fit = textButton(tr("Fit"), "fitComparison", tr("Show the whole images (F)"));
    auto* actual = textButton(tr("1:1"), "actualSizeComparison",
                              tr("One pixel of the images is one of the screen (A)"));
    connect(openA, &QToolButton::clicked, this, [this] { askForFile(0); });
    connect(openB, &QToolButton::clicked, this, [this] { askForFile(1); });
    connect(fit, &QToolButton::clicked, panes_, &ComparisonPanes::fit);
    connect(actual, &QToolButton::clicked, panes_, &ComparisonPanes::showActualSize);

    for (QComboBox* box : {plane_, colors_, modeBox_})
        box->setMinimumWidth(80); // long names give way where the page is narrow
    auto* bar = new FlowBar(this);
    for (QWidget* widget : {static_cast<QWidget*>(openA), static_cast<QWidget*>(openB),
                            static_cast<QWidget*>(swap_), static_cast<QWidget*>(plane_),
                            static_cast<QWidget*>(colors_), static_cast<QWidget*>(modeBox_)})
        bar->first()->addWidget(widget);
    for (QWidget* widget :
         {panes_->wipeControl(), static_cast<QWidget*>(mark_), static_cast<QWidget*>(worst_),
          static_cast<QWidget*>(copy_), static_cast<QWidget*>(export_), static_cast<QWidget*>(fit),
          static_cast<QWidget*>(actual)})
        bar->second()->addWidget(widget);
    return bar;
}

QWidget* ComparisonWindow::makePanel() {
    verdict_ = new QLabel(this);
    verdict_->setObjectName("verdict");
    verdict_->setAlignment(Qt::AlignCenter);
    sentence_ = new QLabel(this);
    sentence_->setObjectName("verdictSentence");
    sentence_->setWordWrap(true);
    sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    numbers_ = new FiguresTable(this);
    numbers_->setObjectName("comparisonNumbers");
    thresholds_ = new ThresholdForm(this);
    inspector_ = new ImageInspector(this);
    inspector_->setTableBelow(true);
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("comparisonTabs");
    tabs_->setDocumentMode(true);
    tabs_->setStyleSheet("QTabBar::tab { padding: 7px 8px; }"); // beside narrow images, too
    tabs_->addTab(numbers_, tr("Numbers"));
    auto* judged = new QWidget(this);
    auto* below = new QVBoxLayout(judged);
    below->setContentsMargins(0, 0, 0, 0);
    below->setSpacing(0);
    below->addWidget(thresholds_, 1);
    below->addWidget(makeCommandPart());
    // Where the page is low it scrolls, and fields keep their height.
    auto* scroll = new QScrollArea(this);
    scroll->setObjectName("thresholdsScroll");
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidgetResizable(true);
    scroll->setWidget(judged);
    scroll->viewport()->setAutoFillBackground(false);
    judged->setAutoFillBackground(false);
    tabs_->addTab(scroll, tr("Thresholds"));
    tabs_->addTab(inspector_, tr("Histogram"));

    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(verdict_, 0, Qt::AlignTop);
    row->addWidget(sentence_, 1);
    column->addLayout(row);
    column->addWidget(tabs_, 1);
    return panel;
}

QWidget* ComparisonWindow::makeCommandPart() {
    commandPart_ = new QWidget(this);
    commandWords_ = new QLabel(commandPart_);
    commandWords_->setObjectName("commandWords");
    commandWords_->setWordWrap(true);
    commandWords_->setForegroundRole(QPalette::PlaceholderText);
    command_ = new QLineEdit(commandPart_);
    command_->setObjectName("commandLine");
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    copyCommand_ = textButton(tr("Copy"), "copyCommand", tr("Copy the command line"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(command_, 1);
    row->addWidget(copyCommand_);
    auto* column = new QVBoxLayout(commandPart_);
    column->setContentsMargins(8, 0, 8, 8);
    column->setSpacing(4);
    column->addWidget(commandWords_);
    column->addLayout(row);
    connect(copyCommand_, &QToolButton::clicked, this, &ComparisonWindow::copyCommand);
    return commandPart_;
}

void ComparisonWindow::connectParts() {
    connect(swap_, &QToolButton::clicked, this, &ComparisonWindow::swapSides);
    connect(worst_, &QToolButton::clicked, this, &ComparisonWindow::goToWorstPixel);
    connect(plane_, &QComboBox::activated, this, &ComparisonWindow::showPlanes);
    connect(colors_, &QComboBox::currentTextChanged, this,
            [this](const QString& name) { panes_->setColorMap(name.toStdString()); });
    connect(modeBox_, &QComboBox::activated, this,
            [this](int index) { setDifferenceMode(irsg::allDifferenceModes[index]); });
    connect(mark_, &QCheckBox::toggled, this, &ComparisonWindow::showMarks);
    connect(thresholds_, &ThresholdForm::changed, this, [this] {
        options_.fail = thresholds_->fail();
        options_.warn = thresholds_->warn();
        compare();
    });
    connect(panes_, &ComparisonPanes::hovered, this, &ComparisonWindow::showReadout);
    connect(panes_, &ComparisonPanes::selectionChanged, this, [this] {
        inspector_->setRectangle(panes_->selection());
        compareRectangle();
    });
    connect(panes_, &ComparisonPanes::differenceLimitsFound, inspector_,
            &ImageInspector::setLimits);
}

QList<std::pair<QString, QString>> comparisonKeys() {
    return {{ComparisonWindow::tr("Space, held"), ComparisonWindow::tr("B in the place of A")},
            {ComparisonWindow::tr("V"), ComparisonWindow::tr("Wipe between A and B")},
            {ComparisonWindow::tr("1 … 4"),
             ComparisonWindow::tr("Signed, absolute, relative difference, ratio")},
            {ComparisonWindow::tr("W"), ComparisonWindow::tr("Go to the worst pixel")},
            {ComparisonWindow::tr("X"), ComparisonWindow::tr("Mark pixels over the thresholds")},
            {ComparisonWindow::tr("S"), ComparisonWindow::tr("Exchange A and B")},
            {ComparisonWindow::tr("H, T"), ComparisonWindow::tr("Histogram, thresholds")}};
}

} // namespace smat::gui
