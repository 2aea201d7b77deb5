#include "mesh_io/keyword/abaqus_model.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "mesh_io/file/words.hpp"

namespace fccda {
namespace {

constexpr int nobody = -1;

class Assembler {
 public:
  Assembler(AbaqusModel model, const Lines& lines) : model_(std::move(model)), lines_(lines), budget_(std::max(smallest_budget, lines.file_size())) {}

  Elements mesh() {
    finish(model_.flat);
    finish(model_.assembly);
    for (auto& [key, part] : model_.parts) finish(part.second);
    for (AbaqusInstance& instance : model_.instances) finish(instance.own);

    const auto as_it_is = [](const Vec3d& point) { return point; };
    add(model_.flat, "", {}, as_it_is);
    if (!model_.has_assembly) {
      is_one_of_many_ = model_.parts.size() > 1;
      for (const auto& [key, part] : model_.parts) add(part.second, part.first, {}, as_it_is);
      return std::move(out_);
    }
    for (const AbaqusInstance& instance : model_.instances)
      spend(size(part_of(instance)) + size(instance.own));  // check the total before creating the first copy
    sort_sets_of_instances();
    is_one_of_many_ = model_.instances.size() > 1;
    for (const AbaqusInstance& instance : model_.instances) {
      const auto placed = [&](const Vec3d& point) { return instance.placed(point); };
      const std::string key = capitals(instance.name);
      add(part_of(instance), instance.name, sets_of_[key], placed);
      add(instance.own, instance.name, sets_of_[key], placed);
    }
    add(model_.assembly, "", {}, as_it_is);
    return std::move(out_);
  }

 private:
  using Sets = std::vector<const AbaqusSet*>;
  // Limit on the expansion of instances and sets, in nodes, corners, set members and name characters. No practical mesh exceeds it; a small
  // file that does is damaged.
  static constexpr std::size_t smallest_budget = std::size_t{8} << 20;

  void finish(AbaqusMesh& mesh) { mesh.mesh.finish(lines_); }

  void sort_sets_of_instances() {
    for (const AbaqusSet& set : model_.assembly.sets)
      if (!set.instance.empty()) sets_of_[capitals(set.instance)].push_back(&set);
  }

  const AbaqusMesh& part_of(const AbaqusInstance& instance) const {
    const auto part = model_.parts.find(capitals(instance.part));
    if (part == model_.parts.end()) {
      lines_.fail_at(instance.line, "instance " + excerpt(instance.name) + " is of part " + excerpt(instance.part) +
                                        ", which is not defined; correct the name or add the part.");
    }
    return part->second.second;
  }

  static std::size_t size(const AbaqusMesh& mesh) { return mesh.mesh.entries() + mesh.groups.size() + mesh.sets.size(); }

  void spend(std::size_t entries) {
    if (entries > budget_) {
      lines_.fail("instances and sets expand to more than " + std::to_string(std::max(smallest_budget, lines_.file_size())) +
                  " nodes and set members; export only the parts in the contact area.");
    }
    budget_ -= entries;
  }

  template <class Moved>
  void add(const AbaqusMesh& mesh, const std::string& name, const Sets& sets_of_instance, const Moved& moved) {
    const std::vector<int> parts = parts_of_elements(mesh, name, sets_of_instance);
    mesh.mesh.append_to(out_, moved, parts, lines_);
  }

  int part_number(const std::string& name) {
    spend(name.size());
    return out_.part_number(name);
  }

  std::string full_name(const std::string& name, const std::string& set) const { return is_one_of_many_ && !name.empty() ? name + "." + set : set; }

  std::vector<int> parts_of_elements(const AbaqusMesh& mesh, const std::string& name, const Sets& sets_of_instance) {
    std::vector<int> parts(mesh.mesh.size(), nobody);
    std::vector<int> part_of_group(mesh.groups.size(), nobody);
    for (std::size_t e = 0; e < parts.size(); ++e) {
      const auto group = static_cast<std::size_t>(mesh.mesh.group(e));
      if (group == 0) continue;
      if (part_of_group[group] == nobody) part_of_group[group] = part_number(full_name(name, mesh.groups[group]));
      parts[e] = part_of_group[group];
    }
    const bool has_sets = claim(mesh, name, sets_of_instance, parts);
    if (std::find(parts.begin(), parts.end(), nobody) != parts.end()) {
      const int rest = part_number(has_sets && !name.empty() ? name + " (rest)" : name);
      std::replace(parts.begin(), parts.end(), nobody, rest);
    }
    return parts;
  }

  /// Assigns elements without a set on *ELEMENT to the sets that list them, smallest set first; a set that shares an element with an earlier one is
  /// skipped entirely. Returns whether any element was assigned.
  bool claim(const AbaqusMesh& mesh, const std::string& name, const Sets& sets_of_instance, std::vector<int>& parts) {
    struct Claim {
      std::string name;
      bool is_own = true;
      std::vector<std::size_t> elements{};
    };
    std::vector<Claim> claims;
    std::unordered_map<std::string, std::size_t> number_of;
    const auto list = [&](const AbaqusSet& set) {
      spend(1);
      const auto [entry, is_new] = number_of.try_emplace(capitals(set.name), claims.size());
      if (is_new) claims.push_back({set.name});
      Claim& one = claims[entry->second];
      one.is_own = one.is_own && set.is_own;
      for (const AbaqusRange& range : set.members) {
        const auto between = mesh.mesh.elements_between(range.first, range.last);
        spend(1 + between.size());
        std::copy_if(between.begin(), between.end(), std::back_inserter(one.elements),
                     [&](std::size_t e) { return (mesh.mesh.id(e) - range.first) % range.step == 0; });
      }
    };
    for (const AbaqusSet& set : mesh.sets)
      if (set.instance.empty()) list(set);
    for (const AbaqusSet* set : sets_of_instance) list(*set);

    for (Claim& one : claims) {
      std::sort(one.elements.begin(), one.elements.end());
      one.elements.erase(std::unique(one.elements.begin(), one.elements.end()), one.elements.end());
    }
    std::stable_sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) { return a.elements.size() < b.elements.size(); });
    bool has_any = false;
    for (const Claim& one : claims) {
      if (!one.is_own || one.elements.empty() || std::any_of(one.elements.begin(), one.elements.end(), [&](std::size_t e) { return parts[e] != nobody; }))
        continue;
      const int part = part_number(full_name(name, one.name));
      for (const std::size_t e : one.elements) parts[e] = part;
      has_any = true;
    }
    return has_any;
  }

  AbaqusModel model_;
  const Lines& lines_;
  std::size_t budget_;
  std::unordered_map<std::string, Sets> sets_of_;
  bool is_one_of_many_ = false;
  Elements out_;
};

}  // namespace

int AbaqusMesh::group_number(const std::string& set) {
  const auto [entry, is_new] = numbers_.try_emplace(capitals(set), static_cast<int>(groups.size()));
  if (is_new) groups.push_back(set);
  return entry->second;
}

Vec3d AbaqusInstance::placed(const Vec3d& point) const { return turn.matrix() * (point + translation - axis_point) + axis_point; }

Elements mesh_of(AbaqusModel model, const Lines& lines) { return Assembler(std::move(model), lines).mesh(); }

}  // namespace fccda
