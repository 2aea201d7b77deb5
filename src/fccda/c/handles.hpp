/// What the handles of fccda.h point to.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fccda/api/contact_detector.hpp"
#include "fccda/api/deforming_contact_detector.hpp"
#include "fccda/fccda.h"
#include "fccda/rigid_body/rigid_body.hpp"

/// A surface, with the text of its report.
struct fccda_surface {
  fccda::SharedSurface shared;
  std::string report;
};

/// A rigid body.
struct fccda_body {
  fccda::RigidBody body;
};

/// A deforming surface, which its detectors share.
struct fccda_deforming_surface {
  std::shared_ptr<fccda::DeformingSurface> surface;
  std::string warnings{};  // as returned
};

namespace fccda::c_interface {

/// A detector with the results that C reads from it. Contacts point into the detector, which therefore stays where it is.
template <class Detector, class Contact, class ContactOfC>
struct DetectorHandle {
  template <class... Arguments>
  explicit DetectorHandle(Arguments&&... arguments) : detector(std::forward<Arguments>(arguments)...) {}
  DetectorHandle(const DetectorHandle&) = delete;
  DetectorHandle& operator=(const DetectorHandle&) = delete;

  Detector detector;
  std::vector<Contact> contacts{};            // of the last detection
  std::vector<ContactOfC> contacts_of_c{};    // the same, as fccda_…contacts() returned them
  std::vector<std::int64_t> points_inside{};  // as returned
  std::vector<std::int64_t> state{};          // as returned
};

}  // namespace fccda::c_interface

/// A detector of contact with a rigid surface.
struct fccda_detector : fccda::c_interface::DetectorHandle<fccda::ContactDetector, fccda::Contact, fccda_contact> {
  fccda_detector(std::string of_bounds, const fccda::SharedSurface& surface, const fccda::ContactDetector::Options& options)
      : DetectorHandle(surface, options), bounds(std::move(of_bounds)) {}

  std::string bounds;  // the sentence that describes the contact bounds
};

/// A detector of contact with a deforming surface.
struct fccda_deforming_detector : fccda::c_interface::DetectorHandle<fccda::DeformingContactDetector, fccda::DeformingContact, fccda_deforming_contact> {
  using DetectorHandle::DetectorHandle;
};
