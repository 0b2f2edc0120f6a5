#include "irsg/atmosphere/AtmosphereSmartParameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "irsg/atmosphere/SmartAdapter.h"
#include "irsg/atmosphere/engine/ParticleParts.h"

namespace irsg {

namespace {

using S = AtmosphereSmartParameters;

std::string withUnit(std::string text, std::string_view unit) {
    return unit.empty() ? text : std::move(text.append(" ").append(unit));
}

class Check {
  public:
    explicit Check(const S& parameters) : p_(parameters) {}

    std::vector<Diagnostic> run() {
        for (const auto table : {smartParameters(), ownSmartParameters()})
            for (const SmartParameter& parameter : table)
                std::ranges::move(rangeDiagnosticsOf(parameter, p_),
                                  std::back_inserter(diagnostics_));
        checkBand();
        checkAlbedo();
        checkCombinations();
        return std::move(diagnostics_);
    }

  private:
    void refuse(std::string_view parameter, std::string value, std::string expected) {
        diagnostics_.push_back({"", std::string(parameter), std::move(value), std::move(expected)});
    }
    bool isRefused(std::string_view parameter) const {
        return std::ranges::find(diagnostics_, parameter, &Diagnostic::position) !=
               diagnostics_.end();
    }

    void checkBand() {
        if (p_.modelType != S().modelType)
            refuse("ModelType", "'" + p_.modelType + "'", S().modelType);
        if (!isRefused("BaseWavelengthMin") && !isRefused("BaseWavelengthMax") &&
            !(p_.baseWavelengthMin_um < p_.baseWavelengthMax_um))
            refuse("BaseWavelengthMin", numberText(p_.baseWavelengthMin_um) + " um",
                   "less than BaseWavelengthMax, " + numberText(p_.baseWavelengthMax_um) + " um");
    }

    void checkAlbedo() {
        const std::vector<double>& x = p_.albedoWavelengths_um;
        if (x.empty())
            refuse("AlbedoWavelengths", "no numbers", "at least one wavelength");
        if (p_.albedoValues.size() != x.size())
            refuse("AlbedoValues", std::to_string(p_.albedoValues.size()) + " numbers",
                   "as many as AlbedoWavelengths, " + std::to_string(x.size()));
        const auto fall = std::ranges::adjacent_find(x, std::greater_equal());
        if (fall != x.end())
            refuse("AlbedoWavelengths",
                   numberText(*std::next(fall)) + " um after " + numberText(*fall) + " um",
                   "wavelengths that ascend");
    }

    void checkCombinations() {
        if (p_.scatteringMode == 1 && p_.cloudModel != 0)
            refuse("ScatteringMode", "1 with CloudModel " + std::to_string(p_.cloudModel),
                   "2: clouds scatter more than once");
        if (p_.meteoModel == 2 && std::abs(p_.temperatureMH_C - p_.temperatureALT0_C) > 10.0)
            refuse("TemperatureMH", numberText(p_.temperatureMH_C) + " C",
                   "within 10 C of TemperatureALT0, " + numberText(p_.temperatureALT0_C) + " C");
        if (!diagnostics_.empty())
            return;
        try {
            particles::check(SmartAdapter::particleSettings(p_));
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics())
                refuse(diagnostic.position, diagnostic.value, diagnostic.expected);
        }
    }

    const S& p_;
    std::vector<Diagnostic> diagnostics_;
};

/// Reads one parameter of a document; diagnostics name its line.
class ValueReader {
  public:
    ValueReader(const KarmaXml& document, std::vector<Diagnostic>& diagnostics)
        : document_(document), diagnostics_(diagnostics) {}

    void read(const SmartParameter& parameter, const KarmaParameter& found, S& values) {
        if (found.kind != parameter.kind) {
            diagnostics_.push_back(document_.diagnostic(found, std::string("a ") + name(found.kind),
                                                        std::string("a ") + name(parameter.kind)));
            return;
        }
        std::visit([&](auto field) { take(parameter, found, values.*field); }, parameter.field);
    }

  private:
    void take(const SmartParameter& parameter, const KarmaParameter& found, int& value) {
        const double number = found.numbers.front();
        if (std::floor(number) != number || std::abs(number) > 1e6)
            diagnostics_.push_back(
                document_.diagnostic(found, withUnit(numberText(number), parameter.unit),
                                     "a whole number: " + std::string(parameter.range)));
        else
            value = static_cast<int>(number);
    }
    void take(const SmartParameter&, const KarmaParameter& found, double& value) {
        value = found.numbers.front();
    }
    void take(const SmartParameter&, const KarmaParameter& found, std::vector<double>& value) {
        value = found.numbers;
    }
    void take(const SmartParameter&, const KarmaParameter& found, std::string& value) {
        value = found.text;
    }

    const KarmaXml& document_;
    std::vector<Diagnostic>& diagnostics_;
};

KarmaParameter karmaOf(const SmartParameter& parameter, const S& values) {
    KarmaParameter result{.name = std::string(parameter.name),
                          .kind = parameter.kind,
                          .numbers = {},
                          .text = {},
                          .documentation = {}};
    std::visit(
        [&](auto field) {
            const auto& value = values.*field;
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::string>)
                result.text = value;
            else if constexpr (std::is_same_v<Value, std::vector<double>>)
                result.numbers = value;
            else
                result.numbers = {static_cast<double>(value)};
        },
        parameter.field);
    return result;
}

/// "Wind speed now. Unit m/s, range 0.1 to 30 m/s."
std::string documentationOf(const SmartParameter& parameter) {
    std::string text(parameter.help);
    if (!parameter.unit.empty())
        text.append(" Unit ").append(parameter.unit).append(".");
    if (parameter.kind == KarmaKind::number)
        text.append(" Range: ").append(parameter.range).append(".");
    return text;
}

} // namespace

std::string valueText(const SmartParameter& parameter, const AtmosphereSmartParameters& values) {
    const KarmaParameter found = karmaOf(parameter, values);
    std::string text = found.text;
    for (const double number : found.numbers)
        text += (text.empty() ? "" : " ") + numberText(number);
    return text;
}

std::vector<Diagnostic> rangeDiagnosticsOf(const SmartParameter& parameter,
                                           const AtmosphereSmartParameters& values) {
    std::vector<Diagnostic> diagnostics;
    const auto check = [&](double value) {
        if (!(std::isfinite(value) && parameter.allows(value)))
            diagnostics.push_back({"", std::string(parameter.name),
                                   withUnit(numberText(value), parameter.unit),
                                   std::string(parameter.range)});
    };
    std::visit(
        [&](auto field) {
            const auto& value = values.*field;
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::vector<double>>)
                std::ranges::for_each(value, check);
            else if constexpr (!std::is_same_v<Value, std::string>)
                check(static_cast<double>(value));
        },
        parameter.field);
    return diagnostics;
}

std::vector<Diagnostic> diagnosticsOf(const AtmosphereSmartParameters& parameters) {
    return Check(parameters).run();
}

std::vector<std::string> remarksOn(const AtmosphereSmartParameters& parameters) {
    std::vector<std::string> remarks;
    const S defaults;
    const auto report = smartParameters();
    const auto unused = [&](std::string_view name, const char* why) {
        const auto row = std::ranges::find(report, name, &SmartParameter::name);
        const std::string value = valueText(*row, parameters);
        if (value != valueText(*row, defaults))
            remarks.push_back(std::string(name) + " " + withUnit(value, row->unit) +
                              " has no effect" + why);
    };
    if (parameters.meteoModel != 2)
        for (const char* name : {"MeasurementHeight", "PressureMH", "RelativeHumidityMH",
                                 "TemperatureALT0", "TemperatureMH"})
            unused(name, " in MeteoModel 1");
    if (parameters.cloudModel == 0)
        for (const char* name : {"CloudBaseAltitude", "CloudExtinction", "CloudThickness"})
            unused(name, " without a cloud (CloudModel 0)");
    const bool navy = parameters.aerosolModel == 3;
    const bool windy = navy || parameters.aerosolModel == 7;
    if (!navy)
        for (const char* name : {"AirMass", "WindSpeedAverage24"})
            unused(name, " without the Navy maritime aerosol (AerosolModel 3)");
    if (!windy)
        for (const char* name : {"WindSpeed", "WindSpeedMeasurementHeight"})
            unused(name, " without the Navy maritime or desert aerosol (AerosolModel 3 or 7)");
    unused("WindDirection", ": the air is the same in all directions");
    return remarks;
}

SmartReading fromKarma(const KarmaXml& document) {
    if (document.typeName() != "AtmosphereSmart")
        throw InputError(document.diagnostic("type", "'" + document.type() + "'",
                                             "a type that ends in /AtmosphereSmart"));
    SmartReading reading;
    std::vector<Diagnostic> diagnostics;
    ValueReader reader(document, diagnostics);
    for (const SmartParameter& parameter : smartParameters())
        if (const KarmaParameter* found = document.find(parameter.name))
            reader.read(parameter, *found, reading.parameters);
        else
            reading.remarks.push_back(
                "no " + std::string(parameter.name) + ": taken as " +
                withUnit(valueText(parameter, reading.parameters), parameter.unit));
    for (const SmartParameter& parameter : ownSmartParameters())
        if (const KarmaParameter* found = document.find(parameter.name))
            reader.read(parameter, *found, reading.parameters);

    // What could not be read keeps its default, so that the rest can still be checked.
    for (const Diagnostic& diagnostic : diagnosticsOf(reading.parameters)) {
        const KarmaParameter* found = document.find(diagnostic.position);
        diagnostics.push_back(
            found ? document.diagnostic(*found, diagnostic.value, diagnostic.expected)
                  : document.diagnostic("parameter " + diagnostic.position + " (default)",
                                        diagnostic.value, diagnostic.expected));
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    for (const KarmaParameter& found : document.parameters()) {
        const auto isKnown = [&](std::span<const SmartParameter> table) {
            return std::ranges::find(table, found.name, &SmartParameter::name) != table.end();
        };
        if (!isKnown(smartParameters()) && !isKnown(ownSmartParameters()))
            reading.remarks.push_back("line " + std::to_string(found.line) + ": " + found.name +
                                      " is no parameter of AtmosphereSmart; it is kept and has no "
                                      "effect");
    }
    std::ranges::move(remarksOn(reading.parameters), std::back_inserter(reading.remarks));
    return reading;
}

void toKarma(const AtmosphereSmartParameters& parameters, KarmaXml& document) {
    const auto write = [&](const SmartParameter& parameter) {
        KarmaParameter value = karmaOf(parameter, parameters);
        if (!document.find(parameter.name))
            value.documentation = documentationOf(parameter);
        document.set(value);
    };
    std::ranges::for_each(smartParameters(), write);
    const AtmosphereSmartParameters defaults;
    for (const SmartParameter& parameter : ownSmartParameters())
        if (valueText(parameter, parameters) != valueText(parameter, defaults))
            write(parameter);
        else
            document.remove(parameter.name);
}

KarmaXml toKarma(const AtmosphereSmartParameters& parameters, const std::string& documentation) {
    KarmaXml document("/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart", documentation);
    toKarma(parameters, document);
    return document;
}

} // namespace irsg
