#include "gui/view/ProjectView.h"

#include <QEvent>

#include "gui/Workbench.h"
#include "gui/view/BandBox.h"
#include "gui/view/LoadingBar.h"
#include "gui/view/ModelPage.h"
#include "gui/view/SceneLoader.h"

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
        dialogs_.tell(page_->window(), tr("This is no band"), sentences);
    });
    connect(view(), &SceneView::cameraMoved, this, [this](const OrbitCamera& camera) {
        if (workbench_.hasProject())
            workbench_.setCamera(camera);
    });
    loading.follow(*loader_);
    connectLoader();
}

void ProjectView::connectLoader() {
    connect(loader_, &SceneLoader::cancelled, this, [this](const QString& names) {
        emit said(tr("%1 was not read; open the project again to see it").arg(names), 0);
    });
    connect(loader_, &SceneLoader::loaded, this,
            [this](const std::shared_ptr<DisplayScene>& scene) {
                for (const auto& remark : scene->remarks)
                    emit said(remark, 8000);
                view()->setScene(std::move(*scene));
                // Settings may have changed in the meantime.
                view()->setTargetPose(targetPoseOf(workbench_.settings()));
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
    if (workbench_.project().models == shown_)
        return;
    showModels();
    followSettings();
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
