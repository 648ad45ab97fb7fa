# cmake -DWORDS=FILE -DARRAY=FILE -DNAME=NAME -P: a file of little-endian words as a C++ array.
file(READ ${WORDS} hex HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words ${hex})
file(WRITE ${ARRAY} "const std::uint32_t ${NAME}[] = {\n${words}};\n")
