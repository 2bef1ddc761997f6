/** The editor of the sketch's text and setting. Text and setting share one history, so that undo restores either. */
import { invertedEffects } from '@codemirror/commands'
import { javascript } from '@codemirror/lang-javascript'
import { lintGutter, setDiagnostics } from '@codemirror/lint'
import { EditorState, StateEffect, StateField } from '@codemirror/state'
import { EditorView } from '@codemirror/view'
import { basicSetup } from 'codemirror'
import { highlightLines, highlightedLines } from './lit.js'
import { theme } from './theme.js'

/** { host, chosen, model }: host and chosen scripts as in hosts.js, model as in offset.js. */
const changeSetting = StateEffect.define()
export const setting = StateField.define({
  create: () => ({ host: 'p5', chosen: [], model: 'sphere' }),
  update: (value, { effects }) =>
    effects.reduce((before, effect) => (effect.is(changeSetting) ? effect.value : before), value),
})
const undoSettings = invertedEffects.of(({ effects, startState }) =>
  effects
    .filter((effect) => effect.is(changeSetting))
    .map(() => changeSetting.of(startState.field(setting))),
)

/** @param onChange called after each change of the text or the setting @param onMove called with the cursor's new line */
export function makeEditor(parent, { onChange, onMove, extensions = [] }) {
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        basicSetup,
        javascript(),
        setting,
        undoSettings,
        lintGutter(),
        highlightedLines,
        theme,
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ 'aria-label': 'Sketch', tabindex: '0' }),
        EditorView.updateListener.of((update) => {
          const isSettingChanged = update.startState.field(setting) !== update.state.field(setting)
          if (update.docChanged || isSettingChanged) onChange()
          if (update.selectionSet || update.docChanged)
            onMove?.(update.state.doc.lineAt(update.state.selection.main.head).number)
        }),
        extensions,
      ],
    }),
  })

  const sketch = () => ({ text: view.state.doc.toString(), ...view.state.field(setting) })

  return {
    view,
    sketch,
    /** Replaces the given properties of { text, host, chosen, model } as one step of the history. */
    set({ text, ...rest }) {
      const before = sketch()
      const { host, chosen, model } = { ...before, ...rest }
      const changes =
        text === undefined || text === before.text
          ? undefined
          : { from: 0, to: view.state.doc.length, insert: text }
      const effects = changeSetting.of({ host, chosen, model })
      view.dispatch({
        changes,
        effects,
        selection: changes && { anchor: 0 },
        userEvent: 'input.set',
      })
    },
    /** Marks the line of a mistake; without an argument, clears the mark. */
    mark(mistake) {
      const { doc } = view.state
      const marks = []
      if (mistake?.line) {
        const line = doc.line(Math.min(mistake.line, doc.lines))
        const from = line.from + /^\s*/.exec(line.text)[0].length
        marks.push({
          from: Math.min(from, line.to),
          to: line.to,
          severity: 'error',
          message: mistake.message,
        })
      }
      view.dispatch(setDiagnostics(view.state, marks))
    },
    /** Highlights the lines with these numbers, and no others. */
    highlight: (lineNumbers) => highlightLines(view, lineNumbers),
    goTo(lineNumber) {
      const { from } = view.state.doc.line(Math.min(lineNumber, view.state.doc.lines))
      view.dispatch({ selection: { anchor: from }, scrollIntoView: true })
      view.focus()
    },
  }
}
