#include "irsg/atmosphere/AtmosphereSmart.h"

#include <set>
#include <utility>

#include "irsg/atmosphere/AtmosphereNodes.h"
#include "irsg/atmosphere/SmartAdapter.h"
#include "irsg/atmosphere/ck/CkCache.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/atmosphere/path/SunDiscGeometry.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileStamp.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

bool isFlux(AtmosphereProperty property) {
    return property == AtmosphereProperty::upwardFlux ||
           property == AtmosphereProperty::downwardFlux;
}

/// Where quadrature points of an air are kept: the key names the files of the shipped tables.
std::optional<CacheStore> storeOf(const AtmosphereSmart& air) {
    return &air.transfer().gases() == GasTable::shipped().get() ? ckStore() : std::nullopt;
}

/// All that quadrature points depend on: the program's own way to train, the tables, the air, the
/// request.
CacheKey keyOf(const AtmosphereSmart& air, const CkRequest& request) {
    CacheKey key;
    key.add(ckTraining);
    // A table that was made anew has another time.
    const std::filesystem::path folder = atmosphereResource("gases.gastable").parent_path();
    std::set<std::filesystem::path> tables;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        tables.insert(entry.path());
    for (const std::filesystem::path& table : tables)
        key.add(table.filename().string() + "|" + stampOf(table).value_or(FileStamp()).text());
    // Tables of answers change nothing of what quadrature points are trained on.
    AtmosphereSmartParameters parameters = air.parameters();
    parameters.irradianceMode = 1;
    for (const auto& some : {smartParameters(), ownSmartParameters()})
        for (const SmartParameter& parameter : some)
            key.add(std::string(parameter.name)).add(valueText(parameter, parameters));
    for (const AtmosphericState& level :
         air.air().profile.levels()) { // of an ascent the file alone says little
        key.add(level.altitude_m).add(level.pressure_hPa).add(level.temperature_K);
        for (const double fraction : level.moleFraction)
            key.add(fraction);
    }
    addTo(key, request);
    return key;
}

} // namespace

AtmosphereSmart::AtmosphereSmart(AtmosphereSmartParameters parameters, std::string name,
                                 const std::filesystem::path& file,
                                 std::shared_ptr<const GasTable> gases)
    : parameters_(std::move(parameters)),
      name_(std::move(name)),
      file_(file),
      remarks_(remarksOn(parameters_)),
      air_(SmartAdapter::atmosphericModel(parameters_, file)),
      gases_(std::move(gases)) {}

std::shared_ptr<AtmosphereSmart> AtmosphereSmart::fromXml(const std::filesystem::path& file,
                                                          std::shared_ptr<const GasTable> gases) {
    SmartReading reading = fromKarma(KarmaXml::read(file));
    auto atmosphere = std::make_shared<AtmosphereSmart>(
        std::move(reading.parameters), "AtmosphereSmart (" + file.filename().string() + ")", file,
        std::move(gases));
    atmosphere->remarks_ = std::move(reading.remarks);
    return atmosphere;
}

std::shared_ptr<AtmosphereSmart> AtmosphereSmart::withResolution(int resolution_per_cm) const {
    AtmosphereSmartParameters parameters = parameters_;
    parameters.resolution_per_cm = resolution_per_cm;
    return withParameters(std::move(parameters));
}

std::shared_ptr<AtmosphereSmart>
AtmosphereSmart::withParameters(AtmosphereSmartParameters parameters) const {
    auto other = std::make_shared<AtmosphereSmart>(std::move(parameters), name_, file_, gases_);
    other->remarks_ = remarks_;
    return other;
}

std::shared_ptr<const Atmosphere> AtmosphereSmart::onTheFly() const {
    if (parameters_.irradianceMode != 1)
        return nullptr;
    const std::lock_guard lock(onTheFlyMutex_);
    if (onTheFly_)
        return onTheFly_;
    AtmosphereSmartParameters parameters = parameters_;
    parameters.irradianceMode = 2;
    auto other = std::make_shared<AtmosphereSmart>(std::move(parameters), name_, file_, gases_);
    other->remarks_ = remarks_;
    // What both make of the same air is kept once.
    (void)transfer();
    std::call_once(other->once_, [&] { other->transfer_ = transfer_; });
    return onTheFly_ = std::move(other);
}

const RadiativeTransfer& AtmosphereSmart::transfer() const {
    std::call_once(once_, [this] { makeTransfer(); });
    return *transfer_;
}

void AtmosphereSmart::makeTransfer() const {
    if (!gases_)
        gases_ = GasTable::shipped();
    const SpectralRange held{wavelengthFromWavenumber_um(gases_->upper_per_cm()),
                             wavelengthFromWavenumber_um(gases_->lower_per_cm())};
    // The last digit of 1e4 / x is nobody's fault.
    constexpr double slack = 1e-9;
    if (base().min_um < held.min_um * (1.0 - slack) || base().max_um > held.max_um * (1.0 + slack))
        throw InputError({name_, "BaseWavelengthMin, BaseWavelengthMax",
                          numberText(base().min_um) + " to " + numberText(base().max_um) + " um",
                          "a band that the gas table holds, " + numberText(held.min_um) + " to " +
                              numberText(held.max_um) + " um"});
    transfer_ = std::make_shared<const RadiativeTransfer>(air_, gases_);
}

const AtmosphereTables& AtmosphereSmart::tables(const NodeSet& nodes) const {
    const RadiativeTransfer& air = transfer();
    const std::lock_guard lock(tablesMutex_);
    auto& own = tables_[nodes.nodes];
    if (!own)
        own = std::make_unique<AtmosphereTables>(
            air, nodes, parameters_.irradianceMode == 1 ? tableTolerance : 0.0);
    return *own;
}

bool AtmosphereSmart::supports(AtmosphereProperty property) const {
    return !isFlux(property) || air_.scattering == ScatteringMode::twoStream;
}

std::string AtmosphereSmart::refusal(AtmosphereProperty property) const {
    return Atmosphere::refusal(property) +
           " in ScatteringMode 1 (single scattering): fluxes need ScatteringMode 2";
}

double AtmosphereSmart::horizonElevation_rad(double altitude_m) const {
    checkAltitude(altitude_m);
    return transfer().tracer().horizonElevation_rad(altitude_m);
}

SunView AtmosphereSmart::sunView(double altitude_m, const SunPosition& sun) const {
    checkAltitude(altitude_m);
    const RayTracer& tracer = transfer().tracer();
    const double horizon_rad = tracer.trueHorizonElevation_rad(altitude_m);
    return {visibleSun(sun.elevation_rad - horizon_rad).part,
            tracer.apparentElevation_rad(altitude_m, sun.elevation_rad)};
}

TargetView AtmosphereSmart::targetView(const AtmosphericPath& path) const {
    checkPath(path);
    return transfer().tracer().targetView(path);
}

std::vector<double> AtmosphereSmart::valuesAt(const NodeSet& nodes,
                                              const AtmosphericQuery& query) const {
    const AtmosphereTables& air = tables(nodes);
    const auto& [quantity, path, sight, altitude_m, sun] = query;
    switch (quantity) {
    case AtmosphereProperty::transmittance:
        return air.transmittance(path);
    case AtmosphereProperty::pathRadiance:
        return air.pathRadiance(path, sun);
    case AtmosphereProperty::backgroundRadiance:
        return air.backgroundRadiance(sight, sun);
    case AtmosphereProperty::solarIrradiance:
        return air.solarIrradiance(altitude_m, sun);
    case AtmosphereProperty::upwardFlux:
        return air.upwardFlux(altitude_m, sun);
    case AtmosphereProperty::downwardFlux:
        return air.downwardFlux(altitude_m, sun);
    case AtmosphereProperty::scatteringOpticalDepth:
        return transfer().scatteringOpticalDepth(air.nodes(), path);
    case AtmosphereProperty::ambientTemperature:
        break;
    }
    throw LogicError("a temperature was asked for at spectral nodes");
}

Spectrum AtmosphereSmart::nativeSpectrum(const AtmosphericQuery& query,
                                         const SpectralRange& range) const {
    return transfer().spectrum(range, valuesAt(transfer().nodesOf(range), query));
}

std::vector<double> AtmosphereSmart::valuesAtPoints(const AtmosphericQuery& query,
                                                    const SensorCkData& points) const {
    return valuesAt(points.nodes(), query);
}

std::optional<std::vector<double>>
AtmosphereSmart::valuesAtNodes(const AtmosphericQuery& query, const AtmosphereNodes& nodes) const {
    (void)transfer();
    if (!nodes.isOf(transfer_))
        return std::nullopt;
    return nodes.arranged(valuesAt(nodes.set(), query));
}

std::shared_ptr<const SpectralSampling>
AtmosphereSmart::nodesOf(const std::vector<Band>& bands) const {
    for (const Band& band : bands)
        checkRange(band.range());
    (void)transfer();
    return std::make_shared<const AtmosphereNodes>(transfer_, bands);
}

std::shared_ptr<const SpectralSampling>
AtmosphereSmart::nodesAt(const std::vector<double>& wavelengths_um) const {
    (void)transfer();
    auto nodes = std::make_shared<const AtmosphereNodes>(transfer_, wavelengths_um);
    checkRange(nodes->range());
    return nodes;
}

double AtmosphereSmart::ambientTemperature_K(double altitude_m) const {
    checkAltitude(altitude_m);
    return air_.profile.at(altitude_m).temperature_K;
}

std::shared_ptr<const SensorCkData> AtmosphereSmart::prepareCk(const CkRequest& request) const {
    checkRange(request.band.range());
    const std::optional<CacheStore> store = storeOf(*this);
    return cachedOrTrained(store, store ? keyOf(*this, request) : CacheKey(),
                           CkNodes(transfer(), request.band), request.band,
                           [&] { return SensorCkData::prepare(transfer(), request); });
}

std::optional<AtmosphericState> airOfPath(const Atmosphere* atmosphere,
                                          const AtmosphericPath& path) {
    const auto* const computed = dynamic_cast<const AtmosphereSmart*>(atmosphere);
    if (!computed)
        return std::nullopt;
    return computed->air().profile.at(0.5 * (path.targetAltitude_m + path.sensorAltitude_m));
}

} // namespace irsg
