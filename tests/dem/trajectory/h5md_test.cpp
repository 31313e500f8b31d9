#include "dem/trajectory/h5md.hpp"

#include <sys/wait.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <thread>

#include "dem/files/file_error.hpp"
#include "dem/files/journaled_file.hpp"
#include "dem/model/errors.hpp"
#include "tests/dem/trajectory/damaged_hdf5.hpp"
#include "tests/dem/trajectory/files.hpp"
#include "tests/dem/trajectory/h5md_frames.hpp"

namespace {

/// As the program does: HDF5 cannot tidy up after damaged files.
struct NoTidyingUp {
  NoTidyingUp() { fiberchain::dem::leave_hdf5_as_it_is_at_exit(); }
};

}  // namespace

BOOST_TEST_GLOBAL_FIXTURE(NoTidyingUp);

BOOST_AUTO_TEST_SUITE(h5md_test)

namespace dem = fiberchain::dem;
using namespace fiberchain::dem;
using namespace fiberchain::test;
namespace fs = std::filesystem;

namespace {

/// A journaled file of so many bytes, "ooo..." behind its head.
void make_file(const fs::path& path, std::size_t bytes) {
  JournaledFile file(path, JournaledFile::Mode::create);
  const std::string letters(bytes - FileHead::kBytes, 'o');
  file.write(FileHead::kBytes, letters.data(), letters.size());
  file.commit();
}

}  // namespace

BOOST_AUTO_TEST_CASE(frames_come_back) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  TrajectoryWriter writer(path, kHeader);
  for (const std::int64_t step : {0, 70, 130}) {
    writer.append(bent_fibers(3, 7, step), {{"height", 0.1 * static_cast<double>(step)}, {"alpha", 2.5}});
    const TrajectoryReader reader(path);  // while the run goes on
    BOOST_TEST(reader.frames() == writer.frames());
    check_equal(reader.read(reader.frames() - 1), bent_fibers(3, 7, step));
  }
  const TrajectoryReader reader(path);
  check_equal(reader.read(1), bent_fibers(3, 7, 70));
  BOOST_TEST((reader.scalars(1) == Scalars{{"alpha", 2.5}, {"height", 7.0}}));
  BOOST_TEST((reader.provenance() == Entries{{"command", "fiberchain run x.yaml"}, {"commit", "abc"}}) ==
             true);
  BOOST_TEST(files_in(scratch.path) == 2);  // and run.h5md
  BOOST_TEST(TrajectoryReader(scratch.path / "run.h5md").frames() == 3);
  BOOST_CHECK_THROW(reader.read(3), ReadError);
  BOOST_CHECK_THROW(reader.read(-1), ReadError);
}

BOOST_AUTO_TEST_CASE(single_spheres_are_a_trajectory_too) {
  const Scratch scratch;
  TrajectoryWriter writer(scratch.path / "run.h5", kHeader);
  writer.append(bent_fibers(5, 1, 3));
  check_equal(TrajectoryReader(scratch.path / "run.h5").read(0), bent_fibers(5, 1, 3));
}

BOOST_AUTO_TEST_CASE(resuming_cuts_what_is_later_and_goes_on) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5", straight = scratch.path / "straight.h5";
  TrajectoryWriter writer(path, kHeader), through(straight, kHeader);
  write_frames(writer, 0, 60);
  TrajectoryWriter resumed = TrajectoryWriter::resume(path, kHeader, 35);
  BOOST_TEST(resumed.frames() == 4);
  BOOST_TEST((TrajectoryReader(path).steps() == std::vector<std::int64_t>{0, 10, 20, 30}) == true);
  write_frames(resumed, 40, 90);
  write_frames(through, 0, 90);
  const TrajectoryReader found(path), expected(straight);
  BOOST_TEST(found.steps() == expected.steps(), boost::test_tools::per_element());
  for (std::int64_t n = 0; n < expected.frames(); ++n) check_equal(found.read(n), expected.read(n));
  // a run that was killed before its first checkpoint, or before its first frame
  BOOST_TEST(TrajectoryWriter::resume(path, kHeader, -1).frames() == 0);
  BOOST_TEST(TrajectoryWriter::resume(scratch.path / "none.h5", kHeader, 100).frames() == 0);
}

BOOST_AUTO_TEST_CASE(frames_that_do_not_go_with_earlier_ones_are_refused) {
  const Scratch scratch;
  TrajectoryWriter writer(scratch.path / "run.h5", kHeader);
  writer.append(bent_fibers(3, 7, 10), {{"height", 1}});
  BOOST_CHECK_THROW(writer.append(bent_fibers(3, 8, 20), {{"height", 1}}), InvalidInput);
  BOOST_CHECK_THROW(writer.append(bent_fibers(3, 7, 10), {{"height", 1}}), InvalidInput);
  BOOST_CHECK_THROW(writer.append(bent_fibers(3, 7, 20), {{"width", 1}}), InvalidInput);
  BOOST_CHECK_THROW(writer.append(bent_fibers(3, 7, 20)), InvalidInput);
  TrajectoryFrame short_of_one = bent_fibers(3, 7, 20);
  short_of_one.velocity.pop_back();
  BOOST_CHECK_THROW(writer.append(short_of_one, {{"height", 1}}), InvalidInput);
  writer.append(bent_fibers(3, 7, 20), {{"height", 1}});
  BOOST_TEST(TrajectoryReader(scratch.path / "run.h5").frames() == 2);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_trajectory_are_refused) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  BOOST_CHECK_THROW(TrajectoryReader{path}, ReadError);
  BOOST_CHECK_THROW(TrajectoryReader{scratch.path}, ReadError);
  std::ofstream(path) << "no HDF5";
  BOOST_CHECK_THROW(TrajectoryReader{path}, ReadError);
  BOOST_CHECK_THROW(TrajectoryWriter::resume(path, kHeader, 5), ReadError);
  fs::remove(path);
  TrajectoryWriter(path, kHeader).append(bent_fibers(3, 7, 10));
  fs::resize_file(path, fs::file_size(path) / 2);
  BOOST_CHECK_THROW(TrajectoryReader{path}, ReadError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_what_was_there) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  TrajectoryWriter writer(path, kHeader);
  write_frames(writer, 0, 20);
  const std::string before = content(path);
  {
    const SizeLimit full(before.size() + 600);
    BOOST_CHECK_EXCEPTION(
        writer.append(bent_fibers(3, 7, 30), {{"height", 3}}), WriteError, [&](const WriteError& error) {
          return std::string(error.what()) == "cannot write " + path.string() + ": File too large";
        });
  }
  BOOST_TEST(content(path) == before);
  BOOST_TEST(files_in(scratch.path) == 2);
  write_frames(writer, 30, 40);  // room again
  check_equal(TrajectoryReader(path).read(3), bent_fibers(3, 7, 30));
}

// The child appends as fast as it can; wherever it is killed, all frames it reported are there, and resuming
// works.
BOOST_AUTO_TEST_CASE(a_killed_run_leaves_a_readable_file) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  std::int64_t kept = 0;
  for (int round = 0; round < 15; ++round) {
    int pipe[2];
    BOOST_REQUIRE(::pipe(pipe) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
      TrajectoryWriter writer = TrajectoryWriter::resume(path, kHeader, 10 * kept - 10);
      for (std::int64_t n = kept;; ++n) {
        write_frames(writer, 10 * n, 10 * n);
        if (::write(pipe[1], "x", 1) != 1) ::_exit(1);
      }
    }
    std::int64_t reported = kept;
    char reports[4096];
    while (reported < kept + 3) reported += ::read(pipe[0], reports, 1);
    std::this_thread::sleep_for(std::chrono::microseconds(1373 * round));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(pipe[1]);
    reported += ::read(pipe[0], reports, sizeof reports);
    ::close(pipe[0]);
    const TrajectoryReader reader(path);
    BOOST_TEST(reader.frames() >= reported);
    BOOST_TEST(reader.frames() <= reported + 1);
    for (std::int64_t n = kept; n < reader.frames(); ++n)
      check_equal(reader.read(n), bent_fibers(3, 7, 10 * n));
    kept = reader.frames() - 2;  // the next run resumes from an earlier checkpoint
  }
  BOOST_TEST(kept >= 15);
}

// The limit lets the journal and the first page through and stops the second page, as a kill between them
// would.
BOOST_AUTO_TEST_CASE(a_commit_cut_off_in_the_middle_is_finished_from_the_journal) {
  const Scratch scratch;
  const fs::path path = scratch.path / "file";
  make_file(path, 400'000);
  std::string expected = content(path);
  {
    JournaledFile file(path, JournaledFile::Mode::change);
    for (const std::size_t at : {8190, 350'000}) {
      file.write(at, "0123456789", 10);
      expected.replace(at, 10, "0123456789");
    }
    const SizeLimit limit(100'000);
    BOOST_CHECK_THROW(file.commit(), WriteError);
  }
  BOOST_TEST(content(path).substr(8190, 10) == "0123456789");
  BOOST_TEST(content(path).substr(350'000, 10) == "oooooooooo");
  const auto all = [&](JournaledFile& file) {
    std::string bytes(file.size(), '\0');
    file.read(0, bytes.data(), bytes.size());
    return bytes;
  };
  JournaledFile reader(path, JournaledFile::Mode::read);
  const auto behind_head = [](const std::string& bytes) { return bytes.substr(FileHead::kBytes); };
  BOOST_TEST((behind_head(all(reader)) == behind_head(expected)));
  BOOST_TEST(!reader.changed());
  JournaledFile next(path, JournaledFile::Mode::change);
  next.write(400'000, "more", 4);
  next.commit();
  BOOST_TEST((behind_head(content(path)) == behind_head(expected + "more")));
  BOOST_TEST(reader.changed());
  BOOST_TEST(files_in(scratch.path) == 1);
}

BOOST_AUTO_TEST_CASE(a_journal_that_is_not_whole_is_none) {
  const Scratch scratch;
  const fs::path path = scratch.path / "file";
  make_file(path, 9000);
  std::ofstream(journal_of(path), std::ios::binary) << "fiberchain journal 1\n" << std::string(5000, 'x');
  const JournaledFile file(path, JournaledFile::Mode::read);
  BOOST_TEST(file.size() == 9000);
  char byte = 0;
  file.read(517, &byte, 1);
  BOOST_TEST(byte == 'o');
}

BOOST_AUTO_TEST_CASE(a_journal_of_another_file_is_none) {
  const Scratch scratch;
  const fs::path path = scratch.path / "file", other = scratch.path / "other";
  make_file(path, 9000);
  make_file(other, 400'000);
  {
    JournaledFile file(other, JournaledFile::Mode::change);
    file.write(8190, "0123456789", 10);
    file.write(350'000, "0123456789", 10);
    const SizeLimit limit(100'000);
    BOOST_CHECK_THROW(file.commit(), WriteError);
  }
  fs::rename(journal_of(other), journal_of(path));
  const JournaledFile file(path, JournaledFile::Mode::read);
  BOOST_TEST(file.size() == 9000);
}

BOOST_AUTO_TEST_CASE(what_is_damaged_is_an_error_or_does_not_matter) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  TrajectoryWriter writer(path, kHeader);
  write_frames(writer, 0, 30);
  const std::string whole = content(path);
  std::uint64_t random = 7;
  int refused = 0;
  for (int n = 0; n < 300; ++n) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    std::string damaged = whole;
    damaged[(random >> 20) % damaged.size()] ^= static_cast<char>(1 << (random >> 61));
    std::ofstream(path, std::ios::binary) << damaged;
    try {
      const TrajectoryReader reader(path);
      for (std::int64_t frame = 0; frame < 4; ++frame)
        check_equal(reader.read(frame), bent_fibers(3, 7, 10 * frame));
    } catch (const ReadError&) {
      ++refused;
    }
    try {
      TrajectoryWriter resumed = TrajectoryWriter::resume(path, kHeader, 20);
      resumed.append(bent_fibers(3, 7, 30), {{"height", 3}});
    } catch (const ReadError&) {
    }
  }
  BOOST_TEST(refused > 50);
}

BOOST_AUTO_TEST_CASE(a_frame_read_beside_a_run_is_of_one_moment) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.h5";
  { TrajectoryWriter(path, kHeader).append(bent_fibers(3, 7, 0), {{"height", 0}}); }
  std::atomic<bool> done = false;
  std::thread run([&] {
    TrajectoryWriter writer = TrajectoryWriter::resume(path, kHeader, 0);
    write_frames(writer, 10, 3000);
    done = true;
  });
  int read = 0;
  while (!done) {
    const TrajectoryReader reader(path);
    const std::int64_t last = reader.frames() - 1;
    check_equal(reader.read(last), bent_fibers(3, 7, 10 * last));
    ++read;
  }
  run.join();
  BOOST_TEST(read > 10);
}

BOOST_AUTO_TEST_CASE(spheres_that_come_later_are_not_read_before) {
  const Scratch scratch;
  const auto path = scratch.path / "growing.h5";
  dem::TrajectoryWriter writer(path, {"tester", "1", {}, true});
  for (const std::int64_t step : {0, 10, 20}) {
    dem::TrajectoryFrame frame = bent_fibers(5, 9, step);
    frame.absent = step == 0 ? 27 : step == 10 ? 9 : 0;
    writer.append(frame);
  }
  const dem::TrajectoryReader reader(path);
  const std::size_t spheres[] = {18, 36, 45}, bonds[] = {16, 32, 40};
  for (std::size_t n = 0; n < 3; ++n) {
    const dem::TrajectoryFrame frame = reader.read(static_cast<std::int64_t>(n));
    BOOST_TEST(frame.position.size() == spheres[n]);
    BOOST_TEST(frame.fiber.size() == spheres[n]);
    BOOST_TEST(frame.bonds.size() == bonds[n]);
    BOOST_TEST(frame.absent == 0);
  }
  dem::TrajectoryWriter fixed(scratch.path / "fixed.h5", {"tester", "1", {}});
  dem::TrajectoryFrame frame = bent_fibers(5, 9, 0);
  frame.absent = 9;
  BOOST_CHECK_THROW(fixed.append(frame), fiberchain::dem::InvalidInput);
}

/// Contacts as many as there are, frames without beside them; a run that goes on may begin with them, or end.
BOOST_AUTO_TEST_SUITE_END()
