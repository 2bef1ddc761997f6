/**
 * Loops that end by themselves: while somebody writes `while (true)`, the page must not stand still with all that was written.
 * Each loop asks, once a round, whether it has gone on for too long; frame/start.js answers.
 */
import { javascriptLanguage } from '@codemirror/lang-javascript'

const loops = new Set(['ForStatement', 'WhileStatement', 'DoStatement'])
const functions = new Set(['ArrowFunction', 'FunctionExpression'])

/** Of these the text is read, by warpjet's operators and p5.strands, which know of no such question. */
const isHandedOver = (node) => functions.has(node.name) && node.parent?.name === 'ArgList'

function isRead(node) {
  for (let above = node; above; above = above.parent) if (isHandedOver(above)) return true
  return false
}

const question = 'playground.goOn();'

/** The text with a question in each loop, in the same lines. Where all functions may be read, it is left alone. */
export function guarded({ text, chosen = [] }) {
  if (chosen.includes('operators')) return text
  const inserts = []
  javascriptLanguage.parser.parse(text).iterate({
    enter({ name, node }) {
      if (!loops.has(name) || isRead(node)) return
      const body = name === 'DoStatement' ? node.firstChild?.nextSibling : node.lastChild
      if (!body || body.type.isError) return
      if (body.name === 'Block') inserts.push([body.from + 1, question])
      else inserts.push([body.from, `{${question}`], [body.to, '}'])
    },
  })
  // From the end, so that places stay. What is inserted at one place keeps its order.
  return inserts
    .sort(([a], [b]) => b - a)
    .reduce((text, [at, insert]) => text.slice(0, at) + insert + text.slice(at), text)
}
