#include "source/wgsl/keywords.hpp"

#include <algorithm>
#include <array>

#include "source/problems.hpp"

namespace warpjet::source::wgsl {

namespace {

using namespace std::string_view_literals;

// WGSL, section 16.1.
constexpr std::array keywords{
    "alias"sv,   "break"sv,    "case"sv,     "const"sv,      "const_assert"sv, "continue"sv,
    "default"sv, "discard"sv,  "else"sv,     "continuing"sv, "diagnostic"sv,   "enable"sv,
    "false"sv,   "fn"sv,       "for"sv,      "if"sv,         "let"sv,          "loop"sv,
    "return"sv,  "override"sv, "requires"sv, "struct"sv,     "switch"sv,       "true"sv,
    "var"sv,     "while"sv,
};

// WGSL, section 16.2: reserved for future use.
// clang-format off
constexpr std::array reserved{
    "NULL"sv, "Self"sv, "abstract"sv, "active"sv, "alignas"sv, "alignof"sv, "as"sv, "asm"sv,
    "asm_fragment"sv, "async"sv, "attribute"sv, "auto"sv, "await"sv, "become"sv, "cast"sv, "catch"sv,
    "class"sv, "co_await"sv, "co_return"sv, "co_yield"sv, "coherent"sv, "column_major"sv,
    "common"sv, "compile"sv, "compile_fragment"sv, "concept"sv, "const_cast"sv, "consteval"sv,
    "constexpr"sv, "constinit"sv, "crate"sv, "debugger"sv, "decltype"sv, "delete"sv, "demote"sv,
    "demote_to_helper"sv, "do"sv, "dynamic_cast"sv, "enum"sv, "explicit"sv, "export"sv, "extends"sv,
    "extern"sv, "external"sv, "fallthrough"sv, "filter"sv, "final"sv, "finally"sv, "friend"sv,
    "from"sv, "fxgroup"sv, "get"sv, "goto"sv, "groupshared"sv, "highp"sv, "impl"sv, "implements"sv,
    "import"sv, "inline"sv, "instanceof"sv, "interface"sv, "layout"sv, "lowp"sv, "macro"sv,
    "macro_rules"sv, "match"sv, "mediump"sv, "meta"sv, "mod"sv, "module"sv, "move"sv, "mut"sv,
    "mutable"sv, "namespace"sv, "new"sv, "nil"sv, "noexcept"sv, "noinline"sv, "nointerpolation"sv,
    "non_coherent"sv, "noncoherent"sv, "noperspective"sv, "null"sv, "nullptr"sv, "of"sv,
    "operator"sv, "package"sv, "packoffset"sv, "partition"sv, "pass"sv, "patch"sv,
    "pixelfragment"sv, "precise"sv, "precision"sv, "premerge"sv, "priv"sv, "protected"sv, "pub"sv,
    "public"sv, "readonly"sv, "ref"sv, "regardless"sv, "register"sv, "reinterpret_cast"sv,
    "require"sv, "resource"sv, "restrict"sv, "self"sv, "set"sv, "shared"sv, "sizeof"sv, "smooth"sv,
    "snorm"sv, "static"sv, "static_assert"sv, "static_cast"sv, "std"sv, "subroutine"sv, "super"sv,
    "target"sv, "template"sv, "this"sv, "thread_local"sv, "throw"sv, "trait"sv, "try"sv, "type"sv,
    "typedef"sv, "typeid"sv, "typename"sv, "typeof"sv, "union"sv, "unless"sv, "unorm"sv,
    "unsafe"sv, "unsized"sv, "use"sv, "using"sv, "varying"sv, "virtual"sv, "volatile"sv, "wgsl"sv,
    "where"sv, "with"sv, "writeonly"sv, "yield"sv,
};
// clang-format on

}  // namespace

bool isKeyword(std::string_view name) {
  return std::find(keywords.begin(), keywords.end(), name) != keywords.end();
}

std::string nameProblem(std::string_view name) {
  const std::string start = quote(name) + " cannot be a name: ";
  if (isKeyword(name)) return start + "it is a keyword";
  if (std::find(reserved.begin(), reserved.end(), name) != reserved.end())
    return start + "WGSL reserves this word; use another name";
  if (name == "_") return start + "use letters";
  if (name.starts_with("__")) return start + "names that start with __ are reserved";
  return {};
}

}  // namespace warpjet::source::wgsl
