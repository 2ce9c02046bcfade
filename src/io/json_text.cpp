#include "io/json_text.hpp"

#include "io/json_library.hpp"

namespace ccdfuzz {

std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace ccdfuzz
