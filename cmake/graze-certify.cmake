# graze_certify(engine [SHAPES s...] [ANSWERS a...] FAMILIES f... [COUNT n] [SEED s] [TOLERANCE x] [RELATIVE_TOLERANCE x]
#               [TIME_LIMIT t] [MEMORY_LIMIT MiB] [JUNIT file] [SAVE file])
#
# Judges a target, a program that speaks the protocol or a module behind graze_engine.h, on generated families: each a test
# of ctest, ENGINE.FAMILY, which fails where the engine does not keep its word.
#   SHAPES, ANSWERS  what the engine must at least declare (ANSWERS: verdict, time, normal, witnesses, distance, depth,
#                    proof; a verdict is in every answer); else its tests fail with a line
#   COUNT, SEED      cases of a family, and the first seed
#   TOLERANCE, ...   hold it to this length, or to this over the scale of each question, whatever it promises
#   TIME_LIMIT       for an answer, in seconds: 1s or 1; MEMORY_LIMIT: of a process
#   JUNIT, SAVE      JUnit's XML, and the failing cases, of each family: graze.xml becomes graze-FAMILY.xml, in the build
#                    folder that is current
function(graze_certify engine)
  cmake_parse_arguments(arg "" "COUNT;SEED;TOLERANCE;RELATIVE_TOLERANCE;TIME_LIMIT;MEMORY_LIMIT;JUNIT;SAVE"
                        "SHAPES;ANSWERS;FAMILIES" ${ARGN})
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "graze_certify: not understood: ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES}")
  endif()
  if(NOT arg_FAMILIES)
    message(FATAL_ERROR "graze_certify: FAMILIES names what ${engine} is judged on; `graze generate --help` lists them")
  endif()
  set(options)
  foreach(shape IN LISTS arg_SHAPES)
    list(APPEND options --needs-shape ${shape})
  endforeach()
  foreach(answer IN LISTS arg_ANSWERS)
    list(APPEND options --needs-answer ${answer})
  endforeach()
  string(REGEX REPLACE "s$" "" arg_TIME_LIMIT "${arg_TIME_LIMIT}")
  foreach(name IN ITEMS COUNT SEED TOLERANCE RELATIVE_TOLERANCE TIME_LIMIT MEMORY_LIMIT)
    if(NOT "${arg_${name}}" STREQUAL "")
      string(TOLOWER ${name} option)
      string(REPLACE _ - option ${option})
      list(APPEND options --${option} ${arg_${name}})
    endif()
  endforeach()
  foreach(family IN LISTS arg_FAMILIES)
    set(files)
    foreach(name IN ITEMS JUNIT SAVE)
      if(arg_${name})
        cmake_path(ABSOLUTE_PATH arg_${name} BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} OUTPUT_VARIABLE file)
        cmake_path(GET file STEM LAST_ONLY stem)
        cmake_path(GET file EXTENSION LAST_ONLY extension)
        cmake_path(REPLACE_FILENAME file ${stem}-${family}${extension})
        string(TOLOWER ${name} option)
        list(APPEND files --${option} ${file})
      endif()
    endforeach()
    add_test(NAME ${engine}.${family} COMMAND graze::command certify --engine "'$<TARGET_FILE:${engine}>'" --family ${family}
                                              ${options} ${files})
    set_tests_properties(${engine}.${family} PROPERTIES LABELS graze)
  endforeach()
endfunction()
