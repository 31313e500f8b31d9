#include <filesystem>

#include <boost/test/unit_test.hpp>

#include "tests/program/packings.hpp"
#include "tests/program/process.hpp"

BOOST_AUTO_TEST_SUITE(pictures_test)

using namespace fiberchain::test;

namespace {

namespace fs = std::filesystem;

const std::string kCantilever =
    "scene: cantilever\n"
    "fiber: {diameter: 2 mm, aspect_ratio: 10, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000}\n"
    "load: {reduced: 1}\n";

/// A directory with a gnuplot that fails, for PATH.
fs::path failing_gnuplot(const Scratch& scratch) {
  const fs::path program = scratch.file("bin/gnuplot", "#!/bin/sh\necho no such terminal >&2\nexit 1\n");
  fs::permissions(program, fs::perms::owner_all);
  return program.parent_path();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_CASE(without_gnuplot_tables_are_written_and_a_warning_says_what_to_install) {
  const Scratch scratch;
  scratch.file("s.yaml", kCantilever);
  const Outcome outcome =
      run({"run", "s.yaml"}, {.directory = scratch.path, .environment = {{"PATH", "/nonexistent"}}});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(has(outcome.error, "warning: gnuplot is not installed (Debian package gnuplot-nox)"),
             outcome.error);
  BOOST_TEST(has(outcome.error, "pictures are missing"), outcome.error);
  for (const char* name : {"s.csv", "s.md", "s-shape.csv"})
    BOOST_TEST(fs::exists(scratch.path / "results" / name), name);
  BOOST_TEST(files_under(scratch.path / "results") == 3);
}

BOOST_AUTO_TEST_CASE(figures_are_of_the_formats_asked_for) {
  const Scratch scratch;
  scratch.file("s.yaml", kCantilever);
  const Outcome outcome =
      run({"run", "s.yaml", "--figure-format", "svg,pdf", "--no-title"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(content(scratch.path / "results" / "s-shape.pdf").starts_with("%PDF"));
  BOOST_TEST(!has(content(scratch.path / "results" / "s-shape.svg"), "Cantilever, "));
  BOOST_TEST(!fs::exists(scratch.path / "results" / "s-shape.png"));
  const Outcome wrong = run({"run", "s.yaml", "--figure-format", "jpeg"}, {.directory = scratch.path});
  BOOST_TEST(wrong.status == 2);
  BOOST_TEST(is_one_error(wrong.error), wrong.error);
  BOOST_TEST(has(wrong.error, "svg"), wrong.error);
}

BOOST_AUTO_TEST_CASE(a_gnuplot_that_fails_costs_the_pictures) {
  const Scratch scratch;
  scratch.file("s.yaml", kCantilever);
  const fs::path bin = failing_gnuplot(scratch);
  const Outcome plain = run({"run", "s.yaml", "--out", "plain"}, {.directory = scratch.path});
  const Outcome outcome =
      run({"run", "s.yaml", "--out", "failed"}, {.directory = scratch.path, .environment = {{"PATH", bin}}});
  BOOST_TEST(plain.status == 0);
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(
      has(outcome.error, "warning: 1 of 1 pictures are missing, all tables are written: gnuplot failed"),
      outcome.error);
  BOOST_TEST(files_under(scratch.path / "plain") == 5);
  BOOST_TEST(files_under(scratch.path / "failed") == 3);
}

BOOST_AUTO_TEST_CASE(a_packing_writes_its_row_whatever_becomes_of_its_pictures) {
  const FewFibers fibers(200);
  const Outcome outcome =
      run(fibers.arguments(), {.directory = fibers.path, .environment = {{"PATH", failing_gnuplot(fibers)}}});
  BOOST_TEST(outcome.status == 0);
  BOOST_TEST(has(content(fibers.out("s.csv")), "finished"));
  BOOST_TEST(has(outcome.error, "2 of 2 pictures are missing") == false, outcome.error);
  BOOST_TEST(has(outcome.error, "pictures are missing"), outcome.error);
}

BOOST_AUTO_TEST_CASE(what_a_study_needs_is_looked_for_before_it_begins) {
  const Scratch scratch;
  const Outcome outcome = run({"tables", "packing", "--data", "/nonexistent"}, {.directory = scratch.path});
  BOOST_TEST(outcome.status == 2);
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
  BOOST_TEST(files_under(scratch.path) == 0);
}

BOOST_AUTO_TEST_CASE(render_without_gnuplot_is_one_error_and_makes_nothing) {
  const FewFibers fibers(200);
  BOOST_TEST(fibers.go().status == 0);
  const Outcome outcome = run({"render", "out/s.h5", "--out", "pictures"},
                              {.directory = fibers.path, .environment = {{"PATH", "/nonexistent"}}});
  BOOST_TEST(outcome.status == 3);
  BOOST_TEST(is_one_error(outcome.error), outcome.error);
  BOOST_TEST(has(outcome.error, "gnuplot-nox"), outcome.error);
  BOOST_TEST(!fs::exists(fibers.path / "pictures"));
}

BOOST_AUTO_TEST_SUITE_END()
