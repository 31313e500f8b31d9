#include "compare/render/ray_trace.hpp"

#include <tachyon.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <thread>

namespace fiberchain::compare {
namespace {

constexpr double kVerticalField = 30 * std::numbers::pi / 180;  ///< angle of view [rad]
constexpr double kMargin = 1.03;
constexpr int kSamples = 3;  ///< more than one a pixel

apivector vector(const Point& p) { return rt_vector(p[0], p[1], p[2]); }
Point unit(const Point& p) { return 1 / norm(p) * p; }

struct Camera {
  Point place, forward, up;
};

std::vector<Point> corners(const Solids& solids) {
  std::vector<Point> all;
  for (int i = 0; i < 8; ++i) {
    all.push_back({i & 1 ? solids.high[0] : solids.low[0], i & 2 ? solids.high[1] : solids.low[1],
                   i & 4 ? solids.high[2] : solids.low[2]});
  }
  return all;
}

/// Looking at `target` from `back`, as near as it can be with every corner within the field of view; `off` is
/// how far the corners' middle is beside the middle of the picture, across the view through the target.
Camera camera_at(const Solids& solids, const Point& target, const Point& back, const Point& right,
                 double aspect, Point& off) {
  const Point up = cross(back, right);
  const double tall = std::tan(kVerticalField / 2) / kMargin, wide = aspect * tall;
  double distance = 0;
  for (const Point& corner : corners(solids)) {
    const Point p = corner - target;
    distance = std::max({distance, dot(p, back) + std::abs(dot(p, right)) / wide,
                         dot(p, back) + std::abs(dot(p, up)) / tall});
  }
  double left = 0, most_right = 0, below = 0, above = 0;
  for (const Point& corner : corners(solids)) {
    const Point p = corner - target;
    const double scale = distance / (distance - dot(p, back));
    left = std::min(left, scale * dot(p, right));
    most_right = std::max(most_right, scale * dot(p, right));
    below = std::min(below, scale * dot(p, up));
    above = std::max(above, scale * dot(p, up));
  }
  off = (left + most_right) / 2 * right + (below + above) / 2 * up;
  return {target + distance * back, -1.0 * back, up};
}

/// The box in the middle of the picture, as large as it can be.
Camera camera_of(const Solids& solids, const View& view, double aspect) {
  const double a = view.azimuth * std::numbers::pi / 180, e = view.elevation * std::numbers::pi / 180;
  const Point back = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  const Point right = {-std::sin(a), std::cos(a), 0};
  Point target = 0.5 * (solids.low + solids.high), off;
  Camera camera = camera_at(solids, target, back, right, aspect, off);
  for (int i = 0; i < 20; ++i) {
    target = target + off;
    camera = camera_at(solids, target, back, right, aspect, off);
  }
  return camera;
}

void* texture(SceneHandle scene, const Color& color, double ambient, double diffuse, double specular,
              double opacity = 1) {
  apitexture all{};
  all.texturefunc = RT_TEXTURE_CONSTANT;
  all.col = rt_color(color.red, color.green, color.blue);
  all.shadowcast = opacity == 1 ? 1 : 0;
  all.ambient = ambient;
  all.diffuse = diffuse;
  all.specular = specular;
  all.opacity = opacity;
  void* made = rt_texture(scene, &all);
  return made;
}

void add_rods(SceneHandle scene, const Solids& solids) {
  std::vector<void*> textures;
  for (const Color& color : solids.palette) {
    textures.push_back(texture(scene, color, 0.42, 0.62, 0));
    rt_tex_phong(textures.back(), 0.12, 30, RT_PHONG_PLASTIC);
  }
  for (const Rod& rod : solids.rods) {
    void* const look = textures[static_cast<std::size_t>(rod.color)];
    const Point axis = rod.to - rod.from;
    if (norm(axis) > 0) {
      rt_fcylinder(scene, look, vector(rod.from), vector(axis), rod.radius);
    } else {
      rt_sphere(scene, look, vector(rod.from), rod.radius);
    }
  }
}

void add_triangles(SceneHandle scene, void* look, const std::vector<std::array<Point, 3>>& triangles,
                   const Point& shift) {
  for (const auto& t : triangles)
    rt_tri(scene, look, vector(t[0] + shift), vector(t[1] + shift), vector(t[2] + shift));
}

/// Edges of the box as thin bars, and its floor where nothing else is one.
void add_box(SceneHandle scene, const Solids& solids) {
  const std::vector<Point> all = corners(solids);
  const double thin = 0.0012 * norm(solids.high - solids.low);
  void* const bar = texture(scene, {0.45f, 0.45f, 0.45f}, 0.8, 0.2, 0);
  for (unsigned i = 0; solids.box && i < 8; ++i) {
    for (unsigned k = 1; k < 8; k *= 2) {
      if (!(i & k)) rt_fcylinder(scene, bar, vector(all[i]), vector(all[i | k] - all[i]), thin);
    }
  }
  void* const floor = texture(scene, {0.93f, 0.93f, 0.93f}, 0.45, 0.55, 0);
  const Point below{0, 0, -thin};
  add_triangles(scene, floor, solids.floor, below);
  if (solids.facets.empty() && solids.floor.empty())
    add_triangles(scene, floor, {{all[0], all[1], all[3]}, {all[0], all[3], all[2]}}, below);
}

/// Walls as panes in frames. Tachyon adds a pane's own light to what comes through it.
void add_walls(SceneHandle scene, const Solids& solids) {
  void* const pane = texture(scene, {0.40f, 0.52f, 0.70f}, 0.09, 0.06, 0, 0.14);
  add_triangles(scene, pane, solids.facets, {});
  const double thin = 0.0016 * norm(solids.high - solids.low);
  void* const bar = texture(scene, {0.25f, 0.30f, 0.38f}, 0.8, 0.2, 0);
  for (const auto& [from, to] : solids.edges) {
    if (norm(to - from) > 0) rt_fcylinder(scene, bar, vector(from), vector(to - from), thin);
  }
}

/// With more threads than processors Tachyon's wait for each other without end.
int usable_threads(int asked) {
  const auto there = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(asked, 1, std::max(there, 1));
}

/// From above, over the camera's left shoulder.
void add_lights(SceneHandle scene, const Camera& camera) {
  const Point right = cross(camera.forward, camera.up), down = {0, 0, -1};
  void* const light = texture(scene, {1, 1, 1}, 1, 1, 0);
  rt_directional_light(scene, light, vector(unit(camera.forward + 0.5 * right + 1.2 * down)));
}

/// Tachyon begins with the lowest row.
void turn_over(Image& image) {
  const auto row = 3 * static_cast<std::ptrdiff_t>(image.width);
  for (auto top = image.rgb.begin(), bottom = image.rgb.end() - row; top < bottom; top += row, bottom -= row)
    std::swap_ranges(top, top + row, bottom);
}

/// Tachyon's library is one for the program; it is begun once and says nothing.
void begin_tachyon() {
  static std::once_flag once;
  std::call_once(once, [] {
    static char name[] = "fiberchain";
    static char* arguments[] = {name, nullptr};
    int count = 1;
    char** list = arguments;
    rt_initialize(&count, &list);
    rt_set_ui_message([](int, char*) {});
    rt_set_ui_progress([](int) {});
  });
}

}  // namespace

Image ray_trace(const Solids& solids, const View& view, int width, int height, int threads) {
  begin_tachyon();
  const std::unique_ptr<void, void (*)(SceneHandle)> owner(rt_newscene(), &rt_deletescene);
  const SceneHandle scene = owner.get();
  Image image{
      width, height,
      std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  const double aspect = static_cast<double>(width) / height;
  const Camera camera = camera_of(solids, view, aspect);
  rt_verbose(scene, 0);
  rt_set_numthreads(scene, usable_threads(threads));
  rt_resolution(scene, width, height);
  rt_aspectratio(scene, 1);
  rt_aa_maxsamples(scene, kSamples);
  rt_rawimage_rgb24(scene, image.rgb.data());
  rt_background(scene, rt_color(1, 1, 1));
  rt_shadermode(scene, RT_SHADER_FULL);
  rt_phong_shader(scene, RT_SHADER_BLINN);
  rt_boundmode(scene, RT_BOUNDING_ENABLED);
  rt_image_clamp(scene);
  rt_camera_projection(scene, RT_PROJECTION_PERSPECTIVE);
  rt_camera_raydepth(scene, 24);  // panes behind each other
  rt_camera_position(scene, vector(camera.place), vector(camera.forward), vector(camera.up));
  rt_camera_zoom(scene, 0.5 / std::tan(kVerticalField / 2));  // at zoom 1 the view is as high as far
  add_rods(scene, solids);
  add_box(scene, solids);
  add_walls(scene, solids);
  add_lights(scene, camera);
  rt_renderscene(scene);
  turn_over(image);
  return image;
}

}  // namespace fiberchain::compare
