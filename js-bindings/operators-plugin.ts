// 'warpjet/operators/plugin'.
export { default, operators, translateModule } from './operators/plugin.js'
