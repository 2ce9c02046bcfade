#pragma once

#include <cstdint>

#include "numeric/block_array.hpp"

namespace ccdfuzz {

/// The queue of a search, a binary heap: taken first is an entry x for which Entry::later(x, y) of
/// no other y. Keeps its memory.
template <class Entry>
class SearchQueue {
 public:
  bool empty() const { return entries_.size() == 0; }
  std::size_t size() const { return entries_.size(); }
  /// Entry i, in the order of the heap: 0 is taken next.
  const Entry& operator[](std::size_t i) const { return *entries_[i]; }

  void clear() { entries_.reset(); }
  void push(const Entry& entry) {
    std::size_t hole = entries_.size();
    entries_.resize(hole + 1);
    for (; hole > 0 && Entry::later(*entries_[(hole - 1) / 2], entry); hole = (hole - 1) / 2) {
      *entries_[hole] = *entries_[(hole - 1) / 2];
    }
    *entries_[hole] = entry;
  }
  Entry pop() {
    const Entry first = *entries_[0], last = *entries_[entries_.size() - 1];
    const std::size_t left = entries_.size() - 1;
    std::size_t hole = 0;
    for (std::size_t child = 1; child < left; child = 2 * hole + 1) {
      if (child + 1 < left && Entry::later(*entries_[child], *entries_[child + 1])) ++child;
      if (!Entry::later(last, *entries_[child])) break;
      *entries_[hole] = *entries_[child];
      hole = child;
    }
    *entries_[hole] = last;
    entries_.resize(left);
    return first;
  }

  /// Bytes of the entries, and of the memory that is held for them.
  std::uint64_t bytes() const { return entries_.size() * sizeof(Entry); }
  std::uint64_t held() const { return entries_.held(); }
  /// Gives back what is held beyond so many bytes, but for the entries.
  void keep_at_most(std::size_t bytes) { entries_.keep_at_most(bytes); }

 private:
  BlockArray<Entry> entries_;
};

}  // namespace ccdfuzz
