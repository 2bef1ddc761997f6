// Edits the GLSL that WebGLRenderer compiles. Its `#include <…>` lines name chunks of three.js.
import { ShaderChunk } from 'three'

const chunks = ShaderChunk as Record<string, string | undefined>

/** Replaces `#include` lines by the chunks that they name, as three.js does later. Unknown ones stay, for three.js to report. */
export const resolveIncludes = (source: string): string =>
  source.replace(/^[ \t]*#include +<([\w\d./]+)>/gm, (line, name: string) => {
    const chunk = chunks[name]
    return chunk === undefined ? line : resolveIncludes(chunk)
  })

/** Returns the source of a chunk; empty if this version of three.js has no chunk with that name. */
export const chunkSource = (name: string): string => resolveIncludes(chunks[name] ?? '')

/** The head of `main`. */
const mainHead = /\bvoid\s+main\s*\(\s*(?:void)?\s*\)/

/** Splits a source before the function `main`; returns `undefined` if it has none. */
export function splitAtMain(source: string): { top: string; main: string } | undefined {
  const start = source.search(mainHead)
  return start < 0 ? undefined : { top: source.slice(0, start), main: source.slice(start) }
}

export const renameMain = (main: string, name: string) => main.replace(mainHead, `void ${name}()`)
