/**
 * Vite plugin: serves the files that the examples load, at the paths that they name. In development each file is generated on
 * request, in a build each is written once. The sketches are served unchanged, so that the gallery shows exactly what a user copies;
 * a content security policy is added to their pages.
 */
import { readFile, readdir } from 'node:fs/promises'
import { extname } from 'node:path'
import { models, toOBJ } from '../models/index.js'
import { withPolicy } from '../site/policy.js'
import { importsOf } from './imports-of.js'
import { pathOf } from './path-of.js'

const root = new URL('../../', import.meta.url)
const read = (path) => readFile(new URL(path, root))

const libraries = [
  'dist/p5.warpjet.min.js',
  'dist/warpjet.deformers.min.js',
  'dist/warpjet.glsl.min.js',
  'dist/warpjet.operators.min.js',
  // p5.warpjet imports this from its own folder if a sketch needs meshes.
  'dist/mesh.min.js',
  'node_modules/p5/lib/p5.min.js',
  'node_modules/p5/lib/p5.webgpu.min.js',
  'node_modules/p5-v1/lib/p5.min.js',
  ...['three.module.js', 'three.core.js', 'three.webgpu.js', 'three.tsl.js'].map(
    (name) => `node_modules/three/build/${name}`,
  ),
  ...[
    'controls/OrbitControls.js',
    'environments/RoomEnvironment.js',
    'libs/lil-gui.module.min.js',
    'libs/stats.module.js',
    'utils/BufferGeometryUtils.js',
  ].map((name) => `node_modules/three/examples/jsm/${name}`),
  'node_modules/glsl-noise/simplex/3d.glsl',
]
/** The modules in the import maps of three.js examples. */
const modules = ['three', 'three.webgpu', 'warpjet', 'mesh', 'deformers', 'glsl'].map(
  (name) => `dist/${name}.js`,
)
const isShared = (path) => /^dist\/shared\/[\w-]+\.js$/.test(path)
const fonts = {
  'fredoka.woff': 'node_modules/@fontsource/fredoka/files/fredoka-latin-700-normal.woff',
}
const recorders = ['recorder.js', 'three-recorder.js']
/** Scripts of the playground's frame. They are served from a folder `dist`, which warpjet skips when it looks up the caller's line. */
const frameScripts = Object.fromEntries(
  ['start', 'files', 'clock', 'record', 'warps', 'warpjet', 'three'].map((name) => [
    `playground/dist/${name}.js`,
    `web/playground/frame/${name}.js`,
  ]),
)
/** Matches files in an example's folder, and files that any sketch in the playground can load. */
const loadable = /^(?:examples\/([\w-]+)|playground\/files)\/([\w.-]*)$/

const types = {
  '.html': 'text/html; charset=utf-8',
  '.glsl': 'text/plain; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.obj': 'text/plain; charset=utf-8',
  '.woff': 'font/woff',
}

const objs = new Map()

function makeOBJ(name) {
  if (!objs.has(name)) objs.set(name, toOBJ(models[name](), name))
  return objs.get(name)
}

/** Returns a tag that runs the sketch, or a changed sketch if the page around the frame has set one. */
const sketchTag = (kind) =>
  `<script>document.write('<script${kind} src="' + (window.frameElement?.sketch ?? 'sketch.js') + '"></' + 'script>')</script>`

/** Returns the example's page, with the recorder, for the frame in the gallery. */
const framedPage = (html) =>
  html
    .replace(
      '<script src="sketch.js"></script>',
      `<script src="../../recorder.js"></script>\n    ${sketchTag('')}`,
    )
    .replace(
      '<script type="module" src="sketch.js"></script>',
      `<script src="../../three-recorder.js"></script>\n    ${sketchTag(' type="module"')}`,
    )

/** Returns the content of the file at `path` of the site; undefined if there is none. */
async function contentOf(path) {
  if (libraries.includes(path) || modules.includes(path) || isShared(path)) return read(path)
  if (recorders.includes(path)) return read(`web/${path}`)
  if (path in frameScripts) return read(frameScripts[path])

  const [isLoadable, example, file] = loadable.exec(path) ?? []
  if (!isLoadable) return
  if (file in fonts) return read(fonts[file])
  const model = /^(\w+)\.obj$/.exec(file)?.[1]
  if (model) return model in models ? makeOBJ(model) : undefined
  if (!example) return
  const page = async () => String(await read(`examples/${example}/index.html`))
  if (file === 'gallery.html') return withPolicy(framedPage(await page()), 'sketch')
  if (!file || file === 'index.html') return withPolicy(await page(), 'sketch')
  return read(`examples/${example}/${file}`)
}

/** Returns the paths of all files of a built gallery: libraries, and each example's pages, sketch, and files that the sketch loads. */
async function allPaths() {
  const paths = [...libraries, ...modules, ...(await importsOf(modules))]
  paths.push(...recorders, ...Object.keys(frameScripts))
  const shared = [...Object.keys(models).map((name) => `${name}.obj`), ...Object.keys(fonts)]
  paths.push(...shared.map((file) => `playground/files/${file}`))
  const folders = await readdir(new URL('examples/', root))
  for (const name of folders.sort()) {
    const sketch = String(await read(`examples/${name}/sketch.js`))
    const loaded = [...sketch.matchAll(/'([\w-]+\.(?:obj|woff))'/g)].map(([, file]) => file)
    const files = new Set(['index.html', 'gallery.html', 'sketch.js', ...loaded])
    paths.push(...[...files].map((file) => `examples/${name}/${file}`))
  }
  return paths
}

async function answer(request, response, next) {
  const path = pathOf(request)
  const content = await contentOf(path).catch(() => undefined)
  if (content === undefined) return next()
  response.setHeader('Content-Type', types[extname(path) || '.html'])
  response.setHeader('Cache-Control', 'no-cache')
  response.end(content)
}

export const exampleFiles = () => ({
  name: 'example-files',

  configureServer(server) {
    server.middlewares.use(answer)
  },

  async generateBundle() {
    for (const path of await allPaths())
      this.emitFile({ type: 'asset', fileName: path, source: await contentOf(path) })
  },
})
