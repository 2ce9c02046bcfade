// Two points that fly at each other: the checker accepts their meeting and refuses any other time.
#include <ccdfuzz/case/query.hpp>
#include <ccdfuzz/certify/checker/check_witness.hpp>
#include <iostream>

int main() {
  using namespace ccdfuzz;
  const auto point = [](double x, double speed) {
    return MovingPatch<double>{Shape::point(), {{x, 0, 0}}, {{speed, 0, 0}}};
  };
  const Query query{{point(-1, 1), point(1, -1)}, 2};
  const Witness at_one{1, {}}, at_half{Rational(1, 2), {}};
  if (const auto accepted = check_witness(query, at_one); !accepted) {
    std::cout << "refused the contact: " << accepted.error().message() << '\n';
    return 1;
  }
  const auto refused = check_witness(query, at_half);
  std::cout << (refused ? "accepted a wrong time" : refused.error().message()) << '\n';
  return refused ? 1 : 0;
}
