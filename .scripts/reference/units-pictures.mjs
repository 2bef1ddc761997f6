// web/docs/units-….svg: shapes of p5 with what `position` is on them in each space, and the spaces themselves. 328 wide, which is what a
// phone of 360 pixels has for them, so that letters are no smaller there than they say.
import { eye, shapes } from './units.mjs'

const width = 328
const [dim, bright, shape, axis] = ['#9da4ba', '#43c6ac', '#ff9468', '#3c4460']

const picture = (title, height, inside) =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="${width * 1.25}" height="${height * 1.25}" viewBox="0 0 ${width} ${height}" font-family="system-ui, sans-serif" font-size="11" fill="#d5d9e6">
<title>${title}</title><rect width="${width}" height="${height}" rx="12" fill="#151823"/>
${inside.join('\n')}
</svg>
`

const text = (x, y, words, more = '') => `<text x="${x}" y="${y}" ${more}>${words}</text>`
const centred = 'text-anchor="middle"'
const code = 'font-family="ui-monospace, monospace"'
const line = (path, colour, more = '') =>
  `<path d="${path}" fill="none" stroke="${colour}" ${more}/>`

const short = (x) => String(x).replace('-', '−')

/** 0, ±0.5, 0…1, or −800 ± 100. */
function inShort([low, high]) {
  if (low === high) return short(low)
  const [middle, half] = [(low + high) / 2, (high - low) / 2]
  if (middle === 0) return `±${half}`
  return low < -eye / 2 ? `${short(middle)}±${half}` : `${short(low)}…${short(high)}`
}

const columns = [60, 99, 141]
const cell = (column, y, words, colour = bright) =>
  text(columns[column], y, words, `${centred} fill="${colour}"`)
const numbers = (y, name, ranges) =>
  [text(8, y, name, `fill="${dim}"`), ...ranges.map((range, i) => cell(i, y, inShort(range)))].join(
    '',
  )

/** From the eye, only z is another. */
const camera = (y, [, , [low, high]]) =>
  [
    text(8, y, 'camera', `fill="${dim}"`),
    text(77, y, 'as world', `${centred} font-size="10" fill="${dim}"`),
    text(158, y, inShort([low - eye, high - eye]), `text-anchor="end" fill="${bright}"`),
  ].join('')

const panel = ({ call, title = call, local, world, outline }, index) =>
  `<g transform="translate(${(index % 2) * 164} ${Math.floor(index / 2) * 192})">
<g transform="translate(82 52)">${line('M-60 0H60M0 -40V40', axis)}${line(outline, shape, 'stroke-width="2"')}</g>
${text(82, 110, title, `${centred} ${code}`)}
${['x', 'y', 'z'].map((name, i) => cell(i, 128, name, dim)).join('')}
${numbers(144, 'local', local)}
${numbers(160, 'world', world)}
${camera(176, world)}
</g>`

/** Six shapes: the first or the second ones. */
export function shapesPicture(number) {
  const shown = shapes.slice(6 * number, 6 * number + 6)
  const names = shown.map(({ call, title = call }) => title.replace(/\(.*/, ''))
  return picture(
    `What position is on ${names.join(', ')}, in each space`,
    3 * 192,
    shown.map(panel),
  )
}

const arrow = (x, y, dx, dy) => {
  const [left, right] = [-dy, dy].map((a, i) => [-dx * 5 + a * 3, -dy * 5 + (i ? -dx : dx) * 3])
  const [endX, endY] = [x + dx, y + dy]
  const size = Math.hypot(dx, dy)
  const head = [left, right].map(([a, b]) => `M${endX} ${endY}l${a / size} ${b / size}`).join('')
  return line(`M${x} ${y}l${dx} ${dy}${head}`, bright)
}

const box = (x, y, by = 1) =>
  `<g transform="translate(${x} ${y}) rotate(20) scale(${by})">${line('M-20 -20H20V20H-20Z', shape, `stroke-width="${2 / by}"`)}</g>`

/** The same box in the three spaces: translate(150, -50), rotateZ(0.35), box(100). */
export function spacesPicture() {
  const local = [
    text(12, 24, 'local', `font-size="14" fill="${bright}"`),
    text(12, 42, 'the shape as it was made'),
    text(12, 58, 'corners at ±0.5,', `fill="${dim}"`),
    text(12, 73, 'however it is drawn', `fill="${dim}"`),
    `<g transform="translate(242 62) rotate(20)">${line('M-34 -34H34V34H-34Z', shape, 'stroke-width="2"')}${arrow(0, 0, 52, 0)}${arrow(0, 0, 0, 46)}${text(56, 4, 'x', `fill="${bright}"`)}${text(-3, 58, 'y', `fill="${bright}"`)}</g>`,
  ]
  const world = [
    text(12, 154, 'world', `font-size="14" fill="${bright}"`),
    text(12, 172, 'pixels from the'),
    text(12, 187, 'middle of the canvas'),
    text(12, 203, 'its middle: (150, −50, 0)', `fill="${dim}"`),
    line('M160 146H316V246H160Z', axis),
    arrow(238, 196, 30, 0),
    arrow(238, 196, 0, 26),
    text(271, 208, 'x', `fill="${bright}"`),
    text(235, 234, 'y', `fill="${bright}"`),
    box(283, 181, 0.75),
    text(166, 240, 'canvas', `fill="${dim}"`),
  ]
  const camera = [
    text(12, 288, 'camera', `font-size="14" fill="${bright}"`),
    text(12, 306, 'pixels from the eye'),
    text(12, 322, `its middle: (150, −50, −${eye})`, `fill="${dim}"`),
    line('M24 366l22 -9v18zM20 366a5 5 0 0 1 5 -5', bright),
    text(14, 390, 'eye', `fill="${bright}"`),
    arrow(50, 366, 176, 0),
    text(110, 359, `−z, ${eye}`, `fill="${bright}"`),
    line('M238 326V408', axis, 'stroke-dasharray="4 4"'),
    text(246, 404, 'canvas', `fill="${dim}"`),
    line('M226 339H250V369H226Z', shape, 'stroke-width="2"'),
  ]
  const rules = line('M12 130H316M12 264H316', axis)
  return picture('The same box in local, world and camera space', 420, [
    rules,
    ...local,
    ...world,
    ...camera,
  ])
}
