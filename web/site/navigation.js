/** The docs in reading order. `file` is a Markdown file of web/docs without its extension. */
export const groups = [
  {
    title: 'Tutorial',
    pages: [
      { file: 'tutorial-1-first-warp', title: '1. First warp' },
      { file: 'tutorial-2-light', title: '2. Lights and normals' },
      { file: 'tutorial-3-noise', title: '3. Noise' },
      { file: 'tutorial-4-composing', title: '4. Composing' },
      { file: 'tutorial-5-your-model', title: '5. Your model' },
      { file: 'tutorial-6-cpu', title: '6. The CPU' },
    ],
  },
  {
    title: 'How to',
    pages: [
      { file: 'how-to-rotate', title: 'Rotate about an axis' },
      { file: 'how-to-flag', title: 'A waving flag' },
      { file: 'how-to-sound', title: 'React to sound' },
      { file: 'how-to-mouse', title: 'Follow the mouse' },
      { file: 'how-to-pick', title: 'Pick a point' },
      { file: 'how-to-blender', title: 'Export for Blender' },
      { file: 'how-to-three', title: 'In three.js' },
      { file: 'how-to-react', title: 'In React' },
      { file: 'how-to-p5-warp', title: 'Migrate from p5.warp' },
      { file: 'how-to-glsl-autodiff', title: 'Migrate from glsl-autodiff' },
    ],
  },
  {
    title: 'Concepts',
    pages: [
      { file: 'units', title: 'Units: what position is' },
      { file: 'spaces', title: 'Spaces' },
      { file: 'normals', title: 'Why normals go wrong' },
      { file: 'surface-variation', title: 'Surface variation' },
      { file: 'precision', title: 'Precision' },
    ],
  },
  {
    title: 'Reference',
    pages: [
      { file: 'p5', title: 'createWarp and p5.js' },
      { file: 'p5-webgpu', title: 'p5.js on WebGPU' },
      { file: 'expressions', title: 'Expressions' },
      { file: 'operations', title: 'Operations' },
      { file: 'plots', title: 'Operations, plotted' },
      { file: 'plots-vectors', title: 'Vectors, matrices and noise, plotted' },
      { file: 'identities', title: 'Identities' },
      { file: 'operators', title: 'Operators: + - * / and if' },
      { file: 'noise', title: 'Noise' },
      { file: 'deformers', title: 'Deformers' },
      { file: 'composition', title: 'Composition' },
      { file: 'glsl', title: 'Shader text' },
      { file: 'core', title: 'Any WebGL program' },
      { file: 'cpu', title: 'On the CPU' },
      { file: 'mesh', title: 'Models and glTF' },
      { file: 'three', title: 'three.js' },
      { file: 'babylon', title: 'Babylon.js' },
      { file: 'typescript', title: 'Bundlers and TypeScript' },
      { file: 'browsers', title: 'Where it runs' },
    ],
  },
  {
    title: 'Behind it',
    pages: [
      { file: 'derivatives', title: 'How exact' },
      { file: 'uptime', title: 'A week of uptime' },
      { file: 'detail', title: 'Triangles for the screen' },
      { file: 'subdivision', title: 'Triangles of subdivide' },
      { file: 'how-it-works', title: 'How it works' },
      { file: 'playground', title: 'The playground' },
      { file: 'develop', title: 'Develop warpjet' },
    ],
  },
]

export const pages = groups.flatMap(({ title: group, pages }) =>
  pages.map((page) => ({ ...page, group })),
)

/** The entries of the bar on every page. `href` is relative to the first page. */
export const entries = [
  { title: 'Gallery', href: '#gallery' },
  { title: 'Docs', href: 'docs/' },
  { title: 'Playground', href: 'playground/' },
  { title: 'Your model', href: 'drop/' },
  { title: 'Measured', href: 'bench/results.html' },
]
