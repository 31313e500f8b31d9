#include "compare/study/validation.hpp"

#include <limits>

namespace fiberchain::compare {
namespace {

MatrixRow own_row(ReferenceKind kind, std::string id, std::string feature, double expected, double measured,
                  double tolerance, std::string source, std::string evidence) {
  return judged({std::move(id), std::move(feature), kind, expected, measured, tolerance, "1", Verdict::fails,
                 std::move(source), std::move(evidence)});
}

MatrixRow from_published(const ValidationInput& input, std::string_view id, double measured, double tolerance,
                         std::string evidence) {
  const PublishedValue& value = find_published(input.published, id);
  return {value.id,
          value.feature,
          ReferenceKind::published,
          value.value,
          measured,
          tolerance,
          value.unit,
          Verdict::fails,
          value.source + ", " + value.page_or_figure + ": " + value.statement,
          std::move(evidence)};
}

}  // namespace

const std::vector<ValidationStep>& validation_steps() {
  static const std::vector<ValidationStep> steps{{"beams", beam_rows},
                                                 {"static cantilever", static_rows},
                                                 {"damped vibration", damping_rows},
                                                 {"rolling friction", rolling_rows},
                                                 {"stability", stability_rows},
                                                 {"fibers in flows", flow_rows},
                                                 {"packing", packing_rows}};
  return steps;
}

MatrixRow exact_row(std::string id, std::string feature, double expected, double measured, double tolerance,
                    std::string source, std::string evidence) {
  return own_row(ReferenceKind::exact, std::move(id), std::move(feature), expected, measured, tolerance,
                 std::move(source), std::move(evidence));
}

MatrixRow method_row(std::string id, std::string feature, double expected, double measured, double tolerance,
                     std::string source, std::string evidence) {
  return own_row(ReferenceKind::independent_method, std::move(id), std::move(feature), expected, measured, tolerance,
                 std::move(source), std::move(evidence));
}

MatrixRow published_row(const ValidationInput& input, std::string_view id, double measured, double tolerance,
                        std::string evidence) {
  return judged(from_published(input, id, measured, tolerance, std::move(evidence)));
}

MatrixRow disputed_row(const ValidationInput& input, std::string_view id, double measured, std::string evidence) {
  return disputed(
      from_published(input, id, measured, std::numeric_limits<double>::quiet_NaN(), std::move(evidence)));
}

}  // namespace fiberchain::compare
