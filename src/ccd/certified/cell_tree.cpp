#include "ccd/certified/cell_tree.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "numeric/verify.hpp"

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

void CellTree::reset(const Shape& shape, std::span<const std::array<double, 6>> controls) {
  if (program_ == nullptr || !(shape == shape_)) program_ = &program_for(shape);
  shape_ = shape;
  width_ = (shape.control_count() + 3) / 4 * 4;
  stride_ = 6 * static_cast<size_t>(width_);
  slots_.resize(static_cast<size_t>(shape.control_count()) + program_->steps.size());
  cells_.assign(1, Cell{});
  first_child_.assign(1, kNone);
  values_.resize(stride_);
  double* net = values_.data();
  for (int k = 0; k < 6; ++k) {
    for (int i = 0; i < width_; ++i) {
      *net++ = controls[std::min(static_cast<size_t>(i), controls.size() - 1)][k];
    }
  }
}

void CellTree::store(Node node, std::span<const std::array<double, 6>> slots,
                     const std::vector<int>& places) {
  double* net = &values_[size_t{node} * stride_];
  const int count = static_cast<int>(places.size());
  for (int i = 0; i < width_; ++i) {
    const std::array<double, 6>& p = slots[places[std::min(i, count - 1)]];
    for (int k = 0; k < 6; ++k) net[k * width_ + i] = p[k];
  }
}

CellTree::Node CellTree::children(Node parent) {
  if (first_child_[parent] != kNone) return first_child_[parent];
  if (shape_.kind == ShapeKind::kPoint) return first_child_[parent] = parent;
  const Node first = static_cast<Node>(cells_.size());
  const size_t count = static_cast<size_t>(shape_.child_count());
  values_.resize(values_.size() + count * stride_);
  const Cell cell = cells_[parent];
  for (size_t c = 0; c < count; ++c) {
    cells_.push_back(cell.child(shape_, static_cast<int>(c)));
    first_child_.push_back(kNone);
  }
  first_child_[parent] = first;

  const double* from = net(parent);
  const int controls = shape_.control_count();
  for (int i = 0; i < controls; ++i) {
    for (int k = 0; k < 6; ++k) slots_[i][k] = from[k * width_ + i];
  }
  std::array<double, 6>* next = &slots_[controls];
  for (const MidpointProgram::Step step : program_->steps) {
    const std::array<double, 6>&l = slots_[step.left], &r = slots_[step.right];
    for (int k = 0; k < 6; ++k) (*next)[k] = (l[k] + r[k]) * 0.5;
    ++next;
  }
  for (size_t c = 0; c < count; ++c) {
    store(first + static_cast<Node>(c), slots_, program_->children[c]);
  }
  return first;
}

}  // namespace ccdfuzz::certified
