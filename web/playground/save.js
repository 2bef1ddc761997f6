/** Exports a sketch: a self-contained page, a page for the p5 editor, or an npm project. */
import { devDependencies, version } from '../../package.json'
import { escapeForScript, pageOf, tag, writeJsonForScript } from './document.js'
import { atCDN, hosts, inModules, isThree, tagsOf } from './hosts.js'
import { modulesAsData } from './modules.js'
import { readText } from './parts.js'
import { siteFile } from './site-files.js'
import { namesOfFiles, withFiles } from './strings.js'
import { zip } from './zip.js'

const versions = {
  ...devDependencies,
  warpjet: version,
  'p5-v1': devDependencies['p5-v1'].replace(/^.*@/, ''),
}

const inline = (text) =>
  `<script>\n${escapeForScript(text.replace(/^\/\/# sourceMappingURL.*$/m, ''))}\n</script>`

/** Finds the files that a sketch names → [[name, Blob]]. Names without a file are skipped: the sketch may save to them. */
async function filesOf({ text }, dropped) {
  const files = await Promise.all(
    namesOfFiles(text).map(async (name) => [name, dropped.get(name) ?? (await siteFile(name))]),
  )
  return files.filter(([, blob]) => blob)
}

async function dataOf(blob) {
  const bytes = new Uint8Array(await blob.arrayBuffer())
  let text = ''
  for (const byte of bytes) text += String.fromCharCode(byte)
  const [type] = (blob.type || 'application/octet-stream').split(';')
  return `data:${type};base64,${btoa(text)}`
}

/** Writes a self-contained page that opens from disk. @param dropped maps name → file */
export async function pageAlone(sketch, dropped = new Map()) {
  const files = await Promise.all(
    (await filesOf(sketch, dropped)).map(async ([name, blob]) => [name, await dataOf(blob)]),
  )
  const isModule = isThree(sketch.host)
  const shim = files.length && [
    `<script>\nwindow.sketchFiles = ${writeJsonForScript(Object.fromEntries(files))}\n</script>`,
    inline(await readText('../dist/files.js')),
  ]
  const body = escapeForScript(sketch.text, { isModule })
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: shim ? shim.join('\n    ') : '',
    tags: await Promise.all(tagsOf(sketch).map(async (path) => inline(await readText(path)))),
    modules: isModule && (await modulesAsData(sketch.text, hosts[sketch.host].modules, readText)),
    sketch: `<script${isModule ? ' type="module"' : ''}>\n${body}\n</script>`,
  })
}

const packageOf = ({ host }) => ({
  name: 'warp',
  private: true,
  type: 'module',
  // A p5 page uses classic script tags, which a bundler cannot build.
  scripts: isThree(host) ? { start: 'vite', build: 'vite build' } : { start: 'vite' },
  dependencies: isThree(host)
    ? { three: versions.three, warpjet: version }
    : { p5: host === 'p5-1' ? versions['p5-v1'] : versions.p5, warpjet: version },
  devDependencies: { vite: versions.vite },
})

/** Serves script tags unchanged: Vite would convert them to modules, which define no globals. */
const configOfTags = `// Serves the scripts of index.html from there unchanged.
export default { publicDir: 'node_modules' }
`

/** Returns true if a file of that name can be in the sketch's own folder. */
const isPlain = (name) => !/[/\\:]/.test(name)

/** Writes a zip of an npm project: `npm i`, then `npm start`. @param dropped maps name → file */
export async function project(sketch, dropped = new Map()) {
  const kind = isThree(sketch.host) ? 'type="module" ' : ''
  const page = pageOf(sketch, {
    title: 'Made with warpjet',
    tags: tagsOf(sketch).map((path) => tag(inModules(path))),
    // Vite resolves the sketch's imports.
    modules: {},
    sketch: `<script ${kind}src="sketch.js"></script>`,
  })
  const own = {
    'package.json': `${JSON.stringify(packageOf(sketch), null, 2)}\n`,
    ...(!isThree(sketch.host) && { 'vite.config.js': configOfTags }),
    'index.html': page,
    'sketch.js': sketch.text,
  }
  const files = await Promise.all(
    (await filesOf(sketch, dropped))
      .filter(([name]) => isPlain(name))
      .map(async ([name, blob]) => {
        // Vite's build copies the files in `public`.
        const place = isThree(sketch.host) ? `public/${name}` : name
        if (Object.hasOwn(own, place))
          throw new Error(`The project already contains ${name}: give your file another name.`)
        return [place, new Uint8Array(await blob.arrayBuffer())]
      }),
  )
  return zip({ ...own, ...Object.fromEntries(files) })
}

/** Escapes text for an HTML comment. */
const insideComment = (text) => text.replaceAll('--', '- -').replaceAll(/[<>]/g, '')

/** Writes a page that loads its scripts from a CDN, for index.html of the p5 editor or anywhere else. */
export function pageWithTags(sketch) {
  const isModule = isThree(sketch.host)
  const { modules = {} } = hosts[sketch.host]
  const atHome = namesOfFiles(sketch.text).filter(isPlain)
  const text = withFiles(sketch.text, (name) => atCDN(name, versions))
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: atHome.length
      ? `<!-- Upload beside this page: ${insideComment(atHome.join(', '))} -->`
      : '',
    tags: tagsOf(sketch).map((path) => tag(atCDN(path, versions))),
    modules: Object.fromEntries(
      Object.entries(modules).map(([name, path]) => [name, atCDN(path, versions)]),
    ),
    sketch: `<script${isModule ? ' type="module"' : ''}>\n${escapeForScript(text, { isModule })}\n</script>`,
  })
}

export function download(blob, name) {
  const href = URL.createObjectURL(blob)
  Object.assign(document.createElement('a'), { href, download: name }).click()
  setTimeout(() => URL.revokeObjectURL(href), 60_000)
}
