// 'warpjet/p5' where p5 can load, which is everywhere except on servers: the addon, registered with the p5 that the project imports.
import p5 from 'p5'
import { warpjet } from './p5/addon.js'

export { warpjet as default, warpjet as setupWarp, createWarp } from './p5/addon.js'
export { registerGlobally } from './p5/page/register.js'

warpjet(p5)
