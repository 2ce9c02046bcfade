#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A mutant of a query of bodies, or of linear patches without loops: one to four changes of
/// points, of a velocity, of a radius or of t_max. Parts come from `other`, which is one of bodies
/// or patches, too. The mutant is a valid query, and its numbers are floats
/// (binary32). Whether anything touches is to be decided. Depends on the arguments alone.
Query mutate_query(const Query& query, const Query& other, Draw& draw);

}  // namespace ccdfuzz
