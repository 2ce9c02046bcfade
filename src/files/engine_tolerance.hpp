#pragma once

#include "case/case.hpp"
#include "files/engine_words.hpp"

// What the test of an engine allows it, by its own tolerances.

namespace ccdfuzz {

/// The point of a body that a witness has, at its time. Requires a witness of bodies.
Vec3<Rational> touched_point(const Case& value, size_t side);
/// How long the step is in which a share of 1 ends: turns are given for a step of 1.
double step_of_bodies(const Query& query, const EngineWords& engine);
/// A number that `origin` of a find says; 0 where it says none.
double said_of(const Origin& origin, const char* name);
/// How deep bodies may come that the engine misses, by its own tolerance; 0 where that is a time.
double depth_allowed(const Case& value, const EngineWords& engine);
/// How much later than the contact the engine may be, as a part of the way. That is its own
/// tolerance in time, or the time in which bodies come as deep as its tolerance in space allows.
/// The direction that keeps them apart until the contact tells how fast that is.
double allowed_delay(const Case& value, const EngineWords& engine, double step);

}  // namespace ccdfuzz
