#pragma once

#include <fmt/format.h>

#include "bezier/turn.hpp"
#include "case/certificate.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

template <>
struct JsonForm<BodyTurn> {
  static void fields(auto& archive, auto& turn) {
    archive("from", turn.from);
    archive("to", turn.to);
    archive.optional("centre", turn.centre, Vec3<double>(0, 0, 0));
    if constexpr (kReads<decltype(archive)>) {
      const auto fault = fault_of(turn);
      if (fault) archive.object().refuse(fmt::format("{} {}", fault->field, fault->what));
    }
  }
};

template <>
struct JsonForm<BodyPlanes::Plane> {
  static void fields(auto& archive, auto& plane) {
    archive("from", plane.from);
    archive("normals", plane.normals);
    archive("offsets", plane.offsets);
    archive("gap", plane.gap);
  }
};

}  // namespace ccdfuzz
