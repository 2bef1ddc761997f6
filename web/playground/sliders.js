/** A slider for each uniform of the sketch that is a plain number. */
import { make } from '../bench/dom.js'

const short = new Intl.NumberFormat('en', { maximumSignificantDigits: 3, useGrouping: false })

/** From nothing to some times the number that the sketch has; around 0 where it has 0. */
const rangeOf = (value) => (value === 0 ? [-1, 1] : [0, 4 * value].sort((a, b) => a - b))

export function makeSliders(place) {
  /** By name: { source, value }, the sketch's number and the hand's. Another number in the sketch counts anew. */
  let moved = {}

  const valueOf = (name, source) => (moved[name]?.source === source ? moved[name].value : source)

  function sliderFor({ name, value: source }) {
    const [min, max] = rangeOf(source)
    const input = make('input', { type: 'range', id: `uniform-${name}`, min, max, step: 'any' })
    input.value = valueOf(name, source)
    const output = make('output', { textContent: short.format(input.value) })
    input.addEventListener('input', () => {
      moved[name] = { source, value: Number(input.value) }
      output.textContent = short.format(input.value)
    })
    return [make('label', { htmlFor: input.id, textContent: name }), input, output]
  }

  return {
    valueOf,
    /** [{ name, value }] of the sketch that is shown. */
    show: (uniforms = []) => place.replaceChildren(...uniforms.flatMap(sliderFor)),
    moved: () => moved,
    /** Such as a link has brought; anything that is no number is left out. */
    set(values) {
      moved = Object.fromEntries(
        Object.entries(values ?? {}).filter(([, each]) => Number.isFinite(each?.value)),
      )
    },
  }
}
