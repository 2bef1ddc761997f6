// Names in the shaders of `exactNormals`, which differ from those of a warp: one shader may have both.

/** Renames what begins with warpjet. */
export const withOwnNames = (source: string) =>
  source.replace(/\bwarpjet(?!Exact)/g, 'warpjetExact')

/** Matches the heads of functions that are made of the user's, which have their names and a hash. */
const head =
  /^(?:(?:high|medium|low)p )?\w+ (?!warpjet)(\w+_[0-9a-z]+(?:Gradient|Jacobian)?)\([^;{]*\) ?\{\n\w+ result;/gm

/** Renames these functions, too. */
export function withOwnFunctions(source: string): string {
  const names = [...source.matchAll(head)].map(([, name]) => name!)
  return names.length === 0
    ? source
    : source.replace(new RegExp(`\\b(?:${names.join('|')})(?=\\()`, 'g'), 'warpjetExact_$&')
}
