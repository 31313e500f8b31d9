#include "dem/trajectory/hdf5_vfd.hpp"

#include <exception>

#if H5_VERSION_GE(1, 14, 0)
#include <H5FDdevelop.h>
#endif

namespace fiberchain::dem {
namespace {

/// HDF5's view of the file; the base must come first.
struct Driven {
  H5FD_t base;
  JournaledFile* file;
  haddr_t allocated;
};

Driven& driven(H5FD_t* file) { return *reinterpret_cast<Driven*>(file); }
const Driven& driven(const H5FD_t* file) { return *reinterpret_cast<const Driven*>(file); }

// No exception may pass through HDF5's C code.
template <class Action>
herr_t attempt(const Action& action) noexcept {
  try {
    action();
    return 0;
  } catch (const std::exception&) {
    return -1;
  }
}

H5FD_t* open(const char* /*name*/, unsigned flags, hid_t access, haddr_t /*largest*/) {
  const auto* info = static_cast<JournaledFile* const*>(H5Pget_driver_info(access));
  if (!info || !*info) return nullptr;
  if (flags & H5F_ACC_TRUNC) (*info)->resize(0);
  return &(new Driven{H5FD_t{}, *info, 0})->base;
}

herr_t close(H5FD_t* file) {
  delete &driven(file);
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const auto *first = driven(a).file, *second = driven(b).file;
  return first < second ? -1 : first > second ? 1 : 0;
}

herr_t query(const H5FD_t* /*file*/, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t allocated(const H5FD_t* file, H5FD_mem_t /*type*/) { return driven(file).allocated; }

herr_t allocate(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
  driven(file).allocated = end;
  return 0;
}

haddr_t end(const H5FD_t* file, H5FD_mem_t /*type*/) { return driven(file).file->size(); }

herr_t read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t at, std::size_t count,
            void* bytes) {
  return attempt([&] { driven(file).file->read(at, bytes, count); });
}

herr_t write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t at, std::size_t count,
             const void* bytes) {
  return attempt([&] { driven(file).file->write(at, bytes, count); });
}

herr_t truncate(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
  return attempt([&] { driven(file).file->resize(driven(file).allocated); });
}

H5FD_class_t driver_class() {
  H5FD_class_t all{};
#if H5_VERSION_GE(1, 14, 0)
  all.version = H5FD_CLASS_VERSION;
  all.value = static_cast<H5FD_class_value_t>(511);
#endif
  all.name = "fiberchain_overlay";
  all.maxaddr = (haddr_t{1} << 62);
  all.fc_degree = H5F_CLOSE_STRONG;
  all.fapl_size = sizeof(JournaledFile*);
  all.open = &open;
  all.close = &close;
  all.cmp = &compare;
  all.query = &query;
  all.get_eoa = &allocated;
  all.set_eoa = &allocate;
  all.get_eof = &end;
  all.read = &read;
  all.write = &write;
  all.truncate = &truncate;
  for (H5FD_mem_t& type : all.fl_map) type = H5FD_MEM_DEFAULT;
  return all;
}

}  // namespace

bool use_journaled_file(hid_t access, JournaledFile& file) {
  static const H5FD_class_t description = driver_class();
  static const hid_t driver = H5FDregister(&description);
  JournaledFile* const info = &file;
  return driver >= 0 && H5Pset_driver(access, driver, &info) >= 0;
}

}  // namespace fiberchain::dem
