/**
 * Vite plugin: extracts our own declarations for completion and hover in the playground: the inputs of an offset function, the
 * functions of each host, and their options, each with its type and comment.
 */
import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { Stop } from '../../.scripts/lib/terminal.mjs'

const readSource = (file) =>
  readFileSync(fileURLToPath(new URL(`../../js-bindings/${file}`, import.meta.url)), 'utf8')

/** Maps a host to the entry whose functions its sketches call. */
const entries = { p5: 'globals.ts', three: 'three.ts', both: 'warpjet.ts' }

/** Maps a function, by file and name, to the declarations of its options. */
const optionsOf = {
  'globals.ts createWarp': [['p5/settings.ts', 'CreateWarpOptions']],
  'globals.ts loadWarpModel': [['p5/geometry/model.ts', 'LoadModelOptions']],
  'three/warp.ts warp': [['three/settings.ts', 'WarpOptions']],
  'three/material.ts warpMaterial': [['three/settings.ts', 'WarpOptions']],
  'compile/compile-warp.ts compileWarp': [
    ['compile/warp-options.ts', 'WarpOptions'],
    ['core/module/result.ts', 'CompileOptions'],
  ],
}

/**
 * `read` returns the text of a file of js-bindings. Throws a Stop if a file lacks a declaration.
 * @returns { inputs: [member], functions: [{ name, host, form, meaning, options: [member] }] }; a member is { name, form, meaning, host }
 */
export async function ownTypes(read = readSource) {
  // The project's TypeScript 7 has no JavaScript API for syntax trees, so this uses TypeScript 5.
  const { default: ts } = await import('typescript')
  const isDeclaredBy = { interface: ts.isInterfaceDeclaration, type: ts.isTypeAliasDeclaration }
  const trees = new Map()

  function treeOf(file) {
    if (!trees.has(file))
      trees.set(file, ts.createSourceFile(file, read(file), ts.ScriptTarget.Latest, true))
    return trees.get(file)
  }

  /** Finds all declarations of a kind in the file, at any depth. */
  function findAll(file, isKind) {
    const nodes = []
    const visit = (node) => {
      if (isKind(node)) nodes.push(node)
      else ts.forEachChild(node, visit)
    }
    visit(treeOf(file))
    return nodes
  }
  const findNamed = (file, isKind, name) =>
    findAll(file, isKind).find((node) => node.name?.text === name)

  /** Finds a declaration that must exist; `keyword` is the one that introduces it. */
  function getNamed(file, keyword, name) {
    const node = findNamed(file, isDeclaredBy[keyword], name)
    if (node) return node
    throw new Stop(
      `own-types: expected js-bindings/${file} to declare \`${keyword} ${name}\`, got none; follow the renaming in web/plugins/own-types.js`,
    )
  }

  const textOf = ({ comment }) => ts.getTextOfJSDocComment(comment) ?? ''
  /** Returns the comment of a declaration, and its `@default` as a sentence. */
  const meaningOf = (node) =>
    [
      ...ts.getJSDocCommentsAndTags(node).map(textOf),
      ...ts
        .getJSDocTags(node)
        .filter(({ tagName }) => tagName.text === 'default')
        .map((tag) => `Default: ${textOf(tag)}.`),
    ]
      .filter(Boolean)
      .join(' ')
      .replaceAll(/\s+/g, ' ')
      .replaceAll('`', '')

  const membersOf = ([file, name]) =>
    getNamed(file, 'interface', name).members.map((member) => {
      const name = member.name.getText()
      const type = member.type.getText()
      // Show the definition of a type alias, which says more than its name, and omit generic types, which say nothing here.
      const alias = findNamed(file, ts.isTypeAliasDeclaration, type)
      const typeText = (alias?.type.getText() ?? type).replaceAll(/\s+/g, ' ')
      return {
        name,
        form: typeText.includes('<') ? name : `${name}: ${typeText}`,
        meaning: [member, alias].filter(Boolean).map(meaningOf).join(' ').trim(),
      }
    })

  /** Finds the functions of an entry: those that it declares and those that it re-exports. */
  function functionsOf(host, entry) {
    const reexported = findAll(entry, ts.isExportDeclaration)
      .filter(({ isTypeOnly, exportClause }) => !isTypeOnly && exportClause?.elements)
      .flatMap(({ moduleSpecifier, exportClause: { elements } }) =>
        elements
          .filter(({ isTypeOnly }) => !isTypeOnly)
          .map(({ name }) => [moduleSpecifier.text.slice(2).replace(/js$/, 'ts'), name.text]),
      )
      .filter(([file]) => !file.startsWith('generated/'))
      .map(([file, name]) => [file, findNamed(file, ts.isFunctionDeclaration, name)])
    return [
      ...findAll(entry, ts.isFunctionDeclaration).map((node) => [entry, node]),
      ...reexported.filter(([, node]) => node),
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

  const p5Inputs = getNamed('three/settings.ts', 'type', 'P5Input').type.types.map(
    ({ literal }) => literal.text,
  )
  return {
    inputs: membersOf(['core/types/offset.ts', 'WarpInputs']).map((input) => ({
      ...input,
      host: p5Inputs.includes(input.name) ? 'p5' : 'both',
    })),
    functions: Object.entries(entries).flatMap(([host, entry]) => functionsOf(host, entry)),
  }
}

const id = 'virtual:own-types'

export const ownTypesPlugin = () => ({
  name: 'own-types',
  resolveId: (requested) => (requested === id ? `\0${id}` : undefined),
  load: async (requested) =>
    requested === `\0${id}` ? `export default ${JSON.stringify(await ownTypes())}` : undefined,
})
