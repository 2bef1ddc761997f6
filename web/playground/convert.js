/**
 * Converts a sketch between versions of p5 by changing its source, so that the visible code is the code that runs. WEBGPU needs an
 * awaited canvas, and p5 1.11 waits only for files that `preload` loads.
 */

/** Returns `text` converted for `host`, one of the p5 hosts in hosts.js. */
export function converted(text, host) {
  const plain = host === 'p5-1' ? toPreload(text) : fromPreload(text)
  return host === 'p5-webgpu' ? toWebGPU(plain) : toWebGL(plain)
}

const canvas = (kind) => new RegExp(`(await )?createCanvas\\(([^()]*),\\s*${kind}\\s*\\)`, 'g')

const toWebGPU = (text) =>
  asyncSetup(text.replaceAll(canvas('WEBGL'), 'await createCanvas($2, WEBGPU)'))

const toWebGL = (text) => plainSetup(text.replaceAll(canvas('WEBGPU'), 'createCanvas($2, WEBGL)'))

/** Matches a function and captures its lines, from its head to the closing brace at the beginning of a line. */
const body = (name) => new RegExp(`^(async )?function ${name}\\(\\) \\{\\n([^]*?)^\\}\\n?`, 'm')

const asyncSetup = (text) =>
  text.replace(body('setup'), (whole, isAsync, lines) =>
    !isAsync && /\bawait\b/.test(lines) ? `async ${whole}` : whole,
  )

const plainSetup = (text) =>
  text.replace(body('setup'), (whole, isAsync, lines) =>
    isAsync && !/\bawait\b/.test(lines) ? whole.replace('async ', '') : whole,
  )

const awaited = /^ *(?:const |let )?(\w+) = await (load\w+\(.*\));?\n/gm

function toPreload(text) {
  const [, , lines] = body('setup').exec(text) ?? []
  const loads = [...(lines ?? '').matchAll(awaited)]
  if (!loads.length) return plainSetup(text)
  // Variables that setup declares become global, since both functions use them now.
  const declared = loads.filter(([line]) => /^ *(const|let) /.test(line)).map(([, name]) => name)
  const rest = text.replace(body('setup'), (whole) => whole.replaceAll(awaited, ''))
  const preload = `function preload() {\n${loads.map(([, name, call]) => `  ${name} = ${call}\n`).join('')}}\n\n`
  const head = declared.length ? `let ${declared.join(', ')}\n` : ''
  return plainSetup(rest.replace(/^(async )?function setup/m, (setup) => head + preload + setup))
}

function fromPreload(text) {
  const [whole, , lines] = body('preload').exec(text) ?? []
  if (!whole) return text
  const loads = lines.replaceAll(/^( *\w+ = )(load\w+\()/gm, '$1await $2')
  const rest = text.replace(new RegExp(body('preload').source + '\\n?', 'm'), '')
  return asyncSetup(rest.replace(body('setup'), (setup) => setup.replace('{\n', `{\n${loads}`)))
}
