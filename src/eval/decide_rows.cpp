#include "eval/decide_rows.hpp"

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

void decide_rows(NamedCase& named) {
  if (!named.rows || named.rows->layout == CsvLayout::kCurved) return;
  named.value.truth = decide(named.value.query).truth;
}

}  // namespace ccdfuzz
