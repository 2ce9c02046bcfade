#pragma once

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// What is asked of a one-sided scene; the defaults are the regular cases'.
struct OneSidedStyle {
  Dyadic t = 1;      ///< t*
  Dyadic t_max = 1;  ///< end of the query
  /// The contact point's coordinates are multiples of 2^contact_unit up to 2^(contact_unit +
  /// contact_bits). They are up to 64 times larger with plane_through_origin.
  int contact_bits = 46;
  long contact_unit = -41;
  bool plane_through_origin = false;
  /// Parameters are multiples of 2^-b for a random b from 2 to this. The more bits they have, the
  /// longer a subdivision keeps the contact inside one cell, off the corners of cells.
  int max_parameter_bits = 12;
  /// Heights above the contact plane are 2^-flatness times about the size of the patch.
  int min_flatness = 0;
  int max_flatness = 12;
  /// All velocities lie in the contact plane: the patches graze each other at t*, and touch at no
  /// other time if their contact points' velocities differ. The moving plane proves nothing then.
  bool grazing = false;
  /// The contact edges of EE and VE may lie in the contact plane. Grazing ones then touch for a
  /// time.
  bool flat_edges = true;
};

/// The one-sided family: Steps I, II and IV in one go, without solving or discarding anything.
///
/// At t* the control points are c + Σ τ·T + h·m. c is the contact point, T1 and T2 span the contact
/// plane, m points out of it. The tangential coordinates τ are arbitrary but for Σ β τ = 0, which
/// puts the contact at c. β are the Bernstein weights at the contact. The heights h are the polar
/// form of a quadratic that is 0 at the contact and positive elsewhere on the patch. The contact
/// edges of EE and VE may be flat. Patch 1 takes them upwards, patch 2 downwards. So the patches
/// touch nowhere but in the plane. All velocities of patch 1 have a smaller normal part than all of
/// patch 2: moving_plane_separates holds by construction. Sizes: patches and velocities are up to
/// about 2^3.
Scene one_sided_scene(ContactClass contact, const OneSidedStyle& style, Draw& draw);

}  // namespace ccdfuzz
