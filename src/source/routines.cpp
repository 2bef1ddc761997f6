#include "source/routines.hpp"

namespace warpjet::source {

std::set<RoutineKey> calledOnce(const Recorder& recorder, const std::vector<Routine>& routines,
                                const std::vector<Id>& results) {
  std::vector<std::size_t> calls(routines.size());
  std::vector<std::size_t> pending;
  const auto countIn = [&](const std::vector<Id>& roots) {
    for (const Id id : recorder.neededBy(roots)) {
      const Operation& each = recorder.at(id);
      if (each.code != Code::Call) continue;
      const auto routine = static_cast<std::size_t>(each.value);
      if (calls[routine]++ == 0) pending.push_back(routine);
    }
  };
  countIn(results);
  while (!pending.empty()) {
    const std::size_t routine = pending.back();
    pending.pop_back();
    countIn(routines[routine].results);
  }
  std::set<RoutineKey> once;
  for (std::size_t i = 0; i < routines.size(); ++i)
    if (calls[i] == 1) once.insert(routines[i].key);
  return once;
}

}  // namespace warpjet::source
