# SPDX-License-Identifier: LGPL-2.1-or-later
# Every third-party library as one interface target, named after what the rooms use it for.

# Static libraries that tools/libraries builds. Another copy in the process stays unseen: its names and
# those here don't meet (bindings/exports.map).
list(PREPEND CMAKE_PREFIX_PATH ${PROJECT_SOURCE_DIR}/build/libraries)

# CHOLMOD (supernodal module: GPL) on OpenBLAS, both on one thread, used by numerics alone.
find_path(CHOLMOD_HEADERS cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
add_library(curveups_cholmod INTERFACE)
target_include_directories(curveups_cholmod SYSTEM INTERFACE ${CHOLMOD_HEADERS})
if(VCPKG_TARGET_TRIPLET)  # other systems: never built
  find_package(CHOLMOD CONFIG REQUIRED)
  find_package(BLAS REQUIRED)
  target_link_libraries(curveups_cholmod INTERFACE SuiteSparse::CHOLMOD_static BLAS::BLAS)
else()
  find_library(CHOLMOD_ARCHIVE cholmod REQUIRED)
  find_library(OPENBLAS_ARCHIVE openblas REQUIRED)
  target_link_libraries(curveups_cholmod INTERFACE ${CHOLMOD_ARCHIVE} ${OPENBLAS_ARCHIVE})
endif()

# oneTBB, used by core alone.
find_path(TBB_HEADERS oneapi/tbb/parallel_for.h REQUIRED)
find_library(TBB_ARCHIVE NAMES tbb tbb12 REQUIRED)
add_library(curveups_tbb INTERFACE)
target_include_directories(curveups_tbb SYSTEM INTERFACE ${TBB_HEADERS})
target_link_libraries(curveups_tbb INTERFACE ${TBB_ARCHIVE})

# CGAL (meshing: GPL), used by geometry alone, as headers: its exact numbers are Boost's.
set(CGAL_DISABLE_GMP ON)
find_package(CGAL 5.5 REQUIRED)
add_library(curveups_cgal INTERFACE)
target_link_libraries(curveups_cgal INTERFACE CGAL::CGAL)

# Clipper: unions and offsets of plane polygons, used by bodies alone.
find_path(CLIPPER_HEADERS polyclipping/clipper.hpp REQUIRED)
find_library(CLIPPER_ARCHIVE polyclipping REQUIRED)
add_library(curveups_clipper INTERFACE)
target_include_directories(curveups_clipper SYSTEM INTERFACE ${CLIPPER_HEADERS})
target_link_libraries(curveups_clipper INTERFACE ${CLIPPER_ARCHIVE})

# fmt: shortest digits of numbers, used by fabrication alone, as headers. Standard libraries have them
# since g++ 11 only.
find_path(FMT_HEADERS fmt/compile.h REQUIRED)
add_library(curveups_fmt INTERFACE)
target_include_directories(curveups_fmt SYSTEM INTERFACE ${FMT_HEADERS})
target_compile_definitions(curveups_fmt INTERFACE FMT_HEADER_ONLY)

# zlib: compressed 3MF files, used by fabrication alone.
find_path(ZLIB_HEADERS zlib.h REQUIRED)
find_library(ZLIB_ARCHIVE NAMES libz.a z zlib REQUIRED)
add_library(curveups_zlib INTERFACE)
target_include_directories(curveups_zlib SYSTEM INTERFACE ${ZLIB_HEADERS})
target_link_libraries(curveups_zlib INTERFACE ${ZLIB_ARCHIVE})

# lib3mf: reads 3MF files in tests.
find_path(LIB3MF_INCLUDE Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(LIB3MF_LIBRARY NAMES 3MF 3mf)
add_library(curveups_lib3mf INTERFACE)
target_include_directories(curveups_lib3mf SYSTEM INTERFACE ${LIB3MF_INCLUDE})
target_link_libraries(curveups_lib3mf INTERFACE ${LIB3MF_LIBRARY})
