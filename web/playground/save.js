/** Exports a sketch: a self-contained page, a page for the p5 editor, or an npm project. */
import { devDependencies, version } from '../../package.json'
import { escapeForScript, pageOf, tag, writeJsonForScript } from './document.js'
import { hosts, isThree, tagsOf, toCDNAddress, toModulePath } from './hosts.js'
import { modulesAsData } from './modules.js'
import { readText } from './parts.js'
import { siteFile } from './site-files.js'
import { namesOfFiles, replaceFileNames } from './strings.js'
import { zip } from './zip.js'

const versions = {
  ...devDependencies,
  warpjet: version,
  'p5-v1': devDependencies['p5-v1'].replace(/^.*@/, ''),
}

const inlineScript = (text) =>
  `<script>\n${escapeForScript(text.replace(/^\/\/# sourceMappingURL.*$/m, ''))}\n</script>`

/** Finds the files that a sketch names. Returns [[name, Blob]]. Names without a file are skipped: the sketch may only write these files. */
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
export async function writePage(sketch, dropped = new Map()) {
  const files = await Promise.all(
    (await filesOf(sketch, dropped)).map(async ([name, blob]) => [name, await dataOf(blob)]),
  )
  const isModule = isThree(sketch.host)
  const fileScripts = files.length && [
    `<script>\nwindow.sketchFiles = ${writeJsonForScript(Object.fromEntries(files))}\n</script>`,
    inlineScript(await readText('../dist/files.js')),
  ]
  const body = escapeForScript(sketch.text, { isModule })
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: fileScripts ? fileScripts.join('\n    ') : '',
    tags: await Promise.all(tagsOf(sketch).map(async (path) => inlineScript(await readText(path)))),
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

/** Makes Vite serve scripts unchanged: it would convert them to modules, which define no globals. */
const viteConfig = `// Serves the scripts of index.html from node_modules, unchanged.
export default { publicDir: 'node_modules' }
`

/** Returns whether a name has no folder, so that the file can be next to the sketch. */
const isPlain = (name) => !/[/\\:]/.test(name)

/** Writes a zip of an npm project: `npm i`, then `npm start`. @param dropped maps name → file */
export async function writeProject(sketch, dropped = new Map()) {
  const kind = isThree(sketch.host) ? 'type="module" ' : ''
  const page = pageOf(sketch, {
    title: 'Made with warpjet',
    tags: tagsOf(sketch).map((path) => tag(toModulePath(path))),
    // Vite resolves the sketch's imports.
    modules: {},
    sketch: `<script ${kind}src="sketch.js"></script>`,
  })
  const projectFiles = {
    'package.json': `${JSON.stringify(packageOf(sketch), null, 2)}\n`,
    ...(!isThree(sketch.host) && { 'vite.config.js': viteConfig }),
    'index.html': page,
    'sketch.js': sketch.text,
  }
  const files = await Promise.all(
    (await filesOf(sketch, dropped))
      .filter(([name]) => isPlain(name))
      .map(async ([name, blob]) => {
        // Vite's build copies the files in `public`.
        const place = isThree(sketch.host) ? `public/${name}` : name
        if (Object.hasOwn(projectFiles, place))
          throw new Error(`The project already contains ${name}: give your file another name.`)
        return [place, new Uint8Array(await blob.arrayBuffer())]
      }),
  )
  return zip({ ...projectFiles, ...Object.fromEntries(files) })
}

/** Escapes text for an HTML comment. */
const escapeForComment = (text) => text.replaceAll('--', '- -').replaceAll(/[<>]/g, '')

/** Writes a page that loads its scripts from a CDN, for index.html of the p5 editor or anywhere else. */
export function writePageWithTags(sketch) {
  const isModule = isThree(sketch.host)
  const { modules = {} } = hosts[sketch.host]
  const localFiles = namesOfFiles(sketch.text).filter(isPlain)
  const text = replaceFileNames(sketch.text, (name) => toCDNAddress(name, versions))
  return pageOf(sketch, {
    title: 'Made with warpjet',
    before: localFiles.length
      ? `<!-- Upload beside this page: ${escapeForComment(localFiles.join(', '))} -->`
      : '',
    tags: tagsOf(sketch).map((path) => tag(toCDNAddress(path, versions))),
    modules: Object.fromEntries(
      Object.entries(modules).map(([name, path]) => [name, toCDNAddress(path, versions)]),
    ),
    sketch: `<script${isModule ? ' type="module"' : ''}>\n${escapeForScript(text, { isModule })}\n</script>`,
  })
}

export function download(blob, name) {
  const href = URL.createObjectURL(blob)
  Object.assign(document.createElement('a'), { href, download: name }).click()
  setTimeout(() => URL.revokeObjectURL(href), 60_000)
}
