#pragma once

#include "case/mesh.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

/// The faces of a body, which is no mesh without them.
void face_fields(auto& archive, auto& patch) {
  if constexpr (kReads<decltype(archive)>) {
    // A corner need not be within the range of its type.
    const auto faces = archive.object().find("faces");
    for (size_t f = 0; faces && f < faces->array().size(); ++f) {
      for (const size_t i : {size_t{0}, size_t{1}, size_t{2}}) {
        faces->item(f).array(3).item(i).integer(0, static_cast<int>(patch.positions.size()) - 1);
      }
    }
  }
  archive.optional("faces", patch.faces, {}, [](const auto& faces) {
    return faces.empty()
               ? fmt::format("has none; a mesh has 1..{}, and a hull no such key", kMaxFaces)
               : "";
  });
}

}  // namespace ccdfuzz
