#include "dem/assembly/packing_law.hpp"

namespace fiberchain::dem {
namespace {

template <BondForm form>
constexpr PackingLaw library_law = packing_law_with<form>(packing_kernel);

}  // namespace

const PackingLaw& packing_law(const AssemblyOptions& options) {
  if (options.law != nullptr) return *options.law;
  return with_bond_form(options.form, []<BondForm form>() -> const PackingLaw& { return library_law<form>; });
}

}  // namespace fiberchain::dem
