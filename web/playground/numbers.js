/** Lets the user change a number in the sketch by dragging it sideways, or with Alt and an arrow key. */
import { syntaxTree } from '@codemirror/language'
import { Prec } from '@codemirror/state'
import { Decoration, EditorView, ViewPlugin, keymap } from '@codemirror/view'

/** Pointer movement in pixels per step, which is also the min distance of a drag. */
const PIXELS_PER_STEP = 4

/** Finds the plain number at a position of the text. Returns { from, to, value, decimals, mayBeNegative }, or undefined. */
export function numberAt(state, at) {
  let node
  for (const side of [1, -1]) {
    const candidate = syntaxTree(state).resolveInner(at, side)
    if (candidate.name === 'Number') node = candidate
  }
  if (!node) return
  const text = state.sliceDoc(node.from, node.to)
  const [isPlain, , fraction = ''] = /^(\d+|(?=\.))(?:\.(\d*))?$/.exec(text) ?? []
  if (isPlain === undefined) return
  const before = state.sliceDoc(Math.max(0, node.from - 1), node.from)
  const isNegated = before === '-' && node.parent?.name === 'UnaryExpression'
  return {
    from: isNegated ? node.from - 1 : node.from,
    to: node.to,
    value: isNegated ? -Number(text) : Number(text),
    decimals: fraction.length,
    // After a minus that subtracts, a second one would form the operator `--`.
    mayBeNegative: isNegated || before !== '-',
  }
}

/**
 * Returns the step of a drag: a unit of the last digit; for integers of three or more digits, of the second digit, so that a drag needs few
 * steps.
 */
const stepOf = ({ value, decimals }) =>
  decimals
    ? 10 ** -decimals
    : Math.max(1, 10 ** (Math.trunc(Math.abs(value)).toString().length - 2))

function stepNumber(number, steps) {
  const value = number.value + steps * stepOf(number)
  const bounded = number.mayBeNegative ? value : Math.max(0, value)
  // Avoid -0.
  return (bounded === 0 ? 0 : bounded).toFixed(number.decimals).replace(/^-(0(\.0*)?)$/, '$1')
}

/** Writes a number. A whole drag is one step of the history: a 'compose' event joins the previous one, however much time has passed. */
function write(view, { from, to }, insert, isFirst) {
  view.dispatch({
    changes: { from, to, insert },
    userEvent: isFirst ? 'input.number' : 'input.type.compose',
  })
  return { from, to: from + insert.length }
}

function drag(event, view) {
  if (event.button !== 0 || event.shiftKey) return false
  if (!event.target.closest?.('.cm-number')) return false
  const at = view.posAtCoords({ x: event.clientX, y: event.clientY })
  const number = at === null ? undefined : numberAt(view.state, at)
  if (!number) return false

  let place
  let shown = view.state.sliceDoc(number.from, number.to)
  const move = ({ clientX }) => {
    const steps = Math.trunc((clientX - event.clientX) / PIXELS_PER_STEP)
    const text = stepNumber(number, steps)
    if ((!place && !steps) || text === shown) return
    place = write(view, place ?? number, text, !place)
    shown = text
  }
  const end = () => {
    removeEventListener('pointermove', move)
    removeEventListener('pointerup', end)
    removeEventListener('pointercancel', end)
    document.body.classList.remove('drags-number')
    if (!place) view.dispatch({ selection: { anchor: at } })
  }
  addEventListener('pointermove', move)
  addEventListener('pointerup', end)
  addEventListener('pointercancel', end)
  document.body.classList.add('drags-number')
  view.focus()
  return true
}

/** Selects the number under a double click, without the minus before it. */
function selectNumber(event, view) {
  if (!event.target.closest?.('.cm-number')) return false
  const at = view.posAtCoords({ x: event.clientX, y: event.clientY })
  const number = at === null ? undefined : numberAt(view.state, at)
  if (!number) return false
  const anchor =
    view.state.sliceDoc(number.from, number.from + 1) === '-' ? number.from + 1 : number.from
  view.dispatch({ selection: { anchor, head: number.to } })
  return true
}

/** Returns a command that changes the number at the cursor. */
function makeStepCommand(steps) {
  return (view) => {
    const { empty, head } = view.state.selection.main
    const number = empty && numberAt(view.state, head)
    if (!number) return false
    write(view, number, stepNumber(number, steps), true)
    return true
  }
}

const mark = Decoration.mark({ class: 'cm-number' })

function marksIn(view) {
  const marks = []
  for (const { from, to } of view.visibleRanges)
    syntaxTree(view.state).iterate({
      from,
      to,
      enter: (node) => {
        if (node.name === 'Number') marks.push(mark.range(node.from, node.to))
      },
    })
  return Decoration.set(marks, true)
}

export const draggableNumbers = [
  ViewPlugin.define(
    (view) => ({
      marks: marksIn(view),
      update(update) {
        const isReparsed = syntaxTree(update.startState) !== syntaxTree(update.state)
        if (update.docChanged || update.viewportChanged || isReparsed)
          this.marks = marksIn(update.view)
      },
    }),
    { decorations: ({ marks }) => marks },
  ),
  // Prevents the mouse from starting a selection.
  EditorView.domEventHandlers({
    pointerdown: drag,
    mousedown: () => document.body.classList.contains('drags-number'),
    dblclick: selectNumber,
  }),
  Prec.high(
    keymap.of([
      { key: 'Alt-ArrowUp', run: makeStepCommand(1) },
      { key: 'Alt-ArrowDown', run: makeStepCommand(-1) },
    ]),
  ),
]
