// GLSL in a form that can be compared and searched.

/** Replaces comments by spaces, so that lines and columns stay. */
export function removeComments(text: string): string {
  return text.replace(/\/\/[^\n]*|\/\*[^]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ' '))
}

/** Returns source without `#line`, empty lines and spaces around lines, for comparisons. */
export function plainLines(text: string): string {
  const lines = text.replace(/^#line \d+\n/gm, '').split('\n')
  return lines
    .map((line) => line.trim())
    .filter(Boolean)
    .join('\n')
}

/** Matches assignments to a variable or its components. */
export const assignmentsTo = (name: string) =>
  new RegExp(`(?<![.\\w])${name}\\s*(?:\\.\\w+\\s*)?(?:[-+*/]?=(?!=))`, 'g')

export const isAssigned = (text: string, name: string) => assignmentsTo(name).test(text)

/** Counts the occurrences of a variable. */
export const countOf = (text: string, name: string) =>
  text.match(new RegExp(`(?<![.\\w])${name}\\b`, 'g'))?.length ?? 0
