// The programs and libraries that the project needs, how to find them, and the Debian packages that have them. CMake checks the versions
// of compilers.
import { existsSync, readdirSync } from 'node:fs'
import { findBrowser, findFirefox, isUbuntu } from './find-browser.mjs'
import { capture } from './run.mjs'
import { findHeader, onPath } from './which.mjs'

const program = (name, names, ...apt) => ({ name, find: () => onPath(...names), apt })
const library = (name, apt, ...headers) => ({
  name,
  find: () => findHeader(...headers),
  apt: [apt],
})

/** On Ubuntu, playwright-core fetches the browser, because Ubuntu's packages of browsers start snaps, which cannot read /tmp. */
const browser = (name, find, apt) =>
  isUbuntu()
    ? {
        name,
        find,
        apt: [],
        fetch: ['playwright-core', 'install', '--with-deps', name.toLowerCase()],
      }
    : { name, find, apt: [apt] }

/** Finds libFuzzer. Debian has it in another package than clang, together with the sanitizers. */
async function findFuzzer() {
  const folder = (await capture('clang++', ['--print-runtime-dir']))?.trim()
  const files = existsSync(folder) ? readdirSync(folder) : []
  return files.some((file) => file.includes('.fuzzer')) ? folder : undefined
}

export const requirements = [
  program('Emscripten', ['emcc'], 'emscripten'),
  program('CMake', ['cmake'], 'cmake'),
  program('Ninja or make', ['ninja', 'make'], 'ninja-build'),
  program('a C++ compiler', [process.env.CXX, 'c++', 'g++', 'clang++'].filter(Boolean), 'g++'),
  program('ccache', ['ccache'], 'ccache'),
  { name: "clang's libFuzzer", find: findFuzzer, apt: ['clang', 'libclang-rt-dev'] },
  library('GoogleTest', 'libgtest-dev', 'gtest/gtest.h'),
  program('clang-format', ['clang-format'], 'clang-format'),
  library('GLM', 'libglm-dev', 'glm/glm.hpp'),
  library('tinygltf', 'libtinygltf-dev', 'tiny_gltf.h'),
  library('nlohmann-json', 'nlohmann-json3-dev', 'nlohmann/json.hpp'),
  library('stb', 'libstb-dev', 'stb/stb_image.h', 'stb_image.h'),
  browser('Chromium', findBrowser, 'chromium-headless-shell'),
  browser('Firefox', findFirefox, 'firefox-esr'),
  // The display on which Firefox draws WebGL, and the driver for it.
  program('Xvfb', ['Xvfb'], 'xvfb', 'libgl1-mesa-dri'),
]
