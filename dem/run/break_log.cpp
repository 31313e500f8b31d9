#include "dem/run/break_log.hpp"

#include <string>

namespace fiberchain::dem {

Table break_log_table() {
  return Table({"step", "simulated_time", "break_fiber", "break_bond", "break_cause", "break_stress",
                "break_energy", "break_x", "break_y", "break_z"});
}

Table break_log_rows(Assembly& assembly) {
  Table table = break_log_table();
  for (const BondBreak& one : assembly.take_breaks()) {
    std::int64_t fiber = one.fiber;
    for (int g = 0; g < one.group; ++g) fiber += assembly.fibers(g);
    table.append({{"step", one.step},
                  {"simulated_time", one.time},
                  {"break_fiber", fiber},
                  {"break_bond", std::int64_t{one.bond}},
                  {"break_cause", std::string(name(one.cause))},
                  {"break_stress", one.stress},
                  {"break_energy", one.energy},
                  {"break_x", one.place[0]},
                  {"break_y", one.place[1]},
                  {"break_z", one.place[2]}});
  }
  return table;
}

}  // namespace fiberchain::dem
