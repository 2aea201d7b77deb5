/// How the described structs nest in a deck: the keys that are not simple fields. The simple ones are in the structs' own tables
/// (T::fields()), so that schema and tables together are the only list of keys.
///
/// A walker takes part in five forms; reader.hpp fills a Setup, reference.cpp describes it, setup_to_text.cpp writes it:
///
///   section("time", s.time, …)           time: {end: …, step: …}        an optional struct is there only where its key is
///   named("bodies", s.bodies, …)         bodies: {plate: {…}, floe: {…}}
///   one_of("shape", b.shape, …)          shape: {box: {…}}                  which one is said by its key
///   alternatives(r.shape)                the same without a map around it: region: {box: {…}, outside: clip}
///   by_word("material", "model", …)      material: {model: ordinary-state, …}
///
/// An alternative that has a field of its own name is written without a map of its own: surface: {file: hull.stl, scale: 0.001}.
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

/// Most structs nest nothing.
template <class Walker, class T>
void sections(Walker&, T&) {}

template <class Walker>
void sections(Walker& walk, Setup& setup) {
  walk.section("time", setup.time, Presence::required, "How long the run is and in which steps.");
  walk.named("bodies", setup.bodies, Presence::required, "The deformable bodies, each under a name of your choice.");
  walk.named("impactors", setup.impactors, Presence::optional, "The rigid bodies that strike, each under a name of your choice.");
  walk.section("contact", setup.contact, Presence::optional, "How bodies and impactors touch.");
  walk.section("output", setup.output, Presence::optional, "What the run leaves behind.");
}

template <class Walker>
void sections(Walker& walk, TimeSetup& time) {
  walk.section("relax", time.relax, Presence::optional, "Relaxes the bodies from one state of equilibrium to the next, instead of following their motion.");
}

template <class Walker>
void sections(Walker& walk, BodySetup& body) {
  walk.one_of("shape", body.shape, Presence::required, "The solid that is filled with particles, or a file of particles.");
  walk.named("add", body.add, Presence::optional, "A solid that is united with the shape, under a name of your choice.");
  walk.named("holes", body.holes, Presence::optional, "A solid that is taken out of shape and parts, under a name of your choice.");
  walk.named("cracks", body.cracks, Presence::optional, "A crack that is there from the start, under a name of your choice.");
  walk.named("particle_sets", body.particle_sets, Presence::optional, "The particles in a solid, under a name of your choice that boundaries and failure use.");
  walk.by_word("material", "model", body.material, "What the body is made of.");
  walk.section("failure", body.failure, Presence::optional, "Which bonds break, beside the critical stretch of the material.");
  walk.named("boundary_conditions", body.boundary_conditions, Presence::optional,
             "What holds, moves, loads or damps some particles, under a name of your choice; its force and work become columns of history.csv.");
}

template <class Walker>
void sections(Walker& walk, BoundaryConditionSetup& boundary) {
  walk.alternatives(boundary.kind);
}

template <class Walker>
void sections(Walker& walk, PrescribedSetup& prescribed) {
  walk.section("x", prescribed.x, Presence::optional, "Course of the particles along x.");
  walk.section("y", prescribed.y, Presence::optional, "Course of the particles along y.");
  walk.section("z", prescribed.z, Presence::optional, "Course of the particles along z.");
}

template <class Walker>
void sections(Walker& walk, SolidSetup& solid) {
  walk.one_of("shape", solid.shape, Presence::required, "What it is.");
}

template <class Walker, std::derived_from<ElasticSetup> Material>
void sections(Walker& walk, Material& material) {
  walk.section("ice", material.ice, Presence::optional,
               "Ice as engineers state it: sets youngs_modulus and, where no other criterion is given, flexural_strength.");
  walk.section("plasticity", material.plasticity, Presence::optional,
               "Yields under pressure: a pressure-dependent yield surface with associated flow, for bond-based materials. {} takes every default.");
}

template <class Walker>
void sections(Walker& walk, ImpactorSetup& impactor) {
  walk.one_of("surface", impactor.surface, Presence::required, "The surface of panels that particles strike.");
  walk.section("coarsen", impactor.coarsen, Presence::optional, "Merges panels where the surface is cut finer than its shape needs, before refine.");
  walk.named("refine", impactor.refine, Presence::optional,
             "Makes panels smaller in some place, under a name of your choice; the shape stays. Where several hold, the smallest panel counts.");
  walk.section("contact_bounds", impactor.contact_bounds, Presence::optional, "Where contact is looked for. Where absent, wherever the surface is.");
  walk.section("motion", impactor.motion, Presence::optional, "Motion against time of degrees of freedom that are not free.");
  walk.named("loads", impactor.loads, Presence::optional, "A force or moment on the impactor besides contact, under a name of your choice.");
  walk.section("floating", impactor.floating, Presence::optional,
               "Weight, and still water that lifts what is under its level of the closed surface. {} takes every default.");
  walk.named("gauges", impactor.gauges, Presence::optional,
             "A gauge, under a name of your choice: force and moment of contact on parts of the surface become columns of history.csv.");
}

template <class Walker>
void sections(Walker& walk, PropellerSurface& propeller) {
  walk.section("sections", propeller.sections, Presence::optional,
               "Blade sections at some radii, in place of the Wageningen series, with smooth curves between them. All lists are as long as radius.");
}

template <class Walker>
void sections(Walker& walk, RefinementSetup& refinement) {
  walk.section("box", refinement.box, Presence::optional, "Only panels that reach into this box. Where absent, wherever they are.");
}

template <class Walker>
void sections(Walker& walk, MotionSetup& motion) {
  walk.section("x", motion.x, Presence::optional, "Translation of the centre of mass along x.");
  walk.section("y", motion.y, Presence::optional, "Translation of the centre of mass along y.");
  walk.section("z", motion.z, Presence::optional, "Translation of the centre of mass along z.");
  walk.section("rx", motion.rx, Presence::optional, "Rotation about the world's x, through the centre of mass.");
  walk.section("ry", motion.ry, Presence::optional, "Rotation about the world's y, through the centre of mass.");
  walk.section("rz", motion.rz, Presence::optional, "Rotation about the world's z, through the centre of mass.");
}

template <class Walker>
void sections(Walker& walk, ContactBoundsSetup& region) {
  walk.alternatives(region.shape);
}

template <class Walker>
void sections(Walker& walk, BoxUnionBoundsSetup& region) {
  walk.named("boxes", region.boxes, Presence::optional, "Boxes as given, each under a name of your choice; instead of count and gain.");
}

template <class Walker>
void sections(Walker& walk, ContactSetup& contact) {
  walk.section("impactors", contact.impactors, Presence::optional, "Contact between particles and impactors.");
  walk.section("fragments", contact.fragments, Presence::optional, "Contact between particles that are not bonded.");
}

template <class Walker>
void sections(Walker& walk, OutputSetup& output) {
  walk.named("probes", output.probes, Presence::optional, "Points whose displacements become columns of history.csv, each under a name of your choice.");
  walk.named("lines", output.lines, Presence::optional, "Lines along which displacements are written at chosen times, each under a name of your choice.");
}

/// True where an alternative is written without a map of its own.
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
