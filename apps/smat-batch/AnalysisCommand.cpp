#include "apps/smat-batch/Analyses.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"

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
        command.add_flag("--dry-run", dryRun_, "Say what would be drawn, and stop");
        if (kind->form == AnalysisForm::sweep) {
            command
                .add_option("--shard", shard_,
                            "Draw one part of the sweep, 2/4 for the second of four, into "
                            "FILE.part2of4; smat-batch merge joins the parts")
                ->type_name("I/N");
            command.add_flag("--resume", resumes_,
                             "Go on with a run that was ended before it was done");
        }
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
            const Project project = project_.load();
            job.data = started(project);
            job.data.settings = job.data.settings.with(given);
        }
        job.data.commandLine = context.commandLine;
        job.files.assign(files_.begin(), files_.end());
        if (!shard_.empty())
            job.share = CaseShare::fromText(shard_, "--shard");
        job.resumes = resumes_;
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
    std::string shard_;
    bool resumes_ = false, dryRun_ = false;
};

} // namespace

void addAnalysisCommands(CLI::App& app, Context& context) {
    for (const AnalysisKind kind : allAnalysisKinds())
        addCommand<AnalysisCommand>(app, context, kind, kind);
}

} // namespace smat::batch
