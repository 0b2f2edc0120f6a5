// The infrared half of the view: what it asks for, and what it makes of the answers.
#include <algorithm>
#include <cmath>

#include "gui/Readable.h"
#include "gui/image/ImageView.h"
#include "gui/view/InfraredDisplay.h"
#include "gui/view/SceneViewImpl.h"
#include "irsg/radiometry/Errors.h"

namespace smat::gui {
namespace {

/// A picture that moves should take about this long, s.
constexpr double slow_s = 0.045, quick_s = 0.012;
constexpr int coarsest = 4;
/// Longer than this the visible display stands in for a picture that is awaited, s.
constexpr double patience_s = 0.5;

} // namespace

void SceneView::setDisplay(ViewDisplay display) {
    if (display == display_)
        return;
    display_ = display;
    if (display == ViewDisplay::visible) {
        rest_.stop();
        waiting_.stop();
        infrared_->forget();
        dropPicture();
        emit pictureShown();
    }
    arrange();
    sceneChanged();
    emit displayChanged();
}

void SceneView::setQuantity(InfraredQuantity quantity) {
    if (quantity == quantity_)
        return;
    quantity_ = quantity;
    // Limits in another unit mean nothing.
    if (rule_.mode == LimitMode::locked)
        rule_.mode = LimitMode::target;
    emit displayChanged();
    sendRequest(false);
}

void SceneView::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    emit displayChanged();
    sendRequest(false);
}

void SceneView::setColorRule(const ColorRule& rule) {
    if (rule.mode == LimitMode::locked && rule_.mode != LimitMode::locked && picture_.image)
        lockedLimits_ = picture_.limits;
    rule_ = rule;
    emit displayChanged();
    sendRequest(false);
}

void SceneView::setLimits(const irsg::DisplayLimits& limits) {
    rule_.mode = LimitMode::locked;
    lockedLimits_ = limits;
    emit displayChanged();
    sendRequest(false);
}

void SceneView::setEditedDatabase(const std::filesystem::path& file,
                                  std::shared_ptr<const irsg::SignatureDatabase> database) {
    const irsg::Vec3 referenceBefore = impl_->scene.referencePoint_m;
    if (database) {
        edited_[file] = database;
        impl_->scene.setSignature(file, database);
    } else if (edited_.erase(file) > 0) {
        // The file counts again; where it cannot be read, the renderer says so.
        std::shared_ptr<const irsg::SignatureDatabase> ofFile;
        try {
            ofFile = SceneBuilder().database(file);
        } catch (const irsg::InputError&) {
            ofFile = nullptr;
        }
        impl_->scene.setSignature(file, std::move(ofFile));
    }
    // Nothing but the infrared picture changes, which is there in a moment: what is drawn until
    // then would only take its time. It is a sum over what is known of the view, so that it need
    // not be coarse, however quickly edits follow each other.
    if (display_ != ViewDisplay::infrared || impl_->scene.referencePoint_m != referenceBefore)
        redraw();
    if (display_ != ViewDisplay::infrared)
        return;
    ++revision_;
    if (isVisible()) {
        rest_.stop();
        sendRequest(false);
    }
}

bool SceneView::showsPicture() const {
    if (display_ != ViewDisplay::infrared || !picture_.image || !problem_.isEmpty())
        return false;
    return picture_.revision == revision_ || infrared_->waiting_s() < patience_s;
}

const InfraredPicture* SceneView::shownPicture() const {
    return showsPicture() ? &picture_ : nullptr;
}

bool SceneView::isUpToDate() const {
    const bool answered = picture_.revision == revision_ || !problem_.isEmpty();
    return !infrared_->isBusy() && !rest_.isActive() && answered;
}

void SceneView::askInfrared() {
    ++revision_;
    if (!isVisible())
        return;
    const bool moving =
        dragFrom_ || (lastChange_.isValid() && lastChange_.elapsed() < 2 * rest_.interval());
    lastChange_.start();
    sendRequest(moving);
    if (moving)
        rest_.start();
    else
        rest_.stop();
}

void SceneView::sendRequest(bool coarse) {
    if (display_ != ViewDisplay::infrared || !project_ || impl_->scene.models.empty() ||
        size().isEmpty())
        return;
    InfraredRequest request;
    request.project = project_;
    request.settings = settings_;
    request.edited = edited_;
    request.models = impl_->scene.loaded;
    request.camera = camera();
    request.targetYaw_rad = targetYaw_rad_;
    request.size_px = size() * devicePixelRatio();
    if (coarse)
        request.size_px = {std::max(request.size_px.width() / coarseness_, 1),
                           std::max(request.size_px.height() / coarseness_, 1)};
    request.horizontalFieldOfView_rad = fieldOfView_rad();
    request.coarse = coarse;
    request.revision = revision_;
    request.quantity = quantity_;
    request.map = map_;
    request.rule = rule_;
    // Colours hold still while something moves.
    const bool isOf = picture_.image && picture_.quantity == quantity_;
    if (coarse && isOf)
        request.limits = picture_.limits;
    else if (rule_.mode == LimitMode::locked)
        request.limits = lockedLimits_;
    infrared_->ask(std::move(request));
    waiting_.start();
}

void SceneView::onDrawn(const InfraredPicture& picture) {
    if (display_ != ViewDisplay::infrared || picture.revision <= droppedAt_)
        return;
    if (picture.coarse && picture.radiance_s > slow_s)
        coarseness_ = std::min(coarseness_ + 1, coarsest);
    else if (picture.coarse && picture.radiance_s < quick_s)
        coarseness_ = std::max(coarseness_ - 1, 1);
    picture_ = picture;
    problem_.clear();
    impl_->hasGlObjectsToDelete =
        impl_->sheet.setPicture(picture.colors, picture.coarse) || impl_->hasGlObjectsToDelete;
    if (!infrared_->isBusy())
        waiting_.stop();
    arrange();
    hover(hoverAt_);
    redraw();
    emit pictureShown();
}

void SceneView::onFailed(const QStringList& sentences, bool ourFault) {
    if (display_ != ViewDisplay::infrared)
        return;
    problem_ = sentences;
    if (ourFault)
        problem_.prepend(tr("Internal error"));
    picture_ = {};
    if (!infrared_->isBusy())
        waiting_.stop();
    arrange();
    redraw();
    emit pictureShown();
    emit pictureFailed(problem_);
}

void SceneView::onWaiting() {
    // The visible display comes and goes with the patience for a picture.
    arrange();
    redraw();
    if (!infrared_->isBusy())
        waiting_.stop();
}

void SceneView::dropPicture() {
    picture_ = {};
    problem_.clear();
    droppedAt_ = revision_;
}

QString SceneView::readoutAt(const QPointF& point) const {
    QStringList words;
    if (const InfraredPicture* picture = shownPicture()) {
        const int x = static_cast<int>(std::floor(point.x() / width() * picture->size_px.width()));
        const int y =
            static_cast<int>(std::floor(point.y() / height() * picture->size_px.height()));
        if (QRect(QPoint(), picture->size_px).contains(x, y)) {
            const auto& plane = picture->plane();
            const auto value = static_cast<double>(plane.values[picture->image->offset(x, y)]);
            words << QStringLiteral("%1 %2 %3")
                         .arg(planeTitle(plane), readableNumber(value), readableUnit(plane.unit));
        }
    }
    if (const auto hits = facesAt(point); !hits.empty())
        words << indexWords(hits.front());
    return words.join("     ");
}

} // namespace smat::gui
