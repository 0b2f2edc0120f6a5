#include "gui/database/EditorContext.h"

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/ModelUse.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

EditorContext::EditorContext(Workbench& workbench, DatabaseSession& session, Dialogs dialogs,
                             QObject* parent)
    : QObject(parent), workbench_(workbench), session_(session), dialogs_(std::move(dialogs)) {
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        target_.reset();
        readModel();
        readSettings();
    });
    const auto readBoth = [this] {
        readModel();
        readSettings();
    };
    connect(&workbench_, &Workbench::projectChanged, this, readBoth);
    connect(&workbench_, &Workbench::modelChosen, this, readBoth);
    connect(&workbench_.painted(), &PaintedModels::changed, this,
            [this](const std::filesystem::path& model) {
                if (target_ && target_->file == model)
                    read(*target_);
            });
    connect(&workbench_, &Workbench::settingsChanged, this, &EditorContext::readSettings);
    readModel();
    readSettings();
}

void EditorContext::readModel() {
    if (!workbench_.hasProject())
        return;
    if (workbench_.project().models.empty()) {
        target_.reset();
        reading_.cancel();
        use_ = {};
        knowsModel_ = false;
        return;
    }
    const ProjectModel& target = workbench_.project().models.at(workbench_.chosenModel());
    const ModelKey key = ModelKey::of(workbench_.project(), target);
    const bool isKnown = target_ == key;
    if (isKnown && use_.fallbackTemperature == target.fallbackTemperature &&
        use_.fallbackMaterial == target.fallbackMaterial)
        return;
    if (!isKnown) {
        use_ = {};
        knowsModel_ = false;
        target_ = key;
        read(key);
    }
    use_.fallbackTemperature = target.fallbackTemperature;
    use_.fallbackMaterial = target.fallbackMaterial;
    emit surroundingsChanged();
}

void EditorContext::read(const ModelKey& key) {
    reading_.run<irsg::ModelUse>(
        [key, models = workbench_.models()] { return irsg::useOf(*models->model(key)); },
        [this](irsg::ModelUse use) {
            use.fallbackTemperature = use_.fallbackTemperature;
            use.fallbackMaterial = use_.fallbackMaterial;
            use_ = std::move(use);
            knowsModel_ = true;
            emit surroundingsChanged();
        },
        [this](const std::exception_ptr& thrown) {
            try {
                std::rethrow_exception(thrown);
            } catch (const irsg::InputError&) {
                // The 3-D view says what is wrong with it; the database can be edited all the same.
                emit surroundingsChanged();
            }
        });
}

void EditorContext::readSettings() {
    if (!workbench_.hasProject())
        return;
    const Project& project = workbench_.project();
    const Settings& settings = workbench_.settings();
    std::string key, air;
    for (const std::string_view name :
         std::initializer_list<std::string_view>{key::sensorBand, key::sensorResponse})
        key += settings.text(name) + "|";
    for (const std::string_view name : std::initializer_list<std::string_view>{
             key::environmentAtmospheres, key::environmentAmbientTemperature})
        air += settings.text(name) + "|";
    irsg::EntityState state;
    if (const std::size_t chosen = workbench_.chosenModel(); chosen < project.models.size()) {
        state = stateOf(project, settings, chosen);
        state.altitude_m = poseOf(project, settings, chosen).position_m.z;
    }
    key += std::to_string(state.time_s) + "|" + std::to_string(state.power) + "|" +
           std::to_string(state.mach);
    air += std::to_string(state.altitude_m);
    if (key == settingsKey_ && air == atmosphereKey_)
        return;
    settingsKey_ = key;
    try {
        band_ = sensorOf(project, settings).band.range();
    } catch (const irsg::InputError&) {
        // A response that cannot be read is told where it is used; the last band stays.
    }
    state.ambient_K = state_.ambient_K;
    state_ = state;
    if (air != atmosphereKey_) {
        atmosphereKey_ = air;
        try {
            state_.ambient_K =
                environmentOf(project, settings).ambientTemperature_K(state_.altitude_m).value;
        } catch (const irsg::InputError&) {
            state_.ambient_K = irsg::EntityState().ambient_K;
        }
    }
    emit surroundingsChanged();
}

int EditorContext::facesOf(const EntryKey& key) const {
    if (key.kind == EntryKind::spectrum)
        return 0;
    const auto& faces =
        key.kind == EntryKind::material ? use_.materialFaces : use_.temperatureFaces;
    const auto found = faces.find(key.index);
    return found == faces.end() ? 0 : found->second;
}

std::vector<EntryKey> EditorContext::missing() const {
    std::vector<EntryKey> keys;
    if (!session_.isOpen())
        return keys;
    for (const auto& [index, faces] : use_.materialFaces)
        if (!session_.value().materials.contains(index))
            keys.push_back({EntryKind::material, index});
    for (const auto& [index, faces] : use_.temperatureFaces)
        if (!session_.value().temperatures.contains(index))
            keys.push_back({EntryKind::temperature, index});
    return keys;
}

QString EditorContext::title(const EntryKey& key) const {
    const auto named = [](const QString& kind, int index, const std::string& name) {
        return name.empty() ? QStringLiteral("%1 %2").arg(kind).arg(index)
                            : QStringLiteral("%1 %2 (%3)")
                                  .arg(kind)
                                  .arg(index)
                                  .arg(QString::fromStdString(name));
    };
    const auto& database = session_.value();
    if (key.kind == EntryKind::material) {
        const auto found = database.materials.find(key.index);
        return named(tr("material"), key.index,
                     found == database.materials.end() ? "" : found->second.name);
    }
    if (key.kind == EntryKind::temperature) {
        const auto found = database.temperatures.find(key.index);
        return named(tr("temperature"), key.index,
                     found == database.temperatures.end() ? "" : found->second.name);
    }
    return tr("spectrum %1").arg(QString::fromStdString(key.name));
}

double EditorContext::bandMean(const irsg::Spectrum& spectrum) const {
    const irsg::Spectrum* factors[] = {&spectrum};
    return irsg::integrateProduct(factors, band_) / band_.width_um();
}

QString counted(long number, const QString& one, const QString& many) {
    return QStringLiteral("%1 %2").arg(number).arg(number == 1 ? one : many);
}

void EditorContext::attempt(const QString& title, const std::function<void()>& act) const {
    try {
        act();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window, title, sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_EditorContext.cpp"
