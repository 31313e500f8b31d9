#pragma once

/// Facts about the build, written by CMake.
namespace fiberchain::dem {

extern const char* const kVersion;            ///< project version
extern const char* const kCommit;             ///< git commit when it was built, see build_info.cmake
extern const char* const kCompiler;           ///< name and version
extern const char* const kFlags;              ///< compile flags
extern const char* const kInstalledData;      ///< data directory once installed, from the program's own
extern const char* const kInstallPrefixData;  ///< the same by its configured place
extern const char* const kSourceData;         ///< data directory of the source tree

}  // namespace fiberchain::dem
