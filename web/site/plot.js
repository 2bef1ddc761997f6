/** Plots an operation: its value and its derivative with respect to x, computed by warpjet, with the generated code for both. */
import { compile } from '../../dist/warpjet.js'
import { escapeHtml } from './html.js'
import { findKinks } from './kinks.js'

const [width, height] = [560, 220]
const steps = 280
const short = (value) => String(Number(value.toPrecision(3)))

/** Returns the SVG path of a curve, interrupted where the curve jumps or leaves the picture. */
function pathOf(values, toX, toY, limit) {
  let path = ''
  let before
  for (const [x, y] of values) {
    const isVisible = Number.isFinite(y) && Math.abs(y) <= limit
    const isJump = before !== undefined && Math.abs(y - before) > limit / 4
    if (isVisible)
      path += `${before === undefined || isJump ? 'M' : 'L'}${toX(x).toFixed(1)} ${toY(y).toFixed(1)}`
    before = isVisible ? y : undefined
  }
  return path
}

export function plotOf(call, from, to) {
  const program = compile((glsl) => {
    const x = glsl.param('x')
    const value = new Function('glsl', 'x', `return ${call}`)(glsl, x)
    return { value, derivative: glsl.derivative(value, x) }
  })
  const places = Array.from({ length: steps + 1 }, (_, i) => from + ((to - from) * i) / steps)
  const evaluated = places.map((x) => [x, program.evaluate({ x })])
  const curves = ['value', 'derivative'].map((name) =>
    evaluated.map(([x, results]) => [x, results[name]]),
  )
  const sizes = curves
    .flat()
    .map(([, y]) => Math.abs(y))
    .filter(Number.isFinite)
    .sort((a, b) => a - b)
  // Limit the height, so that a pole does not flatten the rest of the curve.
  const limit =
    1.15 * Math.max(Math.min(sizes.at(-1), 3 * sizes[Math.floor(sizes.length * 0.8)]), 0.2)
  const toX = (x) => 8 + ((x - from) / (to - from)) * (width - 16)
  const toY = (y) => height / 2 - (y / limit) * (height / 2 - 10)
  const kinks = findKinks((x) => {
    const { value, derivative } = program.evaluate({ x })
    return [value, derivative]
  }, places)
  const zero = from < 0 && to > 0 ? `M${toX(0)} 0V${height}` : ''
  return `<figure class="plot">
<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="Value and derivative of ${escapeHtml(call)}, for x from ${from} to ${to}${kinks.length ? `; kinks or jumps at ${kinks.map(short).join(', ')}` : ''}">
<path class="axes" d="M0 ${height / 2}H${width}${zero}"/>
${kinks.map((x) => `<path class="kink" data-kink="${x}" d="M${toX(x).toFixed(1)} 0V${height}"/>\n`).join('')}<path class="derivative" d="${pathOf(curves[1], toX, toY, limit)}"/>
<path class="value" d="${pathOf(curves[0], toX, toY, limit)}"/>
<text x="8" y="${height / 2 + 16}">${from}</text><text x="${width - 8}" y="${height / 2 + 16}" text-anchor="end">${to}</text>
<text x="8" y="14">${short(limit)}</text>
</svg>
<figcaption><span class="value">value</span> <span class="derivative">derivative</span>${kinks.length ? ' <span class="kink">kink or jump</span>' : ''} of <code>${escapeHtml(call)}</code></figcaption>
<pre tabindex="0" aria-label="The code of value and derivative"><code>${escapeHtml(program.code.trim())}</code></pre>
</figure>
`
}
