// The border of the front end for shader text: plain C. A source is read once, and its functions
// are listed in words that JavaScript replays.
#include "glsl/glsl.hpp"

#include <emscripten.h>

#include <cstdlib>
#include <string>
#include <utility>

using namespace warpjet::glsl;

namespace {

struct Reading {
  Source source;
  Listing listing;
};

// Whoever asked releases it.
const std::string* told(std::string text) { return new std::string(std::move(text)); }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE std::string* makeText(int size) {
  return new std::string(static_cast<std::size_t>(size), '\0');
}

EMSCRIPTEN_KEEPALIVE const char* textAddress(const std::string* text) { return text->data(); }

EMSCRIPTEN_KEEPALIVE int textSize(const std::string* text) {
  return static_cast<int>(text->size());
}

EMSCRIPTEN_KEEPALIVE void releaseText(const std::string* text) { delete text; }

// The builder's name of each code, empty where it is none of its operations.
EMSCRIPTEN_KEEPALIVE const std::string* codes() {
  std::string names;
  for (const char* name : codeNames) (names += name) += ' ';
  return told(names);
}

EMSCRIPTEN_KEEPALIVE Reading* openSource(const std::string* text) {
  return new Reading{Source(*text), {}};
}

EMSCRIPTEN_KEEPALIVE void closeSource(Reading* reading) { delete reading; }

EMSCRIPTEN_KEEPALIVE const std::string* sourceProblem(Reading* reading) {
  return told(reading->source.problem());
}

EMSCRIPTEN_KEEPALIVE const std::string* functionLines(Reading* reading) {
  return told(reading->source.functions());
}

EMSCRIPTEN_KEEPALIVE void lower(Reading* reading, int function, int maxIterations) {
  reading->listing = reading->source.lower(function, maxIterations);
}

EMSCRIPTEN_KEEPALIVE const std::uint32_t* words(Reading* reading) {
  return reading->listing.words.data();
}

EMSCRIPTEN_KEEPALIVE int wordCount(Reading* reading) {
  return static_cast<int>(reading->listing.words.size());
}

EMSCRIPTEN_KEEPALIVE const double* constants(Reading* reading) {
  return reading->listing.constants.data();
}

EMSCRIPTEN_KEEPALIVE int constantCount(Reading* reading) {
  return static_cast<int>(reading->listing.constants.size());
}

EMSCRIPTEN_KEEPALIVE const std::uint32_t* results(Reading* reading) {
  return reading->listing.results.data();
}

EMSCRIPTEN_KEEPALIVE int resultCount(Reading* reading) {
  return static_cast<int>(reading->listing.results.size());
}

EMSCRIPTEN_KEEPALIVE const std::string* routineLines(Reading* reading) {
  return told(reading->listing.routines);
}

EMSCRIPTEN_KEEPALIVE const std::string* nameLines(Reading* reading) {
  return told(reading->listing.names);
}

}  // extern "C"
