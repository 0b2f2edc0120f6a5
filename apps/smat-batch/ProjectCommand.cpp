#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/ModelOptions.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "apps/smat-batch/SettingOptions.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/model/Model.h"
#include "smatcore/project/FileCollection.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneModels.h"
#include "smatcore/simulate/CollectScenario.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat::batch {

namespace {

nlohmann::ordered_json jsonOf(const Project& project) {
    nlohmann::ordered_json models = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const ProjectModel& model = project.models[i];
        nlohmann::ordered_json one{{"number", i},
                                   {"name", model.shownName()},
                                   {"file", model.file.string()},
                                   {"database", model.database.string()}};
        for (const ModelField& field : modelFields()) {
            const std::string text = textOf(project, i, field);
            const auto number = irsg::parseNumber(text);
            one[field.key] = number                   ? nlohmann::ordered_json(*number)
                             : text.empty() && i == 0 ? nlohmann::ordered_json(0.0)
                                                      : nlohmann::ordered_json(text);
        }
        models.push_back(std::move(one));
    }
    return {{"file", project.file.string()}, {"title", project.title}, {"models", models}};
}

int show(const Project& project, const Context& context) {
    if (context.json) {
        fmt::print("{}\n", jsonText(jsonOf(project)));
        return done;
    }
    fmt::print("{}: {} model{}\n", project.file.string(), project.models.size(),
               project.models.size() == 1 ? "" : "s");
    std::size_t widest = 6;
    for (const ProjectModel& model : project.models)
        widest = std::max(widest, model.shownName().size());
    fmt::print("  {:>3}  {:<{}}", "no.", "name", widest);
    for (const ModelField& field : modelFields())
        if (field.key != "yaw")
            fmt::print("  {:>10}", field.key == "timeOffset" ? "offset" : field.key);
    fmt::print("  file, database\n");
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const ProjectModel& model = project.models[i];
        fmt::print("  {:>3}  {:<{}}", i, model.shownName(), widest);
        for (const ModelField& field : modelFields()) {
            const std::string text = textOf(project, i, field);
            if (field.key != "yaw")
                fmt::print("  {:>10}", text.empty() ? "0" : text);
        }
        fmt::print("  {}, {}\n", model.file.string(),
                   model.database.empty() ? "no database" : model.database.string());
    }
    return done;
}

/// What the commands that change a project share: its file, and that it is written and shown.
class ProjectChange {
  public:
    explicit ProjectChange(CLI::App& command) {
        command.add_option("PROJECT", file_, "Project file (.smat)")->required()->type_name("");
    }
    virtual ~ProjectChange() = default;
    int run(Context& context) const {
        Project project = begin();
        change(project);
        irsg::allowChange(file_);
        saveProject(project, file_);
        // As it is read: with paths that are told from its folder.
        return show(openProject(file_), context);
    }

  protected:
    const std::string& file() const { return file_; }
    virtual Project begin() const { return openProject(file_); }
    virtual void change(Project& project) const = 0;

  private:
    std::string file_;
};

/// The model that a change is about.
class ModelChange : public ProjectChange {
  public:
    explicit ModelChange(CLI::App& command, const std::string& help) : ProjectChange(command) {
        command.add_option("MODEL", model_, help)->required()->type_name("");
    }

  protected:
    std::string model_;
};

constexpr const char* nameOrNumber = "Its name, or its number, 0 for the target";

class NewCommand : public ModelChange {
  public:
    explicit NewCommand(CLI::App& command)
        : ModelChange(command, "File of the model that becomes the target"),
          options_(command),
          settings_(command, [](const SettingInfo&) { return false; }) {
        command.add_option("--title", title_, "Title of the project")->type_name("TEXT");
    }

  private:
    Project begin() const override {
        if (std::filesystem::path(file()).extension() != ".smat")
            throw refusal("PROJECT", file(), "a name that ends in .smat");
        if (std::filesystem::exists(file()))
            throw refusal("PROJECT", file() + ", which exists",
                          "a new file; project add and project set change one that exists");
        Project project = projectOfModel(std::filesystem::absolute(model_).lexically_normal());
        project.file = std::filesystem::absolute(file()).lexically_normal();
        return project;
    }
    void change(Project& project) const override {
        if (!title_.empty())
            project.title = title_;
        project.settings = project.settings.with(settings_.values());
        options_.apply(project, 0);
        irsg::Model::load(project.models.front().file, project.models.front().options);
    }

    ModelOptions options_;
    SettingOptions settings_;
    std::string title_;
};

class AddCommand : public ModelChange {
  public:
    explicit AddCommand(CLI::App& command)
        : ModelChange(command, "File of the model"), options_(command) {
        command.footer("Without --east it stands east of all others, at the altitude and with the "
                       "heading of the target.");
    }

  private:
    void change(Project& project) const override {
        const auto file = std::filesystem::absolute(model_).lexically_normal();
        // Read as the options say, so that its size is right.
        Project alone = projectOfModel(file);
        alone.models.push_back(alone.models.front());
        options_.apply(alone, 1);
        std::vector<double> radii_m;
        for (const ProjectModel& model : project.models)
            radii_m.push_back(
                reachOf(*irsg::Model::load(project.resolve(model.file), model.options)));
        radii_m.push_back(reachOf(*irsg::Model::load(file, alone.models[1].options)));
        project.models.push_back(besideOthers(project, file, radii_m));
        options_.apply(project, project.models.size() - 1);
    }

    ModelOptions options_;
};

class SetCommand : public ModelChange {
  public:
    explicit SetCommand(CLI::App& command)
        : ModelChange(command, nameOrNumber),
          options_(command),
          settings_(command, [](const SettingInfo&) { return false; }) {}

  private:
    void change(Project& project) const override {
        const std::size_t model = findModel(project, model_, "MODEL");
        const Settings given = settings_.values();
        if (!options_.areGiven() && given.values().empty())
            throw refusal("project set", "nothing to set",
                          "an option of the model, or --set key=value");
        project.settings = project.settings.with(given);
        options_.apply(project, model);
    }

    ModelOptions options_;
    SettingOptions settings_;
};

class RemoveCommand : public ModelChange {
  public:
    explicit RemoveCommand(CLI::App& command) : ModelChange(command, nameOrNumber) {}

  private:
    void change(Project& project) const override {
        removeModel(project, findModel(project, model_, "MODEL"));
    }
};

class TargetCommand : public ModelChange {
  public:
    explicit TargetCommand(CLI::App& command) : ModelChange(command, nameOrNumber) {}

  private:
    void change(Project& project) const override {
        makeTarget(project, findModel(project, model_, "MODEL"));
    }
};

class CollectCommand {
  public:
    explicit CollectCommand(CLI::App& command) {
        command.add_option("FILE", file_, "Project (.smat) or scenario (.json)")
            ->required()
            ->type_name("");
        command
            .add_option("COPY", copy_, "The copy; its files go into the folder NAME.files beside")
            ->required()
            ->type_name("");
    }
    int run(Context& context) const {
        if (std::filesystem::exists(copy_))
            throw refusal("COPY", copy_ + ", which exists", "a new file");
        FileCollection files(collectionFolder(copy_));
        if (isScenarioFile(file_))
            collectScenario(loadScenario(file_), copy_, &files);
        else
            collectProject(openProject(file_), copy_, &files);
        if (context.json) {
            nlohmann::ordered_json copies = nlohmann::ordered_json::array();
            for (const auto& [from, to] : files.copies())
                copies.push_back({{"from", from.string()}, {"to", to.string()}});
            const nlohmann::ordered_json all{
                {"file", copy_}, {"bytes", files.size_B()}, {"copies", std::move(copies)}};
            fmt::print("{}\n", jsonText(all));
            return done;
        }
        for (const auto& [from, to] : files.copies())
            fmt::print("{} <- {}\n", to.string(), from.string());
        fmt::print("{}: {} files, {:.1f} MB\n", copy_, files.copies().size(),
                   1e-6 * static_cast<double>(files.size_B()));
        return done;
    }

  private:
    std::string file_, copy_;
};

class InfoCommand {
  public:
    explicit InfoCommand(CLI::App& command) {
        command.add_option("PROJECT", file_, "Project file (.smat)")->required()->type_name("");
    }
    int run(Context& context) const { return show(openProject(file_), context); }

  private:
    std::string file_;
};

} // namespace

void addProjectCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("project", "Makes projects and puts models into them");
    command->require_subcommand(1);
    addCommand<InfoCommand>(*command, context, "info",
                            "Its models, where they stand, what they do");
    addCommand<CollectCommand>(*command, context, "collect",
                               "Copies a project or scenario with all files that it needs");
    addCommand<NewCommand>(*command, context, "new", "A new project of one model, its target");
    addCommand<AddCommand>(*command, context, "add", "Adds a model beside the others");
    addCommand<SetCommand>(*command, context, "set",
                           "Places a model, and sets its state, its database and its name");
    addCommand<RemoveCommand>(*command, context, "remove",
                              "Takes a model out; the next becomes the target where it is that");
    addCommand<TargetCommand>(*command, context, "target",
                              "Makes another model the target, the one the camera looks at; "
                              "nothing moves");
}

} // namespace smat::batch
