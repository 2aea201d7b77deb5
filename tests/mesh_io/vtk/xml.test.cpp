#include "mesh_io/vtk/xml.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"

using namespace fccda;
using Kind = XmlTag::Kind;

TEST_CASE("xml: tags are returned with names, attributes, text and lines, without comments") {
  XmlTags tags("<?xml version='1.0'?>\n<!-- <no/> -->\n<a  one = \"1>0\"\n two='\"'>\ntext</a >\n<b/>", "f.xml");
  XmlTag tag = tags.next();
  CHECK(tag.kind == Kind::opening);
  CHECK(tag.name == "a");
  CHECK(tag.line == 3);
  CHECK(tag["one"] == "1>0");
  CHECK(tag["two"] == "\"");
  CHECK(tag["three"].empty());
  CHECK(tag["on"].empty());
  tag = tags.next();
  CHECK(tag.kind == Kind::closing);
  CHECK(tag.name == "a");
  CHECK(tags.text() == "\ntext");
  CHECK(tags.line_of_text() == 4);
  tag = tags.next();
  CHECK(tag.kind == Kind::alone);
  CHECK(tag.name == "b");
  CHECK(tag.line == 6);
  CHECK(tags.next().kind == Kind::end_of_file);
}

TEST_CASE("xml: unclosed tags, comments and instructions, and document types are refused") {
  const auto check_refused = [](const char* text, const char* sentence) { CHECK_THROWS_WITH_AS(XmlTags(text, "f.xml").next(), sentence, InputError); };
  check_refused("\n<a b=\">", "f.xml:2: a tag is not closed; the file is truncated: export it again.");
  check_refused("<!-- ->", "f.xml:1: a comment is not closed; the file is truncated: export it again.");
  check_refused("<?xml", "f.xml:1: a tag <? is not closed; the file is truncated: export it again.");
  check_refused("<!DOCTYPE a>", "f.xml:1: document types and CDATA (`<!`) are not supported; export the file again.");
}
