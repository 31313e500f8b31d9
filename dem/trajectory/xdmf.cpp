#include "dem/trajectory/xdmf.hpp"

#include <fmt/format.h>

#include "dem/files/xml.hpp"
#include "dem/trajectory/output_fields.hpp"

namespace fiberchain::dem {
namespace {

/// Of one frame, `width` numbers a sphere, out of a dataset of all frames.
std::string slab(const std::string& file, const char* path, int width, int bytes, std::size_t frame,
                 std::size_t frames, std::size_t spheres) {
  const bool scalar = width == 1;
  const std::string size = scalar ? fmt::format("{}", spheres) : fmt::format("{} {}", spheres, width);
  return fmt::format(
      "<DataItem ItemType=\"HyperSlab\" Dimensions=\"{0}\"><DataItem Dimensions=\"3 {1}\" Format=\"XML\">{2} "
      "{3} {0}"
      "</DataItem><DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"{4}\" Dimensions=\"{5} {0}\">{6}:"
      "/particles/fibers/{7}/value</DataItem></DataItem>",
      size, scalar ? 2 : 3, frame, scalar ? "0 1 1 1" : "0 0 1 1 1 1", bytes, frames, file, path);
}

std::string grid(const std::string& file, double time, std::size_t frame, std::size_t frames,
                 std::size_t spheres) {
  std::string text = fmt::format("<Grid Name=\"fibers\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n", time);
  text += fmt::format(
      "<Topology TopologyType=\"Polyvertex\" NodesPerElement=\"{}\" NumberOfElements=\"1\"/>\n", spheres);
  text += fmt::format("<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                      slab(file, "position", 3, 8, frame, frames, spheres));
  for (const OutputField& field : sphere_fields) {
    text += fmt::format("<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                        field.name, field.width == 1 ? "Scalar" : "Vector",
                        slab(file, field.name, field.width, 4, frame, frames, spheres));
  }
  for (const auto& [name, kind, bytes] : {std::tuple{"radius", "Float", 8}, std::tuple{"fiber", "Int", 4}}) {
    text += fmt::format(
        "<Attribute Name=\"{0}\" AttributeType=\"Scalar\" Center=\"Node\"><DataItem Format=\"HDF\" "
        "NumberType=\"{1}\" "
        "Precision=\"{2}\" Dimensions=\"{3}\">{4}:/particles/fibers/{0}</DataItem></Attribute>\n",
        name, kind, bytes, spheres, file);
  }
  return text + "</Grid>\n";
}

}  // namespace

std::string xdmf(const std::string& file, const std::vector<double>& times, std::size_t spheres) {
  const std::string safe = xml_escaped(file);
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n<Grid Name=\"frames\" "
      "GridType=\"Collection\" "
      "CollectionType=\"Temporal\">\n";
  for (std::size_t i = 0; i < times.size(); ++i) text += grid(safe, times[i], i, times.size(), spheres);
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace fiberchain::dem
