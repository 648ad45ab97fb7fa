# Options of the presets asan, tidy, coverage and fuzz. Plain builds are not affected.
option(LAVER_SANITIZE "AddressSanitizer and UndefinedBehaviorSanitizer, the first finding ends it" OFF)
option(LAVER_TIDY "clang-tidy on every file that is compiled, clang-format on all" OFF)
option(LAVER_COVERAGE "Count the lines that run, and add the target coverage" OFF)
option(LAVER_FUZZ "Link the fuzz targets with libFuzzer (clang only)" OFF)

if(LAVER_SANITIZE OR LAVER_FUZZ)
  # `undefined` does not include casts of doubles out of the integer's range.
  set(sanitizers -fsanitize=address,undefined,float-cast-overflow)
  add_compile_options(${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(${sanitizers})
endif()

if(LAVER_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "LAVER_FUZZ needs clang: libFuzzer is a part of it.")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(LAVER_TIDY)
  find_program(LAVER_CLANG_TIDY clang-tidy REQUIRED)
  find_program(LAVER_CLANG_FORMAT clang-format REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${LAVER_CLANG_TIDY} --quiet)
  add_custom_target(format ALL
    COMMAND find host tests scenes ( -name *.cpp -o -name *.h )
      -exec ${LAVER_CLANG_FORMAT} --dry-run -Werror {} +
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "clang-format finds nothing to change" VERBATIM)
endif()

if(LAVER_COVERAGE)
  find_program(LAVER_GCOVR gcovr REQUIRED)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
  add_custom_target(coverage
    COMMAND sh ${CMAKE_SOURCE_DIR}/cmake/coverage.sh ${LAVER_GCOVR} ${CMAKE_SOURCE_DIR}
    WORKING_DIRECTORY ${CMAKE_BINARY_DIR}
    COMMENT "Line coverage of host/ by the tests that ran in this folder" USES_TERMINAL VERBATIM)
endif()
