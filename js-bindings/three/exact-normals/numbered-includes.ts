// Resolves includes so that messages name the lines of the shader as its author has it.
import { chunkSource } from '../shader-source.js'

/** Replaces `#include` lines by the chunks that they name, and numbers the lines after each as they were before. */
export const numberedIncludes = (source: string): string =>
  source
    .split('\n')
    .map((line, i) => {
      const [include, name] = /^[ \t]*#include +<([\w\d./]+)>/.exec(line) ?? []
      const chunk = name && chunkSource(name)
      return chunk ? `${chunk}\n#line ${i + 1}\n${line.slice(include!.length)}` : line
    })
    .join('\n')
