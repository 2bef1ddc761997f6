/**
 * Vite plugin: what our own declarations say, for completion and hover in the playground: the inputs of an offset function, the
 * functions of each host, and their options, each with its type and its comment.
 */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'

const path = (file) => fileURLToPath(new URL(`../../js-bindings/${file}`, import.meta.url))

/** Entries whose functions sketches call, by host. */
const entries = { p5: 'globals.ts', three: 'three.ts', both: 'warpjet.ts' }

/** Where the options of a function are declared, by its file and its name. */
const optionsOf = {
  'globals.ts createWarp': [['p5/settings.ts', 'CreateWarpOptions']],
  'globals.ts loadWarpModel': [['p5/geometry/model.ts', 'LoadModelOptions']],
  'three/warp.ts warp': [['three/settings.ts', 'WarpOptions']],
  'three/material.ts warpMaterial': [['three/settings.ts', 'WarpOptions']],
  'compile/compile-warp.ts compileWarp': [
    ['compile/warp-text.ts', 'WarpOptions'],
    ['core/module/result.ts', 'CompileOptions'],
  ],
}

/** → { inputs: [member], functions: [{ name, host, form, meaning, options: [member] }] }; a member is { name, form, meaning, host }. */
export async function ownTypes() {
  // The newest TypeScript cannot be asked for a tree from JavaScript.
  const { default: ts } = await import('typescript')
  const trees = new Map()

  function treeOf(file) {
    if (!trees.has(file)) {
      const text = readFileSync(path(file), 'utf8')
      trees.set(file, ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true))
    }
    return trees.get(file)
  }

  /** All declarations of a kind in the file, at whatever depth. */
  function found(file, is) {
    const nodes = []
    const look = (node) => {
      if (is(node)) nodes.push(node)
      else ts.forEachChild(node, look)
    }
    look(treeOf(file))
    return nodes
  }
  const named = (file, is, name) => found(file, is).find((node) => node.name?.text === name)

  const meaningOf = (node) =>
    ts
      .getJSDocCommentsAndTags(node)
      .map(({ comment }) => ts.getTextOfJSDocComment(comment) ?? '')
      .join(' ')
      .replaceAll(/\s+/g, ' ')
      .replaceAll('`', '')

  const membersOf = ([file, name]) =>
    named(file, ts.isInterfaceDeclaration, name).members.map((member) => {
      const name = member.name.getText()
      const type = member.type.getText()
      // The words that a type stands for tell more than its name, and a type of types tells nothing.
      const alias = named(file, ts.isTypeAliasDeclaration, type)
      const shown = (alias?.type.getText() ?? type).replaceAll(/\s+/g, ' ')
      return {
        name,
        form: shown.includes('<') ? name : `${name}: ${shown}`,
        meaning: [member, alias].filter(Boolean).map(meaningOf).join(' ').trim(),
      }
    })

  /** The functions of an entry: those that it declares, and those of its neighbours that it hands on. */
  function functionsOf(host, entry) {
    const handedOn = found(entry, ts.isExportDeclaration)
      .filter(({ isTypeOnly, exportClause }) => !isTypeOnly && exportClause?.elements)
      .flatMap(({ moduleSpecifier, exportClause: { elements } }) =>
        elements
          .filter(({ isTypeOnly }) => !isTypeOnly)
          .map(({ name }) => [moduleSpecifier.text.slice(2).replace(/js$/, 'ts'), name.text]),
      )
      .filter(([file]) => !file.startsWith('generated/'))
      .map(([file, name]) => [file, named(file, ts.isFunctionDeclaration, name)])
    return [
      ...found(entry, ts.isFunctionDeclaration).map((node) => [entry, node]),
      ...handedOn.filter(([, node]) => node),
    ].map(([file, node]) => {
      const name = node.name.text
      const parameters = node.parameters.map(
        (each) => each.name.getText() + (each.questionToken || each.initializer ? '?' : ''),
      )
      const options = (optionsOf[`${file} ${name}`] ?? []).flatMap(membersOf)
      return {
        name,
        host,
        form: `${name}(${parameters.join(', ')})`,
        meaning: meaningOf(node),
        options,
      }
    })
  }

  const ofP5 = named('three/settings.ts', ts.isTypeAliasDeclaration, 'OfP5').type.types.map(
    ({ literal }) => literal.text,
  )
  return {
    inputs: membersOf(['core/types/offset.ts', 'WarpInputs']).map((input) => ({
      ...input,
      host: ofP5.includes(input.name) ? 'p5' : 'both',
    })),
    functions: Object.entries(entries).flatMap(([host, entry]) => functionsOf(host, entry)),
  }
}

const id = 'virtual:own-types'

export const ownTypesPlugin = () => ({
  name: 'own-types',
  resolveId: (asked) => (asked === id ? `\0${id}` : undefined),
  load: async (asked) =>
    asked === `\0${id}` ? `export default ${JSON.stringify(await ownTypes())}` : undefined,
})
