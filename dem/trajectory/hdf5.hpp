#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// HDF5's C interface with owners for its identifiers and exceptions for its failures. Private to
// dem/trajectory.
namespace fiberchain::dem::hdf5 {

/// HDF5 refused; the message says what was tried and HDF5's own reason. Callers add the file's name.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Closes an identifier when it goes.
class Handle {
 public:
  /// @throws Failure if `id` is none; `what` says what was tried
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what);
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// @throws Failure if the status is an error
void check(herr_t status, const char* what);

/// HDF5 does not print its errors itself while this lives.
class Quiet {
 public:
  Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet();

 private:
  H5E_auto2_t before_ = nullptr;
  void* data_ = nullptr;
};

/// Gives all of a file to its driver: closing it would not tell of a failure.
/// @throws Failure
void flush(hid_t file);

Handle make_group(hid_t parent, const char* name);
Handle open_group(hid_t parent, const char* name);
bool is_group(hid_t parent, const char* name);
bool has(hid_t parent, const std::string& name);
/// Names of what is in a group.
std::vector<std::string> names_in(hid_t group);

/// A text of fixed length, to be read back: its bytes stand with the object, under its checksum.
void set_attribute(hid_t object, const char* name, const std::string& text);
/// A text of variable length, for others only: h5py gives it as str, where it gives fixed ones as bytes,
/// which readers of H5MD in Python do not expect. It has no checksum, and HDF5 falls over a damaged one.
void set_text_for_python(hid_t object, const char* name, const std::string& text);
void set_attribute(hid_t object, const char* name, const std::vector<std::int32_t>& numbers);
void set_attribute(hid_t object, const char* name, const std::vector<std::string>& texts);
/// Text of an attribute; nothing if there is none or it is no text of fixed length.
std::optional<std::string> text_attribute(hid_t object, const char* name);
/// The integer of an attribute; nothing if there is none or it is no single integer.
std::optional<std::int32_t> integer_attribute(hid_t object, const char* name);
/// Text of every attribute that is one of fixed length, by name.
std::vector<std::pair<std::string, std::string>> text_attributes(hid_t object);

/// How the elements of a C++ array are stored.
struct Stored {
  hid_t memory;  ///< type in memory
  hid_t file;    ///< type in the file
};

/// A dataset of a fixed size, written now.
Handle write_array(hid_t parent, const char* name, const Stored& type, const std::vector<hsize_t>& size,
                   const void* values, bool compressed);

/// A dataset that grows along its first index; `size` is that of one entry.
Handle make_series(hid_t parent, const char* name, hid_t type, const std::vector<hsize_t>& size,
                   bool compressed);

/// A dataset of rows of `width` numbers, or of one, that grows by any number of them: none yet.
Handle make_rows(hid_t parent, const char* name, hid_t type, hsize_t width, hsize_t chunk);

Handle open_array(hid_t parent, const char* name);
std::vector<hsize_t> size_of(hid_t array);
void resize_series(hid_t series, hsize_t length);
/// Writes or reads one entry of a series.
void write_entry(hid_t series, hsize_t entry, hid_t type, const void* values);
void read_entry(hid_t series, hsize_t entry, hid_t type, void* values);
/// Likewise some entries that follow each other; none is allowed.
void write_rows(hid_t series, hsize_t first, hsize_t count, hid_t type, const void* values);
void read_rows(hid_t series, hsize_t first, hsize_t count, hid_t type, void* values);

}  // namespace fiberchain::dem::hdf5
