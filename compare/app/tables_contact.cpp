#include <algorithm>

#include "compare/app/commands.hpp"
#include "compare/app/results.hpp"
#include "compare/app/sharded.hpp"
#include "compare/contact/study.hpp"

namespace fiberchain::app {
namespace {

compare::ContactPlan contact_plan(const Arguments& arguments) {
  compare::ContactPlan plan;
  std::vector<std::pair<std::string, int>> choices;
  for (int test = 1; test <= compare::impact_tests; ++test) choices.emplace_back(std::to_string(test), test);
  read_choices(arguments, "--test", plan.tests, choices);
  return plan;
}

/// Rows of a shard with the number of their test among those asked for.
dem::Table by_test(const dem::Table& table, const std::vector<int>& tests, const OutputOptions& output) {
  if (!output.shard) return table;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < table.rows().size(); ++i) {
    const int test = static_cast<int>(table.number(i, "impact_test"));
    numbers.push_back(static_cast<std::size_t>(std::ranges::find(tests, test) - tests.begin()));
  }
  return with_cases(table, numbers);
}

int run_tables_contact(const Arguments& arguments, Context& context) {
  const OutputOptions output = output_options(arguments);
  compare::ContactPlan plan = contact_plan(arguments);
  const std::vector<int> tests = plan.tests;
  plan.tests = chosen(tests, deal(tests.size(), output, context));
  const auto directory = open_output(output, context);
  compare::ContactStudy study = compare::impact_study(plan, output.jobs);
  Results results{.name = "contact",
                  .heading = "Impacts of spheres: Chung & Ooi, Granular Matter 13 (2011) 643",
                  .table = by_test(study.table, tests, output)};
  results.more_tables.emplace_back("contact-steps", by_test(study.steps, tests, output));
  if (!output.shard) results.figures = std::move(study.figures);
  const dem::Table shown =
      results.table.select({"impact_test", "impact_material", "restitution", "incidence", "recoil",
                            "recoil_reference", "impact_steps", "impact_error", "impact_error_rigid"});
  deliver(results, shown, output, directory, context);
  return kSuccess;
}

}  // namespace

Command tables_contact_command() {
  return {
      .name = "tables contact",
      .description =
          "impacts of spheres, the eight tests of Chung & Ooi (2011), against references and "
          "published points, at the default step and at parts of it",
      .footer = "Without a choice all tests are made.\nExample:\n  fiberchain tables contact --test 1,2,4\n",
      .options = with_shards({{"--test", "LIST", "tests of Chung & Ooi, 1 to 8 [all]"}}),
      .run = &run_tables_contact};
}

}  // namespace fiberchain::app
