/** Assembles the scripts, modules and files that a sketch's frame runs, as blobs. */
import { guardLoops } from './guard.js'
import { hosts, isThree, tagsOf } from './hosts.js'
import { moduleTexts } from './modules.js'
import { remember } from './remember.js'
import { folder, siteFile } from './site-files.js'
import { namesOfFiles } from './strings.js'

const frameScripts = (names) => names.map((name) => `../dist/${name}.js`)

/** Maps imports of warpjet to modules of the frame, which record each warp. */
const watchWarps = (modules) => ({
  ...modules,
  'warpjet/itself': modules.warpjet,
  'warpjet/three/itself': modules['warpjet/three'],
  warpjet: '../dist/warpjet.js',
  'warpjet/three': '../dist/three.js',
})

const mesh = '../../dist/mesh.min.js'
/** Matches the functions for which p5.warpjet.min.js imports mesh.min.js, which is next to it. */
const needsMesh = /\b(?:loadWarpModel|subdivide|addSurfaceVariation)\b/

export const readText = remember(async (path) => {
  const response = await fetch(new URL(path, folder))
  if (!response.ok) throw new Error(`Cannot load ${path}: check the connection and reload.`)
  return response.text()
})

/** Makes a blob of a script. Errors name the site's file instead of the blob, so that warpjet can tell its own lines from the sketch's. */
const makeScriptBlob = (text, href) =>
  new Blob([text.replace(/^\/\/# sourceMappingURL=.*$/m, ''), `\n//# sourceURL=${href}\n`], {
    type: 'text/javascript',
  })

const loadScript = remember(async (path) => {
  const { href } = new URL(path, folder)
  return { href, blob: makeScriptBlob(await readText(path), href) }
})

/** Makes a blob of each module that `text` imports, keyed by the name that other modules import it by. */
const makeModuleBlobs = remember(async (_, text, modules) => {
  const texts = await moduleTexts(text, modules, readText)
  return Object.fromEntries(
    Object.entries(texts).map(([name, { path, text }]) => [
      name,
      makeScriptBlob(text, new URL(path, folder).href),
    ]),
  )
})

/** Returns a key for `makeModuleBlobs`: the import statements of a text. */
const importStatements = (text) =>
  (text.match(/\b(?:from|import)\s*\(?\s*["'][^"'\n]+["']/g) ?? []).join()

async function importsOf({ host, text }) {
  if (isThree(host))
    return makeModuleBlobs(importStatements(text), text, watchWarps(hosts[host].modules))
  if (!needsMesh.test(text)) return {}
  const { href, blob } = await loadScript(mesh)
  return { [href]: blob }
}

/** @param dropped maps name → file @returns { scripts, imports, files, sketch } for boot.js */
export async function partsOf(sketch, dropped) {
  const { host, text } = sketch
  const isModule = isThree(host)
  const paths = [
    ...frameScripts(['start', 'files']),
    ...tagsOf(sketch),
    ...frameScripts(isModule ? ['clock', 'record'] : ['clock', 'record', 'warps']),
  ]
  const siteNames = namesOfFiles(text).filter((name) => !dropped.has(name))
  const [scripts, imports, found] = await Promise.all([
    Promise.all(paths.map((path) => loadScript(path))),
    importsOf(sketch),
    Promise.all(siteNames.map(async (name) => [name, await siteFile(name).catch(() => undefined)])),
  ])
  return {
    scripts,
    imports,
    files: Object.fromEntries([...dropped, ...found.filter(([, blob]) => blob)]),
    sketch: { blob: new Blob([guardLoops(sketch)], { type: 'text/javascript' }), isModule },
  }
}
