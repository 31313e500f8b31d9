#include "dem/trajectory/checkpoint.hpp"

#include <bit>
#include <boost/test/unit_test.hpp>
#include <limits>

#include "dem/files/file_error.hpp"
#include "dem/files/sha256.hpp"
#include "dem/trajectory/hdf5.hpp"
#include "tests/dem/trajectory/files.hpp"

BOOST_AUTO_TEST_SUITE(checkpoint_test)

using namespace fiberchain::dem;
using namespace fiberchain::test;
namespace fs = std::filesystem;

namespace {

Checkpoint example(std::int64_t step, std::size_t numbers) {
  Checkpoint checkpoint{.program = "fiberchain 0.1.0 abc GNU 12 -O3",
                        .threads = 2,
                        .scene_sha256 = "e3b0c44298fc1c149afbf4c8996fb924",
                        .scene = "scene: packing\nfibers: 3\n",
                        .keys = "scene = packing\ncontacts.friction = 0.3\n",
                        .step = step,
                        .time = 0.1 * static_cast<double>(step),
                        .inserted = {3, 0, 7},
                        .kinds = {0, 1, 1},
                        .carried = {1, 4},
                        .batches_done = 2,
                        .written = {step, step - 1, -1},
                        .state = {}};
  std::vector<double> reals;
  for (std::size_t i = 0; i < numbers; ++i) reals.push_back(1 / (3.0 + static_cast<double>(i)));
  checkpoint.state = {
      {"load", {1, reals}},
      {"orientation", {2, std::vector<double>{}}},
      {"steps", {1, std::vector<std::int64_t>{step, -1, std::numeric_limits<std::int64_t>::min()}}}};
  return checkpoint;
}

/// Message of the refusal, without the file's name.
std::string refusal(const fs::path& path) {
  try {
    read_checkpoint(path);
  } catch (const ReadError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.starts_with(path.string() + ": "));
    return message.substr(path.string().size() + 2);
  }
  return "none";
}

void overwrite(const fs::path& path, std::size_t at, char byte) {
  std::string bytes = content(path);
  bytes[at] = byte;
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_bit_comes_back) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  Checkpoint written = example(1'234'567'890'123, 1001);
  std::vector<double>& reals = std::get<std::vector<double>>(written.state["load"].values);
  reals[3] = -0.0;
  reals[4] = std::numeric_limits<double>::denorm_min();
  reals[5] = -std::numeric_limits<double>::infinity();
  reals[6] =
      std::bit_cast<double>(0x7ff4dead0000beefull);  // a NaN with a payload, as counters kept in a double are
  written.scene += std::string("\0 and beyond", 12);
  write_checkpoint(path, written);
  Checkpoint read = read_checkpoint(path);
  const auto bits = [](std::vector<double>& all) {
    std::vector<std::uint64_t> patterns;
    for (const double x : all) patterns.push_back(std::bit_cast<std::uint64_t>(x));
    all.clear();
    return patterns;
  };
  BOOST_TEST((bits(std::get<std::vector<double>>(read.state["load"].values)) == bits(reals)));
  BOOST_TEST((read == written));  // all else, integers and versions of fields included
}

BOOST_AUTO_TEST_CASE(the_one_before_is_kept) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  for (const std::int64_t step : {1, 2, 3}) write_checkpoint(path, example(step, 10));
  BOOST_TEST(read_checkpoint(path).step == 3);
  BOOST_TEST(read_checkpoint(previous_checkpoint(path)).step == 2);
  BOOST_TEST(files_in(scratch.path) == 2);
}

BOOST_AUTO_TEST_CASE(what_is_no_whole_checkpoint_is_refused_with_its_reason) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  BOOST_TEST(refusal(path) == "cannot open this checkpoint: No such file or directory");
  BOOST_TEST(refusal(scratch.path) == "is a directory, not a checkpoint");
  std::ofstream(path) << "";
  BOOST_TEST(refusal(path) == "is no checkpoint");
  write_checkpoint(path, example(5, 1000));
  const std::string whole = content(path);
  fs::resize_file(path, 40);
  BOOST_TEST(refusal(path) == "is cut off within its head");
  std::ofstream(path, std::ios::binary) << whole.substr(0, whole.size() - 1);
  BOOST_TEST(refusal(path) == "is cut off: " + std::to_string(whole.size() - 513) + " of " +
                                  std::to_string(whole.size() - 512) + " bytes");
  std::ofstream(path, std::ios::binary) << whole << "more";
  BOOST_TEST(refusal(path) == "is corrupt: its checksum is not that of its content");
  std::ofstream(path, std::ios::binary) << whole;
  BOOST_TEST(refusal(path) == "none");
  std::string later = whole;
  later.replace(later.find("checkpoint 3"), 12, "checkpoint 7");
  std::ofstream(path, std::ios::binary) << later;
  BOOST_TEST(refusal(path) == "is a checkpoint of format 7; this program reads format 3");
}

namespace {

/// An HDF5 file in memory that `write` fills, with the head of a checkpoint of this format.
template <class Write>
void write_image(const fs::path& path, int format, const Write& write) {
  std::string image;
  {
    const hdf5::Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose, "make a property list");
    hdf5::check(H5Pset_fapl_core(access, 1 << 16, false), "work in memory");
    const hdf5::Handle file(H5Fcreate("old", H5F_ACC_TRUNC, H5P_DEFAULT, access), &H5Fclose, "make a file");
    write(file);
    hdf5::flush(file);
    image.resize(static_cast<std::size_t>(H5Fget_file_image(file, nullptr, 0)));
    BOOST_REQUIRE(H5Fget_file_image(file, image.data(), image.size()) > 0);
  }
  std::string head = "fiberchain checkpoint " + std::to_string(format) + "\nsha256 " + sha256(image) +
                     "\nbytes " + std::to_string(image.size()) + "\n";
  head.resize(512, '\0');
  std::ofstream(path, std::ios::binary) << head << image;
}

/// The layout before fields had names, which format 1 was.
void write_unnamed_state(hid_t file) {
  const hdf5::Stored real{H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}, integer{H5T_NATIVE_INT64, H5T_STD_I64LE};
  const std::int64_t one = 1;
  const std::vector<double> state = {1, 0, 0.5, 0, 2};
  hdf5::write_array(file, "scene", {H5T_NATIVE_UCHAR, H5T_STD_U8LE}, {1}, "s", false);
  hdf5::write_array(file, "keys", {H5T_NATIVE_UCHAR, H5T_STD_U8LE}, {1}, "k", false);
  hdf5::write_array(file, "threads", integer, {1}, &one, false);
  hdf5::write_array(file, "step", integer, {1}, &one, false);
  hdf5::write_array(file, "time", real, {1}, state.data(), false);
  hdf5::write_array(file, "state", real, {state.size()}, state.data(), false);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_old_layout_is_refused) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  write_image(path, 1, write_unnamed_state);
  BOOST_TEST(refusal(path) ==
             "is a checkpoint of the old format 1, which does not say what its scene means; this program "
             "reads format 3");
  write_image(path, 3, write_unnamed_state);
  BOOST_TEST(refusal(path) == "is no checkpoint of this program: its state is not stored by named fields");
}

BOOST_AUTO_TEST_CASE(a_field_without_a_version_is_named) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  write_image(path, 3, [](hid_t file) {
    write_unnamed_state(file);
    hdf5::check(H5Ldelete(file, "state", H5P_DEFAULT), "delete");
    const double number = 1;
    hdf5::write_array(hdf5::make_group(file, "state"), "load", {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}, {1},
                      &number, false);
  });
  BOOST_TEST(refusal(path) == "is no checkpoint of this program: field 'load' of the state has no version");
}

// A bit wrong anywhere: in the head, in HDF5's own tables, in the numbers.
BOOST_AUTO_TEST_CASE(no_wrong_byte_goes_unnoticed) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  write_checkpoint(path, example(5, 300));
  const std::string whole = content(path);
  std::size_t tried = 0;
  for (std::size_t at = 0; at < whole.size(); at += 37, ++tried) {
    overwrite(path, at, static_cast<char>(whole[at] ^ (1 << at % 8)));
    BOOST_TEST(refusal(path) != "none", "byte " << at);
    overwrite(path, at, whole[at]);
  }
  BOOST_TEST(tried > 50);
  BOOST_TEST(refusal(path) == "none");
}

BOOST_AUTO_TEST_CASE(a_full_disk_keeps_the_last_good_one) {
  const Scratch scratch;
  const fs::path path = scratch.path / "run.checkpoint";
  write_checkpoint(path, example(1, 2000));
  write_checkpoint(path, example(2, 2000));
  // wherever the disk ends, in what is written first or at the very end
  for (std::size_t room = 100; room < fs::file_size(path); room += 483) {
    const SizeLimit full(room);
    BOOST_CHECK_EXCEPTION(write_checkpoint(path, example(3, 2000)), WriteError, [&](const WriteError& error) {
      return std::string(error.what()) == "cannot write " + path.string() + ": File too large";
    });
  }
  const SizeLimit full(fs::file_size(path) - 1);
  BOOST_CHECK_THROW(write_checkpoint(path, example(3, 2000)), WriteError);
  BOOST_TEST((read_checkpoint(path) == example(2, 2000)));
  BOOST_TEST((read_checkpoint(previous_checkpoint(path)) == example(1, 2000)));
  BOOST_TEST(files_in(scratch.path) == 2);
  BOOST_CHECK_THROW(write_checkpoint(scratch.path / "none" / "run", example(1, 1)), WriteError);
}

BOOST_AUTO_TEST_CASE(another_program_or_thread_count_is_told) {
  const Checkpoint checkpoint = example(5, 1);
  BOOST_TEST(resumed_differently(checkpoint, checkpoint.program, 2) == "");
  BOOST_TEST(resumed_differently(checkpoint, checkpoint.program, 1) ==
             "the checkpoint was written by a run of 2 threads, not 1");
  BOOST_TEST(resumed_differently(checkpoint, "other", 2) ==
             "the checkpoint was written by another program (fiberchain 0.1.0 abc GNU 12 -O3, not other)");
}

BOOST_AUTO_TEST_SUITE_END()
