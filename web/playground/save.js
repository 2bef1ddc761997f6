/** What one takes away: a page that stands alone, a page for the p5 editor, a picture. */
import { devDependencies, version } from '../../package.json'
import { insideScript, pageOf, tag } from './document.js'
import { atCDN, hosts, inModules, isThree, tagsOf } from './hosts.js'
import { modulesAsData } from './modules.js'
import { zip } from './zip.js'

const folder = new URL('files/', location.href)
const versions = {
  ...devDependencies,
  warpjet: version,
  'p5-v1': devDependencies['p5-v1'].replace(/^.*@/, ''),
}

/** Files that a sketch names. */
const named =
  /(['"`])([^'"`\n]+\.(?:obj|stl|glb|gltf|woff2?|[to]tf|png|jpe?g|webp|glsl|vert|frag|json|csv|txt))\1/g
export const filesIn = (text) => [...new Set([...text.matchAll(named)].map(([, , name]) => name))]

const inline = (text) =>
  `<script>\n${insideScript(text.replace(/^\/\/# sourceMappingURL.*$/m, ''))}\n</script>`

async function read(path) {
  const response = await fetch(new URL(path, folder))
  if (!response.ok)
    throw new Error(`The file ${path} is not there: the sketch cannot be saved with it.`)
  return response
}
const textAt = async (path) => (await read(path)).text()

async function dataOf(name, dropped) {
  const response = dropped[name] ? await fetch(dropped[name]) : await read(name)
  const bytes = new Uint8Array(await response.arrayBuffer())
  let text = ''
  for (const byte of bytes) text += String.fromCharCode(byte)
  const [type] = (response.headers.get('content-type') || 'application/octet-stream').split(';')
  return `data:${type};base64,${btoa(text)}`
}

/** A page with all that it needs in it, which opens from a disk. `dropped` are files by name. */
export async function pageAlone(sketch, dropped = {}) {
  const files = await Promise.all(
    filesIn(sketch.text).map(async (name) => [name, await dataOf(name, dropped)]),
  )
  const isModule = isThree(sketch.host)
  const shim = files.length && [
    inline(`window.sketchFiles = ${JSON.stringify(Object.fromEntries(files))}`),
    inline(await textAt('../dist/files.js')),
  ]
  const body = insideScript(sketch.text)
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: shim ? shim.join('\n    ') : '',
    tags: await Promise.all(tagsOf(sketch).map(async (path) => inline(await textAt(path)))),
    modules: isModule && (await modulesAsData(sketch.text, hosts[sketch.host].modules, textAt)),
    sketch: `<script${isModule ? ' type="module"' : ''}>\n${body}\n</script>`,
  })
}

const packageOf = ({ host }) => ({
  name: 'warp',
  private: true,
  type: 'module',
  // Scripts that are tags, as p5 wants them, are for no bundler.
  scripts: isThree(host) ? { start: 'vite', build: 'vite build' } : { start: 'vite' },
  dependencies: isThree(host)
    ? { three: versions.three, warpjet: version }
    : { p5: host === 'p5-1' ? versions['p5-v1'] : versions.p5, warpjet: version },
  devDependencies: { vite: versions.vite },
})

/** For tags of scripts: Vite would make modules of them, which have no globals. */
const configOfTags = `// The scripts that index.html names are served from there as they are.
export default { publicDir: 'node_modules' }
`

/** A project of npm, packed: `npm i`, then `npm start`. `dropped` are files by name. */
export async function project(sketch, dropped = {}) {
  const kind = isThree(sketch.host) ? 'type="module" ' : ''
  const page = pageOf(sketch, {
    title: 'Made with warpjet',
    tags: tagsOf(sketch).map((path) => tag(inModules(path))),
    // Vite finds what the sketch imports.
    modules: {},
    sketch: `<script ${kind}src="sketch.js"></script>`,
  })
  const files = await Promise.all(
    filesIn(sketch.text)
      .filter((name) => !name.includes('/'))
      .map(async (name) => {
        const response = dropped[name] ? await fetch(dropped[name]) : await read(name)
        // What lies in `public` is built, too.
        const place = isThree(sketch.host) ? `public/${name}` : name
        return [place, new Uint8Array(await response.arrayBuffer())]
      }),
  )
  return zip({
    'package.json': `${JSON.stringify(packageOf(sketch), null, 2)}\n`,
    ...(!isThree(sketch.host) && { 'vite.config.js': configOfTags }),
    'index.html': page,
    'sketch.js': sketch.text,
    ...Object.fromEntries(files),
  })
}

/** A page whose scripts come from a CDN, for index.html of the p5 editor or anywhere else. */
export function pageWithTags(sketch) {
  const isModule = isThree(sketch.host)
  const { modules = {} } = hosts[sketch.host]
  const atHome = filesIn(sketch.text).filter((name) => !name.includes('/'))
  const text = sketch.text.replaceAll(
    named,
    (whole, quote, name) => quote + atCDN(name, versions) + quote,
  )
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: atHome.length ? `<!-- Upload beside this page: ${atHome.join(', ')} -->` : '',
    tags: tagsOf(sketch).map((path) => tag(atCDN(path, versions))),
    modules: Object.fromEntries(
      Object.entries(modules).map(([name, path]) => [name, atCDN(path, versions)]),
    ),
    sketch: `<script${isModule ? ' type="module"' : ''}>\n${insideScript(text)}\n</script>`,
  })
}

export function download(blob, name) {
  const href = URL.createObjectURL(blob)
  Object.assign(document.createElement('a'), { href, download: name }).click()
  setTimeout(() => URL.revokeObjectURL(href), 60_000)
}
