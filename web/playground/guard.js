/**
 * Guards loops: while a user is typing `while (true)`, the page must not hang and lose the text. In each
 * iteration, a loop calls a function that throws if the loop runs for too long; frame/start.js defines it.
 */
import { javascriptLanguage } from '@codemirror/lang-javascript'

const loops = new Set(['ForStatement', 'WhileStatement', 'DoStatement'])
const functions = new Set(['ArrowFunction', 'FunctionExpression'])

/** warpjet's operators and p5.strands parse the source of functions that are passed to them, and do not support the guard. */
const isArgument = (node) => functions.has(node.name) && node.parent?.name === 'ArgList'

function mayBeParsed(node) {
  for (let above = node; above; above = above.parent) if (isArgument(above)) return true
  return false
}

const guardCall = 'playground.checkLoop();'

/** Adds a guard to each loop without changing line numbers. With the operators any function may be parsed, so nothing changes. */
export function guardLoops({ text, chosen = [] }) {
  if (chosen.includes('operators')) return text
  const inserts = []
  javascriptLanguage.parser.parse(text).iterate({
    enter({ name, node }) {
      if (!loops.has(name) || mayBeParsed(node)) return
      const body = name === 'DoStatement' ? node.firstChild?.nextSibling : node.lastChild
      if (!body || body.type.isError) return
      if (body.name === 'Block') inserts.push([body.from + 1, guardCall])
      else inserts.push([body.from, `{${guardCall}`], [body.to, '}'])
    },
  })
  // Inserts from the end, so that positions stay valid. Insertions at the same position keep their order.
  return inserts
    .sort(([a], [b]) => b - a)
    .reduce((text, [at, insert]) => text.slice(0, at) + insert + text.slice(at), text)
}
