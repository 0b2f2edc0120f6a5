#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include "gui/image/ColorRule.h"
#include "gui/view/DisplayScene.h"
#include "gui/view/InfraredRequest.h"
#include "gui/view/ModelFaces.h"
#include "gui/view/ViewCameras.h"
#include "gui/view/ViewProjection.h"

namespace smat::gui {

class InfraredDisplay;
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
    void setTargetPose(const irsg::Pose& pose);
    /// That of the sensor.
    void setCamera(const OrbitCamera& camera, double targetYaw_rad);
    /// The one that is looked through.
    const OrbitCamera& camera() const { return cameras_.camera(); }
    const ViewCameras& cameras() const { return cameras_; }
    void showCamera(ViewCamera camera);
    /// Of the inspection camera: the whole model, or a side of it.
    void fit();
    void lookAt(ViewSide side);
    /// The picture of the other camera in a corner, in visible colours.
    void setInsetVisible(bool on);
    /// Where it is, in the widget; null where there is none.
    QRectF insetRect() const;
    void setFrame(const ViewFrame& frame);
    /// A database that is being edited stands in for a file, by its resolved path; null for the
    /// file again. Drawn at once.
    void setEditedDatabase(const std::filesystem::path& file,
                           std::shared_ptr<const irsg::SignatureDatabase> database);

    void setDisplay(ViewDisplay display);
    ViewDisplay display() const { return display_; }
    void setQuantity(InfraredQuantity quantity);
    InfraredQuantity quantity() const { return quantity_; }
    /// Throws irsg::InputError for a map that does not exist.
    void setColorMap(const std::string& name);
    const irsg::ColorMap& colorMap() const { return *map_; }
    /// What comes to be locked stays as it is seen.
    void setColorRule(const ColorRule& rule);
    const ColorRule& colorRule() const { return rule_; }
    /// Locks limits at these.
    void setLimits(const irsg::DisplayLimits& limits);
    /// Those of the project, with the camera that is looked through.
    Settings shownSettings() const;
    /// The infrared picture that is seen; null where there is none.
    const InfraredPicture* shownPicture() const;

    /// Every question about the infrared is answered, with a picture or with why there is none.
    bool isUpToDate() const;

    void setWireframe(bool on);
    void setViewAxesVisible(bool on);
    void setModelAxesVisible(bool on);
    void setSunVectorVisible(bool on);
    /// Tints and outlines faces, in either display; an empty selection none.
    void setHighlighted(const FaceSelection& selection);
    const FaceSelection& highlighted() const { return look_.selection; }

    /// Moves the sensor to where the whole model is seen.
    void showWholeModel();
    /// Of what is seen: in the infrared the camera of the picture.
    ViewProjection projection() const;
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
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void releaseGl();
    void aim();
    void sensorMoved();
    void inspected();
    void tellCamera();
    OrbitCamera& moved(bool sensor);
    void tellMoved(bool sensor);
    double narrowFieldOfView_rad() const;
    void aimInset();
    void redraw();
    /// Paints what is written over the picture where it differs.
    void refreshHud();
    /// Something that is seen has changed.
    void sceneChanged();
    void arrange();
    void pick(const QPointF& point);
    void hover(const std::optional<QPointF>& point);
    ViewHud hud() const;
    irsg::Viewpoint eye() const;
    double fieldOfView_rad() const;
    QString indexWords(const FaceHit& hit) const;

    bool showsPicture() const;
    void askInfrared();
    void sendRequest(bool coarse);
    void onDrawn(const InfraredPicture& picture);
    void onFailed(const QStringList& sentences, bool ourFault);
    void onWaiting();
    void dropPicture();

    struct Impl;
    std::unique_ptr<Impl> impl_;
    ViewCameras cameras_;
    ViewCamera toldCamera_ = ViewCamera::sensor; ///< as the last displayChanged had it
    double targetYaw_rad_ = 0.0;
    ViewFrame frame_;
    irsg::Vec3 towardsSun_{0, 0, 1};
    bool viewAxes_ = true, modelAxes_ = false, sunVector_ = false, inset_ = true;
    struct Look {
        FaceSelection selection;
        bool wireframe = false;
    } look_;

    ViewDisplay display_ = ViewDisplay::visible;
    InfraredQuantity quantity_ = InfraredQuantity::radiance;
    const irsg::ColorMap* map_ = nullptr;
    bool projectMap_ = false; ///< that of the project's settings was taken
    ColorRule rule_;
    irsg::DisplayLimits lockedLimits_;
    std::shared_ptr<const Project> project_;
    Settings settings_;
    SceneBuilder::DatabaseOverrides edited_;
    InfraredDisplay* infrared_ = nullptr;
    InfraredPicture picture_;
    QStringList problem_;
    long revision_ = 0, droppedAt_ = 0;
    int coarseness_ = 2; ///< pixels of the view to one of a picture that moves
    QElapsedTimer lastChange_;
    QTimer rest_, waiting_;

    std::optional<QPointF> pressAt_, dragFrom_, hoverAt_;
    bool dragsSensor_ = false, dragPans_ = false;
    struct LastPick {
        QPointF at;
        std::size_t number = 0;
        OrbitCamera camera;
    };
    std::optional<LastPick> lastPick_;
    QString readout_;
    QString renderer_;
    long frameCount_ = 0;
    QWidget* hud_ = nullptr;
};

} // namespace smat::gui
