#include "judge/corpus.h"

#include <algorithm>
#include <boost/property_tree/json_parser.hpp>
#include <filesystem>
#include <iterator>

#include "geometry/shapes.h"

namespace evenload::corpus {
namespace {

using boost::property_tree::ptree;

std::filesystem::path folder() {
  return std::filesystem::path(EVENLOAD_SOURCE_DIR) / "tests" / "corpus";
}

std::vector<double> numbers(const ptree& list) {
  std::vector<double> result;
  for (const auto& [key, value] : list) result.push_back(value.get_value<double>());
  return result;
}

Curve chain(const ptree& list, bool open) {
  std::vector<Vertex> vertices;
  for (const auto& [key, value] : list) {
    const std::vector<double> v = numbers(value);
    vertices.push_back({{v.at(0), v.at(1)}, v.at(2), open});
  }
  return Curve(std::move(vertices), true);
}

}  // namespace

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder()))
    if (entry.path().extension() == ".json") result.push_back(entry.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> clearable() {
  std::vector<std::string> result = names();
  std::erase(result, "too_small");
  return result;
}

Case load(const std::string& name) {
  ptree tree;
  boost::property_tree::read_json((folder() / (name + ".json")).string(), tree);
  Case result;
  result.name = tree.get<std::string>("name");
  result.tool_diameter = tree.get<double>("tool");
  result.engagement_angle = tree.get<double>("engagement_deg") * kPi / 180;
  result.axial_depth = tree.get<double>("axial_depth");
  result.feed = tree.get<double>("feed");
  result.link_feed = tree.get<double>("link_feed");
  result.maximum_feed = tree.get<double>("max_feed");
  result.roll_radius = tree.get<double>("roll_radius");
  std::vector<Curve> islands;
  for (const auto& [key, value] : tree.get_child("islands")) islands.push_back(chain(value, false));
  result.region = make_region(chain(tree.get_child("outer"), tree.get("open", false)), islands);
  if (const auto hole = tree.get_child_optional("hole")) {
    const std::vector<double> v = numbers(*hole);
    result.hole = Hole{{v.at(0), v.at(1)}, v.at(2)};
  }
  return result;
}

ClearingParams Case::params() const {
  ClearingParams p;
  p.tool_diameter = tool_diameter;
  p.engagement_angle = engagement_angle;
  p.feed_control = FeedControl::kConstantRemovalRate;
  p.feed = p.plunge_feed = feed;
  p.link_feed = link_feed;
  p.maximum_feed = maximum_feed;
  p.roll_radius = roll_radius;
  p.minimum_radius = 0.15 * tool_diameter;
  p.helix_diameter = 0.9 * tool_diameter;
  p.levels = {-axial_depth};
  if (hole) {
    p.entry = EntryKind::kPredrilledHole;
    p.entry_point = hole->centre;
    p.hole_diameter = hole->diameter;
  }
  return p;
}

Case moved(const Case& original, double angle, bool mirrored, Vec2 shift) {
  Case result = original;
  result.region = shapes::moved(original.region, angle, mirrored, 1, shift);
  if (result.hole)
    result.hole->centre = shapes::moved(original.hole->centre, angle, mirrored, 1, shift);
  return result;
}

}  // namespace evenload::corpus
