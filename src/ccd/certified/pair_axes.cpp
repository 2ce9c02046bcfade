#include "ccd/certified/pair_axes.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz::certified {

CornerFrame::CornerFrame(const CellTree& tree, CellTree::Node node, double t)
    : CornerFrame(tree.shape(), [net = tree.net(node), t](int i) {
        const double* x = net + kPerPoint * i;
        Axis p{x[0] + t * x[4], x[1] + t * x[5], x[2] + t * x[6]};
        if (const double weight = x[kWeightPlace]; weight != 0) {
          for (double& coordinate : p) coordinate /= weight;
        }
        return p;
      }) {}

CornerFrame::CornerFrame(const Shape& shape, const Snapshot& snapshot, double way)
    : CornerFrame(shape, [&](int i) {
        Axis p;
        for (int k = 0; k < 3; ++k) {
          p[k] = (1 - way) * snapshot.at(0, k, i) + way * snapshot.at(1, k, i);
        }
        return p;
      }) {}

CandidateAxes::CandidateAxes(const CornerFrame& a, const CornerFrame& b, bool apart)
    : a_(a), b_(b), apart_(apart) {
  const Axis offset = minus(a.middle, b.middle);
  if (apart && offset != Axis{}) add(offset);
  if (a.has_normal()) add(a.normal);
  if (b.has_normal()) add(b.normal);
  if (a.edge_count > 0 && b.edge_count > 0) add(cross(a.edges[0], b.edges[0]));
  if (a.has_normal()) add(cross(a.normal, a.edges[0]));
  if (count_ < kLanes) add_rest();
}

void CandidateAxes::add_rest() {
  complete_ = true;
  for (int i = 0; i < a_.edge_count; ++i) {
    for (int j = 0; j < b_.edge_count; ++j) {
      if (i + j > 0) add(cross(a_.edges[i], b_.edges[j]));
    }
  }
  for (const CornerFrame* s : {&a_, &b_}) {
    if (!s->has_normal()) continue;
    for (int i = s == &a_ ? 1 : 0; i < s->edge_count; ++i) add(cross(s->normal, s->edges[i]));
  }
  if (a_.has_normal() && b_.has_normal()) return;
  const Axis offset = minus(a_.middle, b_.middle);
  if (!apart_ && offset != Axis{}) add(offset);
  for (const CornerFrame* s : {&a_, &b_}) {
    for (int i = 0; i < s->edge_count; ++i) add(cross(s->edges[i], cross(offset, s->edges[i])));
  }
}

}  // namespace ccdfuzz::certified
