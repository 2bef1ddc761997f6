#include "graph/schedule.hpp"

#include <algorithm>

namespace warpjet {

namespace {

class Scheduler {
 public:
  explicit Scheduler(const Work& work)
      : work_(work),
        size_(static_cast<std::uint32_t>(work.tasks.size())),
        states_(size_),
        readers_(work) {
    for (std::uint32_t i = 0; i < size_; ++i) {
      states_[i].undone = static_cast<std::uint32_t>(work.readsOf(i).size());
      states_[i].readers = static_cast<std::uint32_t>(readers_.of(i).size());
    }
    findHeights();
  }

  std::vector<std::uint32_t> run() {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (states_[i].undone == 0) offer(i);
    }
    std::vector<std::uint32_t> order;
    order.reserve(size_);
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const std::uint32_t next = ~static_cast<std::uint32_t>(heap_.back());
      heap_.pop_back();
      if (states_[next].isDone) continue;
      take(next);
      order.push_back(next);
    }
    return order;
  }

 private:
  struct State {
    std::uint32_t undone = 0;   // unfinished tasks that it reads
    std::uint32_t readers = 0;  // unfinished tasks that read it
    std::uint32_t height = 0;   // length of the longest path to a result
    bool isDone = false;
  };

  void findHeights() {
    for (std::uint32_t i = size_; i-- > 0;) {
      for (const std::uint32_t read : work_.readsOf(i))
        states_[read].height = std::max(states_[read].height, states_[i].height + 1);
    }
  }

  // Returns true if the next reader of a value is the last, so that the value dies. Results never
  // die.
  bool diesWithNext(std::uint32_t i) const {
    return states_[i].readers == 1 && !work_.tasks[i].isResult;
  }

  void offer(std::uint32_t i) {
    std::uint64_t dying = 0;
    for (const std::uint32_t read : work_.readsOf(i)) dying += diesWithNext(read);
    heap_.push_back(std::min<std::uint64_t>(dying, 255) << 56 |
                    std::uint64_t{states_[i].height} << 32 | ~i);
    std::push_heap(heap_.begin(), heap_.end());
  }

  void take(std::uint32_t i) {
    states_[i].isDone = true;
    for (const std::uint32_t read : work_.readsOf(i)) {
      --states_[read].readers;
      if (diesWithNext(read)) offerAgain(read);
    }
    for (const std::uint32_t reader : readers_.of(i)) {
      if (--states_[reader].undone == 0) offer(reader);
    }
  }

  // Offers the last reader of a value again, since it has become a better candidate. Its old entry
  // stays in the heap and is skipped later.
  void offerAgain(std::uint32_t read) {
    for (const std::uint32_t reader : readers_.of(read)) {
      if (!states_[reader].isDone && states_[reader].undone == 0) offer(reader);
    }
  }

  const Work& work_;
  std::uint32_t size_;
  std::vector<State> states_;
  Readers readers_;
  // Candidates, best on top. Each is one number: how many values die with the task, its height, and
  // the complement of its task number.
  std::vector<std::uint64_t> heap_;
};

}  // namespace

// Groups the readers by the task that they read, by counting sort: counts them, then places each
// after the readers of the preceding tasks.
Readers::Readers(const Work& work) : ends_(work.tasks.size() + 2) {
  const auto size = static_cast<std::uint32_t>(work.tasks.size());
  for (std::uint32_t i = 0; i < size; ++i) {
    for (const std::uint32_t read : work.readsOf(i)) ++ends_[read + 2];
  }
  for (std::uint32_t i = 2; i < size + 2; ++i) ends_[i] += ends_[i - 1];
  all_.resize(ends_.back());
  for (std::uint32_t i = 0; i < size; ++i) {
    for (const std::uint32_t read : work.readsOf(i)) all_[ends_[read + 1]++] = i;
  }
}

std::vector<std::uint32_t> schedule(const Work& work) { return Scheduler(work).run(); }

}  // namespace warpjet
