#include "gui/image/ComparisonBar.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include "gui/image/ImageExport.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "irsg/image/ColorMap.h"

namespace smat::gui {

ComparisonBar::ComparisonBar(QWidget* wipe, QWidget* parent) : FlowBar(parent) {
    auto* openA = textButton(tr("Open A…"), "openA", tr("Open image A, or drop it on A"));
    auto* openB = textButton(tr("Open B…"), "openB", tr("Open image B, or drop it on B"));
    for (QToolButton* button : {openA, openB}) {
        button->setIcon(icon("open"));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    auto* fit = textButton(tr("Fit"), "fitComparison", tr("Show the whole images (F)"));
    auto* actual = textButton(tr("1:1"), "actualSizeComparison",
                              tr("One pixel of the images is one of the screen (A)"));
    connect(openA, &QToolButton::clicked, this, [this] { emit openWanted(0); });
    connect(openB, &QToolButton::clicked, this, [this] { emit openWanted(1); });
    connect(fit, &QToolButton::clicked, this, &ComparisonBar::fitWanted);
    connect(actual, &QToolButton::clicked, this, &ComparisonBar::actualSizeWanted);
    makeBoxes();
    makeButtons();
    for (QWidget* widget : {static_cast<QWidget*>(openA), static_cast<QWidget*>(openB),
                            static_cast<QWidget*>(swap_), static_cast<QWidget*>(plane_),
                            static_cast<QWidget*>(colors_), static_cast<QWidget*>(mode_)})
        first()->addWidget(widget);
    for (QWidget* widget : {wipe, static_cast<QWidget*>(mark_), static_cast<QWidget*>(worst_),
                            static_cast<QWidget*>(copy_), static_cast<QWidget*>(export_),
                            static_cast<QWidget*>(fit), static_cast<QWidget*>(actual)})
        second()->addWidget(widget);
}

void ComparisonBar::makeBoxes() {
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
    mode_ = new QComboBox;
    mode_->setObjectName("differenceMode");
    mode_->setToolTip(tr("What the difference shows (1 to 4)"));
    for (const auto mode : irsg::allDifferenceModes)
        mode_->addItem(differenceName(mode));
    for (QComboBox* box : {plane_, colors_, mode_})
        box->setMinimumWidth(80); // long names give way where the page is narrow
    connect(plane_, &QComboBox::activated, this, &ComparisonBar::planeChosen);
    connect(colors_, &QComboBox::currentTextChanged, this,
            [this](const QString& name) { emit colorsChosen(name.toStdString()); });
    connect(mode_, &QComboBox::activated, this,
            [this](int index) { emit modeChosen(irsg::allDifferenceModes[index]); });
}

void ComparisonBar::makeButtons() {
    swap_ = textButton(tr("A ⇄ B"), "swapSides", tr("Exchange A and B (S)"));
    mark_ = new QCheckBox(tr("Mark"));
    mark_->setObjectName("markPixels");
    mark_->setToolTip(tr("Colour the pixels over the thresholds in the difference (X): orange over "
                         "the warning, pink over the failure threshold"));
    worst_ = textButton(tr("Worst pixel"), "worstPixel",
                        tr("Go to the pixel with the largest |A − B| (W)"));
    copy_ = menuButton(tr("Copy"), "copyComparison", tr("Copy to other programs"));
    copy_->menu()->addAction(tr("Numbers"), this, &ComparisonBar::numbersWanted);
    copy_->menu()->addAction(tr("Picture of the difference"), this, &ComparisonBar::pictureWanted);
    copyCommand_ =
        copy_->menu()->addAction(tr("Command line"), this, &ComparisonBar::commandWanted);
    copyCommand_->setObjectName("copyCommandLine");
    export_ = menuButton(tr("Export"), "exportComparison", tr("Write the difference to a file"));
    for (const QString& filter : imageFilters())
        export_->menu()->addAction(filter, this, [this, filter] { emit exportWanted(filter); });
    connect(swap_, &QToolButton::clicked, this, &ComparisonBar::swapWanted);
    connect(mark_, &QCheckBox::toggled, this, &ComparisonBar::marksToggled);
    connect(worst_, &QToolButton::clicked, this, &ComparisonBar::worstWanted);
}

void ComparisonBar::offerPlanes(const ComparedPair& pair) {
    const QString before = plane();
    plane_->clear();
    for (const auto& [title, name] : pair.planeChoices())
        plane_->addItem(title, QString::fromStdString(name));
    if (plane_->count() > 0)
        plane_->setCurrentIndex(std::max(plane_->findData(before), 0));
}

QString ComparisonBar::plane() const {
    return plane_->currentData().toString();
}

void ComparisonBar::setMode(irsg::DifferenceMode mode) {
    mode_->setCurrentIndex(static_cast<int>(mode));
}

bool ComparisonBar::isMarking() const {
    return mark_->isChecked();
}

void ComparisonBar::toggleMarks() {
    mark_->toggle();
}

void ComparisonBar::changeColors(bool back) {
    const int step = back ? colors_->count() - 1 : 1;
    colors_->setCurrentIndex((colors_->currentIndex() + step) % colors_->count());
}

void ComparisonBar::refresh(const ComparedPair& pair) {
    for (QWidget* widget : {static_cast<QWidget*>(worst_), static_cast<QWidget*>(copy_),
                            static_cast<QWidget*>(export_), static_cast<QWidget*>(mark_)})
        widget->setEnabled(pair.whole().has_value());
    swap_->setEnabled(pair.hasAny());
    mode_->setEnabled(pair.difference() != nullptr);
    plane_->setEnabled(plane_->count() > 1);
}

void ComparisonBar::setHasCommand(bool has) {
    copyCommand_->setEnabled(has);
}

} // namespace smat::gui

#include "moc_ComparisonBar.cpp"
