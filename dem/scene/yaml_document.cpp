#include "dem/scene/yaml_document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "dem/scene/scene_error.hpp"

namespace fiberchain::dem {
namespace {

/// Handler that discards the events of a document.
struct DiscardEvents : YAML::EventHandler {
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
  }
  void OnMapEnd() override {}
};

/// YAML::Load ignores what follows the first document, and YAML::LoadAll of yaml-cpp 0.7 never ends on
/// some texts (", a"), so that text is looked for here.
void check_single(const std::string& text, const std::string& name) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DiscardEvents skip;
  parser.HandleNextDocument(skip);
  if (parser) throw SceneError(name + ": holds more than one document, or text after its end");
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  const auto is_odd = [](unsigned char c) { return c < 0x20 || c >= 0x7f; };
  std::string safe(text.substr(0, kLongest));
  std::ranges::replace_if(safe, is_odd, '?');
  return text.size() > kLongest ? safe + "..." : safe;
}

YAML::Node read_document(const std::string& text, const std::string& name) {
  try {
    check_single(text, name);
    const YAML::Node document = YAML::Load(text);
    if (!document.IsDefined() || document.IsNull()) throw SceneError(name + ": holds no scene: it is empty");
    return document;
  } catch (const YAML::DeepRecursion&) {
    throw SceneError(name + ": is nested too deeply");
  } catch (const YAML::Exception& error) {
    throw SceneError(fmt::format("{}:{}: is no YAML: {}", name, error.mark.line + 1, printable(error.msg)));
  }
}

}  // namespace fiberchain::dem
