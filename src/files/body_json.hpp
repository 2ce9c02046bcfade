#pragma once

#include "bezier/turn.hpp"
#include "case/certificate.hpp"
#include "case/mesh.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

template <>
struct JsonForm<BodyTurn> {
  static void fields(auto& archive, auto& turn) {
    archive("from", turn.from);
    archive("to", turn.to);
    archive.optional("centre", turn.centre, Vec3<double>(0, 0, 0));
  }
};

/// A turn by an angular velocity, as it is in files.
struct SpinInFiles {
  BodyTurn turn;

  static void fields(auto& archive, auto& spin) {
    archive("velocity", spin.turn.spin, [](const auto& numbers) {
      return numbers.empty() ? "has 0 numbers, and needs 3" : "";  // it would be no spin
    });
    archive.optional("centre", spin.turn.centre, Vec3<double>(0, 0, 0));
  }
};

/// The turn of a body, which is in files as a `turn` or a `spin`.
void turn_fields(auto& archive, auto& turn) {
  if constexpr (kReads<decltype(archive)>) {
    archive.optional("turn", turn);
    std::optional<SpinInFiles> spin;
    archive.optional("spin", spin);
    if (!spin) return;
    if (turn) archive.object().at("spin").refuse("stands beside a turn; a body has one of them");
    turn = spin->turn;
  } else if (turn) {
    turn->is_spin() ? archive("spin", SpinInFiles{*turn}) : archive("turn", *turn);
  }
}

/// The faces of a body, which is no mesh without them.
void face_fields(auto& archive, auto& patch) {
  const Each<Each<Within<int>>> corners{{{0, static_cast<int>(patch.positions.size()) - 1}}};
  archive.optional("faces", patch.faces, {}, corners, [](const auto& faces) {
    return faces.empty()
               ? fmt::format("has none; a mesh has 1..{}, and a hull no such key", kMaxFaces)
               : "";
  });
}

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
