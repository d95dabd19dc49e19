// Shapes written to files by OpenCASCADE itself, to be read back.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>

namespace beadmesh::test {

/// A folder of its own that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// By ending: .step, .igs or .brep.
void write_shape(const TopoDS_Shape& shape, const std::filesystem::path& path);

void write_text(const std::filesystem::path& path, const std::string& text);
std::string read_text(const std::filesystem::path& path);

TopoDS_Shape box(double x, double y, double z);
TopoDS_Shape cylinder(double radius, double height);
TopoDS_Shape sphere(double radius);
TopoDS_Shape cone(double radius, double height);
TopoDS_Shape torus(double major, double minor);
/// 100 x 60 in the plane z = 0 with a round hole of so many edges in its middle.
TopoDS_Shape plate_with_hole(double radius = 10, int edges = 1);
/// Two squares of side 10 that touch along x = 10, each with an edge of its own there; the second one is
/// turned over.
TopoDS_Shape two_loose_squares();
/// A plane face bounded by (0,0) (10,10) (10,0) (0,10): the loop crosses itself.
TopoDS_Shape bow_tie();
/// z = 5 cos(pi x / 60) cos(pi y / 60) over |x|, |y| <= 30: a B-spline surface.
TopoDS_Shape dome();
/// Two walls of this length (to the outer corner) and width, at a right angle, with a bend of this outer
/// radius: a solid.
TopoDS_Shape bent_sheet(double length, double width, double radius, double thickness);
/// Two plates, the second one moved by 100 in x: one shape at two places.
TopoDS_Shape two_places();

}  // namespace beadmesh::test
