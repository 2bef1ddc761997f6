// A plugin for materials of Babylon.js that shows a value of the shader in place of the colour.
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js'

/** Maps a value that `Shown` writes in place of the colour → its number in the shader. Values named `rest…` are unwarped. */
const shownValues = { color: 0, normal: 1, restPosition: 2, restNormal: 3, restUv: 4 }

/** Writes the value that the property `shown` names. */
export class Shown extends MaterialPluginBase {
  shown = 'color'

  constructor(material) {
    super(material, 'Shown', 300, { SHOWN: true }, false)
    this._pluginManager._addPlugin(this)
    this._enable(true)
  }

  getClassName() {
    return 'Shown'
  }

  isCompatible() {
    return true
  }

  prepareDefinesBeforeAttributes(defines) {
    Object.assign(defines, { _needUVs: true, _needNormals: true })
  }

  getUniforms() {
    const ubo = [{ name: 'shown', size: 1, type: 'float' }]
    // `fragment` is for engines without uniform buffers.
    return { ubo, fragment: 'uniform float shown;' }
  }

  bindForSubMesh(buffer) {
    buffer.updateFloat('shown', shownValues[this.shown])
  }

  getCustomCode(stage, language) {
    const isWGSL = language === 1
    const names = ['restPosition', 'restNormal', 'restUv']
    const declarations = names
      .map((name) => (isWGSL ? `varying ${name}: vec3f;` : `varying vec3 ${name};`))
      .join('\n')
    const output = isWGSL ? 'vertexOutputs.' : ''
    const input = isWGSL ? 'fragmentInputs.' : ''
    const vec3 = isWGSL ? 'vec3f' : 'vec3'
    const shown = isWGSL ? 'uniforms.shown' : 'shown'
    const color = this._material.getClassName() === 'PBRMaterial' ? 'finalColor' : 'color'
    if (stage === 'vertex')
      return {
        CUSTOM_VERTEX_DEFINITIONS: declarations,
        CUSTOM_VERTEX_UPDATE_POSITION: `${output}restPosition = positionUpdated;
${output}restUv = ${vec3}(0.0);
${output}restNormal = ${vec3}(0.0);
#ifdef NORMAL
${output}restNormal = normalUpdated;
#endif
#ifdef UV1
${output}restUv = ${vec3}(uvUpdated, 0.0);
#endif`,
      }
    const write = (value) => `${color} = ${vec3.replace('3', '4')}(${value}, 1.0);`
    return {
      CUSTOM_FRAGMENT_DEFINITIONS: declarations,
      CUSTOM_FRAGMENT_BEFORE_FRAGCOLOR: ['normalW', ...names.map((name) => input + name)]
        .map((value, i) => `if (abs(${shown} - ${i + 1}.0) < 0.5) { ${write(value)} }`)
        .join('\n'),
    }
  }
}
