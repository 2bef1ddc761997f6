// Resolves includes such that messages name lines of the shader as its author wrote it.
import { chunkSource } from '../shader-source.js'

/** Replaces `#include` lines by the chunks that they name; `#line` restores the numbers of the lines after each chunk. */
export const numberIncludes = (source: string): string =>
  source
    .split('\n')
    .map((line, i) => {
      const [include, name] = /^[ \t]*#include +<([\w\d./]+)>/.exec(line) ?? []
      const chunk = name && chunkSource(name)
      return chunk ? `${chunk}\n#line ${i + 1}\n${line.slice(include!.length)}` : line
    })
    .join('\n')
