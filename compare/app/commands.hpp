#pragma once

#include <vector>

#include "compare/app/command.hpp"

/// The commands of the program, one source file each.
namespace fiberchain::app {

Command bench_command();           ///< run time against error, and what bounds the inner loops
Command calibrate_command();       ///< damping of the bonds for a damping of the fiber, and the reverse
Command check_command();           ///< what a scene will take, without running it
Command columns_command();         ///< the dictionary of the columns
Command fit_command();             ///< laws fitted to the damping against aspect ratio, Eq 20
Command identify_command();        ///< Young's modulus and damping from a ring-down
Command merge_command();           ///< shards of a study become the whole
Command materials_command();       ///< the materials of data/materials
Command render_command();          ///< pictures of a trajectory, Fig 11
Command report_command();          ///< one page that shows what holds
Command export_command();          ///< a trajectory as text for other programs
Command run_command();             ///< one scene
Command stability_command();       ///< largest stable step, theory and runs
Command tables_capstan_command();  ///< fibers that slide about a drum
Command tables_contact_command();  ///< impacts of spheres, adhesion
Command tables_contact_modulus_command();  ///< packings by the modulus of their contacts
Command tables_damping_command();          ///< damping of the fiber by that of the bonds, Figs 6 to 9
Command tables_friction_command();         ///< rolling friction of the bonds, Fig 10
Command tables_materials_command();        ///< the damping that materials have
Command tables_packing_command();          ///< many fibers fall and pack, Figs 11 and 12
Command tables_press_command();            ///< beds of fibers under a plate, van Wyk's law
Command tables_rod_packing_command();      ///< packings of stiff rods
Command tables_rods_command();             ///< rods in space, chains against shooting
Command tables_shear_command();            ///< fibers in flows: orbits, flexible fibers, buckling, Fig 5
Command tables_spacing_command();          ///< fibers cut into bonds longer than thick
Command tables_static_command();  ///< departure of the chain from the Elastica, its causes, Figs 3 and 4
Command validate_command();       ///< the validation matrix
Command manual_command();         ///< the manual page
Command completion_command();     ///< scripts of shells

/// A name that commands share, "tables", and what it stands for.
struct Group {
  std::string name;
  std::string description;
  std::string footer;
};

/// All of them, in the order of the help.
inline std::vector<Command> all_commands() {
  return {columns_command(),
          run_command(),
          check_command(),
          render_command(),
          export_command(),
          tables_static_command(),
          tables_damping_command(),
          tables_friction_command(),
          tables_materials_command(),
          tables_shear_command(),
          tables_packing_command(),
          tables_contact_command(),
          tables_contact_modulus_command(),
          tables_press_command(),
          tables_spacing_command(),
          tables_rod_packing_command(),
          tables_rods_command(),
          tables_capstan_command(),
          fit_command(),
          calibrate_command(),
          identify_command(),
          materials_command(),
          stability_command(),
          bench_command(),
          merge_command(),
          validate_command(),
          report_command(),
          manual_command(),
          completion_command()};
}

inline std::vector<Group> all_groups() {
  return {{"tables", "make the paper's tables and figures",
           "Example:\n  fiberchain tables static --load 0.05..10:log:12"}};
}

}  // namespace fiberchain::app
