#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tools/samples/ModelWriter.h"

namespace smat {

/// A smooth curve through points of ascending x that has no maximum between them (monotone cubic
/// interpolation after Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980). Constant outside.
class Curve {
  public:
    struct Knot {
        double x, y;
    };
    Curve(std::initializer_list<Knot> knots);
    double operator()(double x) const;

  private:
    std::vector<Knot> knots_;
    std::vector<double> slopes_;
};

/// Edges of cells from `first` to `last`, about `step` apart, with every one of `marks` that lies
/// between among them. Ascending.
std::vector<double> edges(double first, double last, double step,
                          std::span<const double> marks = {});
/// Edges that lie closer at both ends, as the cosine has them.
std::vector<double> roundedEdges(double first, double last, int cells);

/// A smooth surface over two parameters, m.
using Shape = std::function<irsg::Vec3(double u, double v)>;
/// The surface of a cell by its middle; null where there is none.
using SurfaceAt = std::function<const FlightSurface*(double u, double v)>;

/// Writes the cells of a surface between these edges, each kind of surface as a mesh of its own
/// with the surface's true normals. Its front is on the side of du x dv.
void addPatch(ModelWriter& writer, const Shape& shape, std::span<const double> us,
              std::span<const double> vs, const SurfaceAt& surfaceAt);
/// The same of one kind of surface.
void addPatch(ModelWriter& writer, const Shape& shape, std::span<const double> us,
              std::span<const double> vs, const FlightSurface& surface);

/// Writes an ellipsoid with its poles on y, of so many rings and segments.
void addEllipsoid(ModelWriter& writer, const irsg::Vec3& centre, const irsg::Vec3& radii,
                  const FlightSurface& surface, int rings, int segments);

} // namespace smat
