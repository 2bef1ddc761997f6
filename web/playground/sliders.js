/** What moves the uniforms of the sketch: a slider for a number, one for each part of a vector, and a field for a colour. */
import { make } from '../bench/dom.js'
import { isValue } from './messages.js'

const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3, useGrouping: false })

/** From nothing to some times the number that the sketch has; around 0 where it has 0. */
const rangeOf = (value) => (value === 0 ? [-1, 1] : [0, 4 * value].sort((a, b) => a - b))

const isColor = (value) => typeof value === 'string'
const isAlike = (a, b) => typeof a === typeof b && a.length === b.length

/** `changed` gets what hands have moved, as `moved()` does. */
export function makeSliders(place, changed) {
  /** By name: { source, value }, the sketch's value and the hand's. Another value in the sketch counts anew. */
  let moved = {}

  /** The very source where no hand has moved it. */
  const valueOf = (name, source) =>
    String(moved[name]?.source) === String(source) ? moved[name].value : source

  function row(title, input, print) {
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
    return row(title, input, (value) => short.format(value))
  }

  function controlsFor({ name, value: source }) {
    const move = (value) => {
      moved[name] = { source, value }
      changed(moved)
    }
    const now = () => valueOf(name, source)
    if (isColor(source)) {
      const input = make('input', { type: 'color', value: now() })
      input.addEventListener('input', () => move(input.value))
      return row(name, input, (color) => color)
    }
    if (typeof source === 'number') return sliderFor(name, source, now(), move)
    return [...source].flatMap((part, i) =>
      sliderFor(`${name}.${'xyzw'[i]}`, part, now()[i], (value) =>
        move(Array.from(now(), (before, k) => (k === i ? value : before))),
      ),
    )
  }

  return {
    /** [{ name, value }] of the sketch that is shown. */
    show: (uniforms = []) => place.replaceChildren(...uniforms.flatMap(controlsFor)),
    /** Maps name → { source, value }. */
    moved: () => moved,
    /** Such as a link has brought; anything else than values is left out. */
    set(values) {
      moved = Object.fromEntries(
        Object.entries(values ?? {}).filter(
          ([, each]) =>
            isValue(each?.value) && isValue(each.source) && isAlike(each.value, each.source),
        ),
      )
    },
  }
}
