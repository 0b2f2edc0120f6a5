#include "gui/view/InfraredPictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/image/ImageView.h"
#include "gui/view/InfraredDisplay.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// A picture that moves should take about this long, s.
constexpr double slow_s = 0.045, quick_s = 0.012;
constexpr int coarsest = 4;
/// An edit whose picture would take longer than this has one without light between surfaces first,
/// s.
constexpr double patience_s = 0.25;
/// From so many triangles on, light between surfaces may take seconds where it is not known yet.
constexpr std::size_t largeModel = 5000;

std::size_t trianglesOf(const LoadedModels& models) {
    std::size_t count = 0;
    for (const auto& [key, model] : models)
        count += model->mesh()->facets();
    return count;
}

/// Both ends, where they are set.
std::optional<irsg::DisplayLimits> limitsIn(const Settings& settings) {
    const auto low = settings[key::displayMinimum], high = settings[key::displayMaximum];
    if (!low || !high || !(*low < *high))
        return std::nullopt;
    return irsg::DisplayLimits{*low, *high};
}

} // namespace

InfraredPictures::InfraredPictures(std::function<std::optional<InfraredRequest>()> view,
                                   QObject* parent)
    : QObject(parent), view_(std::move(view)) {
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    display_ = new InfraredDisplay(this);
    connect(display_, &InfraredDisplay::drawn, this, &InfraredPictures::take);
    connect(display_, &InfraredDisplay::failed, this, &InfraredPictures::refuse);
    rest_.setSingleShot(true);
    rest_.setInterval(140);
    connect(&rest_, &QTimer::timeout, this, [this] { send(false); });
    waiting_.setInterval(100);
    connect(&waiting_, &QTimer::timeout, this, [this] {
        emit waited();
        stopWaiting();
    });
}

InfraredPictures::~InfraredPictures() {
    delete display_; // its answers would find nothing any more
}

void InfraredPictures::setOn(bool on) {
    isOn_ = on;
    if (on)
        return;
    rest_.stop();
    waiting_.stop();
    display_->forget();
    drop();
}

void InfraredPictures::setQuantity(InfraredQuantity quantity) {
    if (quantity == quantity_)
        return;
    quantity_ = quantity;
    // Limits in another unit mean nothing.
    if (rule_.mode == LimitMode::locked)
        rule_.mode = LimitMode::target;
    emit lookChanged();
    send(false);
}

void InfraredPictures::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    emit lookChanged();
    send(false);
}

void InfraredPictures::setColorRule(const ColorRule& rule) {
    if (rule.mode == LimitMode::locked && rule_.mode != LimitMode::locked && picture_.image)
        lockedLimits_ = picture_.limits;
    rule_ = rule;
    emit lookChanged();
    send(false);
}

void InfraredPictures::setLimits(const irsg::DisplayLimits& limits) {
    rule_.mode = LimitMode::locked;
    lockedLimits_ = limits;
    emit lookChanged();
    send(false);
}

void InfraredPictures::followColors(const Settings& settings) {
    const Settings before = std::exchange(followed_, settings);
    const bool isFirst = !std::exchange(hasFollowed_, true);
    if (const std::string& map = settings.text(key::displayColorMap);
        before.text(key::displayColorMap) != map || isFirst)
        setColorMap(map);
    if (const std::string& scale = settings.text(key::displayScale);
        before.text(key::displayScale) != scale ||
        before[key::displayMarkOutside] != settings[key::displayMarkOutside]) {
        ColorRule rule = rule_;
        rule.scale = irsg::colorScaleNamed(scale);
        rule.marksOutside = settings[key::displayMarkOutside];
        setColorRule(rule);
    }
    const auto limits = limitsIn(settings), limitsBefore = limitsIn(before);
    if (limits == limitsBefore && !(isFirst && limits))
        return;
    if (limits && quantity_ == InfraredQuantity::radiance)
        setLimits(*limits);
    else if (limitsBefore && rule_.mode == LimitMode::locked) {
        ColorRule rule = rule_;
        rule.mode = LimitMode::target;
        setColorRule(rule);
    }
}

QString InfraredPictures::readoutAt(double right, double down) const {
    const InfraredPicture* picture = shown();
    if (picture == nullptr)
        return {};
    const int x = static_cast<int>(std::floor(right * picture->size_px.width()));
    const int y = static_cast<int>(std::floor(down * picture->size_px.height()));
    if (!QRect(QPoint(), picture->size_px).contains(x, y))
        return {};
    const auto& plane = picture->plane();
    const auto value = static_cast<double>(plane.values[picture->image->offset(x, y)]);
    const QString words =
        QStringLiteral("%1 %2").arg(planeTitle(plane), valueWithUnit(value, plane.unit));
    return isOfEarlierState() ? tr("%1 (before the edit)").arg(words) : words;
}

const InfraredPicture* InfraredPictures::shown() const {
    if (!isOn_ || !picture_.image || !problem_.isEmpty())
        return nullptr;
    // The last one stands until the next is there: what it is of can still be seen.
    return &picture_;
}

bool InfraredPictures::isUpToDate() const {
    const bool answered = picture_.revision == revision_ || !problem_.isEmpty();
    return !display_->isBusy() && !rest_.isActive() && answered;
}

double InfraredPictures::waiting_s() const {
    return display_->waiting_s();
}

QString InfraredPictures::stage() const {
    return display_->stage();
}

void InfraredPictures::ask(bool isDragging) {
    const bool moving =
        isDragging || (lastChange_.isValid() && lastChange_.elapsed() < 2 * rest_.interval());
    lastChange_.start();
    send(moving);
    if (moving)
        rest_.start();
    else
        rest_.stop();
}

void InfraredPictures::askSharp() {
    rest_.stop();
    send(false);
}

void InfraredPictures::send(bool coarse) {
    if (!isOn_)
        return;
    std::optional<InfraredRequest> request = view_();
    if (!request)
        return;
    // Something to be looked at comes first, of a new scene and of one that was edited.
    const bool isSlowEdit = picture_.image && picture_.revision != revision_ &&
                            !request->edited.empty() && ofEdit_s_ > patience_s;
    request->direct = (!picture_.image || isSlowEdit) &&
                      trianglesOf(request->models) >= largeModel &&
                      request->settings[key::renderBounces] != 0.0;
    if (coarse)
        request->size_px = {std::max(request->size_px.width() / coarseness_, 1),
                            std::max(request->size_px.height() / coarseness_, 1)};
    request->coarse = coarse || request->direct;
    request->revision = revision_;
    request->quantity = quantity_;
    request->map = map_;
    request->rule = rule_;
    // Colours hold still while something moves.
    const bool isOf = picture_.image && picture_.quantity == quantity_;
    if (coarse && isOf)
        request->limits = picture_.limits;
    else if (rule_.mode == LimitMode::locked)
        request->limits = lockedLimits_;
    display_->ask(std::move(*request));
    waiting_.start();
}

void InfraredPictures::take(const InfraredPicture& picture) {
    if (!isOn_ || picture.revision <= droppedAt_)
        return;
    const bool moves = picture.coarse && !picture.direct;
    if (moves && picture.radiance_s > slow_s)
        coarseness_ = std::min(coarseness_ + 1, coarsest);
    else if (moves && picture.radiance_s < quick_s)
        coarseness_ = std::max(coarseness_ - 1, 1);
    // The first with light of a state says how long that may take.
    if (!picture.direct && !picture.coarse && picture.revision != sharpRevision_) {
        sharpRevision_ = picture.revision;
        ofEdit_s_ = std::max(ofEdit_s_, picture.radiance_s);
    }
    picture_ = picture;
    problem_.clear();
    if (picture.direct && !display_->isBusy() && !rest_.isActive())
        send(false);
    stopWaiting();
    emit drawn(picture_);
}

void InfraredPictures::refuse(const QStringList& sentences, bool ourFault) {
    if (!isOn_)
        return;
    problem_ = sentences;
    if (ourFault)
        problem_.prepend(tr("Internal error"));
    picture_ = {};
    stopWaiting();
    emit failed(problem_);
}

void InfraredPictures::stopWaiting() {
    if (!display_->isBusy())
        waiting_.stop();
}

void InfraredPictures::beginAnew() {
    hasFollowed_ = false;
    drop();
}

void InfraredPictures::drop() {
    picture_ = {};
    problem_.clear();
    droppedAt_ = revision_;
    ofEdit_s_ = 0.0;
}

} // namespace smat::gui

#include "moc_InfraredPictures.cpp"
