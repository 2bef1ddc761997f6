// Writes the source of our own functions: those that statements call, and those that these
// functions call.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/emit.hpp"
#include "functions/library.hpp"

namespace warpjet {

class Declarations {
 public:
  Declarations(const Dialect& dialect, Library& library) : dialect_(dialect), library_(library) {}

  // Adds, without duplicates, the functions that these statements call, each after those that it
  // calls itself.
  void add(const Graph& graph, const EmittedCode& emitted);

  const std::string& text() const { return text_; }

 private:
  bool isDefined(std::string_view name) const;
  void define(const Function& function, int order);
  void define(std::string_view name, std::string_view text);
  std::string header(const std::string& type, const std::string& name, const Body& body) const;

  const Dialect& dialect_;
  Library& library_;
  std::vector<std::string> defined_;
  std::string text_;
};

}  // namespace warpjet
