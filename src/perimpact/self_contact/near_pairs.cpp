#include "perimpact/self_contact/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <utility>

#include "base/parallel_throwing.hpp"

namespace perimpact {

namespace {

using Pack = fccda::NativePack;

constexpr std::size_t block = 256;  // particles per task of a thread

/// Skin in spacings of the finest body. Measured (benchmarks/fragments): where a quarter or all of a plate disperses at a hundredth of the speed of
/// sound, 0.35 and 0.75 cost 3 to 7 and 9 to 38 % more: a thin skin needs more rebuilds, a thick one has more pairs.
constexpr double skin_ratio = 0.5;

// marks of a cell
constexpr std::uint8_t holds_lost = 1;      // contains a particle that has lost a bond
constexpr std::uint8_t holds_exposed = 2;   // contains an exposed particle
constexpr std::uint8_t is_near_damage = 4;  // itself or a neighbour contains one that has lost a bond
constexpr std::uint8_t is_near = 8;         // itself or a neighbour contains one that searches for contacts

}  // namespace

NearPairs::NearPairs(const ShortRangeLaw& law, std::span<const ContactingBody> bodies) : law_(law) {
  double finest = std::numeric_limits<double>::infinity();
  std::uint64_t first_id = 0;
  std::vector<double> extremes = {0};  // [m] largest size of all particles, and minus the smallest of each body
  for (const ContactingBody& body : bodies) {
    const Particles& particles = body.particles;
    finest = std::min(finest, particles.spacing());
    shares_.emplace_back(particles.share());
    particle_at_.emplace_back(particles.slots(), none);
    first_ids_.push_back(first_id);
    first_id += particles.slots_of_whole();
    double& minus_smallest = extremes.emplace_back(-std::numeric_limits<double>::infinity());
    for (const std::uint32_t slot : particles.slot_of()) {
      const double size = particles.size_of(slot);
      extremes[0] = std::max(extremes[0], size), minus_smallest = std::max(minus_smallest, -size);
    }
  }
  ranks().max(extremes);
  // slightly enlarged, so that reach_of() decides in every search, and not the rounding of packs and cells
  longest_ = (1 + 1e-9) * weight_reach * law.distance_ratio * extremes[0];
  skin_ = skin_ratio * finest;
  // Two fast particles that may meet are within two rings of cells. The limit of three skins keeps lists short beside a much coarser body.
  fast_ = FastParticles(0.5 * skin_, std::min(0.5 * longest_ + skin_, 3 * skin_));
  for (std::size_t b = 0; b < bodies.size(); ++b) bonded_within_.push_back((1 - 1e-9) * bodies[b].family.reach(-extremes[1 + b]));
  list_particles(bodies);
}

/// All of this rank but those that are crushed.
void NearPairs::list_particles(std::span<const ContactingBody> bodies) {
  std::size_t count = 0;
  for (const ContactingBody& body : bodies) count += body.particles.size();
  particles_.clear();
  particles_.reserve(count);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Particles& particles = bodies[b].particles;
    std::ranges::fill(particle_at_[b], none);
    for (const std::uint32_t slot : particles.slot_of()) {
      if (particles.crushed.is_crushed(slot)) continue;
      particle_at_[b][slot] = static_cast<std::uint32_t>(particles_.size());
      particles_.push_back({static_cast<std::uint32_t>(b), 0, slot, particles.reference(slot), particles.size_of(slot), particles.volume(slot),
                            first_ids_[b] + shares_[b].whole_slot(slot)});
    }
  }
  reference_positions_ = VectorArray(particles_.size(), 0);
  near_damage_.assign(particles_.size(), 0);
}

void NearPairs::forget() {
  is_known_ = false;
  exposures_.clear();
}

bool NearPairs::needs_new_list(std::span<const ContactingBody> bodies) {
  const DisplacementExtremes of_others = displacement_extremes(runs_, bodies, reference_positions_, drift_);
  const bool have_moved = fast_have_moved(bodies, of_others);
  return needs_new_list(bodies, of_others) || have_moved;
}

bool NearPairs::needs_new_list(std::span<const ContactingBody> bodies, const DisplacementExtremes& of_own) {
  bool is_valid = is_known_;
  if (exposures_.empty())
    for (const ContactingBody& body : bodies) exposures_.emplace_back(body.particles, body.family, body.broken_ends);
  broken_eights_.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Exposure::Change change = exposures_[b].update(bodies[b].family, bodies[b].broken_ends);
    broken_eights_[b] = std::move(change.eights);
    for (const std::uint32_t slot : change.first_lost) {
      const std::uint32_t particle = particle_at_[b][slot];
      if (particle == none) continue;  // it was crushed
      is_valid = is_valid && near_damage_[particle];
      if (!is_valid || member_of_[particle] == none) continue;  // make() examines all members
      exposed_[member_of_[particle]] = 1;
      ++times_exposed_;
    }
  }
  const bool has_moved = has_moved_by_skin(of_own);
  return ranks().any(!is_valid) || has_moved;
}

std::vector<std::uint32_t> NearPairs::members_with_broken_bonds() const {
  std::vector<std::uint32_t> found;
  for (std::size_t b = 0; b < broken_eights_.size(); ++b)
    for (const std::size_t eight : broken_eights_[b]) {
      const std::size_t end = std::min((eight + 1) * fccda::byte_lanes, particle_at_[b].size());
      for (std::size_t slot = eight * fccda::byte_lanes; slot < end; ++slot) {
        const std::uint32_t particle = particle_at_[b][slot];
        if (particle == none || particles_[particle].is_foreign || member_of_[particle] == none) continue;
        if (const std::uint32_t member = member_of_[particle]; unbonded_counts_[member] < pair_counts_[member]) found.push_back(member);
      }
    }
  return found;
}

/// None in a run of several ranks, each of which receives foreign particles within the common skin alone.
void NearPairs::choose_fast(std::span<const ContactingBody> bodies) {
  fast_.clear();
  if (!has_fast_ || ranks().size() > 1) return;
  fast_.choose(particles_.size(), [&](std::size_t p) { return bodies[particles_[p].body].particles.velocity.at(particles_[p].slot); });
}

/// The movement of all other particles is examined in each step, without their descriptions.
void NearPairs::list_runs() {
  runs_.clear();
  for (std::size_t p = 0; p < particles_.size(); ++p) {
    const Member& particle = particles_[p];
    if (particle.is_foreign || fast_.contains(static_cast<std::uint32_t>(p))) continue;
    ParticleRun* last = runs_.empty() ? nullptr : &runs_.back();
    const bool continues = last && last->body == particle.body && last->slot + last->count == particle.slot && last->particle + last->count == p;
    if (continues && last->count < block)
      ++last->count;
    else
      runs_.push_back({p, particle.body, particle.slot, 1});
  }
}

bool NearPairs::has_moved_by_skin(const DisplacementExtremes& of_own) {
  std::array<double, 7> largest = {-of_own.low.x, -of_own.low.y, -of_own.low.z, of_own.high.x, of_own.high.y, of_own.high.z, of_own.furthest};
  ranks().max(largest);
  const Vec3d low{-largest[0], -largest[1], -largest[2]}, high{largest[3], largest[4], largest[5]};
  drift_ = 0.5 * (low + high);  // the next step's
  return !(squared_norm(high - low) <= skin_ * skin_ || largest[6] <= 0.25 * skin_ * skin_);
}

/// Whether a fast particle has moved by more than its margin from the drift of which all others are within half a skin.
bool NearPairs::fast_have_moved(std::span<const ContactingBody> bodies, const DisplacementExtremes& of_others) const {
  const bool is_in_box = squared_norm(of_others.high - of_others.low) <= skin_ * skin_;
  const Vec3d drift = is_in_box ? 0.5 * (of_others.low + of_others.high) : drift_;
  return !std::ranges::all_of(fast_.all(), [&](const FastParticles::Particle& fast) {
    const Member& particle = particles_[fast.particle];
    const Vec3d by = bodies[particle.body].particles.position.at(particle.slot) - reference_positions_.at(fast.particle);
    return squared_norm(by - drift) <= fast.margin * fast.margin;
  });
}

std::size_t NearPairs::body_of(std::uint64_t id) const {
  return static_cast<std::size_t>(std::upper_bound(first_ids_.begin(), first_ids_.end(), id) - first_ids_.begin()) - 1;
}

int NearPairs::owner_of(std::uint64_t id) const {
  const std::size_t body = body_of(id);
  return shares_[body].owner_of(static_cast<std::size_t>(id - first_ids_[body]));
}

std::optional<std::size_t> NearPairs::member_of_id(std::uint64_t id) const {
  const std::size_t body = body_of(id);
  std::uint32_t particle = none;
  if (const auto slot = shares_[body].owned_slot(static_cast<std::size_t>(id - first_ids_[body]))) {
    particle = particle_at_[body][*slot];
  } else if (const auto found = std::ranges::lower_bound(foreign_.all(), id, {}, &ForeignParticles::Particle::id);
             found != foreign_.all().end() && found->id == id) {
    particle = foreign_particles_[static_cast<std::size_t>(found - foreign_.all().begin())];
  }
  if (particle == none || member_of_[particle] == none) return std::nullopt;
  return member_of_[particle];
}

/// Replaces the foreign particles in the list of all particles by those that are near now.
void NearPairs::find_foreign(std::span<const ContactingBody> bodies) {
  if (ranks().size() == 1) return;
  std::erase_if(particles_, [](const Member& particle) { return particle.is_foreign != 0; });
  VectorArray own_positions(particles_.size(), 0);
  for (std::size_t p = 0; p < particles_.size(); ++p) own_positions.set(p, bodies[particles_[p].body].particles.position.at(particles_[p].slot));
  const std::vector<Member> own = std::move(particles_);
  foreign_.find(ranks(), own_positions, longest_ + skin_, [&](std::size_t p) {
    const Member& i = own[p];
    return ForeignParticles::Particle{
        i.id, i.body, exposures_[i.body].is_exposed(i.slot), exposures_[i.body].has_lost(i.slot), i.reference, own_positions.at(p), i.size, i.volume};
  });
  for (std::vector<std::uint32_t>& at : particle_at_) std::ranges::fill(at, none);
  particles_ = {};
  particles_.reserve(own.size() + foreign_.all().size());
  reference_positions_ = VectorArray(own.size() + foreign_.all().size(), 0);
  own_particles_.clear(), foreign_particles_.clear(), foreign_states_.clear();
  std::size_t next = 0;
  const auto add_own_before = [&](std::uint64_t id) {
    for (; next < own.size() && own[next].id < id; ++next) {
      particle_at_[own[next].body][own[next].slot] = static_cast<std::uint32_t>(particles_.size());
      own_particles_.push_back(static_cast<std::uint32_t>(particles_.size()));
      reference_positions_.set(particles_.size(), own_positions.at(next));
      particles_.push_back(own[next]);
    }
  };
  for (const ForeignParticles::Particle& i : foreign_.all()) {
    add_own_before(i.id);
    if (const auto slot = shares_[i.body].local_slot(static_cast<std::size_t>(i.id - first_ids_[i.body])))
      particle_at_[i.body][*slot] = static_cast<std::uint32_t>(particles_.size());
    reference_positions_.set(particles_.size(), i.position);
    const auto index = static_cast<std::uint32_t>(foreign_particles_.size());
    foreign_particles_.push_back(static_cast<std::uint32_t>(particles_.size()));
    foreign_states_.push_back({i.position, {}, i.is_exposed});
    particles_.push_back({i.body, 1, index, i.reference, i.size, i.volume, i.id});
  }
  add_own_before(std::numeric_limits<std::uint64_t>::max());
  near_damage_.assign(particles_.size(), 0);
}

void NearPairs::refresh_foreign(std::span<const ContactingBody> bodies) {
  if (ranks().size() == 1) return;
  const auto state_of = [&](std::size_t own) {
    const Member& i = particles_[own_particles_[own]];
    const Particles& particles = bodies[i.body].particles;
    return ForeignState{particles.position.at(i.slot), particles.velocity.at(i.slot), exposures_[i.body].is_exposed(i.slot)};
  };
  foreign_.refresh<ForeignState>(ranks(), state_of, [&](std::size_t foreign, const ForeignState& state) {
    foreign_states_[foreign] = state;
    if (const std::uint32_t m = member_of_[foreign_particles_[foreign]]; m != none) exposed_[m] = state.is_exposed != 0;
  });
}

void NearPairs::make(std::span<const ContactingBody> bodies) {
  ++times_made_;
  if (std::ranges::any_of(bodies, [](const ContactingBody& body) { return !body.particles.crushed.empty(); })) list_particles(bodies);
  find_foreign(bodies);
  choose_fast(bodies);
  list_runs();
  fccda::parallel_for_blocks(particles_.size(), block, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p)
      if (!particles_[p].is_foreign) reference_positions_.set(p, bodies[particles_[p].body].particles.position.at(particles_[p].slot));
  });
  drift_ = {};
  cells_.sort(reference_positions_, longest_ + skin_);
  if (references_by_cell_.slots() != particles_.size()) references_by_cell_ = VectorArray(particles_.size(), fccda::byte_lanes);
  fccda::parallel_for_blocks(particles_.size(), block, [&](std::size_t first, std::size_t last) {
    for (std::size_t n = first; n < last; ++n) references_by_cell_.set(n, particles_[cells_.points_by_cell()[n]].reference);
  });
  mark_cells();
  find_far_pairs();

  // There is mostly room where the pairs of the latest list were. If not, they are counted, and found again when there is.
  if ((pair_count_ = find_pairs(bodies)) > std::min(others_.size(), bonds_.size())) {
    make_room(others_, pair_count_), make_room(bonds_, pair_count_);
    others_.resize(others_.capacity()), bonds_.resize(bonds_.capacity());
    find_pairs(bodies);
  }
  list_members();
  fccda::parallel_for(static_cast<std::ptrdiff_t>(members_.size()), [&](std::ptrdiff_t member) {
    const auto m = static_cast<std::size_t>(member);
    const std::size_t first = first_pair_[m], last = first + pair_counts_[m];
    std::size_t unbonded = 0;
    for (std::size_t pair = first; pair < last; ++pair) {
      others_[pair] = static_cast<std::int32_t>(member_of_[static_cast<std::size_t>(others_[pair])]);
      unbonded += bonds_[pair] == no_bond;
    }
    unbonded_counts_[m] = static_cast<std::uint32_t>(unbonded);
  });
  is_known_ = true;
}

/// The near search finds pairs within the common skin; the two criteria exclude each other bitwise, so that no pair is lost or listed twice.
void NearPairs::find_far_pairs() {
  const std::span<const FastParticles::Particle> fast = fast_.all();
  std::vector<std::vector<FarPair>> of_fast(fast.size());
  fccda::parallel_for_uneven_throwing(static_cast<std::ptrdiff_t>(fast.size()), [&](std::ptrdiff_t number) {
    const std::uint32_t p = fast[static_cast<std::size_t>(number)].particle;
    const double margin = fast[static_cast<std::size_t>(number)].margin;
    std::vector<FarPair>& found = of_fast[static_cast<std::size_t>(number)];
    const auto visit = [&](std::uint32_t q) {
      if (q == p) return;
      const double its_margin = fast_.margin_of(q), contact = reach_of(particles_[p], particles_[q]), common = contact + skin_,
                   least = contact + (margin + its_margin), squared = squared_reference_distance(p, q);
      if (squared < common * common || !(squared < least * least)) return;
      found.push_back({p, q});
      if (!fast_.contains(q)) found.push_back({q, p});
    };
    const double reach = longest_ + margin + fast_.most();
    const auto all = [](std::size_t) { return ~0u; };
    cells_.for_each_around(
        cells_.cell_of(p), [&](std::size_t cell) { cells_.for_each_within(cell, reference_positions_.at(p), reach * reach, all, visit); }, 2);
  });
  far_pairs_.clear();
  for (const std::vector<FarPair>& pairs : of_fast) far_pairs_.insert(far_pairs_.end(), pairs.begin(), pairs.end());
  std::ranges::sort(far_pairs_);
}

std::span<const NearPairs::FarPair> NearPairs::far_pairs_of(std::size_t particle) const {
  const auto number = static_cast<std::uint32_t>(particle);
  const auto first = std::ranges::lower_bound(far_pairs_, number, {}, &FarPair::particle);
  return {first, std::ranges::upper_bound(first, far_pairs_.end(), number, {}, &FarPair::particle)};
}

/// Writes the pairs of all particles, if there is room, with particles in place of members, and returns the room they need. Blocks of particles lie in the
/// order in which threads complete them, on which no result depends.
std::size_t NearPairs::find_pairs(std::span<const ContactingBody> bodies) {
  counts_.assign(particles_.size(), 0);
  first_of_block_.assign((particles_.size() + block - 1) / block, 0);
  const std::size_t room = std::min(others_.size(), bonds_.size());
  std::atomic<std::size_t> end = 0;
  fccda::parallel_for_blocks_throwing(particles_.size(), block, [&](std::size_t first, std::size_t last) {
    thread_local std::vector<Found> found, of_block;  // kept from list to list: to return and obtain their memory takes longer than to find the pairs
    of_block.clear();
    for (std::size_t p = first; p < last; ++p) {
      if (particles_[p].is_foreign || (!(cell_marks_[cells_.cell_of(p)] & is_near) && far_pairs_of(p).empty())) continue;
      find_of(p, bodies, found);
      counts_[p] = static_cast<std::uint32_t>(found.size());
      for (const bool bonded : {false, true})
        std::ranges::copy_if(found, std::back_inserter(of_block), [&](const Found& pair) { return (pair.bond != no_bond) == bonded; });
      of_block.resize(fccda::in_eights(of_block.size()), Found{0, no_bond});  // padding, read but not used
    }
    const std::size_t at = end.fetch_add(of_block.size());
    first_of_block_[first / block] = at;
    if (at + of_block.size() > room) return;
    for (std::size_t n = 0; n < of_block.size(); ++n) others_[at + n] = static_cast<std::int32_t>(of_block[n].particle), bonds_[at + n] = of_block[n].bond;
  });
  return end;
}

/// Those particles that have pairs, and foreign ones in pairs of others.
void NearPairs::list_members() {
  members_.clear();
  first_pair_.clear();
  pair_counts_.clear();
  broken_eights_.clear();
  exposed_.clear();
  // calls visit(particle, its first pair) for all
  const auto for_each_particle = [&](const auto& visit) {
    std::size_t pair = 0;
    for (std::size_t p = 0; p < particles_.size(); ++p) {
      if (p % block == 0) pair = first_of_block_[p / block];
      visit(p, pair);
      pair += fccda::in_eights(counts_[p]);
    }
  };
  std::vector<std::uint8_t> is_used(foreign_.all().size(), 0);
  if (!is_used.empty())
    for_each_particle([&](std::size_t p, std::size_t pair) {
      for (const std::int32_t other : std::span(others_).subspan(pair, counts_[p]))
        if (const Member& particle = particles_[static_cast<std::size_t>(other)]; particle.is_foreign) is_used[particle.slot] = 1;
    });
  if (ranks().size() > 1) foreign_.keep(ranks(), is_used);
  member_of_.assign(particles_.size(), none);
  for_each_particle([&](std::size_t p, std::size_t pair) {
    const Member& particle = particles_[p];
    if (particle.is_foreign ? !is_used[particle.slot] : counts_[p] == 0) return;
    member_of_[p] = static_cast<std::uint32_t>(members_.size());
    members_.push_back(particle);
    first_pair_.push_back(pair);
    pair_counts_.push_back(counts_[p]);
    exposed_.push_back(is_exposed(particle));
  });
  unbonded_counts_.assign(members_.size(), 0);
}

void NearPairs::mark_cells() {
  cell_marks_.assign(cells_.size(), 0);
  cell_bodies_.assign(cells_.size(), none);
  const auto for_each_cell = [&](const auto& f) {
    fccda::parallel_for_blocks(cells_.size(), block, [&](std::size_t first, std::size_t last) {
      for (std::size_t cell = first; cell < last; ++cell) f(cell);
    });
  };
  for_each_cell([&](std::size_t cell) {
    const auto points = cells_.points_in(cell);
    std::uint8_t mark = 0;
    for (const std::uint32_t p : points) {
      if (has_lost(particles_[p])) mark |= holds_lost;
      if (is_exposed(particles_[p])) mark |= holds_exposed;
    }
    cell_marks_[cell] = mark;
    if (!points.empty() && std::ranges::all_of(points, [&](std::uint32_t p) { return particles_[p].body == particles_[points.front()].body; }))
      cell_bodies_[cell] = particles_[points.front()].body;
  });
  // marks of the neighbours are combined in a second array, so that no thread reads what another writes
  const auto widen = [&](unsigned from, std::uint8_t to) {
    std::vector<std::uint8_t> widened(cell_marks_.size());
    for_each_cell([&](std::size_t cell) {
      unsigned around = 0;
      cells_.for_each_around(cell, [&](std::size_t other) { around |= cell_marks_[other]; });
      widened[cell] = static_cast<std::uint8_t>(cell_marks_[cell] | ((around & from) ? to : 0));
    });
    cell_marks_ = std::move(widened);
  };
  widen(holds_lost, is_near_damage);
  // Before marks of other ranks are added: bonds break without a new list only where every rank that may have the other end knows of it.
  fccda::parallel_for_blocks(particles_.size(), block, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) near_damage_[p] = (cell_marks_[cells_.cell_of(p)] & is_near_damage) != 0;
  });
  // Where owners assume damage bonds may break without a new list, although what is damaged may be out of reach here.
  if (ranks().size() > 1)
    foreign_.refresh<std::uint8_t>(
        ranks(), [&](std::size_t own) { return static_cast<std::uint8_t>(near_damage_[own_particles_[own]] ? is_near_damage : 0); },
        [&](std::size_t foreign, std::uint8_t mark) { cell_marks_[cells_.cell_of(foreign_particles_[foreign])] |= mark; });
  widen(holds_exposed | is_near_damage, is_near);
}

void NearPairs::find_of(std::size_t p, std::span<const ContactingBody> bodies, std::vector<Found>& found) const {
  found.clear();
  const Member& i = particles_[p];
  const bool near_damage = (cell_marks_[cells_.cell_of(p)] & is_near_damage) != 0, searches = near_damage || is_exposed(i);
  const double within = bonded_within_[i.body], surely_bonded = within * within, reach = longest_ + skin_;
  bool may_be_bonded = false;
  const auto is_damaged_near = [&](std::size_t cell) { return (cell_marks_[cell] & is_near_damage) != 0; };
  // of a particle within the reach of the list
  const auto add = [&](std::uint32_t q, bool others_near_damage) {
    const Member& j = particles_[q];
    if (!searches && !others_near_damage && !is_exposed(j)) return;
    // between two particles that have lost no bond, a bond of theirs is intact
    if (!near_damage && !others_near_damage && i.body == j.body && squared_norm(j.reference - i.reference) < surely_bonded) return;
    may_be_bonded = may_be_bonded || i.body == j.body;
    found.push_back({q, no_bond});
  };
  for (const FarPair& pair : far_pairs_of(p)) add(pair.other, is_damaged_near(cells_.cell_of(pair.other)));
  cells_.for_each_around(cells_.cell_of(p), [&](std::size_t cell) {
    const bool others_near_damage = is_damaged_near(cell);
    if (!searches && !others_near_damage && !(cell_marks_[cell] & holds_exposed)) return;
    const bool is_whole = !near_damage && !others_near_damage;
    const auto visit = [&](std::uint32_t q) {
      const double least = reach_of(i, particles_[q]) + skin_;
      if (q != p && squared_reference_distance(p, q) < least * least) add(q, others_near_damage);
    };
    // in most cells all are of this body and whole: packs leave out those that are surely bonded
    const bool is_of_body = is_whole && cell_bodies_[cell] == i.body;
    cells_.for_each_within(
        cell, reference_positions_.at(p), reach * reach,
        [&](std::size_t first) {
          return is_of_body ? ~fccda::bits_where_greater(Pack(surely_bonded), squared_distances<Pack>(references_by_cell_, first, i.reference)) : ~0u;
        },
        visit);
  });
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.particle < b.particle; });
  if (may_be_bonded) name_bonds(p, bodies, found);
}

void NearPairs::name_bonds(std::size_t p, std::span<const ContactingBody> bodies, std::span<Found> found) const {
  const Member& i = particles_[p];
  const Family& family = bodies[i.body].family;
  std::size_t next = 0;  // both are sorted by slot
  family.for_each_bond(i.slot, [&](const FamilyBond& bond) {
    const std::uint32_t particle = particle_at_[i.body][bond.j];
    if (particle == none) return;
    while (next < found.size() && found[next].particle < particle) ++next;
    if (next == found.size() || found[next].particle != particle) return;
    found[next].bond = static_cast<std::uint32_t>(family.row_of(i.slot, bond));
  });
}

}  // namespace perimpact
