/** The hosts that can run a sketch, and the optional scripts. Paths are relative to a folder two levels below the site, as in examples. */

const p5Style = `body { background: #151823; display: grid; margin: 0; min-height: 100vh; place-items: center }
      canvas { display: block; height: auto !important; max-width: 100vw }`

export const threeStyle = (
  background,
) => `body { background: ${background}; margin: 0; overflow: hidden }
      canvas { display: block }`

const p5 = '../../node_modules/p5/lib/p5.min.js'
const cdn = 'https://cdn.jsdelivr.net/npm/'

/** Maps a host's name, as in links, to its title and libraries. `libraries` are script tags, `modules` is an import map. */
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
      'three/webgpu': '../../node_modules/three/build/three.webgpu.js',
      'three/tsl': '../../node_modules/three/build/three.tsl.js',
      'three/addons/': '../../node_modules/three/examples/jsm/',
      warpjet: '../../dist/warpjet.js',
      'warpjet/three': '../../dist/three.js',
      'warpjet/three/webgpu': '../../dist/three.webgpu.js',
      'warpjet/deformers': '../../dist/deformers.js',
      'warpjet/glsl': '../../dist/glsl.js',
    },
    style: threeStyle('#151823'),
  },
}

/** For code that defines only an offset function; offset.js completes it to a sketch. */
hosts.offset = { ...hosts.p5, title: 'Offset alone, on a model' }

/** Script tags in addition to p5's libraries. The first is always included. */
export const scripts = {
  p5: { file: '../../dist/p5.warpjet.min.js' },
  deformers: { title: 'Deformers', file: '../../dist/warpjet.deformers.min.js' },
  glsl: { title: 'Shader text', file: '../../dist/warpjet.glsl.min.js' },
  operators: { title: 'Operators', file: '../../dist/warpjet.operators.min.js' },
}

export const isThree = (host) => host === 'three'

/** Returns the label of the checkbox that adds the script named in an error message; `undefined` for three.js, which uses imports. */
export function boxNamedIn(mistake, host) {
  const isNamed = ({ title, file }) => title && mistake.includes(file.split('/').at(-1))
  return isThree(host) ? undefined : Object.values(scripts).find(isNamed)?.title
}

/** Returns the paths of the script tags that a sketch needs, in order. */
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

/** Converts a path of the examples to the path on a server of node_modules. */
export const toModulePath = (file) =>
  file
    .replace('../../dist/', '/warpjet/dist/')
    .replace('../../node_modules/p5-v1/', '/p5/')
    .replace('../../node_modules/', '/')

/** Converts a path of the examples to a CDN address. @param versions maps package → version */
export const toCDNAddress = (file, versions) =>
  file
    .replace('../../dist/', `${cdn}warpjet@${versions.warpjet}/dist/`)
    .replace('../../node_modules/p5-v1/', `${cdn}p5@${versions['p5-v1']}/`)
    .replace(
      /^\.\.\/\.\.\/node_modules\/([\w-]+)\//,
      (_, name) => `${cdn}${name}@${versions[name]}/`,
    )
