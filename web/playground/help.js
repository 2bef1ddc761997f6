/** Completion and hover in the editor, from what the docs say. */
import { javascriptLanguage } from '@codemirror/lang-javascript'
import { hoverTooltip } from '@codemirror/view'
import { make } from '../bench/dom.js'
import { meaningOf, reference } from './reference.js'

const { operations, deformers, inputs, makers } = reference

const option =
  (type) =>
  ([label, { forms, meanings }]) => ({
    label,
    type,
    detail: (forms.at(-1).match(/\(.*\)/) ?? [''])[0],
    info: () => about({ forms, meanings }),
  })
const optionsOf = (map, type) => [...map].map(option(type))

const methods = optionsOf(operations, 'method')
const warps = optionsOf(deformers, 'function')
const words = [...optionsOf(inputs, 'variable'), ...optionsOf(makers, 'function')]

/** Components of a vector need no help; what follows a number or a call gets all methods. */
function complete(context) {
  const member = context.matchBefore(/[\w$)\]]\.\w*$/)
  if (member) {
    const before = context.state.sliceDoc(Math.max(0, member.from - 12), member.from + 1)
    const isLibrary = /\bwarpjet$/.test(before)
    return { from: member.from + 2, options: isLibrary ? warps : methods, validFor: /^\w*$/ }
  }
  const word = context.matchBefore(/\w+$/)
  if (!word && !context.explicit) return null
  return { from: word?.from ?? context.pos, options: words, validFor: /^\w*$/ }
}

function about({ forms, meanings }) {
  return make(
    'div',
    { className: 'about' },
    make('code', { textContent: forms.join('  ·  ') }),
    ...meanings.map((textContent) => make('p', { textContent })),
  )
}

const hover = hoverTooltip((view, at) => {
  const { from, to, text } = view.state.doc.lineAt(at)
  let [start, end] = [at, at]
  while (start > from && /\w/.test(text[start - from - 1])) start--
  while (end < to && /\w/.test(text[end - from])) end++
  if (start === end) return null
  const isMember = text[start - from - 1] === '.'
  const meaning = meaningOf(text.slice(start - from, end - from), isMember)
  return meaning && { pos: start, end, create: () => ({ dom: about(meaning) }) }
})

export const help = [javascriptLanguage.data.of({ autocomplete: complete }), hover]
