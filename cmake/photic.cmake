# How every target of Photic is made.

add_library(photic_flags INTERFACE)
target_compile_features(photic_flags INTERFACE cxx_std_20)
# Where files are compiled together, a name of one is none of another's business.
set(shadow -Wshadow)
if(CMAKE_UNITY_BUILD)
  set(shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
endif()
# The masks of one photon are bools, and `&` is theirs, too.
set(bool_masks $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
# No contraction: the same bits from every schedule of the same formulas; but in the engine's lanes, which round as is fastest
# (docs/decisions/0006, 0031).
set(contraction "-ffp-contract=$<IF:$<BOOL:$<TARGET_PROPERTY:PHOTIC_CONTRACTED>>,fast,off>")
target_compile_options(photic_flags INTERFACE -Wall -Wextra -Wpedantic ${shadow} ${bool_masks} -Wconversion
                       -Wno-sign-conversion -Wno-psabi -Werror ${contraction} -fno-math-errno -fno-trapping-math)
# Shared objects are made of these libraries, too, with no more to see of them than what they are asked for.
target_compile_options(photic_flags INTERFACE -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)

photic_choose_isas(photic_isas)
foreach(isa IN LISTS photic_isas)
  string(TOUPPER ${isa} upper)
  target_compile_definitions(photic_flags INTERFACE PHOTIC_ISA_${upper})
endforeach()

set(flags_of_baseline "")
# Packs that are copied go through registers: g++ 12 would have string instructions for them, which take some tens of
# cycles to begin (docs/decisions/0024). What is the same in different blocks is computed again: to keep it takes too many of
# AVX-512's registers (0032).
set(flags_of_avx2 -mavx2 -mfma "$<$<CXX_COMPILER_ID:GNU>:-mmove-max=256;-mstore-max=256>")
set(flags_of_avx512 -mavx2 -mfma -mavx512f -mavx512bw -mavx512dq -mavx512vl -mprefer-vector-width=512
                     "$<$<CXX_COMPILER_ID:GNU>:-mmove-max=512;-mstore-max=512;-fno-gcse>")

# To optimise takes most of the time that a debug build needs, so only what tests would wait for is.
set(optimised_also_for_debugging $<$<CONFIG:Debug>:-O1>)

# What takes longer to compile than it ever runs: files of scenes and results, the command line, lanes of the baseline. In other
# builds than releases all is compiled alike, as clang's precompiled header has to be. Bits are the same: nothing is contracted.
set(sooner $<$<CONFIG:Release>:-O1>)

# photic_library(name SOURCES a.cpp … USES core … [LINKS …] [SOONER])  → target photic_name, headers under src/
function(photic_library name)
  cmake_parse_arguments(ARG "SOONER" "" "SOURCES;USES;LINKS;PRIVATE_INCLUDES" ${ARGN})
  if(ARG_SOURCES)
    add_library(photic_${name} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(photic_${name} PRIVATE photic_flags)
    if(ARG_SOONER)
      target_compile_options(photic_${name} PRIVATE ${sooner})
    endif()
    if(NOT name STREQUAL "io")
      target_compile_options(photic_${name} PRIVATE ${optimised_also_for_debugging})
    endif()
    if(ARG_PRIVATE_INCLUDES)
      target_include_directories(photic_${name} SYSTEM PRIVATE ${ARG_PRIVATE_INCLUDES})
    endif()
  else()
    add_library(photic_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(photic_${name} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/photic>)
  set_property(GLOBAL APPEND PROPERTY PHOTIC_LIBRARIES photic_${name})
  list(TRANSFORM ARG_USES PREPEND photic_)
  target_link_libraries(photic_${name} ${scope} ${ARG_USES} ${ARG_LINKS})
endfunction()

# GNU's linker, whatever the compiler's own is: others do not seal.
find_program(PHOTIC_SEALER NAMES ld.bfd ld REQUIRED)

# photic_for_each_isa(target source.cpp "entry*" library… [CONTRACTED] [WITHOUT isa…])  → the source compiled for each of
# photic_isas but some, in one program; PHOTIC_ISA is the set's name. CONTRACTED: products and sums are rounded once where
# the set has an instruction for both.
#
# The danger: an inline function or template, std::max<float> say, is compiled into each of these objects and into
# ordinary ones, and the linker keeps one copy for the whole program. If that is one made of AVX-512, a program on a
# processor without it dies in code that has nothing to do with lanes; if it is another, lanes lose their speed. So each
# object is sealed: a partial link resolves its groups of such functions, and then all its symbols but those that match
# the entry are made local to it. Whatever it has inlined or instantiated is its own, at every level of optimisation and with
# every standard library. What is left: nothing in such an object may run before main, on every processor. So headers
# that it includes have no variables with constructors (tests/unit/schedule/check_sealed.py looks for both).
function(photic_for_each_isa target source entry)
  cmake_path(GET source STEM stem)
  cmake_parse_arguments(ARG "CONTRACTED" "" "WITHOUT" ${ARGN})
  foreach(isa IN LISTS photic_isas)
    if(isa IN_LIST ARG_WITHOUT)
      continue()
    endif()
    set(object ${target}_${stem}_${isa})
    add_library(${object} OBJECT ${source})
    target_compile_definitions(${object} PRIVATE PHOTIC_ISA=${isa})
    set_property(TARGET ${object} PROPERTY PHOTIC_CONTRACTED ${ARG_CONTRACTED})
    # g++ 12 takes the operand that its own headers leave undefined on purpose for a mistake. Symbols that are to be one in
    # the whole process cannot be made local.
    target_compile_options(${object} PRIVATE ${flags_of_${isa}}
                           "$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized;-fno-gnu-unique>")
    target_link_libraries(${object} PRIVATE ${ARG_UNPARSED_ARGUMENTS} photic_flags)
    target_compile_options(${object} PRIVATE ${optimised_also_for_debugging})
    target_include_directories(${object} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    set(sealed ${CMAKE_CURRENT_BINARY_DIR}/${object}.sealed.o)
    add_custom_command(
      OUTPUT ${sealed}
      COMMAND ${PHOTIC_SEALER} -r --force-group-allocation -o ${sealed} $<TARGET_OBJECTS:${object}>
      COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=${entry} ${sealed}
      DEPENDS ${object} $<TARGET_OBJECTS:${object}> VERBATIM)
    target_sources(${target} PRIVATE ${sealed})
    set_property(TARGET ${target} APPEND PROPERTY PHOTIC_SEALED ${sealed})
    set_source_files_properties(${sealed} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  endforeach()
endfunction()

# The folder of a test inside tests/, its label: unit/scene, statistical, …
function(photic_test_label result)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests OUTPUT_VARIABLE path)
  set(${result} ${path} PARENT_SCOPE)
endfunction()

# The headers that all tests share, read once. Linked like a test, for the same flags.
function(photic_test_headers)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp CONTENT "")
  add_library(test_headers STATIC ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(test_headers PRIVATE photic_core GTest::gtest_main photic_flags)
  target_precompile_headers(test_headers PRIVATE <gtest/gtest.h> <fmt/format.h>
                            <boost/math/distributions/chi_squared.hpp> <boost/math/distributions/normal.hpp>
                            <algorithm> <cmath> <filesystem> <functional> <map> <optional> <random> <string> <vector>)
endfunction()

# photic_test(name SOURCES a.cpp … USES core … [LONG_LOOPS] [ENGINE] [NOT_SANITIZED filter])  → one test program; ctest knows each
# of its tests, under their folder in tests/ as label (ctest -L unit); target tests_unit builds all in tests/unit. More labels:
# engine, of tests that run lanes and so run in a release, too; not_sanitized, of those that would follow histories for a minute or
# more with sanitizers, by a filter of GoogleTest.
function(photic_test name)
  cmake_parse_arguments(ARG "LONG_LOOPS;ENGINE" "TIMEOUT;NOT_SANITIZED" "SOURCES;USES;LINKS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  list(TRANSFORM ARG_USES PREPEND photic_)
  target_link_libraries(${name} PRIVATE ${ARG_USES} ${ARG_LINKS} photic_flags GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE PHOTIC_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(ARG_LONG_LOOPS AND CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(${name} PRIVATE ${optimised_also_for_debugging})  # and the shared headers are not
  else()
    target_precompile_headers(${name} REUSE_FROM test_headers)
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  # g++ 12 takes strings of a precompiled <string> for overruns; the sanitizers find real ones.
  target_compile_options(${name} PRIVATE -Wno-array-bounds)
  photic_test_label(label)
  set(labels ${label})
  if(ARG_ENGINE)
    list(APPEND labels engine)
  endif()
  set(set_labels "")
  foreach(part NOT_SANITIZED REST)
    set(filter "${ARG_NOT_SANITIZED}")
    set(all ${labels} not_sanitized)
    if(part STREQUAL "REST")
      set(filter "-${ARG_NOT_SANITIZED}")
      set(all ${labels})
    elseif(filter STREQUAL "")
      continue()
    endif()
    # gtest_discover_tests takes no lists.
    gtest_discover_tests(${name} TEST_FILTER "${filter}" TEST_LIST ${name}_${part} DISCOVERY_TIMEOUT 60
                         PROPERTIES TIMEOUT ${ARG_TIMEOUT})
    string(APPEND set_labels
           "if(${name}_${part})\n  set_tests_properties(\${${name}_${part}} PROPERTIES LABELS \"${all}\")\nendif()\n")
  endforeach()
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake "${set_labels}")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
  string(REGEX REPLACE "/.*" "" kind ${label})
  if(NOT TARGET tests_${kind})
    add_custom_target(tests_${kind})
  endif()
  add_dependencies(tests_${kind} ${name})
endfunction()

# Debian's own interpreter: it has the packages of tools/install_packages, another python3 in PATH may not.
set(PHOTIC_PYTHON /usr/bin/python3 CACHE FILEPATH "Python of the tests")

# photic_pytest(a.py … [NOT_SANITIZED b.py …])  → one test for each file, with the program and the Python package of this build;
# first in line, for they take long: what is short fills the cores to the end
function(photic_pytest)
  cmake_parse_arguments(ARG "" "" "NOT_SANITIZED" ${ARGN})
  photic_test_label(label)
  foreach(file ${ARG_UNPARSED_ARGUMENTS} ${ARG_NOT_SANITIZED})
    get_filename_component(stem ${file} NAME_WE)
    add_test(NAME ${label}.${stem}
             COMMAND ${PHOTIC_PYTHON} -m pytest -q -p no:cacheprovider ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    set(environment "PHOTIC_PROGRAM=$<TARGET_FILE:photic>" "PHOTIC_BUILD=${PROJECT_BINARY_DIR}"
        "PYTHONPATH=${PROJECT_BINARY_DIR}/python" PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg)
    set(labels ${label})
    if(file IN_LIST ARG_NOT_SANITIZED)
      list(APPEND labels not_sanitized)
    endif()
    set_tests_properties(${label}.${stem} PROPERTIES LABELS "${labels}" TIMEOUT 300 COST 10 ENVIRONMENT "${environment}")
  endforeach()
endfunction()
