# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT: LAYOUT_STRUCT(type) and LAYOUT_MEMBER(type, member) for every struct of FILES, so
# that the test of the layout names each member by itself, in both languages.
cmake_minimum_required(VERSION 3.25)

set(table "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\\[[^]]*\\]" "" text "${text}")
  string(REPLACE ";" "," text "${text}")
  string(REGEX MATCHALL "typedef struct [A-Za-z]+ {[^}]*}" structs "${text}")
  foreach(struct IN LISTS structs)
    string(REGEX MATCH "struct ([A-Za-z]+) {(.*)}" _ "${struct}")
    set(type ${CMAKE_MATCH_1})
    string(APPEND table "LAYOUT_STRUCT(${type})\n")
    string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]*[ \n]*," members "${CMAKE_MATCH_2}")
    foreach(member IN LISTS members)
      string(REGEX REPLACE "[ \n]*,$" "" member "${member}")
      string(APPEND table "LAYOUT_MEMBER(${type}, ${member})\n")
    endforeach()
  endforeach()
endforeach()
file(WRITE ${OUTPUT} "${table}")
