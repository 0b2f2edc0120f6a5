#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/PlacingOptions.h"
#include "smatcore/project/ModelFields.h"

namespace smat::batch {

/// The options of a command that says something of one model of a project: name, database, how its
/// file is placed and what stands in for codes without an entry, and everything of modelFields().
class ModelOptions {
  public:
    explicit ModelOptions(CLI::App& command);

    /// Does to the model what was given. Throws InputError with every diagnostic.
    void apply(Project& project, std::size_t model) const;
    bool areGiven() const;

  private:
    struct Given {
        const ModelField* field;
        std::string text;
    };
    std::string name_, database_, referencePoint_, fallbackTemperature_, fallbackMaterial_;
    CLI::Option* databaseOption_ = nullptr;
    PlacingOptions placing_;
    std::vector<std::unique_ptr<Given>> fields_; ///< the parser keeps pointers into them
};

} // namespace smat::batch
