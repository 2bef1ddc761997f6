/**
 * Vite plugin: serves the pages of web/site with their style, font and pictures; in development they are generated on request, in a
 * build they are written once. It also compiles the first page's warp, so that the page does not need the compiler.
 */
import { readFile, readdir } from 'node:fs/promises'
import { extname } from 'node:path'
import { fileURLToPath } from 'node:url'
import { pathOf } from './path-of.js'

const root = new URL('../../', import.meta.url)
const read = (path) => readFile(new URL(path, root))

const staticFiles = {
  'site/site.css': 'web/site/site.css',
  'playground/host.html': 'web/playground/frame/host.html',
  'site/hero.webp': 'web/site/hero.webp',
  'site/fredoka.woff2': 'node_modules/@fontsource/fredoka/files/fredoka-latin-600-normal.woff2',
}
const folders = { 'posters/': /\.webp$/, 'docs/': /\.(?:png|svg|webp)$/ }

const types = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
}

/** Imports by a computed address: Vite would bundle a literal import, and with it all of warpjet, into its config. */
const load = (path) => import(new URL(path, root).href)

const sitePages = async () => (await load('web/site/pages.js')).sitePages()

/** Returns the repository path of a file that the site serves unchanged; undefined for others. */
function sourceOf(path) {
  if (path in staticFiles) return staticFiles[path]
  const folder = Object.keys(folders).find((name) => path.startsWith(name))
  return folder && folders[folder].test(path) && !path.includes('..') ? `web/${path}` : undefined
}

/** Returns a file's content. The style sheet includes the palette, which saves a request. */
async function contentOf(path) {
  const content = await read(sourceOf(path))
  if (path !== 'site/site.css') return content
  return Buffer.concat([await read('web/site/palette.css'), content])
}

/** Lists the files that the site serves unchanged. */
async function listUnchanged() {
  const paths = Object.keys(staticFiles)
  for (const [folder, matches] of Object.entries(folders))
    for (const file of await readdir(new URL(`web/${folder}`, root)))
      if (matches.test(file)) paths.push(folder + file)
  return paths
}

async function compileHero() {
  const { compileWarp } = await load('dist/warpjet.js')
  const { hero, names, uniforms } = await load('web/site/hero-warp.js')
  const { code, declarations } = compileWarp(hero, { names, uniforms, surfaceVariation: false })
  return `export default ${JSON.stringify({ code, declarations })}`
}

const heroModule = 'virtual:hero-text'

export function sitePagesPlugin() {
  let pages
  return {
    name: 'site-pages',

    resolveId: (id) => (id === heroModule ? `\0${heroModule}` : undefined),
    load: (id) => (id === `\0${heroModule}` ? compileHero() : undefined),

    configureServer(server) {
      const forget = (file) => {
        if (/[\\/]web[\\/]docs[\\/].*\.md$/.test(file)) pages = undefined
      }
      server.watcher.on('all', (_, file) => forget(file))
      server.middlewares.use(async (request, response, next) => {
        let path = pathOf(request)
        if (path === '' || /^(?:docs|gallery\/[\w-]+)\/$/.test(path)) path += 'index.html'
        try {
          let content
          if (
            /^(?:index\.html|docs\/[\w-]+\.html|gallery\/[\w-]+\/(?:index|full)\.html|site\/search\.json)$/.test(
              path,
            )
          )
            content = (await (pages ??= sitePages())).get(path)
          else if (sourceOf(path)) content = await contentOf(path).catch(() => undefined)
          if (content === undefined) return next()
          response.setHeader('Content-Type', types[extname(path)])
          response.setHeader('Cache-Control', 'no-cache')
          response.end(content)
        } catch (error) {
          pages = undefined
          next(error)
        }
      })
    },

    async generateBundle() {
      // Without this, GitHub Pages would leave out the folder node_modules.
      this.emitFile({ type: 'asset', fileName: '.nojekyll', source: '' })
      for (const [fileName, source] of await sitePages())
        this.emitFile({ type: 'asset', fileName, source })
      for (const fileName of await listUnchanged())
        this.emitFile({ type: 'asset', fileName, source: await contentOf(fileName) })
    },
  }
}

export const siteScripts = Object.fromEntries(
  ['site', 'home', 'example', 'full'].map((name) => [
    `site/${name}`,
    fileURLToPath(new URL(`../site/${name}.js`, import.meta.url)),
  ]),
)
