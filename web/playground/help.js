/** Completion and hover in the editor, with texts from the docs and from our own declarations. */
import { javascriptLanguage } from '@codemirror/lang-javascript'
import { syntaxTree } from '@codemirror/language'
import { hoverTooltip } from '@codemirror/view'
import { make } from '../bench/dom.js'
import { setting } from './editor.js'
import { isThree } from './hosts.js'
import { deformers, hostEntries, libraryFunctions, meaningOf, operations } from './reference.js'

/** Returns a function that makes a completion from an entry [name, { forms, meanings }]. */
const makeCompletion =
  (type) =>
  ([label, { forms, meanings }]) => ({
    label,
    type,
    detail: (forms.at(-1).match(/\(.*\)/) ?? [''])[0],
    info: () => describe({ forms, meanings }),
  })
const completionsOf = (map, type) => [...map].map(makeCompletion(type))

const methods = completionsOf(operations, 'method')
const members = [
  ...completionsOf(deformers, 'function'),
  ...completionsOf(libraryFunctions, 'function'),
]
const words = Object.fromEntries(
  Object.entries(hostEntries).map(([host, { inputs, functions }]) => [
    host,
    [...completionsOf(inputs, 'variable'), ...completionsOf(functions, 'function')],
  ]),
)
const hostOf = (state) => (isThree(state.field(setting).host) ? 'three' : 'p5')

/**
 * Returns the options of a function, by name, if the name at `from` is a key in an object that is passed to the function; otherwise
 * undefined.
 */
function optionsAround(state, from) {
  if (!/[{,]\s*$/.test(state.sliceDoc(Math.max(0, from - 200), from))) return
  let node = syntaxTree(state).resolveInner(from, -1)
  while (node && !/^(?:ObjectExpression|ObjectPattern|ArrowFunction|Block)$/.test(node.name))
    node = node.parent
  const list = node?.name === 'ObjectExpression' && node.parent
  if (list?.name !== 'ArgList') return
  const { from: start, to: end } = list.parent.firstChild
  const name = state.sliceDoc(start, end).split('.').at(-1)
  const options = hostEntries[hostOf(state)].functions.get(name)?.options
  return options?.size ? options : undefined
}

/**
 * Completes methods after a dot, options in an object that is passed to a function, and inputs and functions elsewhere. Components of
 * vectors need no completion.
 */
function complete(context) {
  const { state, pos } = context
  const member = context.matchBefore(/[\w$)\]]\.\w*$/)
  if (member) {
    const before = state.sliceDoc(Math.max(0, member.from - 12), member.from + 1)
    const isLibrary = /\bwarpjet$/.test(before)
    return { from: member.from + 2, options: isLibrary ? members : methods, validFor: /^\w*$/ }
  }
  const word = context.matchBefore(/\w+$/)
  if (!word && !context.explicit) return null
  const from = word?.from ?? pos
  const functionOptions = optionsAround(state, from)
  // Rank options above JavaScript's keywords.
  const options = functionOptions
    ? completionsOf(functionOptions, 'property').map((each) => ({ ...each, boost: 50 }))
    : words[hostOf(state)]
  return { from, options, validFor: /^\w*$/ }
}

function describe({ forms, meanings }) {
  return make(
    'div',
    { className: 'about' },
    make('code', { textContent: forms.join('  ·  ') }),
    ...meanings.map((textContent) => make('p', { textContent })),
  )
}

const hover = hoverTooltip(({ state }, at) => {
  const { from, to, text } = state.doc.lineAt(at)
  let [start, end] = [at, at]
  while (start > from && /\w/.test(text[start - from - 1])) start--
  while (end < to && /\w/.test(text[end - from])) end++
  if (start === end) return null
  const name = text.slice(start - from, end - from)
  const isMember = text[start - from - 1] === '.'
  const meaning =
    optionsAround(state, start)?.get(name) ?? meaningOf(name, isMember, hostEntries[hostOf(state)])
  return meaning && { pos: start, end, create: () => ({ dom: describe(meaning) }) }
})

export const help = [javascriptLanguage.data.of({ autocomplete: complete }), hover]
