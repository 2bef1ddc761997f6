/** Highlights lines of the editor while the pointer is on the shader code generated from them. */
import { StateEffect, StateField } from '@codemirror/state'
import { Decoration, EditorView } from '@codemirror/view'

const setLines = StateEffect.define()
const line = Decoration.line({ class: 'cm-lit' })

export const highlightedLines = StateField.define({
  create: () => Decoration.none,
  update: (marks, { changes, effects, state }) =>
    effects.reduce(
      (before, effect) =>
        effect.is(setLines)
          ? Decoration.set(
              effect.value
                .filter((lineNumber) => lineNumber <= state.doc.lines)
                .sort((a, b) => a - b)
                .map((lineNumber) => line.range(state.doc.line(lineNumber).from)),
            )
          : before,
      marks.map(changes),
    ),
  provide: (field) => EditorView.decorations.from(field),
})

export const highlightLines = (view, lineNumbers) =>
  view.dispatch({ effects: setLines.of(lineNumbers) })
