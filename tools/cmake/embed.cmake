# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ file that holds every kernel source of FOLDER as raw strings.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*.h ${FOLDER}/*.cl ${FOLDER}/*.def)
list(SORT files)

set(text "// Made from kernels/ by tools/cmake/embed.cmake.\n#include \"base/embedded.h\"\n\n")
string(APPEND text "const lobe::EmbeddedFile lobe::embedded_files[] = {\n")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} content)
  string(LENGTH "${content}" length)
  string(APPEND text "    {\"${file}\",\n")
  # Compilers need not take string literals past 64 KiB; adjacent pieces are joined by the compiler.
  foreach(start RANGE 0 ${length} 8000)
    string(SUBSTRING "${content}" ${start} 8000 piece)
    string(APPEND text "R\"~~~~(${piece})~~~~\"\n")
  endforeach()
  string(APPEND text "    },\n")
endforeach()
string(APPEND text "};\nconst std::size_t lobe::embedded_file_count = "
       "sizeof(embedded_files) / sizeof(embedded_files[0]);\n")
file(WRITE ${OUTPUT} "${text}")
