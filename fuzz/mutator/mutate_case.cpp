#include <algorithm>

#include "fuzz/mutator/libfuzzer.hpp"
#include "fuzz/mutator/moves.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "generators/draw_contact.hpp"

namespace ccdfuzz {

namespace {

std::size_t put(const Contact& q, std::uint8_t method, std::span<std::uint8_t> out) {
  const auto bytes = to_bytes(q, method);
  if (!bytes || bytes->size() > out.size()) return 0;
  std::copy(bytes->begin(), bytes->end(), out.begin());
  return bytes->size();
}

/// Mostly the same one: the input was kept for what it covers of *it*.
std::uint8_t mutated_method(std::uint8_t method, std::uint64_t count, Draw& draw) {
  constexpr std::uint64_t kChangedIn = 8;
  if (method >= count) return static_cast<std::uint8_t>(draw.below(count));
  if (count < 2 || draw.below(kChangedIn) != 0) return method;
  return static_cast<std::uint8_t>((method + 1 + draw.below(count - 1)) % count);
}

/// Half of what is drawn anew is of a vertex and a face or two edges, as codes of meshes take them.
/// Mutation alone makes hardly any of these of others.
ContactRange draw_range(Draw& draw) {
  constexpr std::array<std::array<Shape, 2>, 2> kOfMeshes = {
      {{Shape::point(), Shape::triangle(1)}, {Shape::curve(1), Shape::curve(1)}}};
  ContactRange range{.off_grid = true};
  if (draw.coin()) range.shapes = draw.pick(kOfMeshes);
  return range;
}

}  // namespace

std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed,
                        const CaseMutation& options) {
  Draw draw{Random(seed)};
  const std::uint8_t method = mutated_method(method_number({data, size}), options.methods, draw);
  if (draw.below(options.own_in) == 0 && LLVMFuzzerMutate != nullptr && size > 1) {
    data[0] = method;
    return 1 + LLVMFuzzerMutate(data + 1, size - 1, max_size - 1);
  }
  const std::optional<Contact> q = contact_of_bytes(std::span(data, size), options.range);
  // Draws from a source of its own: what the seed makes of q does not depend on it.
  Draw anew{Random::keyed({seed, 1})};
  if (anew.below(options.drawn_in) == 0 || !q) {
    const ContactRange range = draw_range(anew);
    const std::size_t drawn = put(draw_witnessed(anew, range), method, {data, max_size});
    if (drawn > 0) return drawn;
  }
  const Contact whole = q.value_or(falling_point());
  return put(mutate(whole, whole, draw, options.range), method, {data, max_size});
}

std::size_t cross_cases(std::span<const std::uint8_t> first, std::span<const std::uint8_t> second,
                        std::uint8_t* out, std::size_t max_size, unsigned seed, QueryRange range) {
  Draw draw{Random(seed)};
  const auto mother = contact_of_bytes(first, range), father = contact_of_bytes(second, range);
  if (!mother || !father) return 0;
  Contact child = *mother;
  if (!splice(child, *father, draw)) return 0;
  return put(mutate(child, *father, draw, range), method_number(first), {out, max_size});
}

}  // namespace ccdfuzz
