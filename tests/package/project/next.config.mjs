export default {
  distDir: 'out-next',
  output: 'export',
  outputFileTracingRoot: import.meta.dirname,
  turbopack: { root: import.meta.dirname },
}
