/** The editor's theme, in the gallery's colours. */
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language'
import { EditorView } from '@codemirror/view'
import { tags } from '@lezer/highlight'

const appearance = EditorView.theme(
  {
    '&': { backgroundColor: 'transparent', color: 'var(--text)', height: '100%' },
    '&.cm-focused': { outline: 'none' },
    '.cm-scroller': { font: 'var(--code)', scrollbarColor: 'var(--line) transparent' },
    '.cm-content': { caretColor: 'var(--gold)', padding: '0.8rem 0' },
    '.cm-cursor': { borderLeftColor: 'var(--gold)' },
    '.cm-gutters': { backgroundColor: 'var(--panel)', color: 'var(--faint)', border: '0' },
    '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: '#ffffff0a' },
    '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground':
      { backgroundColor: '#3a4160' },
    '.cm-matchingBracket, &.cm-focused .cm-matchingBracket': {
      backgroundColor: '#43c6ac33',
      outline: '1px solid #43c6ac66',
    },
    '.cm-selectionMatch': { backgroundColor: '#e9c46a22' },
    '.cm-foldPlaceholder': { background: 'none', border: '0', color: 'var(--faint)' },
    '.cm-lintRange-error': { backgroundColor: '#ff8a5b2e' },
    '.cm-tooltip, .cm-panels': {
      backgroundColor: 'var(--panel)',
      border: '1px solid var(--line)',
      borderRadius: '0.4rem',
      color: 'var(--text)',
    },
    '.cm-tooltip-autocomplete ul li[aria-selected]': {
      backgroundColor: 'var(--line)',
      color: 'var(--text)',
    },
    '.cm-tooltip-autocomplete ul': { maxWidth: 'min(90vw, 36rem)' },
    '.cm-completionInfo, .cm-tooltip-hover': {
      font: '0.875rem/1.5 system-ui, sans-serif',
      maxWidth: 'min(90vw, 26rem)',
      padding: '0.5rem 0.75rem',
    },
    '.about p': { margin: '0.25rem 0 0' },
    '.about code': { color: 'var(--violet)', font: 'var(--code)' },
    '.cm-diagnostic-error': { borderLeftColor: 'var(--coral)' },
    '.cm-number': {
      cursor: 'ew-resize',
      touchAction: 'pan-y',
      borderBottom: '1px dotted #e9c46a99',
    },
  },
  { dark: true },
)

const colors = HighlightStyle.define([
  { tag: [tags.comment], color: 'var(--faint)' },
  { tag: [tags.keyword, tags.modifier], color: 'var(--coral)' },
  { tag: [tags.string, tags.special(tags.string), tags.regexp], color: 'var(--teal)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--gold)' },
  {
    tag: [tags.function(tags.definition(tags.variableName)), tags.propertyName],
    color: 'var(--violet)',
  },
  { tag: [tags.function(tags.variableName)], color: 'var(--violet)' },
])

export const theme = [appearance, syntaxHighlighting(colors)]
