// The meaning of names at each point of the source.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "source/tree.hpp"

namespace warpjet::source {

struct Meaning {
  enum class Kind : std::uint8_t { None, Variable, Structure, Function, Block } kind = Kind::None;
  // The index of a variable or structure. A function has none, since a name may have several
  // overloads.
  std::int32_t index = nothing;
};

class Scope {
 public:
  void open() { marks_.push_back(names_.size()); }
  void close() {
    while (names_.size() > marks_.back()) {
      meanings_[names_.back()].pop_back();
      names_.pop_back();
    }
    marks_.pop_back();
  }
  bool isGlobal() const { return marks_.empty(); }

  Meaning find(std::string_view name) const {
    const auto found = meanings_.find(name);
    if (found == meanings_.end() || found->second.empty()) return {};
    return found->second.back().meaning;
  }

  // Returns true if the name has no meaning yet in the innermost scope.
  bool isFree(std::string_view name) const {
    const auto found = meanings_.find(name);
    return found == meanings_.end() || found->second.empty() ||
           found->second.back().depth < marks_.size();
  }

  void add(std::string_view name, Meaning meaning) {
    names_.push_back(name);
    meanings_[name].push_back({meaning, marks_.size()});
  }

  // Calls `visit(name)` for all names of a kind that are visible here.
  template <class Visit>
  void each(Meaning::Kind kind, Visit visit) const {
    for (const auto& [name, meanings] : meanings_)
      if (!meanings.empty() && meanings.back().meaning.kind == kind) visit(name);
  }

 private:
  struct Entry {
    Meaning meaning;
    std::size_t depth;  // the depth of the scope that declares it
  };

  std::vector<std::string_view> names_;
  std::vector<std::size_t> marks_;
  std::map<std::string_view, std::vector<Entry>> meanings_;
};

}  // namespace warpjet::source
