#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QOpenGLWidget>

#include "gui/view/FaceOverlay.h"
#include "gui/view/FacePicker.h"
#include "gui/view/InfraredPictures.h"
#include "gui/view/ViewNavigation.h"
#include "gui/view/ViewSubject.h"

namespace smat::gui {

class PlaceMouse;
class SceneDrawing;
class SensorFrusta;
class ViewOverlay;
struct ViewHud;

enum class ViewDisplay { visible, infrared };

/// OpenSceneGraph in a Qt window: shows a model, in its visible colours or in the infrared. Draws
/// when asked and not otherwise. It looks through the sensor of the project, whose picture is
/// framed, or through an inspection camera that changes nothing: whoever takes the mouse looks
/// around. The left button turns, the right one or Shift shifts, the wheel comes nearer, a double
/// click shows the whole model, a click picks a face; with Ctrl it is the sensor that moves. The
/// picture of the other camera is seen in a corner, where a click changes to it. The infrared
/// picture is drawn by the infrared renderer in a thread of its own, coarser while something moves;
/// what it cannot be made of is told over the view.
class SceneView : public QOpenGLWidget {
    Q_OBJECT

  public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Why this desktop cannot give a 3-D view; empty where it can.
    static QString problem();

    void setScene(DisplayScene scene);
    /// Pose, camera, frame, sun and all that the infrared picture depends on. The geometry stays
    /// that of setScene.
    void setProject(const Project& project, const Settings& settings);
    void placeModels(const Project& project, const Settings& settings);
    /// The model that is meant where one of them is.
    void setChosenModel(std::size_t model);
    /// Whether that one has handles to place it by.
    void setHandlesVisible(bool on);
    bool hasHandles() const { return handles_ && subject_.hasModels(); }
    /// The handles as they are drawn; LogicError of the standard library without models.
    PlaceHandles handles() const;
    PlaceMouse& placeMouse() { return *placing_; }
    /// A database that is being edited stands in for a file, by its resolved path; null for the
    /// file again. Drawn at once.
    void setEditedDatabase(const std::filesystem::path& file,
                           std::shared_ptr<const irsg::SignatureDatabase> database);

    void setDisplay(ViewDisplay display);
    ViewDisplay display() const;
    /// Quantity and colours of the infrared display.
    InfraredPictures& infrared() { return *infrared_; }
    const InfraredPictures& infrared() const { return *infrared_; }
    /// The infrared picture that is seen; null where there is none.
    const InfraredPicture* shownPicture() const { return infrared_->shown(); }
    /// Every question about the infrared is answered, with a picture or with why there is none.
    bool isUpToDate() const { return infrared_->isUpToDate(); }

    /// What moves the cameras.
    ViewNavigation& navigation() { return *navigation_; }
    const ViewCameras& cameras() const { return navigation_->cameras(); }
    /// Moves the sensor to where the whole target is seen, or all models.
    void showWholeModel() { navigation_->showWholeModel(); }
    void showWholeScene() { navigation_->showWholeScene(); }
    /// The one that is looked through.
    const OrbitCamera& camera() const { return cameras().camera(); }
    /// Settings of the project, with the camera that is looked through.
    Settings shownSettings() const { return subject_.settingsWith(camera()); }
    /// Of what is seen: in the infrared the camera of the picture.
    ViewProjection projection() const;
    /// The picture of the other camera in a corner, in visible colours.
    void setInsetVisible(bool on);
    /// Where it is, in the widget; null where there is none.
    QRectF insetRect() const;

    void setWireframe(bool on);
    /// The frusta of the sensor's zoom windows, in either display.
    SensorFrusta& frusta() { return *frusta_; }
    /// Axes, sun vector and words over the picture.
    ViewOverlay& overlay() { return *overlay_; }
    /// Tints and outlines faces, in either display; an empty selection none.
    void setHighlighted(const FaceSelection& selection);
    const FaceSelection& highlighted() const { return selection_; }
    /// Tints and outlines single faces; another scene has none.
    void setChosen(const ChosenFaces& faces);
    /// Shows codes in place of the file's colours in the visible display; null for these.
    void setCodeColors(std::shared_ptr<const CodeColors> codes);
    /// Takes clicks before faces are picked by them; true where it was for it.
    using ClickHandler = std::function<bool(const QPointF&, Qt::KeyboardModifiers)>;
    void setClickHandler(ClickHandler handler) { clickHandler_ = std::move(handler); }
    /// The models as they are shown.
    const DisplayScene& scene() const { return subject_.scene(); }
    /// See DisplayScene::setModel; the infrared picture follows.
    void setModel(const ModelKey& key, std::shared_ptr<const irsg::Model> model,
                  const std::shared_ptr<const ModelFaces>& faces);
    /// What stands under a point of the widget, nearest first.
    std::vector<FaceHit> facesAt(const QPointF& point) const;
    /// "Radiance 1.234 W·m⁻²·sr⁻¹   temperature 3 (wing)   material 2 (grey paint)".
    QString readoutAt(const QPointF& point) const;

    /// GL renderer of this view; empty before its first frame.
    QString renderer() const { return renderer_; }
    /// Frames drawn so far.
    long frameCount() const { return frameCount_; }

  signals:
    /// The user moved the sensor.
    void cameraMoved(const OrbitCamera& camera);
    /// A click on a face; at the same place again, the face behind it.
    void facePicked(int temperatureIndex, int materialIndex, int model, const irsg::Vec3& point_m);
    /// A click beside the model.
    void nothingPicked();
    void displayChanged();
    /// A new infrared picture is seen, or none any more.
    void pictureShown();
    /// Why there is no infrared picture, as written over the view.
    void pictureFailed(const QStringList& sentences);

  protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void follow();
    void arrange();
    void redraw();
    /// Something that is seen has changed.
    void sceneChanged();
    void click(const QPointF& point, Qt::KeyboardModifiers modifiers);
    void pick(const QPointF& point);
    void refreshReadout();
    ViewHud hud() const;
    std::optional<InfraredRequest> infraredRequest() const;
    std::optional<InfraredRequest> sensorRequest() const;
    double fieldOfView_rad() const { return fieldOfViewOf(subject_.frame(), size()); }

    std::unique_ptr<SceneDrawing> drawing_;
    ViewSubject subject_;
    ViewNavigation* navigation_ = nullptr;
    InfraredPictures* infrared_ = nullptr;
    SensorFrusta* frusta_ = nullptr;
    ViewOverlay* overlay_ = nullptr;
    FacePicker picker_;
    PlaceMouse* placing_ = nullptr;
    bool inset_ = true, wireframe_ = false, handles_ = false;
    FaceSelection selection_;
    ChosenFaces chosen_;
    std::shared_ptr<const CodeColors> codes_;
    long facesRevision_ = 0;
    ClickHandler clickHandler_;
    QMetaObject::Connection contextGoes_;
    QString renderer_;
    long frameCount_ = 0;
};

} // namespace smat::gui
