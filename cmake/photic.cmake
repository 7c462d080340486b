# How every target of Photic is made.

add_library(photic_flags INTERFACE)
target_compile_features(photic_flags INTERFACE cxx_std_20)
# No contraction: the same bits from every schedule of the same formulas (docs/decisions).
target_compile_options(photic_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Werror -ffp-contract=off -fno-math-errno)

# photic_library(name SOURCES a.cpp … USES core … [LINKS …])  → target photic_name, headers under src/
function(photic_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LINKS;PRIVATE_INCLUDES" ${ARGN})
  if(ARG_SOURCES)
    add_library(photic_${name} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(photic_${name} PRIVATE photic_flags)
    if(ARG_PRIVATE_INCLUDES)
      target_include_directories(photic_${name} SYSTEM PRIVATE ${ARG_PRIVATE_INCLUDES})
    endif()
  else()
    add_library(photic_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(photic_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  list(TRANSFORM ARG_USES PREPEND photic_)
  target_link_libraries(photic_${name} ${scope} ${ARG_USES} ${ARG_LINKS})
endfunction()

# photic_test(name SOURCES a.cpp … USES core …)  → one test program; ctest knows each of its tests
function(photic_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;USES;LINKS" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  list(TRANSFORM ARG_USES PREPEND photic_)
  target_link_libraries(${name} PRIVATE ${ARG_USES} ${ARG_LINKS} photic_flags GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE PHOTIC_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} DISCOVERY_TIMEOUT 60)
endfunction()
