#include "gui/view/SceneView.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QOpenGLContext>

#include "gui/view/PlaceMouse.h"
#include "gui/view/SceneDrawing.h"
#include "gui/view/SensorFrusta.h"
#include "gui/view/ViewHud.h"
#include "gui/view/ViewLook.h"
#include "gui/view/ViewOverlay.h"
#include "gui/widgets/Theme.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

constexpr double insetPart = 0.3; ///< of the view's shorter way
constexpr double insetMargin_px = 14.0;

} // namespace

SceneView::SceneView(QWidget* parent)
    : QOpenGLWidget(parent), drawing_(std::make_unique<SceneDrawing>()) {
    setObjectName("sceneView");
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(280, 240);
    setMouseTracking(true);
    setFormat(SceneDrawing::surfaceFormat());
    navigation_ = new ViewNavigation(this, [this] {
        const DisplayScene& scene = subject_.scene();
        const auto fromTarget = [&](ViewBall ball) {
            ball.centre_m = ball.centre_m - scene.referencePoint_m;
            return ball;
        };
        return ViewNavigation::Surroundings{.projection = projection(),
                                            .frame = subject_.frame(),
                                            .radius_m = scene.radius_m,
                                            .reach_m = scene.reach_m(),
                                            .all = fromTarget(scene.ballOfAll()),
                                            .chosen = fromTarget(scene.ballOf(subject_.chosen())),
                                            .inset = insetRect()};
    });
    infrared_ = new InfraredPictures([this] { return infraredRequest(); }, this);
    frusta_ = new SensorFrusta([this] { return sensorRequest(); }, this);
    overlay_ = new ViewOverlay(this, [this] { return hud(); });
    overlay_->show();
    placing_ = new PlaceMouse(this, [this]() -> std::optional<PlaceMouse::Seen> {
        if (!hasHandles())
            return std::nullopt;
        return PlaceMouse::Seen{handles(), projection()};
    });
    follow();
}

SceneView::~SceneView() {
    // Nothing that still happens to the widget is for them.
    delete infrared_;
    delete frusta_;
    delete navigation_;
    disconnect(contextGoes_);
    if (context() != nullptr) {
        makeCurrent();
        drawing_->end(subject_.scene());
        doneCurrent();
    }
}

void SceneView::follow() {
    connect(navigation_, &ViewNavigation::moved, this, [this] {
        picker_.forget();
        arrange();
        sceneChanged();
    });
    connect(navigation_, &ViewNavigation::cameraChanged, this, &SceneView::displayChanged);
    connect(navigation_, &ViewNavigation::sensorMoved, this, &SceneView::cameraMoved);
    connect(navigation_, &ViewNavigation::clicked, this, &SceneView::click);
    connect(navigation_, &ViewNavigation::hovered, this, &SceneView::refreshReadout);
    connect(navigation_, &ViewNavigation::dismissed, this, [this] {
        setHighlighted({});
        emit nothingPicked();
    });

    connect(frusta_, &SensorFrusta::changed, this, &SceneView::redraw);
    connect(placing_, &PlaceMouse::litChanged, overlay_, &ViewOverlay::refresh);
    connect(infrared_, &InfraredPictures::lookChanged, this, &SceneView::displayChanged);
    connect(infrared_, &InfraredPictures::drawn, this, [this](const InfraredPicture& picture) {
        drawing_->setPicture(picture);
        arrange();
        refreshReadout();
        redraw();
        emit pictureShown();
    });
    connect(infrared_, &InfraredPictures::failed, this, [this](const QStringList& sentences) {
        arrange();
        redraw();
        emit pictureShown();
        emit pictureFailed(sentences);
    });
    // The visible display comes and goes with the patience for a picture.
    connect(infrared_, &InfraredPictures::waited, this, [this] {
        arrange();
        redraw();
    });
}

QString SceneView::problem() {
    QOpenGLContext context;
    if (!context.create())
        return tr("This desktop gives no OpenGL context, so the model cannot be shown in 3-D.\n"
                  "Analyses, images and plots work all the same.");
    return {};
}

void SceneView::initializeGL() {
    // Qt makes a new context when the widget moves to another window: start anew with it.
    drawing_->end(subject_.scene());
    drawing_->begin(size() * devicePixelRatio(), isDark(palette()));
    arrange();
    disconnect(contextGoes_);
    contextGoes_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        drawing_->end(subject_.scene());
        doneCurrent();
    });
    renderer_ = SceneDrawing::rendererOf(*context());
}

void SceneView::arrange() {
    drawing_->arrange(subject_.scene(),
                      {selection_, chosen_, codes_, facesRevision_, shownPicture() != nullptr,
                       wireframe_, devicePixelRatioF()},
                      !insetRect().isNull());
}

void SceneView::paintGL() {
    const double ratio = devicePixelRatioF();
    if (drawing_->resize(size() * devicePixelRatio()))
        arrange();
    if (const QRectF inner = insetRect(); !inner.isNull())
        drawing_->aimInset({subject_.viewpoint(*cameras().other()),
                            fieldOfViewOf(subject_.frame(), inner.size()),
                            inner.width() / inner.height()},
                           {inner.left() * ratio, (height() - inner.bottom()) * ratio,
                            inner.width() * ratio, inner.height() * ratio});
    // Framebuffer 0 is not this widget, and the one that is changes at every resize.
    drawing_->draw(defaultFramebufferObject(),
                   {projection().eye, fieldOfView_rad(),
                    static_cast<double>(width()) / std::max(height(), 1)});
    ++frameCount_;
}

ViewProjection SceneView::projection() const {
    const InfraredPicture* picture = shownPicture();
    return ViewProjection::of(picture != nullptr ? picture->eye : subject_.viewpoint(camera()),
                              size(), fieldOfView_rad());
}

void SceneView::setScene(DisplayScene scene) {
    if (context() != nullptr)
        makeCurrent();
    drawing_->forget(subject_.scene());
    placing_->drop();
    subject_.setScene(std::move(scene));
    selection_ = {};
    chosen_ = {};
    picker_.forget();
    infrared_->beginAnew();
    if (!subject_.hasModels())
        navigation_->forgetInspection();
    arrange();
    if (context() != nullptr)
        doneCurrent();
    sceneChanged();
}

void SceneView::setProject(const Project& project, const Settings& settings) {
    if (subject_.isOf(project, settings))
        return;
    infrared_->followColors(lookOf(project, settings));
    subject_.setProject(project, settings);
    navigation_->setSensor(
        {settings[key::cameraAzimuth], settings[key::cameraElevation], settings[key::cameraRange]});
    sceneChanged();
}

void SceneView::placeModels(const Project& project, const Settings& settings) {
    subject_.scene().place(project, settings);
    sceneChanged();
}

void SceneView::setChosenModel(std::size_t model) {
    subject_.setChosen(model);
    overlay_->refresh();
}

void SceneView::setHandlesVisible(bool on) {
    handles_ = on;
    if (!on)
        placing_->drop();
    overlay_->refresh();
}

PlaceHandles SceneView::handles() const {
    PlaceHandles handles = subject_.handles();
    const ViewProjection through = projection();
    // Neither a few pixels nor out of sight, however far the model is.
    const double metresPerPixel =
        std::max(through.depth_m(handles.pose.position_m), 1e-6) / through.focalLength_px;
    const double side = std::min(through.window.width(), through.window.height());
    handles.length_m = std::clamp(handles.length_m, 56.0 * metresPerPixel,
                                  std::max(56.0, 0.38 * side) * metresPerPixel);
    handles.lit = placing_->lit();
    if (handles.lit)
        handles.value = subject_.fieldWords(keyOf(*handles.lit));
    return handles;
}

void SceneView::setEditedDatabase(const std::filesystem::path& file,
                                  std::shared_ptr<const irsg::SignatureDatabase> database) {
    const bool hasMoved = subject_.setEditedDatabase(file, std::move(database));
    // Nothing but the infrared picture changes, which is there in a moment: what is drawn until
    // then would only take its time. It is a sum over what is known of the view, so that it need
    // not be coarse, however quickly edits follow each other.
    if (!infrared_->isOn() || hasMoved)
        redraw();
    frusta_->outdate();
    if (!infrared_->isOn())
        return;
    infrared_->outdate();
    if (isVisible())
        infrared_->askSharp();
}

void SceneView::setDisplay(ViewDisplay wanted) {
    if (wanted == display())
        return;
    infrared_->setOn(wanted == ViewDisplay::infrared);
    if (wanted == ViewDisplay::visible)
        emit pictureShown();
    arrange();
    sceneChanged();
    emit displayChanged();
}

ViewDisplay SceneView::display() const {
    return infrared_->isOn() ? ViewDisplay::infrared : ViewDisplay::visible;
}

std::optional<InfraredRequest> SceneView::infraredRequest() const {
    if (size().isEmpty())
        return std::nullopt;
    auto request = subject_.request(camera());
    if (request) {
        request->size_px = size() * devicePixelRatio();
        request->horizontalFieldOfView_rad = fieldOfView_rad();
    }
    return request;
}

std::optional<InfraredRequest> SceneView::sensorRequest() const {
    auto request = subject_.request(cameras().sensor());
    if (request) {
        request->size_px = {subject_.frame().width_px, subject_.frame().height_px};
        request->horizontalFieldOfView_rad = subject_.frame().horizontalFieldOfView_rad;
    }
    return request;
}

void SceneView::setInsetVisible(bool on) {
    inset_ = on;
    arrange();
    redraw();
}

QRectF SceneView::insetRect() const {
    if (!inset_ || !cameras().other() || !subject_.hasModels())
        return {};
    const QSizeF room = QSizeF(size()) * insetPart;
    QRectF inner = frameRectIn(subject_.frame(), room);
    inner.moveTopRight(QPointF(width() - insetMargin_px, insetMargin_px));
    return inner;
}

void SceneView::setWireframe(bool on) {
    wireframe_ = on;
    drawing_->setWireframe(on);
    arrange();
    redraw();
}

void SceneView::setHighlighted(const FaceSelection& selection) {
    if (selection == selection_)
        return;
    selection_ = selection;
    arrange();
    redraw();
}

void SceneView::setChosen(const ChosenFaces& faces) {
    if (faces == chosen_)
        return;
    chosen_ = faces;
    arrange();
    redraw();
}

void SceneView::setCodeColors(std::shared_ptr<const CodeColors> codes) {
    if (codes == codes_)
        return;
    codes_ = std::move(codes);
    arrange();
    redraw();
}

void SceneView::setModel(const ModelKey& key, std::shared_ptr<const irsg::Model> model,
                         const std::shared_ptr<const ModelFaces>& faces) {
    subject_.scene().setModel(key, std::move(model), faces);
    ++facesRevision_;
    picker_.forget();
    arrange();
    sceneChanged();
}

void SceneView::sceneChanged() {
    redraw();
    frusta_->outdate();
    if (!infrared_->isOn())
        return;
    infrared_->outdate();
    if (isVisible())
        infrared_->ask(navigation_->isDragging());
}

void SceneView::redraw() {
    update();
    overlay_->refresh();
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    sceneChanged();
}

void SceneView::showEvent(QShowEvent* event) {
    QOpenGLWidget::showEvent(event);
    sceneChanged();
}

void SceneView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        drawing_->setBackground(isDark(palette()));
        arrange();
        redraw();
    }
    QOpenGLWidget::changeEvent(event);
}

std::vector<FaceHit> SceneView::facesAt(const QPointF& point) const {
    return facesUnder(subject_.scene(), projection(), point);
}

void SceneView::click(const QPointF& point, Qt::KeyboardModifiers modifiers) {
    if (!clickHandler_ || !clickHandler_(point, modifiers))
        pick(point);
}

void SceneView::pick(const QPointF& point) {
    const auto hits = facesAt(point);
    const FaceHit* hit = picker_.pick(hits, point, camera());
    if (hit == nullptr) {
        setHighlighted({});
        emit nothingPicked();
        return;
    }
    setHighlighted({hit->codes.temperature, hit->codes.material, hit->model});
    emit facePicked(hit->codes.temperature, hit->codes.material, hit->model, hit->point_m);
}

void SceneView::refreshReadout() {
    const auto point = navigation_->readsAt();
    overlay_->setReadout(point ? readoutAt(*point) : QString());
}

QString SceneView::readoutAt(const QPointF& point) const {
    QStringList words{infrared_->readoutAt(point.x() / width(), point.y() / height())};
    if (const auto hits = facesAt(point); !hits.empty())
        words << indexWords(subject_.scene(), hits.front());
    words.removeAll(QString());
    return words.join("     ");
}

ViewHud SceneView::hud() const {
    ViewHud hud;
    subject_.fill(hud);
    hud.projection = projection();
    hud.camera = camera();
    hud.inspecting = cameras().isInspecting();
    hud.inset = insetRect();
    hud.frusta = frusta_->frusta(hud.reference_m);
    for (const irsg::SampledTile& window : frusta_->windows())
        hud.mostSamples = std::max(hud.mostSamples, std::min(window.across, window.down));
    if (hasHandles())
        hud.handles = handles();
    // On an infrared picture its own brightness counts, not the theme's.
    const InfraredPicture* picture = shownPicture();
    hud.dark = picture != nullptr ? qGray(picture->colors.pixel(0, 0)) < 128 : isDark(palette());
    if (!infrared_->isOn())
        return hud;
    hud.problem = infrared_->problem();
    if (const double waited_s = infrared_->waiting_s(); waited_s > 0.3) {
        QString doing = infrared_->stage();
        if (doing.isEmpty())
            doing = picture != nullptr && picture->direct ? tr("adding inter-reflection")
                                                          : tr("computing");
        hud.busy = tr("infrared: %1… %2 s").arg(doing).arg(waited_s, 0, 'f', 1);
    }
    return hud;
}

} // namespace smat::gui

#include "moc_SceneView.cpp"
