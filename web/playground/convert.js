/**
 * Converts a sketch between versions of p5 by changing its source, so that the visible code is the code that runs. WEBGPU needs an
 * awaited canvas, and p5 1.11 waits only for files that `preload` loads.
 */

/** Returns `text` converted for `host`, one of the p5 hosts in hosts.js. */
export function convert(text, host) {
  const converted = host === 'p5-1' ? toPreload(text) : fromPreload(text)
  return host === 'p5-webgpu' ? toWebGPU(converted) : toWebGL(converted)
}

const canvasPattern = (kind) =>
  new RegExp(`(await )?createCanvas\\(([^()]*),\\s*${kind}\\s*\\)`, 'g')

const toWebGPU = (text) =>
  addAsyncIfNeeded(text.replaceAll(canvasPattern('WEBGL'), 'await createCanvas($2, WEBGPU)'))

const toWebGL = (text) =>
  removeUnneededAsync(text.replaceAll(canvasPattern('WEBGPU'), 'createCanvas($2, WEBGL)'))

/** Matches a function, up to the closing brace at the beginning of a line, and captures `async` and the lines of its body. */
const functionPattern = (name) =>
  new RegExp(`^(async )?function ${name}\\(\\) \\{\\n([^]*?)^\\}\\n?`, 'm')

const addAsyncIfNeeded = (text) =>
  text.replace(functionPattern('setup'), (whole, isAsync, lines) =>
    !isAsync && /\bawait\b/.test(lines) ? `async ${whole}` : whole,
  )

const removeUnneededAsync = (text) =>
  text.replace(functionPattern('setup'), (whole, isAsync, lines) =>
    isAsync && !/\bawait\b/.test(lines) ? whole.replace('async ', '') : whole,
  )

const awaitedLoad = /^ *(?:const |let )?(\w+) = await (load\w+\(.*\));?\n/gm

function toPreload(text) {
  const [, , lines] = functionPattern('setup').exec(text) ?? []
  const loads = [...(lines ?? '').matchAll(awaitedLoad)]
  if (!loads.length) return removeUnneededAsync(text)
  // Variables that setup declares become global, since preload and setup both use them now.
  const declared = loads.filter(([line]) => /^ *(const|let) /.test(line)).map(([, name]) => name)
  const rest = text.replace(functionPattern('setup'), (whole) => whole.replaceAll(awaitedLoad, ''))
  const preload = `function preload() {\n${loads.map(([, name, call]) => `  ${name} = ${call}\n`).join('')}}\n\n`
  const head = declared.length ? `let ${declared.join(', ')}\n` : ''
  return removeUnneededAsync(
    rest.replace(/^(async )?function setup/m, (setup) => head + preload + setup),
  )
}

function fromPreload(text) {
  const [whole, , lines] = functionPattern('preload').exec(text) ?? []
  if (!whole) return text
  const loads = lines.replaceAll(/^( *\w+ = )(load\w+\()/gm, '$1await $2')
  const rest = text.replace(new RegExp(functionPattern('preload').source + '\\n?', 'm'), '')
  return addAsyncIfNeeded(
    rest.replace(functionPattern('setup'), (setup) => setup.replace('{\n', `{\n${loads}`)),
  )
}
