# fiberchain_add_kernels(TARGET SOURCE...): compiles each kernel source once for every instruction set and adds the copies to
# the target; which one runs is chosen at run time (dem/simd/instruction_set.hpp). tests/dem checks that the wide copies define
# no symbol that another file could be linked to.
set(FIBERCHAIN_INSTRUCTION_SETS scalar avx2 avx512)
if(FIBERCHAIN_SANITIZE)
  # The scalar copy is the same source; the wide ones would take the compiler minutes.
  set(FIBERCHAIN_INSTRUCTION_SETS scalar)
endif()

function(fiberchain_add_kernels target)
  # The compiler's own vectorizer would pack the components of one sphere and wait on its own stores.
  set(options -fno-tree-vectorize -fno-tree-slp-vectorize)
  # Products and sums are fused where the processor can, half the arithmetic of the loop: the wide copies agree with the others
  # to round-off, not to the bit. GCC 12 warns of its own AVX-512 header.
  set(options_scalar)
  set(options_avx2 -mavx2 -mfma -ffp-contract=fast)
  set(options_avx512 -mavx512f -ffp-contract=fast -mprefer-vector-width=512 -Wno-uninitialized -Wno-maybe-uninitialized)
  foreach(set IN LISTS FIBERCHAIN_INSTRUCTION_SETS)
    set(copy ${target}_kernels_${set})
    add_library(${copy} OBJECT ${ARGN})
    target_compile_definitions(${copy} PRIVATE FIBERCHAIN_INSTRUCTION_SET=${set})
    target_include_directories(${copy} PRIVATE ${PROJECT_SOURCE_DIR})
    target_include_directories(${copy} SYSTEM PRIVATE ${FIBERCHAIN_XSIMD_INCLUDE})
    target_compile_features(${copy} PRIVATE cxx_std_20)
    set_target_properties(${copy} PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
    target_link_libraries(${copy} PRIVATE Eigen3::Eigen)
    # Those of every target first: the last one that says whether to fuse wins.
    target_compile_options(${copy} PRIVATE
      $<TARGET_PROPERTY:fiberchain_flags,INTERFACE_COMPILE_OPTIONS> ${options} ${options_${set}})
    target_compile_definitions(${copy} PRIVATE $<TARGET_PROPERTY:fiberchain_flags,INTERFACE_COMPILE_DEFINITIONS>)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${copy}>)
  endforeach()
endfunction()
