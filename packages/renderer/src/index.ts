export { FarolRenderer } from './renderer/FarolRenderer';
export type { FarolEvents, FarolOptions } from './renderer/FarolOptions';
export { techniques, type TechniqueName } from './techniques';
export { views, type View } from './frame/views';
export type { FarolEffect } from './frame/FarolEffect';
export type { FarolInfo, PassInfo } from './renderer/FarolInfo';
export type { LazyPart } from './renderer/lazyCode';
export { setShading } from './materials/setShading';
export type { ShadingName } from './materials/shadingOf';
