#include <optional>

#include "apps/smat-batch/Analyses.h"
#include "apps/smat-batch/PartOptions.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/ImageSensor.h"

namespace smat::batch {

namespace {

/// The command of one kind of analysis: `smat-batch polar PROJECT [options] --out FILE`.
class AnalysisCommand {
  public:
    AnalysisCommand(CLI::App& command, AnalysisKind kind)
        : kind_(kind), project_(command), settings_(command, kind) {
        command.add_option("--out", files_, "Result file; may be given more than once")
            ->type_name("FILE")
            ->expected(1)
            ->take_all();
        command.add_option("--analysis", analysis_, "Start from this analysis of the project")
            ->type_name("NAME");
        addDryRun(command, dryRun_);
        if (kind->form == AnalysisForm::sweep)
            parts_.emplace(command, "the sweep");
        if (kind->form == AnalysisForm::image) {
            command.footer("Several bands give a file each: FILE@3-5um.exr.");
        } else if (kind->form != AnalysisForm::spectrum) {
            command.footer(
                "Columns: where the case is, then the sums of all objects, then those of each "
                "object "
                "where there are several, as OBJECT.contrast_intensity, each at its own range "
                "OBJECT.range. Of several bands each column is there once a band, as "
                "contrast_intensity@3-5um. A second object of one name is NAME-2.");
        } else {
            command.footer("Columns: wavenumber and wavelength, then the sums of all objects, then "
                           "those of each object where there are several, as "
                           "OBJECT.spectral_contrast_intensity, each at its own range. One band.");
        }
    }

    int run(Context& context) const {
        if (files_.empty() && !dryRun_) {
            throw irsg::InputError(irsg::Diagnostic{.file = "--out",
                                                    .position = "",
                                                    .value = "nothing",
                                                    .expected = "a result file, such as --out " +
                                                                name(kind_) +
                                                                resultExtensions(kind_).front()});
        }
        Job job;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Settings given = settings_.values();
            Project project = project_.load();
            settings_.place(project);
            job.data = started(project);
            job.data.settings = job.data.settings.with(given);
            settings_.requireNamed(job.data.settings);
            refuseIdleOfSensor(job.data, given);
        }
        job.data.commandLine = context.commandLine;
        job.files.assign(files_.begin(), files_.end());
        if (parts_) {
            job.share = parts_->share();
            job.resumes = parts_->resumes();
        }
        return dryRun_ ? describeJobs({job}, context) : runJobs({job}, context);
    }

  private:
    AnalysisData started(const Project& project) const {
        if (analysis_.empty())
            return AnalysisData::of(project, kind_);
        AnalysisData data = AnalysisData::of(project, analysis_);
        if (data.kind != kind_) {
            throw irsg::InputError(
                irsg::Diagnostic{.file = "--analysis",
                                 .position = "",
                                 .value = analysis_ + ", which is of kind " + name(data.kind),
                                 .expected = "an analysis of kind " + name(kind_)});
        }
        return data;
    }

    AnalysisKind kind_;
    ProjectInput project_;
    SettingOptions settings_;
    std::vector<std::string> files_;
    std::string analysis_;
    std::optional<PartOptions> parts_;
    bool dryRun_ = false;
};

} // namespace

void addAnalysisCommands(CLI::App& app, Context& context) {
    for (const AnalysisKind kind : allAnalysisKinds())
        addCommand<AnalysisCommand>(app, context, kind, kind);
}

void addSweepCommands(CLI::App& app, Context& context) {
    for (const AnalysisKind kind : allAnalysisKinds())
        if (kind->form == AnalysisForm::sweep)
            addCommand<AnalysisCommand>(app, context, kind, kind);
}

} // namespace smat::batch
