// Which name means what, at each point of a text.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "glsl/tree.hpp"

namespace warpjet::glsl {

struct Meaning {
  enum class Kind : std::uint8_t { None, Variable, Structure, Function } kind = Kind::None;
  // Of a variable or structure; functions have several.
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
    return found->second.back();
  }

  // Whether the name has no meaning yet in the innermost scope.
  bool isFree(std::string_view name) const {
    const std::size_t start = marks_.empty() ? 0 : marks_.back();
    for (std::size_t i = start; i < names_.size(); ++i)
      if (names_[i] == name) return false;
    return true;
  }

  void add(std::string_view name, Meaning meaning) {
    names_.push_back(name);
    meanings_[name].push_back(meaning);
  }

  // All names of a kind that mean something here, to `visit(name)`.
  template <class Visit>
  void each(Meaning::Kind kind, Visit visit) const {
    for (const auto& [name, meanings] : meanings_)
      if (!meanings.empty() && meanings.back().kind == kind) visit(name);
  }

 private:
  std::vector<std::string_view> names_;
  std::vector<std::size_t> marks_;
  std::map<std::string_view, std::vector<Meaning>> meanings_;
};

}  // namespace warpjet::glsl
