#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Matrix4.h"

namespace irsg {

struct LoadedGraph;
struct ModelCodes;

/// A loaded model: its mesh with the codes of its surfaces, in the axes of this program (x
/// starboard, y nose, z up). Two loads of a file give equal meshes.
class Model {
  public:
    /// Loads .flt, .osgt, .osgb, .ive and the other models of OpenableFiles.h. An OpenFlight file
    /// is validated by the record scanner first. Throws InputError for a file that is missing,
    /// truncated, malformed (with the byte offset), unreadable or without faces.
    static std::shared_ptr<Model> load(const std::filesystem::path& file,
                                       const ModelOptions& options = {});
    /// The same of what was read already (loadGraphAsIs) or made in memory, with these codes beside
    /// it; the graph is left as it is, and nobody else may use it meanwhile.
    static std::shared_ptr<Model> ofGraph(const LoadedGraph& asIs, const ModelCodes& codes,
                                          const std::filesystem::path& file,
                                          const ModelOptions& options = {});
    ~Model();

    const std::string& name() const;
    const std::filesystem::path& file() const;
    /// Never null.
    const std::shared_ptr<const Mesh>& mesh() const;
    const std::map<IrCodes, CodeUse>& codes() const;
    /// What was given beside those of the file; never null.
    const std::shared_ptr<const ModelCodes>& codesBeside() const;
    /// Of all geometry, model axes.
    const BoundingBox& bounds() const;
    /// Of the geometry whose codes are wanted; not valid() where there is none.
    BoundingBox boundsOf(const std::function<bool(const IrCodes&)>& wanted) const;
    /// What the loader had to do or could not keep: LODs overridden, normals made, files missing.
    const std::vector<std::string>& remarks() const;

    /// Where the order of its file decides what is drawn; the largest first.
    const std::vector<SharedPlane>& sharedPlanes() const;
    /// As the model was read, up, nose and unit set; the origin where it was asked for.
    const ModelPlacing& placing() const;
    /// Leads from the axes and the unit of the file to model axes.
    const Matrix4& fromFile() const;

  private:
    struct Impl;
    explicit Model(std::unique_ptr<Impl> parts);
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
