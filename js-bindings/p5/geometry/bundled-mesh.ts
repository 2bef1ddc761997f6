/** Loads the mesh module on first use. A bundler makes it a separate file. */
export const importMesh = (_method: string) => import('./with-mesh.js')
