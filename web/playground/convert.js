/**
 * A sketch of p5 for another p5, in its own text, so that what one sees is what runs there: WEBGPU wants a canvas that is
 * awaited, and p5 1.11 waits for what `preload` loads and for nothing else.
 */

/** `text` for `host`, one of hosts.js that runs p5. */
export function converted(text, host) {
  const plain = host === 'p5-1' ? toPreload(text) : fromPreload(text)
  return host === 'p5-webgpu' ? toWebGPU(plain) : toWebGL(plain)
}

const canvas = (kind) => new RegExp(`(await )?createCanvas\\(([^()]*),\\s*${kind}\\s*\\)`, 'g')

const toWebGPU = (text) =>
  asyncSetup(text.replaceAll(canvas('WEBGL'), 'await createCanvas($2, WEBGPU)'))

const toWebGL = (text) => plainSetup(text.replaceAll(canvas('WEBGPU'), 'createCanvas($2, WEBGL)'))

/** The function's lines, between its head and the brace that ends it at the beginning of a line. */
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
  // What setup declared for itself is a variable of both functions now.
  const declared = loads.filter(([line]) => /^ *(const|let) /.test(line)).map(([, name]) => name)
  const kept = text.replace(body('setup'), (whole) => whole.replaceAll(awaited, ''))
  const preload = `function preload() {\n${loads.map(([, name, call]) => `  ${name} = ${call}\n`).join('')}}\n\n`
  const head = declared.length ? `let ${declared.join(', ')}\n` : ''
  return plainSetup(kept.replace(/^(async )?function setup/m, (setup) => head + preload + setup))
}

function fromPreload(text) {
  const [whole, , lines] = body('preload').exec(text) ?? []
  if (!whole) return text
  const loads = lines.replaceAll(/^( *\w+ = )(load\w+\()/gm, '$1await $2')
  const rest = text.replace(new RegExp(body('preload').source + '\\n?', 'm'), '')
  return asyncSetup(rest.replace(body('setup'), (setup) => setup.replace('{\n', `{\n${loads}`)))
}
