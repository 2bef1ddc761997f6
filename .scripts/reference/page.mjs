// web/docs/operations.md: what there is for an offset, a table a group.
import { Stop } from '../lib/terminal.mjs'

/** The text of the page, not yet formatted. */
export function pageText({ operations, aliases, others, headings }) {
  const text = page(
    headings.map((heading) =>
      group(
        heading,
        operations.filter((operation) => operation.heading === heading),
      ),
    ),
    aliases,
  )
  const missing = others.filter(({ name }) => !text.includes(`${name}(`))
  if (missing.length)
    throw new Stop(`.scripts/reference/page.mjs lacks ${missing.map(({ name }) => name)}.`)
  return text
}

function group(heading, operations) {
  const isByComponent = ({ kinds }) => kinds.every((kind) => kind === 'number or vector')
  const columns = [
    ['function', (operation) => code(functionForm(operation))],
    ['method', (operation) => code(methodForm(operation))],
    ['what it is', ({ meaning }) => meaning],
  ]
  if (!operations.every(isByComponent)) columns.push(['takes → gives', types])
  if (operations.some(({ missingIn }) => missingIn.length))
    columns.push(['lowered in', ({ missingIn }) => languages(missingIn)])
  return `## ${heading}\n\n${table(columns, operations)}\n${notes[heading] ?? ''}`
}

const table = (columns, rows) =>
  [
    columns.map(([head]) => head),
    columns.map(() => '---'),
    ...rows.map((row) => columns.map(([, cell]) => cell(row).replaceAll('|', '\\|'))),
  ]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n')

const code = (text) => `\`${text}\``
const more = ({ isChained }) => (isChained ? ', …' : '')

function functionForm(operation) {
  return `glsl.${operation.name}(${operation.operands.join(', ')}${more(operation)})`
}

function methodForm(operation) {
  const [receiver, ...others] = operation.operands
  return `${receiver}.${operation.name}(${others.join(', ')}${more(operation)})`
}

function types({ kinds, result }) {
  return `${kinds.join(', ')} → ${result}`
}

const languages = (names) => (names.length === 3 ? 'all' : names.map(code).join(', '))

/** What is to be said below a table. */
const notes = {
  Conditions: `
A condition is 1 or 0 where it is used as a number.
`,
  Matrices: `
Matrices also have \`neg\`, \`add\`, \`sub\`, \`mix\`, \`mult\`, and \`div\` by a number. \`m.mult(v)\` is a matrix times a column,
\`v.mult(m)\` a row times a matrix.
`,
  Derivatives: `
An input is what the shader gives, such as \`millis\`, \`position.x()\` or \`glsl.param('speed')\`, and nothing computed.
Derivatives may be derived again: \`height.derivative(millis).derivative(millis)\` is an acceleration.
`,
}

const page = (
  groups,
  aliases,
) => `<!-- Written by \`npm run reference\`; the tables come from src/ops/documentation.hpp and src/builder/compositions.hpp. -->

# Operations

Every operation is a function of the builder, \`glsl.pow(x, 2)\`, and a method of what it takes first, \`x.pow(2)\`. It takes
numbers of JavaScript and expressions alike. Angles are in radians.

If a table does not say what an operation takes, it takes numbers and vectors and goes by component: vectors have one size,
and a number beside a vector counts for each component. Where dots stand, any number of operands may follow.

Everything works in \`glsl300\`, \`glsl100\` and \`wgsl\`. Where a language lacks an operation, or gets it wrong for large numbers,
it is _lowered_: written with others. [How exact each is](derivatives.md) was measured.

Formulas, derivatives and plots have pages of their own: [of numbers](plots.md), and [of vectors, matrices and noise](plots-vectors.md).

## Numbers, vectors and matrices

| function | what it is |
| --- | --- |
| \`glsl.val(2)\` | A number as an expression. |
| \`glsl.param('speed')\`, \`glsl.vec2Param(name)\` … \`vec4Param(name)\`, \`mat2Param(name)\` … \`mat4Param(name)\` | A variable of the shader, or any expression that reads one there. |
| \`glsl.vec2(x, y)\`, \`glsl.vec3(x, y, z)\`, \`glsl.vec4(x, y, z, w)\` | A vector of numbers and smaller vectors, such as \`glsl.vec3(uv, 0)\`. One number fills all components. |
| \`v.x()\`, \`v.zy()\`, \`color.rgb()\`, \`v.xxx()\` | One to four components of a vector, in any order, repeats too; letters of \`xyzw\`, \`rgba\`, \`stpq\` or \`uv\`. |
| \`glsl.mat2(a, b)\`, \`glsl.mat3(a, b, c)\`, \`glsl.mat4(a, b, c, d)\` | A matrix of columns; of as many numbers, down the columns; of one number for the diagonal; or of a matrix of another size. |
| \`glsl.mat2Rows(a, b)\`, \`glsl.mat3Rows(a, b, c)\`, \`glsl.mat4Rows(a, b, c, d)\` | A matrix of rows, or of numbers along the rows. |
| \`m.column(0)\`, \`m.row(0)\` | A column or row of a matrix as a vector, by its number from 0. |

${groups.join('\n')}
## Other names

From glsl-autodiff: ${sentence(aliases)}.

## Loops

\`glsl.repeat(count, start, (state, i) => next)\` is a loop of the shader. The function is called once, with expressions of the
state and of the step's number from 0 on, and returns the next state; a state is a number, a vector, or an object of them.

<!-- run inside glsl.vec3(z.mult(0.1), 0) -->
\`\`\`js
const { z } = glsl.repeat(8, { z: position.xy(), size: 1 }, ({ z, size }, i) => ({
  z: z.yx().mult(1.7).add(i).sin().mult(size),
  size: size.mult(0.8),
}))
\`\`\`

JavaScript's own loops work too: they write their body into the shader as often as they run. Take those for a few steps, or
where steps differ. Take \`repeat\` where many steps are alike: the text stays short, and the shader starts sooner. Derivatives
run in the same loop as the value. \`count\` is a number of JavaScript, up to 10,000, those of repeats within each other
multiplied; where only the shader knows when to stop, give the most there can be and keep the state by \`ifElse\`. A derivative
of the state can be taken of what \`repeat\` gives, not inside its function.

## Your own functions

<!-- run inside bump(position).mult(0.2) -->
\`\`\`js
const bump = glsl.fn({
  name: 'bump',
  source: 'float bump(float x) { return exp(-x * x); }',
  arity: 1,
  derivatives: [(x) => x.mult(-2).mult(bump(x))],
})
bump(position) // by component, as built-in functions go
\`\`\`

\`source\` is in the language of the shader, from floats to a float; \`{ glsl, wgsl }\` holds both. \`arity\` says how many floats
it takes, 1 to 16. \`derivatives\` has one entry for each: a number, an expression, or a function of all arguments. It can be left
out if nothing is derived; a warp's normal needs it.

## Images

\`glsl.texture(image, uv, { filter, wrap })\` is the colour of an image at \`uv\`, a vec4: (0, 0) is its top left corner and (1, 1) its
bottom right one. \`image\` is one of the option \`uniforms\`, or the name of the shader's \`sampler2D\`. It may displace a surface, by
\`glsl.texture(uniforms.heights, position.xy().add(0.5)).r()\`, and its derivatives are exactly those of what it gives, since it reads
texels and mixes them itself.

| filter | between the texels |
| ------ | ------------------ |
| \`'bilinear'\` | the mix of four; its slope, and so light, jumps at every row and column of texels |
| \`'bicubic'\` | a smooth curve through the texels (Keys, 1981: Catmull-Rom), a little beyond them beside edges |
| \`'bspline'\` | a cubic B-spline, smooth up to its second derivatives, which blurs the image by about a texel; best for heights |
| \`'nearest'\` | the texel itself, for images that hold data; its derivative is 0 |

Beyond 0 and 1, \`wrap\` is \`'clamp'\` (the colour of the edge), \`'repeat'\`, \`'mirror'\`, or \`'sampler'\`: what your own shader's sampler
does, in GLSL; in WGSL, where an image has none, it clamps.

If you leave them out, both are what the host draws with, for an image among the \`uniforms\` of \`createWarp\`, \`warp\` and \`BabylonWarp\`: p5's \`textureWrap\`,
\`wrapS\`, \`wrapT\` and \`magFilter\` of a texture of three.js, \`wrapU\`, \`wrapV\` and the sampling mode of one of Babylon.js, read anew for every
frame. Such a texture's \`offset\`, \`repeat\` and \`rotation\`, or its matrix, move \`uv\` first; \`transform: false\` leaves \`uv\` as it is. Everywhere
else the defaults are \`'bilinear'\` and \`'clamp'\`. \`texture()\` in GLSL that warpjet reads wraps as the host's sampler does, and never moves \`uv\`.

A transparent image's colours are as the host keeps them:
p5 multiplies them by alpha. WebGL 1 must be told the size: \`uniform vec2 heightsSize\` beside \`uniform sampler2D heights\`.
The CPU cannot read images.

## At kinks and edges

Where a function has no derivative, it still gets one that lighting can live with.

| where | derivative |
| --- | --- |
| \`abs(x)\` | sign(x), so 0 at 0 |
| \`floor\`, \`ceil\`, \`round\`, \`trunc\`, \`sign\`, \`step\`, comparisons | 0 everywhere |
| \`fract(x)\` | 1 everywhere |
| \`mod(x, divisor)\` | 1 by \`x\`, -floor(x / divisor) by \`divisor\` |
| \`min\`, \`max\`, \`clamp\`, \`ifElse\` | that of the operand whose value is taken, bounds included; \`min\` and \`max\` take the first of equal ones |
| \`length\`, \`dist\`, \`distance\`, \`normalize\` of zero | 0 |
| \`sqrt(0)\`, \`pow(0, exponent)\` unless it is a product | 0 |
| \`asin\` and \`acos\` of 1 and -1, \`acosh(1)\`, \`atan(0, 0)\` | 0 |
| \`log(0)\`, \`inversesqrt(0)\`, \`atanh(1)\`, \`1 / 0\` | infinite, as the value is |
| \`1 / x\`, \`exp(-x)\`, \`atan(x)\`, \`tanh(x)\` and the like, where \`x\` is infinite | 0 |
| \`atan(y / x)\` where \`x\` is 0 | that of \`atan(y, x)\` |

Values follow GLSL, and where it leaves them open: a half rounds to the even neighbour, \`normalize\` of zero is zero, and
\`clamp(x, low, high)\` is \`min(max(x, low), high)\` even where \`low\` is above \`high\`. Constants keep all their digits, but
what jumps, such as a comparison or \`floor\`, sees them as the shader does, in float32: 0.1 + 0.2 equals 0.3.
`

/** `a` and `b` are `c`, `d` is `e`, … */
function sentence(aliases) {
  const originals = [...new Set(aliases.map(({ of }) => of))]
  const texts = originals.map((original) => {
    const names = aliases.filter(({ of }) => of === original).map(({ name }) => code(name))
    return `${names.join(' and ')} ${names.length > 1 ? 'are' : 'is'} ${code(original)}`
  })
  return texts.join(', ')
}
