/** What a sketch may run in, and the scripts that it may ask for. Paths are those of the examples, from a folder two below the site. */

const p5Style = `body { background: #151823; display: grid; margin: 0; min-height: 100vh; place-items: center }
      canvas { display: block; height: auto !important; max-width: 100vw }`

export const threeStyle = (
  background,
) => `body { background: ${background}; margin: 0; overflow: hidden }
      canvas { display: block }`

const p5 = '../../node_modules/p5/lib/p5.min.js'
const cdn = 'https://cdn.jsdelivr.net/npm/'

/** By its name in a link. `libraries` are script tags, `modules` an import map. */
export const hosts = {
  p5: { title: 'p5 2, WebGL', libraries: [p5], style: p5Style },
  'p5-webgpu': {
    title: 'p5 2, WebGPU',
    libraries: [p5, '../../node_modules/p5/lib/p5.webgpu.min.js'],
    style: p5Style,
  },
  'p5-1': {
    title: 'p5 1.11',
    libraries: ['../../node_modules/p5-v1/lib/p5.min.js'],
    style: p5Style,
  },
  three: {
    title: 'three.js',
    libraries: [],
    modules: {
      three: '../../node_modules/three/build/three.module.js',
      'three/addons/': '../../node_modules/three/examples/jsm/',
      warpjet: '../../dist/warpjet.js',
      'warpjet/three': '../../dist/three.js',
      'warpjet/deformers': '../../dist/deformers.js',
      'warpjet/glsl': '../../dist/glsl.js',
    },
    style: threeStyle('#151823'),
  },
}

/** With an offset function as the whole text; offset.js writes the sketch around it. */
hosts.offset = { ...hosts.p5, title: 'Offset alone, on a model' }

/** Beside the libraries of p5, each a tag of its own. The first is always there. */
export const scripts = {
  p5: { file: '../../dist/p5.warpjet.min.js' },
  deformers: { title: 'Deformers', file: '../../dist/warpjet.deformers.min.js' },
  glsl: { title: 'Shader text', file: '../../dist/warpjet.glsl.min.js' },
  operators: { title: 'Operators', file: '../../dist/warpjet.operators.min.js' },
}

export const isThree = (host) => host === 'three'

/** What is written beside the box for the script that a mistake says is missing; three.js has no boxes, but imports. */
export function boxNamedIn(mistake, host) {
  const isNamed = ({ title, file }) => title && mistake.includes(file.split('/').at(-1))
  return isThree(host) ? undefined : Object.values(scripts).find(isNamed)?.title
}

/** The tags that a sketch needs → paths, in order. */
export const tagsOf = ({ host, chosen }) =>
  isThree(host)
    ? []
    : [
        ...hosts[host].libraries,
        scripts.p5.file,
        ...Object.keys(scripts)
          .filter((name) => chosen.includes(name))
          .map((name) => scripts[name].file),
      ]

/** The same file where npm has put it, from its folder of packages. */
export const inModules = (file) =>
  file
    .replace('../../dist/', '/warpjet/dist/')
    .replace('../../node_modules/p5-v1/', '/p5/')
    .replace('../../node_modules/', '/')

/** The same file at a CDN; `versions` by package. */
export const atCDN = (file, versions) =>
  file
    .replace('../../dist/', `${cdn}warpjet@${versions.warpjet}/dist/`)
    .replace('../../node_modules/p5-v1/', `${cdn}p5@${versions['p5-v1']}/`)
    .replace(
      /^\.\.\/\.\.\/node_modules\/([\w-]+)\//,
      (_, name) => `${cdn}${name}@${versions[name]}/`,
    )
