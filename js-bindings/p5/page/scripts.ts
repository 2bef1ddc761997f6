/** Maps functions that other scripts add to the global `warpjet` to the name of the script. */
const scripts: Record<string, string> = {
  'twist bend taper bulge stretch wave ripple melt inflate genie spherify shear noiseDisplace chain add blend mask inSpace':
    'deformers',
  'glslOffset differentiate exactNormals': 'glsl',
  operators: 'operators',
}

export const isAmong = (names: string, name: string) => names.split(' ').includes(name)

/** All functions of other scripts. */
export const namesInOtherScripts = Object.keys(scripts).join(' ').split(' ')

/** Returns advice on how a page gets the function `name`; `undefined` if no script has it. */
export function addScript(name: string): string | undefined {
  const [, script] = Object.entries(scripts).find(([names]) => isAmong(names, name)) ?? []
  return script && `add the script warpjet.${script}.min.js after p5.warpjet.min.js`
}
