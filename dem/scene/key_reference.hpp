#pragma once

#include <string>

namespace fiberchain::dem {

/// All keys of all kinds of scenes in Markdown tables, made from their declarations: key, unit, allowed
/// values, default, meaning.
std::string key_reference();

}  // namespace fiberchain::dem
