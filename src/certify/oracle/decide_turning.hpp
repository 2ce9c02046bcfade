#pragma once

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// decide for a valid query of bodies of which one turns, or both. From a time on that is clear it
/// tries one plane (certificate N) up to a later time. At both of them it is normal to the way
/// between the nearest points. As such a plane turns along, its error is of second order, and what
/// is left of the way to a contact shrinks faster than by halves. Where they overlap at a time, the
/// first contact has come. The witness is at most 2^-38 of its time after clear_until. It may be
/// earlier where the contact is known, and planes get shorter past options.wanted_clear. Undecided
/// stays what touches without overlapping, unless that contact is known, and what takes
/// options.max_pops tries, or more than 400. First it tries one plane for all the time, if
/// options.apart_along has a direction.
Decision decide_turning(const Query& query, const OracleOptions& options);

}  // namespace ccdfuzz
