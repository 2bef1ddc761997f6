#include "source/recursion.hpp"

namespace warpjet::source {

// Searches depth-first, and visits each function once.
std::optional<FunctionCall> findRecursion(std::size_t functionCount,
                                          const std::vector<FunctionCall>& calls) {
  enum class State : std::uint8_t { New, Open, Done };
  std::vector<State> states(functionCount, State::New);
  std::vector<std::vector<std::size_t>> from(functionCount);
  for (std::size_t i = 0; i < calls.size(); ++i) from[calls[i].from].push_back(i);
  for (std::size_t root = 0; root < states.size(); ++root) {
    if (states[root] != State::New) continue;
    std::vector<std::pair<std::size_t, std::size_t>> way{{root, 0}};
    states[root] = State::Open;
    while (!way.empty()) {
      auto& [function, next] = way.back();
      if (next == from[function].size()) {
        states[function] = State::Done;
        way.pop_back();
        continue;
      }
      const FunctionCall& call = calls[from[function][next++]];
      if (states[call.to] == State::Open) return call;
      if (states[call.to] == State::New) {
        states[call.to] = State::Open;
        way.push_back({static_cast<std::size_t>(call.to), 0});
      }
    }
  }
  return std::nullopt;
}

}  // namespace warpjet::source
