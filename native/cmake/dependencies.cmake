# SPDX-License-Identifier: LGPL-2.1-or-later
# Every third-party library as one interface target, named after what the rooms use it for.

# CHOLMOD (supernodal module: GPL) on OpenBLAS, used by numerics/sparse_cholesky.cpp alone.
find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)
add_library(curveups_cholmod INTERFACE)
target_include_directories(curveups_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
# With OpenMP's flag Eigen would split products among threads: slower here, and sums in another order.
target_compile_definitions(curveups_cholmod INTERFACE EIGEN_DONT_PARALLELIZE)
target_link_libraries(curveups_cholmod INTERFACE ${CHOLMOD_LIBRARY} ${OPENBLAS_LIBRARY}
                                                 OpenMP::OpenMP_CXX)

# CGAL (meshing: GPL), used by geometry alone. Exact constructions need GMP and MPFR.
find_package(CGAL 5.5 REQUIRED)
add_library(curveups_cgal INTERFACE)
target_link_libraries(curveups_cgal INTERFACE CGAL::CGAL)

# Ceres: least squares with robust losses, used by geometry/registration.cpp alone.
find_package(Ceres 2.1 REQUIRED)

# Clipper: unions and offsets of plane polygons, used by bodies alone.
find_path(CLIPPER_INCLUDE polyclipping/clipper.hpp REQUIRED)
find_library(CLIPPER_LIBRARY polyclipping REQUIRED)
add_library(curveups_clipper INTERFACE)
target_include_directories(curveups_clipper SYSTEM INTERFACE ${CLIPPER_INCLUDE})
target_link_libraries(curveups_clipper INTERFACE ${CLIPPER_LIBRARY})

# OpenCASCADE, used by fabrication alone. The toolkits FreeCAD has loaded already.
find_package(OpenCASCADE REQUIRED)
add_library(curveups_occt INTERFACE)
target_include_directories(curveups_occt SYSTEM INTERFACE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(curveups_occt INTERFACE TKernel TKMath TKG2d TKG3d TKGeomBase TKGeomAlgo
  TKBRep TKTopAlgo TKPrim)
# What reads STEP files back in tests; one toolkit since 7.8.
if(OpenCASCADE_VERSION VERSION_LESS 7.8)
  set(step_toolkits TKSTEPBase TKSTEPAttr TKSTEP209 TKSTEP TKXDESTEP)
else()
  set(step_toolkits TKDESTEP)
endif()
add_library(curveups_occt_step INTERFACE)
target_link_libraries(curveups_occt_step INTERFACE curveups_occt TKMesh TKShHealing TKXSBase
  ${step_toolkits} TKCDF TKLCAF TKCAF TKVCAF TKXCAF)

# lib3mf: named bodies in 3MF files.
find_path(LIB3MF_INCLUDE Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
find_library(LIB3MF_LIBRARY NAMES 3MF 3mf REQUIRED)
add_library(curveups_lib3mf INTERFACE)
target_include_directories(curveups_lib3mf SYSTEM INTERFACE ${LIB3MF_INCLUDE})
target_link_libraries(curveups_lib3mf INTERFACE ${LIB3MF_LIBRARY})
