# Writes a source that gives a text file's contents: cmake -DTEXT=page.html -DSOURCE=page.cpp -DHEADER=io/report/page.hpp -DFUNCTION=perimpact::report::page -P embed_text.cmake
file(READ ${TEXT} text)
string(REGEX REPLACE "::[^:]*$" "" namespace ${FUNCTION})
string(REGEX REPLACE ".*::" "" name ${FUNCTION})
file(WRITE ${SOURCE} "#include \"${HEADER}\"\n\nnamespace ${namespace} {\n\nstd::string_view ${name}() {\n  static constexpr char text[] = R\"embedded(${text})embedded\";\n  return {text, sizeof text - 1};\n}\n\n}  // namespace ${namespace}\n")
