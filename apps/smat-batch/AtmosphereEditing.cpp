#include "apps/smat-batch/AtmosphereEditing.h"

#include <utility>

#include "irsg/atmosphere/SmartParameterText.h"
#include "irsg/core/FileReading.h"
#include "irsg/karma/KarmaXml.h"

namespace smat::batch {

namespace {

/// Assigns all, or throws what is wrong with them.
void assign(irsg::AtmosphereSmartParameters& parameters,
            const std::vector<std::string>& assignments) {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals == 0 || equals == std::string::npos) {
            diagnostics.push_back({"command line", "", "'" + assignment + "'",
                                   "NAME=VALUE, such as Visibility=5000"});
            continue;
        }
        setFromText(parameters, assignment.substr(0, equals), assignment.substr(equals + 1),
                    diagnostics);
    }
    if (diagnostics.empty())
        diagnostics = diagnosticsOf(parameters);
    for (irsg::Diagnostic& diagnostic : diagnostics)
        diagnostic.file = "command line";
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

} // namespace

void writeNewAtmosphere(const std::vector<std::string>& assignments, const std::string& out) {
    irsg::AtmosphereSmartParameters parameters;
    assign(parameters, assignments);
    toKarma(parameters).write(out);
}

void changeAtmosphere(const std::string& file, const std::vector<std::string>& assignments,
                      const std::string& out) {
    irsg::KarmaXml document = irsg::KarmaXml::read(file);
    irsg::AtmosphereSmartParameters parameters = irsg::fromKarma(document).parameters;
    assign(parameters, assignments);
    toKarma(parameters, document);
    if (out.empty())
        irsg::allowChange(file);
    document.write(out.empty() ? file : out);
}

} // namespace smat::batch
