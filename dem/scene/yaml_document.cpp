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

/// Whether this line (from 0) is indented with a tab, which yaml-cpp answers with "illegal map value".
bool has_tab_indent(const std::string& text, int number) {
  std::istringstream stream(text);
  std::string line;
  for (int n = 0; n <= number; ++n) std::getline(stream, line);
  const std::size_t first = line.find_first_not_of(" \t");
  return first != line.npos && line.find('\t') < first;
}

/// Editors on Windows begin UTF-8 with a mark of the byte order.
std::string without_byte_order_mark(const std::string& text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  const auto is_odd = [](unsigned char c) { return c < 0x20 || c >= 0x7f; };
  std::string safe(text.substr(0, kLongest));
  std::ranges::replace_if(safe, is_odd, '?');
  return text.size() > kLongest ? safe + "..." : safe;
}

YAML::Node read_document(const std::string& bytes, const std::string& name) {
  const std::string text = without_byte_order_mark(bytes);
  try {
    check_single(text, name);
    const YAML::Node document = YAML::Load(text);
    if (!document.IsDefined() || document.IsNull()) throw SceneError(name + ": holds no scene: it is empty");
    return document;
  } catch (const YAML::DeepRecursion&) {
    throw SceneError(name + ": is nested too deeply");
  } catch (const YAML::Exception& error) {
    if (has_tab_indent(text, error.mark.line)) {
      throw SceneError(
          fmt::format("{}:{}: is indented with a tab: YAML allows spaces only", name, error.mark.line + 1));
    }
    throw SceneError(fmt::format("{}:{}: is no YAML: {}", name, error.mark.line + 1, printable(error.msg)));
  }
}

}  // namespace fiberchain::dem
