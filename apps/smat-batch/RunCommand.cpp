#include <algorithm>

#include "apps/smat-batch/Analyses.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/Folders.h"

namespace smat::batch {

namespace {

/// `smat-batch run PROJECT --out DIR`: the analyses a project names.
class RunCommand {
  public:
    explicit RunCommand(CLI::App& command) : project_(command), settings_(command, std::nullopt) {
        command.add_option("--analysis", names_, "Only this one; may be given more than once")
            ->type_name("NAME")
            ->expected(1)
            ->take_all();
        command.add_option("--out", folder_, "Folder for the results; made where it is missing")
            ->type_name("DIR");
        addDryRun(command, dryRun_);
    }

    int run(Context& context) const {
        if (!dryRun_)
            checkFolderGiven(folder_, "the results");
        std::vector<Job> jobs;
        {
            const StageTimer::Scope scope(&context.timer, "load");
            const Settings given = settings_.values();
            Project project = project_.load();
            settings_.place(project);
            jobs = jobsOf(project, given, context);
        }
        if (dryRun_) {
            if (!folder_.empty())
                checkFolder(folder_, "the results");
            // Of a folder that is still to be made no file is in the way.
            if (!std::filesystem::exists(folder_))
                for (Job& job : jobs)
                    job.files.clear();
            return describeJobs(jobs, context);
        }
        makeFolder(folder_, "the results");
        return runJobs(jobs, context);
    }

  private:
    std::vector<Job> jobsOf(const Project& project, const Settings& given,
                            const Context& context) const {
        std::vector<std::string> names = names_;
        if (names.empty())
            for (const NamedAnalysis& analysis : project.analyses)
                names.push_back(analysis.name);
        if (names.empty()) {
            throw irsg::InputError(irsg::Diagnostic{.file = project.displayName(),
                                                    .position = "analyses",
                                                    .value = "none",
                                                    .expected = "at least one named analysis"});
        }
        std::vector<Job> jobs;
        for (const std::string& one : names) {
            Job job;
            job.data = AnalysisData::of(project, one);
            job.data.settings = job.data.settings.with(given);
            settings_.requireNamed(job.data.settings);
            job.data.commandLine = context.commandLine;
            for (const std::string& extension : usualResultExtensions(job.data.kind))
                job.files.push_back(std::filesystem::path(folder_) / (one + extension));
            jobs.push_back(std::move(job));
        }
        return jobs;
    }

    ProjectInput project_;
    SettingOptions settings_;
    std::vector<std::string> names_;
    std::string folder_;
    bool dryRun_ = false;
};

} // namespace

void addRunCommand(CLI::App& app, Context& context) {
    addCommand<RunCommand>(app, context, "run", "The analyses a project names, or some of them");
}

} // namespace smat::batch
