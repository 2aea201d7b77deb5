/// Closest-point and segment queries compared with CGAL's AABB tree and Embree: CSV rows on standard output.
///
///   contact_queries --panels 1e5
///
/// Query points lie within two edge lengths of the hull's surface, as in contact detection. Segments of half an edge length begin at the points
/// outside; the query is whether they intersect the surface. Times are medians over rounds in which all libraries alternate, on one thread.
/// `differs`: the largest difference from our distance [m], or the share of segments with a different result. perimpact and CGAL compute in double
/// precision, Embree traverses its tree in single precision. CGAL is under the GPL: only this program is built with it.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "fccda/detect/path_test.hpp"
#include "mesh/search/bvh.hpp"
#include "scene.hpp"

namespace {

using fccda::Vec3d;

struct Query {
  Vec3d point, end;
};

std::vector<Query> queries_near(const fccda::Surface& surface, std::size_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return normalised(Vec3d{x, y, z});
  };
  const double edge = std::sqrt(4 / std::sqrt(3.0) * surface.report().area / static_cast<double>(surface.triangles().size()));
  std::vector<Query> queries;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t t = random() % surface.triangles().size();
    const double u = unit(random), v = unit(random) * (1 - u);
    const Vec3d a = surface.corner(t, 0), place = a + u * (surface.corner(t, 1) - a) + v * (surface.corner(t, 2) - a);
    const Vec3d point = place + 2 * edge * unit(random) * direction();
    queries.push_back({point, point + 0.5 * edge * direction()});
  }
  return queries;
}

class Ours {
 public:
  static constexpr const char* name = "perimpact";
  explicit Ours(const fccda::Surface& surface) : bvh_(surface) {}
  double distance(const Query& q) { return bvh_.closest(q.point)->distance; }
  bool meets(const Query& q) {
    std::size_t tested = 0;
    return bvh_.first_hit(q.point, q.end, tested).has_value();
  }

 private:
  fccda::Bvh bvh_;
};

class Cgal {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

 public:
  static constexpr const char* name = "CGAL AABB_tree";
  explicit Cgal(const fccda::Surface& surface) {
    std::vector<Mesh::Vertex_index> index;
    for (const Vec3d& v : surface.vertices()) index.push_back(mesh_.add_vertex({v.x, v.y, v.z}));
    const auto at = [&](int v) { return index[static_cast<std::size_t>(v)]; };
    for (const fccda::Triangle& t : surface.triangles()) mesh_.add_face(at(t.vertex[0]), at(t.vertex[1]), at(t.vertex[2]));
    tree_.insert(faces(mesh_).first, faces(mesh_).second, mesh_);
    tree_.build();
    tree_.accelerate_distance_queries();
  }
  double distance(const Query& q) { return std::sqrt(tree_.squared_distance(point(q.point))); }
  bool meets(const Query& q) { return tree_.do_intersect(Kernel::Segment_3(point(q.point), point(q.end))); }

 private:
  static Kernel::Point_3 point(const Vec3d& p) { return {p.x, p.y, p.z}; }
  Mesh mesh_;
  Tree tree_;
};

/// Embree traverses its tree and leaves the triangle distance to a callback, here the reference function of our tests.
class Embree {
 public:
  static constexpr const char* name = "Embree";
  explicit Embree(const fccda::Surface& surface) : surface_(surface), device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface.vertices().size()));
    for (const Vec3d& v : surface.vertices())
      for (std::size_t axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(v[axis]);
    auto* index =
        static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), surface.triangles().size()));
    for (const fccda::Triangle& t : surface.triangles())
      for (const int v : t.vertex) *index++ = static_cast<unsigned>(v);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_);
  }
  Embree(const Embree&) = delete;
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  double distance(const Query& q) {
    RTCPointQuery query{};
    query.x = static_cast<float>(q.point.x), query.y = static_cast<float>(q.point.y), query.z = static_cast<float>(q.point.z);
    query.radius = std::numeric_limits<float>::infinity();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Search search{&surface_, q.point, std::numeric_limits<double>::infinity()};
    rtcPointQuery(scene_, &query, &context, closer, &search);
    return std::sqrt(search.squared);
  }
  bool meets(const Query& q) {
    const Vec3d way = q.end - q.point;
    RTCRay ray{};
    ray.org_x = static_cast<float>(q.point.x), ray.org_y = static_cast<float>(q.point.y), ray.org_z = static_cast<float>(q.point.z);
    ray.dir_x = static_cast<float>(way.x), ray.dir_y = static_cast<float>(way.y), ray.dir_z = static_cast<float>(way.z);
    ray.tfar = 1;
    ray.mask = ~0u;
    RTCRayHit hit{ray, {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &hit);
    return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

 private:
  struct Search {
    const fccda::Surface* surface;
    Vec3d point;
    double squared;
  };
  static bool closer(RTCPointQueryFunctionArguments* arguments) {
    Search& search = *static_cast<Search*>(arguments->userPtr);
    const std::size_t t = arguments->primID;
    const Vec3d on = fccda::closest_on_triangle(search.point, {search.surface->corner(t, 0), search.surface->corner(t, 1), search.surface->corner(t, 2)}).point;
    const double squared = squared_norm(search.point - on);
    if (squared >= search.squared) return false;
    search.squared = squared;
    arguments->query->radius = static_cast<float>(std::sqrt(squared));
    return true;
  }
  const fccda::Surface& surface_;
  RTCDevice device_;
  RTCScene scene_;
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Results of one library for all queries, and the times of its rounds.
struct Answers {
  std::vector<double> distance;
  std::vector<bool> meets;
  std::vector<double> distance_times, meets_times;  // [s] per query
};

template <class Library>
void ask(Library& library, const std::vector<Query>& near, const std::vector<Query>& outside, Answers& answers) {
  answers.distance.resize(near.size());
  answers.meets.resize(outside.size());
  double begin = seconds();
  for (std::size_t k = 0; k < near.size(); ++k) answers.distance[k] = library.distance(near[k]);
  answers.distance_times.push_back((seconds() - begin) / static_cast<double>(near.size()));
  begin = seconds();
  for (std::size_t k = 0; k < outside.size(); ++k) answers.meets[k] = library.meets(outside[k]);
  answers.meets_times.push_back((seconds() - begin) / static_cast<double>(outside.size()));
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void print(const char* library, const Answers& answers, const Answers& ours, std::size_t panels) {
  double furthest = 0;
  for (std::size_t k = 0; k < answers.distance.size(); ++k) furthest = std::max(furthest, std::fabs(answers.distance[k] - ours.distance[k]));
  std::size_t differ = 0;
  for (std::size_t k = 0; k < answers.meets.size(); ++k) differ += answers.meets[k] != ours.meets[k];
  fmt::print("{},closest point,{},{:.4g},{:.4g},{:.3g},{}\n", library, panels, 1e9 * median(answers.distance_times),
             median(answers.distance_times) / median(ours.distance_times), furthest, answers.distance.size());
  fmt::print("{},segment,{},{:.4g},{:.4g},{:.3g},{}\n", library, panels, 1e9 * median(answers.meets_times),
             median(answers.meets_times) / median(ours.meets_times), static_cast<double>(differ) / static_cast<double>(answers.meets.size()),
             answers.meets.size());
}

}  // namespace

int main(int argc, char** argv) {
  double panels = 1e5;
  std::size_t count = 50000;
  int rounds = 5;
  CLI::App app("Times closest-point and segment queries against CGAL and Embree; prints CSV rows.");
  app.add_option("--panels", panels)->check(CLI::PositiveNumber);
  app.add_option("--queries", count)->check(CLI::PositiveNumber);
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  const auto surface = benchmark::hull(panels);
  const std::vector<Query> near = queries_near(*surface, count);
  const fccda::PathTest test(surface, fccda::Unbounded(), 0);
  std::vector<Query> outside;
  for (const Query& q : near)
    if (!test.is_inside(q.point, 0)) outside.push_back(q);

  Ours ours(*surface);
  Cgal cgal(*surface);
  Embree embree(*surface);
  Answers of_ours, of_cgal, of_embree;
  for (int round = 0; round < rounds; ++round) {
    ask(ours, near, outside, of_ours);
    ask(cgal, near, outside, of_cgal);
    ask(embree, near, outside, of_embree);
  }
  const std::size_t triangles = surface->triangles().size();
  fmt::print("library,query,panels,ns/query,times_ours,differs,queries\n");
  print(Ours::name, of_ours, of_ours, triangles);
  print(Cgal::name, of_cgal, of_ours, triangles);
  print(Embree::name, of_embree, of_ours, triangles);
  return 0;
}
