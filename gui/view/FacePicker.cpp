#include "gui/view/FacePicker.h"

#include <algorithm>

#include <QLineF>
#include <QObject>
#include <QStringList>

namespace smat::gui {

std::vector<FaceHit> facesUnder(const DisplayScene& scene, const ViewProjection& through,
                                const QPointF& point) {
    const irsg::Vec3 direction = through.ray(point);
    std::vector<FaceHit> hits;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        const DisplayModel& model = scene.models[i];
        if (!model.faces)
            continue;
        const irsg::Rotation toModel = model.pose.attitude.rotation().transposed();
        const irsg::Vec3 eye = toModel * (through.eye.position_m - model.pose.position_m);
        for (const auto& hit : model.faces->along(eye, toModel * direction))
            hits.push_back(
                {static_cast<int>(i), hit.codes, model.pose.toWorld(hit.point_m), hit.distance_m});
    }
    std::ranges::stable_sort(hits, {}, &FaceHit::distance_m);
    return hits;
}

QString indexWords(const DisplayScene& scene, const FaceHit& hit) {
    const DisplayModel& model = scene.models.at(static_cast<std::size_t>(hit.model));
    const auto named = [](const QString& word, int index, const std::string& name) {
        const QString number = QStringLiteral("%1 %2").arg(word).arg(index);
        return name.empty() ? number
                            : QStringLiteral("%1 (%2)").arg(number, QString::fromStdString(name));
    };
    std::string temperature, material;
    if (model.signature) {
        const auto& temperatures = model.signature->temperatures;
        if (const auto entry = temperatures.find(hit.codes.temperature);
            entry != temperatures.end())
            temperature = entry->second.name;
        const auto& materials = model.signature->materials;
        if (const auto entry = materials.find(hit.codes.material); entry != materials.end())
            material = entry->second.name;
    }
    QStringList words{named(QObject::tr("temperature"), hit.codes.temperature, temperature),
                      named(QObject::tr("material"), hit.codes.material, material)};
    if (scene.models.size() > 1)
        words << model.name;
    return words.join("     ");
}

const FaceHit* FacePicker::pick(const std::vector<FaceHit>& hits, const QPointF& point,
                                const OrbitCamera& camera) {
    if (hits.empty()) {
        forget();
        return nullptr;
    }
    std::size_t number = 0;
    const auto sameFace = [](const FaceHit& a, const FaceHit& b) {
        return a.model == b.model && a.codes == b.codes;
    };
    if (last_ && QLineF(last_->at, point).length() < 3.0 && last_->camera == camera &&
        last_->number < hits.size()) {
        number = last_->number;
        while (number < hits.size() && sameFace(hits[number], hits[last_->number]))
            ++number;
        if (number == hits.size())
            number = 0;
    }
    last_ = Pick{point, number, camera};
    return &hits[number];
}

} // namespace smat::gui
