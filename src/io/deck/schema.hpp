/// Nesting of the described structs in a deck, that is the keys that are not simple fields. Simple fields are in the structs' own tables
/// (T::fields()); schema and tables together are the only list of keys.
///
/// A walker implements five operations; reader.hpp fills a Setup, reference.cpp describes it, setup_to_text.cpp writes it:
///
///   section("time", s.time, …)           time: {end: …, step: …}        an optional struct exists only where its key is given
///   named("bodies", s.bodies, …)         bodies: {plate: {…}, floe: {…}}
///   one_of("shape", b.shape, …)          shape: {box: {…}}                  the key selects the alternative
///   alternatives(r.shape)                the same without an enclosing map: contact_bounds: {box: {…}, on_exceed: clip}
///   by_word("material", "model", …)      material: {model: ordinary-state, …}
///
/// An alternative with a field of the same name is written without a nested map: surface: {file: hull.stl, scale: 0.001}.
#pragma once

#include <algorithm>
#include <concepts>
#include <string>
#include <vector>

#include "perimpact/deck_model/setup.hpp"

namespace perimpact::deck {

using fccda::Presence;

template <class T>
concept Described = requires {
  { T::fields() } -> std::convertible_to<std::span<const Field<T>>>;
};

/// Most structs contain no nested maps. Materials and boundary conditions list theirs in their own folder.
template <class Walker, class T>
void sections(Walker& walk, T& one) {
  if constexpr (requires { T::sections(walk, one); }) T::sections(walk, one);
}

template <class Walker>
void sections(Walker& walk, Setup& setup) {
  walk.section("time", setup.time, Presence::required, "Duration of the run and time step.");
  walk.named("bodies", setup.bodies, Presence::required, "The deformable bodies, each under a name of your choice.");
  walk.named("impactors", setup.impactors, Presence::optional, "The impactors, rigid or elastic, each under a name of your choice.");
  walk.section("contact", setup.contact, Presence::optional, "Contact of bodies and impactors.");
  walk.section("output", setup.output, Presence::optional, "Results of the run.");
}

template <class Walker>
void sections(Walker& walk, TimeSetup& time) {
  walk.section("relax", time.relax, Presence::optional,
               "Quasi-static analysis: adaptive dynamic relaxation from one equilibrium state to the next, instead of dynamics.");
}

template <class Walker>
void sections(Walker& walk, BodySetup& body) {
  walk.one_of("shape", body.shape, Presence::required, "The solid that is filled with particles, or a file of particles.");
  walk.named("add", body.add, Presence::optional, "A solid united with the shape, under a name of your choice.");
  walk.named("holes", body.holes, Presence::optional, "A solid removed from the shape and the added solids, under a name of your choice.");
  walk.named("cracks", body.cracks, Presence::optional, "An initial crack, under a name of your choice.");
  walk.named("particle_sets", body.particle_sets, Presence::optional,
             "A particle set: the particles in a solid, under a name of your choice to which boundary conditions and failure refer.");
  walk.by_word("material", "model", body.material, "Material model of the body.");
  walk.section("failure", body.failure, Presence::optional, "Bond failure in addition to the critical stretch of the material.");
  walk.named("boundary_conditions", body.boundary_conditions, Presence::optional,
             "A boundary condition on a particle set (constraint, prescribed motion, load or damping), under a name of your choice; its force and work become "
             "columns of history.csv.");
  walk.section("moving_window", body.moving_window, Presence::optional,
               "Makes the body a moving window that follows an impactor: particles are added ahead of it and discarded behind it.");
}

template <class Walker>
void sections(Walker& walk, BoundaryConditionSetup& boundary) {
  walk.alternatives(boundary.kind);
}

template <class Walker>
void sections(Walker& walk, SolidSetup& solid) {
  walk.one_of("shape", solid.shape, Presence::required, "Shape of the solid.");
}

template <class Walker>
void sections(Walker& walk, ImpactorSetup& impactor) {
  walk.one_of("surface", impactor.surface, Presence::required, "The surface mesh of panels with which particles come into contact.");
  walk.section("coarsen", impactor.coarsen, Presence::optional, "Coarsens panels that are finer than the shape requires, before refine.");
  walk.named("refine", impactor.refine, Presence::optional,
             "A local refinement of panels, under a name of your choice; the shape is preserved. Where several apply, the smallest panel size governs.");
  walk.section("contact_bounds", impactor.contact_bounds, Presence::optional,
               "Contact bounds: the volume in which contact is searched. Where absent, the whole surface.");
  walk.section("motion", impactor.motion, Presence::optional, "Prescribed motion against time of degrees of freedom that are not free.");
  walk.named("loads", impactor.loads, Presence::optional, "A force or moment on the impactor in addition to contact, under a name of your choice.");
  walk.section("floating", impactor.floating, Presence::optional,
               "Weight and buoyancy in still water, from the volume of the closed surface below its level. {} takes every default.");
  walk.section("elastic", impactor.elastic, Presence::optional,
               "Makes the impactor elastic: vibration modes, superposed on its rigid motion. Where absent, it is rigid.");
  walk.named("gauges", impactor.gauges, Presence::optional,
             "A gauge, under a name of your choice: contact force and moment on parts of the surface become columns of history.csv.");
}

template <class Walker>
void sections(Walker& walk, PropellerSurface& propeller) {
  walk.section("sections", propeller.sections, Presence::optional,
               "Blade sections at given radii, in place of the Wageningen series, interpolated smoothly. All lists are as long as radius.");
}

template <class Walker>
void sections(Walker& walk, RefinementSetup& refinement) {
  walk.section("box", refinement.box, Presence::optional, "Restricts refinement to panels that reach into this box. Where absent, no restriction.");
}

template <class Walker>
void sections(Walker& walk, MotionSetup& motion) {
  walk.section("x", motion.x, Presence::optional, "Translation of the centre of mass along x.");
  walk.section("y", motion.y, Presence::optional, "Translation of the centre of mass along y.");
  walk.section("z", motion.z, Presence::optional, "Translation of the centre of mass along z.");
  walk.section("rx", motion.rx, Presence::optional, "Rotation about the global x axis, through the centre of mass.");
  walk.section("ry", motion.ry, Presence::optional, "Rotation about the global y axis, through the centre of mass.");
  walk.section("rz", motion.rz, Presence::optional, "Rotation about the global z axis, through the centre of mass.");
}

template <class Walker>
void sections(Walker& walk, ContactBoundsSetup& region) {
  walk.alternatives(region.shape);
}

template <class Walker>
void sections(Walker& walk, ContactSetup& contact) {
  walk.section("impactors", contact.impactors, Presence::optional, "Contact between particles and impactors.");
  walk.section("fragments", contact.fragments, Presence::optional, "Short-range contact between particles that are not bonded.");
}

template <class Walker>
void sections(Walker& walk, OutputSetup& output) {
  walk.section(
      "frame_particles", output.frame_particles, Presence::optional,
      "Thins frames to a part of the particles: of those in boxes, or of all, the ones that meet surface, stride, damage_above or detached, one of those "
      "given. Each particle then has its number in the body as the field particle. Where absent, all particles are written.");
  walk.named("probes", output.probes, Presence::optional, "Points whose displacements become columns of history.csv, each under a name of your choice.");
  walk.named("lines", output.lines, Presence::optional, "Lines along which displacements are written at chosen times, each under a name of your choice.");
}

template <class Walker>
void sections(Walker& walk, FrameParticlesSetup& particles) {
  walk.named("boxes", particles.boxes, Presence::optional,
             "A box in the reference (undeformed) configuration, under a name of your choice. Only particles in one of the boxes are written.");
}

/// True where an alternative is written without a nested map.
template <class T>
bool is_written_flat() {
  const auto fields = T::fields();
  return std::any_of(fields.begin(), fields.end(), [](const auto& field) { return field.name == T::name; });
}

/// Calls visit(alternative), with a default-constructed value of each described alternative of the variant.
template <class... Alternatives, class Visit>
void for_each_alternative(const std::variant<Alternatives...>&, const Visit& visit) {
  const auto one = [&]<class T>(T alternative) {
    if constexpr (Described<T>) visit(alternative);
  };
  (one(Alternatives{}), ...);
}

template <class Variant>
std::vector<std::string> alternative_names(const Variant& variant) {
  std::vector<std::string> names;
  for_each_alternative(variant, [&]<class T>(const T&) { names.emplace_back(T::name); });
  return names;
}

}  // namespace perimpact::deck
