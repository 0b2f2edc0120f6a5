#include "gui/view/ProjectView.h"

#include <algorithm>
#include <cmath>

#include <QEvent>

#include "gui/view/BandBox.h"
#include "gui/view/LoadingBar.h"
#include "gui/view/ModelPage.h"
#include "gui/view/PlaceMouse.h"
#include "gui/view/SceneLoader.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/ModelFields.h"

namespace smat::gui {

ProjectView::ProjectView(Workbench& workbench, Dialogs& dialogs, LoadingBar& loading,
                         QWidget* pages)
    : QObject(pages),
      workbench_(workbench),
      dialogs_(dialogs),
      page_(new ModelPage(pages)),
      loader_(new SceneLoader(workbench.models(), this)) {
    view()->installEventFilter(this);
    auto* band = new BandBox(workbench_, page_);
    page_->addField(band);
    connect(band, &BandBox::refused, this, [this](const QStringList& sentences) {
        dialogs_.tell(page_->window(), tr("This is not a band"), sentences);
    });
    connect(view(), &SceneView::cameraMoved, this, [this](const OrbitCamera& camera) {
        if (workbench_.hasProject())
            workbench_.setCamera(camera);
    });
    loading.follow(*loader_);
    connectLoader();
    connectHandles();
}

void ProjectView::connectLoader() {
    connect(loader_, &SceneLoader::cancelled, this, [this](const QString& names) {
        emit said(tr("%1 was not read; open the project again to see it").arg(names), 0);
    });
    connect(loader_, &SceneLoader::loaded, this,
            [this](const std::shared_ptr<DisplayScene>& scene) {
                for (const auto& remark : scene->remarks)
                    emit remarked(remark);
                view()->setScene(std::move(*scene));
                // Places may have changed in the meantime.
                view()->placeModels(workbench_.project(), workbench_.settings());
                emit shown();
            });
    connect(loader_, &SceneLoader::failed, this, [this](const QStringList& sentences) {
        dialogs_.tell(page_->window(), tr("The model cannot be shown"), sentences);
    });
}

SceneView* ProjectView::view() const {
    return page_->view();
}

void ProjectView::followTitle() {
    const Project& project = workbench_.project();
    page_->setTitle(
        QString::fromStdString(project.title.empty() ? project.displayName() : project.title));
}

void ProjectView::showModels() {
    view()->setScene({});
    shown_ = workbench_.project().models;
    loader_->load(workbench_.project(), workbench_.settings());
}

void ProjectView::followModels() {
    const auto& models = workbench_.project().models;
    if (models == shown_)
        return;
    // Where they stand and what they do is no reason to read them again.
    const bool areRead = std::ranges::equal(models, shown_, [](ProjectModel a, ProjectModel b) {
        a.pose = b.pose;
        a.own = b.own;
        return a == b;
    });
    if (areRead)
        shown_ = models;
    else
        showModels();
    followSettings();
}

void ProjectView::followHandles() {
    const std::size_t count = workbench_.project().models.size();
    if ((count > 1) != (placeable_ > 1))
        page_->showHandles(count > 1);
    placeable_ = count;
    view()->setChosenModel(workbench_.chosenModel());
}

void ProjectView::connectHandles() {
    PlaceMouse& mouse = view()->placeMouse();
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        placeable_ = 1;
        page_->showHandles(false);
        followHandles();
    });
    connect(&workbench_, &Workbench::projectChanged, this, &ProjectView::followHandles);
    connect(&workbench_, &Workbench::modelChosen, this, &ProjectView::followHandles);
    connect(view(), &SceneView::facePicked, this, [this](int, int, int model, const irsg::Vec3&) {
        workbench_.chooseModel(static_cast<std::size_t>(model));
    });
    connect(&mouse, &PlaceMouse::begun, this, [this](PlaceHandle handle) {
        workbench_.holdStep();
        const std::string text = textOf(workbench_.editedProject(), workbench_.chosenModel(),
                                        *findModelField(keyOf(handle)));
        begunAt_ = QString::fromStdString(text).toDouble();
    });
    connect(&mouse, &PlaceMouse::dragged, this, &ProjectView::drag);
    connect(&mouse, &PlaceMouse::ended, this, [this] { workbench_.closeStep(); });
}

void ProjectView::drag(PlaceHandle handle, double change) {
    const std::size_t model = workbench_.chosenModel();
    const ModelField& field = *findModelField(keyOf(handle));
    double value = begunAt_ + change;
    // To what a pixel can tell; angles to a tenth of a degree, within a turn.
    const ViewProjection through = view()->projection();
    const double pixel_m =
        std::max(through.depth_m(view()->handles().pose.position_m), 1e-6) / through.focalLength_px;
    const double step =
        PlaceHandles::isRing(handle)
            ? 0.1
            : std::clamp(std::pow(10.0, std::floor(std::log10(pixel_m))), 1e-3, 1.0);
    value = std::round(value / step) * step;
    if (handle == PlaceHandle::heading)
        value = std::remainder(value, 360.0);
    if (handle == PlaceHandle::roll)
        value = std::remainder(value, 360.0);
    value = std::clamp(value, field.info.minimum, field.info.maximum);
    try {
        workbench_.setFields(
            model, {{&field, QString::number(value, 'g', 10).toStdString()}},
            tr(PlaceHandles::isRing(handle) ? "Turn %1" : "Move %1")
                .arg(QString::fromStdString(workbench_.project().models.at(model).shownName())));
    } catch (const irsg::InputError&) {
        // Beyond what can be: it stays where it was.
    }
}

void ProjectView::followSettings() {
    view()->setProject(workbench_.project(), workbench_.settings());
}

bool ProjectView::isLoading() const {
    return loader_->isBusy();
}

bool ProjectView::eventFilter(QObject* watched, QEvent* event) {
    // Turning the model by the mouse is one step to undo.
    if (event->type() == QEvent::MouseButtonPress)
        workbench_.holdStep();
    if (event->type() == QEvent::MouseButtonRelease)
        workbench_.closeStep();
    return QObject::eventFilter(watched, event);
}

} // namespace smat::gui

#include "moc_ProjectView.cpp"
