/** 'warpjet/mesh', fetched when it is first needed: whoever bundles this makes it a file of its own. */
export const importMesh = (_method: string) => import('../mesh.js')
