/** Loads the mesh module when it is first needed. A bundler makes it a file of its own. */
export const importMesh = (_method: string) => import('./with-mesh.js')
