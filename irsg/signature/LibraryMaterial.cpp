#include "irsg/signature/LibraryMaterial.h"

#include <optional>
#include <utility>

#include "irsg/core/BoundedValues.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"

namespace irsg {

void takeLibrarySpectrum(const LibrarySpectrum& library, const std::string& file,
                         Material& material) {
    using Quantity = LibrarySpectrum::Quantity;
    std::vector<Diagnostic> diagnostics;
    BoundedValues bounds(0.0, 1.0);
    Material read = material;
    for (const LibrarySpectrum::Column& column : library.columns) {
        const bool isIndex =
            column.quantity == Quantity::refractiveIndex || column.quantity == Quantity::extinction;
        std::vector<double> values;
        for (std::size_t i = 0; i < column.values.size(); ++i) {
            const std::string place = "line " + std::to_string(column.lines[i]);
            const double value = column.values[i];
            const auto taken = isIndex ? (value >= 0.0 ? std::optional(value) : std::nullopt)
                                       : bounds.take(value, place);
            if (!taken)
                diagnostics.push_back({file, place, numberText(value),
                                       isIndex ? "a value of at least 0" : "a value from 0 to 1"});
            values.push_back(taken.value_or(0.0));
        }
        if (!diagnostics.empty())
            continue;
        const auto spectrum = [&](std::vector<double> of) {
            return Spectrum(column.wavelengths_um, std::move(of), Spectrum::Outside::hold, file);
        };
        const auto fromOne = [](std::vector<double> of) {
            for (double& value : of)
                value = 1.0 - value;
            return of;
        };
        switch (column.quantity) {
        case Quantity::refractiveIndex:
            read.refractiveIndex = spectrum(std::move(values));
            break;
        case Quantity::extinction:
            read.extinction = spectrum(std::move(values));
            break;
        case Quantity::transmissivity:
            read.emissivity = spectrum(fromOne(values));
            read.transmissivity = spectrum(std::move(values));
            break;
        case Quantity::reflectivity:
        case Quantity::emissivity:
            read.transmissivity = Spectrum();
            read.emissivity =
                spectrum(column.quantity == Quantity::emissivity ? std::move(values)
                                                                 : fromOne(std::move(values)));
            break;
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    bounds.remark(file);
    remarkOn(file, "read as a spectrum of " + library.format +
                       (library.title.empty() ? "" : ", '" + library.title + "'"));
    material = std::move(read);
}

} // namespace irsg
