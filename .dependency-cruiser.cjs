// The dependency rules of js-bindings, which js-bindings/ARCHITECTURE.md explains. A module is a folder of js-bindings; the files
// beside the folders are the entries that users import.
const entry = '^js-bindings/[^/]+\\.ts$'
const inModule = '^js-bindings/[^/]+/'

module.exports = {
  forbidden: [
    {
      name: 'no-circular-files',
      comment: 'Files must not import each other in a circle, types included.',
      severity: 'error',
      // The types of expressions and of their generated methods name each other. Nothing of them exists at run time.
      from: { pathNot: '^js-bindings/core/types/' },
      to: { circular: true },
    },
    {
      name: 'no-circular-modules',
      comment: 'Modules must not depend on each other in a circle, types included.',
      // To become an error: wasm still imports two types of core.
      severity: 'warn',
      scope: 'folder',
      from: { path: '^js-bindings/[^/]+$' },
      to: { path: '^js-bindings/[^/]+$', circular: true },
    },
    {
      name: 'no-entry-from-below',
      comment: 'Only tests and other entries may import an entry.',
      severity: 'error',
      from: { path: inModule },
      to: { path: entry },
    },
    {
      name: 'no-orphans',
      comment: 'Every file must be reached from an entry.',
      severity: 'error',
      from: { path: inModule, orphan: true, pathNot: '\\.d\\.ts$' },
      to: {},
    },
    {
      name: 'no-unresolved',
      comment: 'Every import must name a file or an installed package.',
      severity: 'error',
      from: {},
      to: { couldNotResolve: true },
    },
  ],
  options: {
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.json' },
    doNotFollow: { path: 'node_modules' },
    exclude: { path: '^js-bindings/generated/' },
    enhancedResolveOptions: {
      exportsFields: ['exports'],
      conditionNames: ['import', 'browser', 'types', 'default'],
    },
  },
}
