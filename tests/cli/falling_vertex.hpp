#pragma once

#include <string>

namespace ccdfuzz {

/// The rows of a vertex at (1/4, 1/4, 1) that ends at (1/4, 1/4, z) over a face in z = 0. label <
/// 0: none.
inline std::string falling_vertex(const std::string& z, int label) {
  std::string text;
  for (const std::string& end : {std::string("1,1"), z}) {
    for (const std::string& point : {"1,4,1,4," + end, std::string("0,1,0,1,0,1"),
                                     std::string("0,1,1,1,0,1"), std::string("1,1,0,1,0,1")}) {
      text += point + (label < 0 ? "" : "," + std::to_string(label)) + "\n";
    }
  }
  return text;
}

}  // namespace ccdfuzz
