#include "dem/trajectory/hdf5.hpp"

#include <algorithm>

namespace fiberchain::dem::hdf5 {
namespace {

/// The innermost of HDF5's own words on the last error.
std::string last_error() {
  std::string reason;
  const auto keep = [](unsigned /*depth*/, const H5E_error2_t* error, void* to) -> herr_t {
    if (error->desc) *static_cast<std::string*>(to) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep, &reason);
  return reason;
}

[[noreturn]] void fail(const char* what) {
  const std::string reason = last_error();
  throw Failure("HDF5 cannot " + std::string(what) + (reason.empty() ? "" : ": " + reason));
}

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), &H5Tclose, "make a text type");
  check(H5Tset_size(type, std::max<std::size_t>(size, 1)), "make a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
  return type;
}

Handle space_of(const std::vector<hsize_t>& size, const hsize_t* largest = nullptr) {
  return {H5Screate_simple(static_cast<int>(size.size()), size.data(), largest), &H5Sclose,
          "make a dataspace"};
}

/// Without the times of changes, so that the same content gives the same bytes.
Handle creation() {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose, "make a property list");
  check(H5Pset_obj_track_times(properties, false), "leave out times");
  return properties;
}

/// Bytes in the same place of successive numbers stand together: exponents compress, the last digits hardly.
void compress(hid_t creation) {
  check(H5Pset_shuffle(creation), "shuffle");
  check(H5Pset_deflate(creation, 1), "deflate");
}

/// Rows of an entry that make a chunk of up to a megabyte.
hsize_t rows_of_chunk(const std::vector<hsize_t>& size, std::size_t element) {
  hsize_t row = element;
  for (std::size_t i = 1; i < size.size(); ++i) row *= size[i];
  const hsize_t chunks = std::max<hsize_t>(1, (size[0] * row + (1 << 20) - 1) >> 20);
  return std::max<hsize_t>(1, (size[0] + chunks - 1) / chunks);
}

/// Places of some entries within a series.
Handle entry_space(hid_t series, hsize_t entry, hsize_t entries = 1) {
  Handle space(H5Dget_space(series), &H5Sclose, "find a dataset's size");
  std::vector<hsize_t> count = size_of(series);
  std::vector<hsize_t> start(count.size(), 0);
  start[0] = entry;
  count[0] = entries;
  check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
        "select an entry");
  return space;
}

Handle entry_memory(hid_t series, hsize_t entries = 1) {
  std::vector<hsize_t> count = size_of(series);
  count[0] = entries;
  return space_of(count);
}

Handle write_attribute(hid_t object, const char* name, hid_t type, hid_t space, const void* value) {
  if (H5Aexists(object, name) > 0) check(H5Adelete(object, name), "replace an attribute");
  Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), &H5Aclose,
                   "make an attribute");
  check(H5Awrite(attribute, type, value), "write an attribute");
  return attribute;
}

}  // namespace

Handle::Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
  if (id < 0) fail(what);
}

void check(herr_t status, const char* what) {
  if (status < 0) fail(what);
}

void flush(hid_t file) { check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush"); }

Quiet::Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &before_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Quiet::~Quiet() { H5Eset_auto2(H5E_DEFAULT, before_, data_); }

Handle make_group(hid_t parent, const char* name) {
  return {H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), &H5Gclose, "make a group"};
}

Handle open_group(hid_t parent, const char* name) {
  return {H5Gopen2(parent, name, H5P_DEFAULT), &H5Gclose, name};
}

bool has(hid_t parent, const std::string& name) { return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0; }

bool is_group(hid_t parent, const char* name) {
  if (!has(parent, name)) return false;
  const Handle object(H5Oopen(parent, name, H5P_DEFAULT), &H5Oclose, name);
  return H5Iget_type(object) == H5I_GROUP;
}

std::vector<std::string> names_in(hid_t group) {
  H5G_info_t info;
  check(H5Gget_info(group, &info), "list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto get = [&](char* to, std::size_t room) {
      return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, to, room, H5P_DEFAULT);
    };
    const ssize_t length = get(nullptr, 0);
    if (length < 0) fail("list a group");
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    get(name.data(), name.size());
    name.pop_back();
    names.push_back(name);
  }
  return names;
}

void set_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose, "make a dataspace");
  write_attribute(object, name, text_type(text.size() + 1), space, text.c_str());
}

void set_text_for_python(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type(H5T_VARIABLE);
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose, "make a dataspace");
  const char* const value = text.c_str();
  write_attribute(object, name, type, space, &value);
}

void set_attribute(hid_t object, const char* name, const std::vector<std::int32_t>& numbers) {
  const Handle space = numbers.size() == 1 ? Handle(H5Screate(H5S_SCALAR), &H5Sclose, "make a dataspace")
                                           : space_of({numbers.size()});
  write_attribute(object, name, H5T_NATIVE_INT32, space, numbers.data());
}

void set_attribute(hid_t object, const char* name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size() + 1);
  std::string all;
  for (const std::string& text : texts) all += text + std::string(longest - text.size(), '\0');
  write_attribute(object, name, text_type(longest), space_of({texts.size()}), all.data());
}

std::optional<std::string> text_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), &H5Aclose, "open an attribute");
  const Handle type(H5Aget_type(attribute), &H5Tclose, "find an attribute's type");
  const Handle space(H5Aget_space(attribute), &H5Sclose, "find an attribute's size");
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Sget_simple_extent_npoints(space) != 1)
    return std::nullopt;
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, text.data()), "read an attribute");
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::optional<std::int32_t> integer_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), &H5Aclose, "open an attribute");
  const Handle type(H5Aget_type(attribute), &H5Tclose, "find an attribute's type");
  const Handle space(H5Aget_space(attribute), &H5Sclose, "find an attribute's size");
  if (H5Tget_class(type) != H5T_INTEGER || H5Sget_simple_extent_npoints(space) != 1) return std::nullopt;
  std::int32_t value = 0;
  check(H5Aread(attribute, H5T_NATIVE_INT32, &value), "read an attribute");
  return value;
}

std::vector<std::pair<std::string, std::string>> text_attributes(hid_t object) {
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names), "list attributes");
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string& name : names) {
    if (auto text = text_attribute(object, name.c_str())) all.emplace_back(name, *std::move(text));
  }
  return all;
}

Handle write_array(hid_t parent, const char* name, const Stored& type, const std::vector<hsize_t>& size,
                   const void* values, bool compressed) {
  const Handle space = space_of(size);
  const Handle properties = creation();
  const hsize_t all = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space));
  if (compressed && all > 0) {
    std::vector<hsize_t> chunk = size;
    chunk[0] = rows_of_chunk(size, H5Tget_size(type.file));
    check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "choose chunks");
    compress(properties);
    check(H5Pset_fletcher32(properties), "add checksums");
  }
  Handle array(H5Dcreate2(parent, name, type.file, space, H5P_DEFAULT, properties, H5P_DEFAULT), &H5Dclose,
               "make a dataset");
  if (all > 0) check(H5Dwrite(array, type.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write a dataset");
  return array;
}

Handle make_series(hid_t parent, const char* name, hid_t type, const std::vector<hsize_t>& size,
                   bool compressed) {
  std::vector<hsize_t> extent = {0}, largest = {H5S_UNLIMITED}, chunk = {1};
  for (const hsize_t count : size) {
    extent.push_back(count);
    largest.push_back(count);
    chunk.push_back(std::max<hsize_t>(count, 1));
  }
  const Handle properties = creation();
  if (compressed && !size.empty()) {
    chunk[1] = rows_of_chunk(size, H5Tget_size(type));
    compress(properties);
  } else {
    chunk[0] = 128;  // changed in place from entry to entry
  }
  check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "choose chunks");
  check(H5Pset_fletcher32(properties), "add checksums");
  return {
      H5Dcreate2(parent, name, type, space_of(extent, largest.data()), H5P_DEFAULT, properties, H5P_DEFAULT),
      &H5Dclose, "make a dataset"};
}

Handle make_rows(hid_t parent, const char* name, hid_t type, hsize_t width, hsize_t chunk) {
  std::vector<hsize_t> extent = {0}, largest = {H5S_UNLIMITED}, chunks = {chunk};
  if (width > 1) extent.push_back(width), largest.push_back(width), chunks.push_back(width);
  const Handle properties = creation();
  compress(properties);
  check(H5Pset_chunk(properties, static_cast<int>(chunks.size()), chunks.data()), "choose chunks");
  check(H5Pset_fletcher32(properties), "add checksums");
  return {
      H5Dcreate2(parent, name, type, space_of(extent, largest.data()), H5P_DEFAULT, properties, H5P_DEFAULT),
      &H5Dclose, "make a dataset"};
}

Handle open_array(hid_t parent, const char* name) {
  return {H5Dopen2(parent, name, H5P_DEFAULT), &H5Dclose, name};
}

std::vector<hsize_t> size_of(hid_t array) {
  const Handle space(H5Dget_space(array), &H5Sclose, "find a dataset's size");
  std::vector<hsize_t> size(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  check(H5Sget_simple_extent_dims(space, size.data(), nullptr), "find a dataset's size");
  return size;
}

void resize_series(hid_t series, hsize_t length) {
  std::vector<hsize_t> size = size_of(series);
  if (size.empty()) throw Failure("a dataset that should grow is a single number");
  size[0] = length;
  check(H5Dset_extent(series, size.data()), "change a dataset's size");
}

void write_entry(hid_t series, hsize_t entry, hid_t type, const void* values) {
  check(H5Dwrite(series, type, entry_memory(series), entry_space(series, entry), H5P_DEFAULT, values),
        "write an entry");
}

void read_entry(hid_t series, hsize_t entry, hid_t type, void* values) {
  check(H5Dread(series, type, entry_memory(series), entry_space(series, entry), H5P_DEFAULT, values),
        "read an entry");
}

void write_rows(hid_t series, hsize_t first, hsize_t count, hid_t type, const void* values) {
  if (count == 0) return;
  check(H5Dwrite(series, type, entry_memory(series, count), entry_space(series, first, count), H5P_DEFAULT,
                 values),
        "write rows");
}

void read_rows(hid_t series, hsize_t first, hsize_t count, hid_t type, void* values) {
  if (count == 0) return;
  check(H5Dread(series, type, entry_memory(series, count), entry_space(series, first, count), H5P_DEFAULT,
                values),
        "read rows");
}

}  // namespace fiberchain::dem::hdf5
