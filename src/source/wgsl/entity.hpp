// The meaning of a name in WGSL.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "source/wgsl/operand.hpp"

namespace warpjet::source::wgsl {

struct Entity {
  enum class Kind : std::uint8_t {
    None,
    Value,        // `value`: a variable, a constant, or a pointer
    Type,         // `type`
    Function,     // `index`
    Unsupported,  // `reason`: a declaration that no warp can read
  };

  Kind kind = Kind::None;
  Operand value{};
  Type type{};
  FunctionId index = nothing;
  std::string reason{};
};

// The local names at one point of a function. Inner scopes may redeclare names.
class Scopes {
 public:
  void open() { scopes_.emplace_back(); }
  void close() { scopes_.pop_back(); }

  bool isFree(std::string_view name) const { return !scopes_.back().contains(name); }
  void add(std::string_view name, Entity entity) {
    scopes_.back().emplace(name, std::move(entity));
  }

  const Entity* find(std::string_view name) const {
    for (std::size_t i = scopes_.size(); i-- > 0;)
      if (const auto found = scopes_[i].find(name); found != scopes_[i].end())
        return &found->second;
    return nullptr;
  }

  template <class Visit>
  void each(const Visit& visit) const {
    for (const auto& scope : scopes_)
      for (const auto& [name, entity] : scope) visit(name, entity);
  }

 private:
  std::vector<std::map<std::string_view, Entity>> scopes_;
};

// A declaration outside of functions, which may be used above itself.
struct Global {
  std::string_view name;
  Location location;
  // The positions of its first attribute and of its keyword.
  std::size_t start = 0, keyword = 0;
  enum class State : std::uint8_t { New, Open, Done } state = State::New;
  Entity entity{};
};

}  // namespace warpjet::source::wgsl
