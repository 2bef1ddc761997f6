/** What the scripts beside this one add to the global `warpjet`. */
const scripts: Record<string, string> = {
  'twist bend taper bulge stretch wave ripple melt inflate genie spherify shear noiseDisplace chain add blend mask inSpace':
    'deformers',
  'glslOffset differentiate exactNormals': 'glsl',
  operators: 'operators',
}

export const isAmong = (names: string, name: string) => names.split(' ').includes(name)

/** All of it. */
export const elsewhereNames = Object.keys(scripts).join(' ').split(' ')

/** What to do for a page to have it. */
export function addScript(name: string): string | undefined {
  const [, script] = Object.entries(scripts).find(([names]) => isAmong(names, name)) ?? []
  return script && `add the script warpjet.${script}.min.js after p5.warpjet.min.js`
}
