#include "ccd/certified/cell_tree.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <tuple>

namespace ccdfuzz::certified {

namespace {

/// Programs are made once per shape and live as long as the process.
const MidpointProgram& program_for(const Shape& shape) {
  static std::mutex mutex;
  static std::map<std::tuple<int, int, int>, std::unique_ptr<MidpointProgram>> programs;
  const std::scoped_lock lock(mutex);
  auto& program = programs[{static_cast<int>(shape.kind), shape.n, shape.m}];
  if (!program) program = std::make_unique<MidpointProgram>(shape);
  return *program;
}

}  // namespace

void CellTree::reset(const Shape& shape, std::span<const std::array<double, 6>> controls,
                     std::span<const double> weights) {
  if (program_ == nullptr || !(shape == shape_)) program_ = &program_for(shape);
  shape_ = shape;
  is_rational_ = !weights.empty();
  stride_ = static_cast<size_t>(kPerPoint) * controls.size();
  slots_.resize(stride_ + static_cast<size_t>(kPerPoint) * program_->steps.size());
  values_.reset(stride_);
  nodes_.reset();
  // The root, and room, so that each family begins at a multiple of its size.
  const auto family = static_cast<size_t>(shape.child_count());
  values_.resize(family);
  nodes_.resize(family);
  made_ = 1;
  *nodes_[0] = {};
  nodes_[0]->crossed = !region_.is_whole();
  double* net = values_[0];
  for (size_t i = 0; i < controls.size(); ++i, net += kPerPoint) {
    const double weight = is_rational_ ? weights[i] : 1;
    for (size_t k = 0; k < 3; ++k) {
      net[k] = weight * controls[i][k];
      net[k + 4] = weight * controls[i][k + 3];
    }
    net[kWeightPlace] = is_rational_ ? weight : 0;
    net[7] = 0;
  }
}

Cell CellTree::cell(Node node) const {
  const Entry& entry = *nodes_[node];
  return entry.parent == kNone ? Cell{} : cell(entry.parent).child(shape_, entry.place);
}

CellTree::Node CellTree::children(Node parent) {
  if (nodes_[parent]->first_child != kNone) return nodes_[parent]->first_child;
  if (shape_.kind == ShapeKind::kPoint) return nodes_[parent]->first_child = parent;
  const Node first = static_cast<Node>(nodes_.size());
  const size_t count = static_cast<size_t>(shape_.child_count());
  values_.resize(first + count);
  nodes_.resize(first + count);
  made_ += count;
  const auto depth = static_cast<std::uint8_t>(nodes_[parent]->depth + 1);
  for (size_t c = 0; c < count; ++c) {
    *nodes_[first + c] = {parent, kNone, depth, static_cast<std::uint8_t>(c)};
  }
  if (nodes_[parent]->crossed) {
    const TrimRegion::Children in_domain = region_.children(cell(parent));
    nodes_[parent]->outside = static_cast<std::uint8_t>(in_domain.outside);
    for (size_t c = 0; c < count; ++c) {
      nodes_[first + c]->crossed = (in_domain.crossed >> c & 1) != 0;
    }
  }
  nodes_[parent]->first_child = first;
  split_net(*program_, net(parent), this->count(), slots_.data(), values_[first]);
  return first;
}

}  // namespace ccdfuzz::certified
