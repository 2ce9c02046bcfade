#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// A patch as triangles (a surface), a chain of lines (a curve) or a point.
struct Tessellation {
  std::vector<Uv<double>> at;                           ///< parameters of the vertices
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< none for curves and points
};

/// `steps` ≥ 1 parts along each parameter.
Tessellation tessellate(const Shape& shape, int steps);

/// The lines of a control net: pairs of places of control points that are neighbours.
std::vector<std::array<std::uint32_t, 2>> net_lines(const Shape& shape);

/// The vertices of a tessellation at a time, in double precision.
Points<double> vertices_at(const MovingPatch<double>& patch, const Tessellation& mesh, double t);

/// Unit normals of the vertices: means of those of the triangles around each, by area.
/// Where there is none, (0, 0, 1).
Points<double> normals_of(const Tessellation& mesh, const Points<double>& vertices);

}  // namespace ccdfuzz
