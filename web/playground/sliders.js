/** Controls for the sketch's uniforms: a slider for a number, one for each component of a vector, and a field for a colour. */
import { make } from '../bench/dom.js'
import { isValue } from './messages.js'

const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3, useGrouping: false })

/** Returns the range of a slider: from 0 to four times the sketch's value; from -1 to 1 if the value is 0. */
const rangeOf = (value) => (value === 0 ? [-1, 1] : [0, 4 * value].sort((a, b) => a - b))

const isColor = (value) => typeof value === 'string'
const hasSameForm = (a, b) => typeof a === typeof b && a.length === b.length

/** @param onChange called with the values that the user has changed, in the form that `moved()` returns */
export function makeSliders(place, onChange) {
  /** Maps name → { source, value }: the sketch's value and the user's. If the sketch's value changes, the user's is dropped. */
  let moved = {}

  /** Returns the user's value, or `source` itself if the user has not moved the control. */
  const valueOf = (name, source) =>
    String(moved[name]?.source) === String(source) ? moved[name].value : source

  function makeRow(title, input, print) {
    input.id = `uniform-${title}`
    const output = make('output', { textContent: print(input.value) })
    input.addEventListener('input', () => (output.textContent = print(input.value)))
    return [make('label', { htmlFor: input.id, textContent: title }), input, output]
  }

  function sliderFor(title, source, value, move) {
    const [min, max] = rangeOf(source)
    const input = make('input', { type: 'range', min, max, step: 'any' })
    input.value = value
    input.addEventListener('input', () => move(Number(input.value)))
    return makeRow(title, input, (value) => short.format(value))
  }

  function controlsFor({ name, value: source }) {
    const move = (value) => {
      moved[name] = { source, value }
      onChange(moved)
    }
    const current = () => valueOf(name, source)
    if (isColor(source)) {
      const input = make('input', { type: 'color', value: current() })
      input.addEventListener('input', () => move(input.value))
      return makeRow(name, input, (color) => color)
    }
    if (typeof source === 'number') return sliderFor(name, source, current(), move)
    return [...source].flatMap((part, i) =>
      sliderFor(`${name}.${'xyzw'[i]}`, part, current()[i], (value) =>
        move(Array.from(current(), (before, k) => (k === i ? value : before))),
      ),
    )
  }

  return {
    /** Shows controls for the visible sketch's uniforms, [{ name, value }]. */
    show: (uniforms = []) => place.replaceChildren(...uniforms.flatMap(controlsFor)),
    /** Maps name → { source, value }. */
    moved: () => moved,
    /** Sets the moved values, as read from a link; invalid ones are dropped. */
    set(values) {
      moved = Object.fromEntries(
        Object.entries(values ?? {}).filter(
          ([, each]) =>
            isValue(each?.value) && isValue(each.source) && hasSameForm(each.value, each.source),
        ),
      )
    },
  }
}
