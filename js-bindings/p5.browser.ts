// 'warpjet/p5' as bundlers for the browser resolve it: the same addon, registered with the p5 that the
// project imports. Elsewhere (Node, import maps) `p5.ts` stands alone, since p5 cannot load without a browser.
import p5 from 'p5'
import warpjet from './p5.js'

warpjet(p5)

export { default, createWarp, registerGlobally } from './p5.js'
