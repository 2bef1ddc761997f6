// The programs and libraries that the project needs, how to find them, and the Debian packages that have them.
import { mkdirSync, writeFileSync } from 'node:fs'
import { findBrowser, findFirefox, isUbuntu } from './browser.mjs'
import { path } from './files.mjs'
import { capture } from './run.mjs'
import { atLeast, cacheAnswer, findHeader, versionOf } from './versions.mjs'
import { onPath } from './which.mjs'

/** Finds a program with a minimum version → { found }, { wrong }, or {} if it is missing. */
const program = (names, minVersion) => async () => {
  const file = onPath(...names)
  const version = file && (await versionOf(file))
  if (!version) return {}
  if (minVersion && !atLeast(version, minVersion))
    return { wrong: `expected ${minVersion} or newer, got ${version}` }
  return { found: `${version} (${file})` }
}

/** A library, found by a header. */
const library = (name, apt, ...headers) => ({
  name,
  find: () => ({ found: findHeader(...headers) }),
  apt: [apt],
})

/** A browser. Ubuntu's packages start snaps, which cannot read /tmp, so playwright-core fetches one there. */
const browser = (name, find, apt) => ({
  name,
  find: async () => {
    const file = await find()
    return file ? { found: `${await versionOf(file)} (${file})`, file } : {}
  },
  apt: isUbuntu() ? [] : [apt],
  fetch: isUbuntu() ? ['playwright-core', 'install', '--with-deps', name.toLowerCase()] : null,
})

// Uses the C++20 features that the core relies on, so that a compiler that accepts this accepts the core.
const probe = `#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <span>
#include <tuple>
struct Key { std::uint32_t a, b; auto operator<=>(const Key&) const = default; };
template <std::floating_point T> constexpr T twice(T x) { return x + x; }
constexpr auto rows = std::tuple{[]<class T>(T x) { return twice(x); }};
static_assert(std::get<0>(rows)(1.0) == 2.0 && Key{1, 2} < Key{1, 3});
int main() { const int n[] = {0}; return std::span(n)[0] + int(std::bit_cast<std::uint32_t>(0.0f)); }
`

/** Returns whether the compiler builds a program from this source. Cached until the compiler changes. */
const compiles = (compiler, name, source, args) =>
  cacheAnswer(compiler, [source, ...args].join('\0'), async () => {
    const file = path('.build', `${name}.cpp`)
    mkdirSync(path('.build'), { recursive: true })
    writeFileSync(file, source)
    const output = await capture(compiler, [...args, file, '-o', path('.build', name)])
    return output === null ? null : 'yes'
  })

async function compiler() {
  const file = onPath(...[process.env.CXX, 'c++', 'g++', 'clang++'].filter(Boolean))
  if (!file) return {}
  const version = await versionOf(file)
  return (await compiles(file, 'probe', probe, ['-std=c++20']))
    ? { found: `${version} (${file})` }
    : { wrong: `${file} ${version} does not compile C++20` }
}

const fuzzProbe = `extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }
`

/** Finds clang with libFuzzer and the sanitizers, which are a separate Debian package. */
async function libFuzzer() {
  const file = onPath('clang++')
  if (!file) return {}
  const args = ['-fsanitize=fuzzer,address,undefined']
  return (await compiles(file, 'fuzz-probe', fuzzProbe, args))
    ? { found: `${await versionOf(file)} (${file})` }
    : {}
}

export const requirements = [
  {
    name: 'Emscripten',
    find: program(['emcc'], '3.1.6'),
    apt: ['emscripten'],
    advice: 'put a newer one on PATH with emsdk (https://emscripten.org/docs/getting_started)',
  },
  { name: 'CMake', find: program(['cmake'], '3.21'), apt: ['cmake'] },
  { name: 'Ninja or make', find: program(['ninja', 'make']), apt: ['ninja-build'] },
  {
    name: 'C++20 compiler',
    find: compiler,
    apt: ['g++'],
    advice: 'install g++ 11 or newer and name it in CXX',
  },
  { name: 'ccache', find: program(['ccache'], '4.0'), apt: ['ccache'] },
  { name: "clang's libFuzzer", find: libFuzzer, apt: ['clang', 'libclang-rt-dev'] },
  library('GoogleTest', 'libgtest-dev', 'gtest/gtest.h'),
  { name: 'clang-format', find: program(['clang-format']), apt: ['clang-format'] },
  library('GLM', 'libglm-dev', 'glm/glm.hpp'),
  library('tinygltf', 'libtinygltf-dev', 'tiny_gltf.h'),
  library('nlohmann-json', 'nlohmann-json3-dev', 'nlohmann/json.hpp'),
  library('stb', 'libstb-dev', 'stb/stb_image.h', 'stb_image.h'),
  browser('Chromium', findBrowser, 'chromium-headless-shell'),
  browser('Firefox', findFirefox, 'firefox-esr'),
  {
    name: 'Xvfb',
    find: async () => (onPath('Xvfb') ? { found: `(${onPath('Xvfb')})` } : {}),
    // The display on which Firefox draws WebGL, and the driver for it.
    apt: ['xvfb', 'libgl1-mesa-dri'],
  },
]
