#include "gui/view/StatePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/image/ImageExport.h"
#include "gui/view/SceneLoader.h"
#include "gui/view/SceneView.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

StatePage::StatePage(Workbench& workbench, SceneView& live, const QString& name, QWidget* parent)
    : QWidget(parent), live_(live), name_(name), project_(workbench.editedProject()) {
    setObjectName("statePage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    layOut();
    // A file may be saved over in the meantime.
    SceneBuilder::DatabaseOverrides databases;
    for (const DisplayModel& model : live.scene().models)
        if (model.signature)
            databases[model.database] = model.signature;

    loader_ = new SceneLoader(workbench.models(), this);
    connect(loader_, &SceneLoader::loaded, this,
            [this, databases](const std::shared_ptr<DisplayScene>& scene) {
                problem_->hide();
                view_->setScene(std::move(*scene));
                takeState(databases);
            });
    connect(loader_, &SceneLoader::failed, this,
            [this](const QStringList& sentences) { problem_->setText(sentences.join('\n')); });
    connect(link_, &QToolButton::toggled, this, &StatePage::followLive);
    connect(&live.navigation(), &ViewNavigation::moved, this, &StatePage::followLive);
    connect(&workbench, &Workbench::settingsChanged, this, &StatePage::followLive,
            Qt::QueuedConnection);
    connect(&live, &SceneView::displayChanged, this, &StatePage::followColors);
    connect(&live, &SceneView::pictureShown, this, &StatePage::followColors);
    connect(&view_->navigation(), &ViewNavigation::moved, this, [this] {
        if (!isLinked() || isFollowing_)
            return;
        isFollowing_ = true;
        live_.navigation().take(view_->cameras());
        isFollowing_ = false;
    });
    loader_->load(project_, project_.settings);
}

void StatePage::layOut() {
    auto* strip = new QHBoxLayout;
    strip->setContentsMargins(8, 5, 8, 5);
    auto* title = new QLabel(name_, this);
    title->setToolTip(tr("The project as it was then; what is edited now does not change it"));
    title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    link_ = textButton(tr("Link cameras"), "linkCameras",
                       tr("This view and that of the project turn together, in the same colours"));
    link_->setCheckable(true);
    link_->setChecked(true);
    strip->addWidget(title, 1);
    strip->addWidget(link_);
    view_ = new SceneView(this);
    problem_ = new QLabel(tr("Reading the model…"), this);
    problem_->setObjectName("stateProblem");
    problem_->setMargin(8);
    problem_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(strip);
    column->addWidget(problem_);
    column->addWidget(view_, 1);
}

bool StatePage::isLinked() const {
    return link_->isChecked();
}

bool StatePage::isLoading() const {
    return loader_->isBusy();
}

void StatePage::takeState(SceneBuilder::DatabaseOverrides databases) {
    view_->setProject(project_, project_.settings);
    for (auto& [file, database] : databases)
        view_->setEditedDatabase(file, std::move(database));
    followLive();
}

void StatePage::followLive() {
    if (!isLinked() || isFollowing_ || isLoading())
        return;
    isFollowing_ = true;
    view_->navigation().take(live_.cameras());
    isFollowing_ = false;
    followColors();
}

void StatePage::followColors() {
    if (!isLinked() || isLoading())
        return;
    view_->setDisplay(live_.display());
    InfraredPictures& own = view_->infrared();
    const InfraredPictures& shown = live_.infrared();
    own.setQuantity(shown.quantity());
    if (&own.colorMap() != &shown.colorMap())
        own.setColorMap(shown.colorMap().name());
    const InfraredPicture* picture = live_.shownPicture();
    if (picture == nullptr || picture->coarse)
        return;
    ColorRule rule = shown.colorRule();
    rule.mode = LimitMode::locked;
    if (own.colorRule() != rule)
        own.setColorRule(rule);
    if (own.lockedLimits() != picture->limits)
        own.setLimits(picture->limits);
}

QStringList StatePage::exportFilters() const {
    return {tr("Picture (*.png)")};
}

void StatePage::exportTo(const std::filesystem::path& file) const {
    writePicture(view_->grab().toImage(), file);
}

} // namespace smat::gui

#include "moc_StatePage.cpp"
